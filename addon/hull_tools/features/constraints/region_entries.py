# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions of a hull's faces: a number that the faces have in the mesh, and an entry with what the
region is to be in a collection of Object.hull, as `flats` and `developables`."""

import bpy


def new_number(collection, in_mesh):
    """A number that no region has, in the mesh's numbers `in_mesh`, in another hull or in a variant
    of one, so that hulls can be joined. collection: its name."""
    used = {
        entry.region
        for other in bpy.data.objects
        for ship in (other.hull, *other.hull.variants.kept)
        for entry in getattr(ship, collection)
    }
    return 1 + max(used.union(in_mesh), default=0)


def keep_only(entries, used):
    """Removes the entries of a collection whose region is not among the numbers `used`."""
    for index in reversed(range(len(entries))):
        if entries[index].region not in used:
            entries.remove(index)
