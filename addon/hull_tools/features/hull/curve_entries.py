# SPDX-License-Identifier: GPL-3.0-or-later
"""Entries of control curves in Object.hull.fairness.curves, by the numbers that their edges have in
the mesh. No two hulls of a file have a number in common, so that hulls can be joined: edges that
came by that get the entry that they had."""

import bpy

from ...bridge.mesh import curve_marks
from ...bridge.objects import hull_objects

_known = {}  # what entries were last: {number: (name, is_shown)}


def new_number(obj):
    """A number that no curve has, of this mesh or in an entry of any hull."""
    used = {entry.number for other in bpy.data.objects for entry in other.hull.fairness.curves}
    return 1 + max(used.union(curve_marks.present(obj.data)), default=0)


def add(obj, number, name, is_shown=True):
    """A new entry of a hull, which is returned."""
    entry = obj.hull.fairness.curves.add()
    entry.number, entry.name, entry.is_shown = number, name, is_shown
    return entry


def follow(obj):
    """Gives a hull entries of the curves that only its mesh knows. In edit mode there come none."""
    known = {entry.number: (entry.name, entry.is_shown) for entry in obj.hull.fairness.curves}
    _known.update(known)
    if obj.data.is_editmode or hull_objects.locked(obj):
        return
    for number in sorted(curve_marks.present(obj.data).difference(known)):
        add(obj, number, *_known.get(number, (f"Curve {number}",)))


def forget_all():
    _known.clear()
