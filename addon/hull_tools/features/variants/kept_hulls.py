# SPDX-License-Identifier: GPL-3.0-or-later
"""The variants of a hull: hulls that were kept under a name, with all that decides on results.

A variant is an entry of Object.hull.variants.kept: the settings of then, and a copy of the mesh as
Blender has it, so that it comes back bit by bit, with creases, locks, flats and whatever else the
mesh carries. It is saved with the file, appended and copied with the object; copies of an object
share the meshes of its variants, which nothing writes to.
"""

from types import SimpleNamespace

import bmesh
import bpy

from ...bridge import limits
from ...bridge.mesh import start_points
from ...bridge.mesh.mesh_editing import check_single_user
from ...bridge.objects import hull_objects
from ..hull import hull_creation, hull_state
from . import ship_settings


def keep(obj, name="", note=""):
    """Keeps a hull as it is, in edit mode too, under a name, or one that is free; returns the
    entry, which is the chosen one then. ValueError for a linked hull, and for too many."""
    _check_own(obj)
    kept = obj.hull.variants.kept
    limits.at_most(len(kept) + 1, "variants", limits.MOST_VARIANTS)
    if obj.mode == "EDIT":
        obj.update_from_editmode()
    free = name.strip() or _free_name(kept)
    entry = kept.add()
    entry.name, entry.note = free, note
    entry.mesh = obj.data.copy()
    start_points.forget(entry.mesh)  # of what is previewed as it is shown
    entry.mesh.use_fake_user = False
    entry.mesh.name = f"{obj.name}, {entry.name}"
    ship_settings.copy_ship(obj.hull, entry)
    obj.hull.variants.active = len(kept) - 1
    obj.update_tag(refresh={"DATA"})
    return entry


def _free_name(kept):
    names = {entry.name for entry in kept}
    number = len(kept) + 1
    while f"Variant {number}" in names:
        number += 1
    return f"Variant {number}"


def chosen(obj):
    """The entry that is chosen in the list; None without any."""
    variants = obj.hull.variants
    is_there = 0 <= variants.active < len(variants.kept)
    return variants.kept[variants.active] if is_there else None


def named(obj, name):
    """The first variant of that name, or for "" the chosen one; ValueError where there is none."""
    kept = obj.hull.variants.kept
    entry = next((one for one in kept if one.name == name), None) if name else chosen(obj)
    if entry is None:
        told = f'There is no variant "{name}"' if name else "There is no variant"
        raise ValueError(f"{told}: keep the hull as one first")
    return entry


def as_hull(obj, entry):
    """A variant in the place of a hull object, for what reads its name, mesh, settings and layers,
    with the appendages that the hull has now. ValueError when its mesh is gone."""
    if entry.mesh is None:
        raise ValueError(f'The mesh of the variant "{entry.name}" was deleted: remove the variant')
    slots = [SimpleNamespace(material=material) for material in entry.mesh.materials]
    return SimpleNamespace(
        name=f"{obj.name}, {entry.name}",
        data=entry.mesh,
        hull=entry,
        material_slots=slots,
        children=obj.children,
    )


def go_back(obj, scene, entry, keep_present=False):
    """Makes a hull what a variant is: mesh, marks and settings, bit by bit; returns its HullState.

    In object mode. keep_present: what it is now is kept as a variant first; the chosen one stays
    so. ValueError for a linked hull or a mesh that others have too.
    """
    _check_own(obj)
    check_single_user(obj.data)
    if obj.data.is_editmode:
        raise ValueError("Leave edit mode first (Tab)")
    if keep_present:
        variants = obj.hull.variants
        place, before = list(variants.kept).index(entry), variants.active
        keep(obj)
        entry, variants.active = variants.kept[place], before
    kept = as_hull(obj, entry)
    if obj.data.shape_keys is not None:
        obj.shape_key_clear()
    write_mesh(kept.data, obj.data)
    ship_settings.copy_ship(entry, obj.hull)
    return hull_state.follow_edit(obj, scene, is_by_hand=False)


def write_mesh(source, target):
    """Makes a mesh what another one is, with all that it carries, its materials too."""
    # First the materials: with them Blender resets the slots of the faces.
    if list(target.materials) != list(source.materials):
        target.materials.clear()
        for material in source.materials:
            target.materials.append(material)
    bm = bmesh.new()
    try:
        bm.from_mesh(source)
        bm.to_mesh(target)
    finally:
        bm.free()
    target.update()


def remove(obj, entry):
    """Removes a variant; the one after it, or else the last, is chosen then."""
    _check_own(obj)
    variants = obj.hull.variants
    variants.kept.remove(list(variants.kept).index(entry))
    variants.active = max(min(variants.active, len(variants.kept) - 1), 0)
    obj.update_tag(refresh={"DATA"})


def duplicate(obj, scene, entry):
    """A hull object of its own that is what a variant is, where the hull stands; returns it."""
    kept = as_hull(obj, entry)
    mesh = kept.data.copy()
    mesh.name = kept.name
    made = bpy.data.objects.new(kept.name, mesh)
    for collection in obj.users_collection:
        collection.objects.link(made)
    made.matrix_world = obj.matrix_world
    for group in obj.vertex_groups:
        made.vertex_groups.new(name=group.name)
    made.hull.samples = obj.hull.samples
    ship_settings.copy_view(obj.hull, made.hull)
    ship_settings.copy_ship(entry, made.hull)
    hull_creation.make_hull(made, scene, entry.half)
    return made


def _check_own(obj):
    reason = hull_objects.locked(obj)
    if reason:
        raise ValueError(reason)
