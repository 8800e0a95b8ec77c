# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls from mesh objects and from files."""

import bpy
import numpy as np

from ....hull_io.hull_data import KEPT_IN
from ...bridge.blender import letters, preferences, units
from ...bridge.mesh import mesh_arrays, row_marks
from ...bridge.objects import hull_objects, migration, shown_objects
from ..constraints import developables, flats, kept_points, point_locks
from ..flotation import loading_data
from ..lines import line_data, line_places
from ..surface import materials
from . import (
    appendage_data,
    curve_data,
    field_data,
    hull_state,
    plating_data,
    tie_data,
    wanted_data,
)

_PARTICULARS = ("length_pp", "beam", "draft", "depth")


def make_hull(obj, scene, half):
    """Turns a mesh object into a hull and shows its surface; returns its HullState.

    Particulars that are still zero are taken from the mesh. ValueError when the object is refused.
    """
    reason = hull_objects.refusal(obj) or hull_objects.locked(obj)
    if reason:
        raise ValueError(reason)
    obj.hull.is_hull = True
    obj.hull.format = migration.FORMAT
    obj.hull.half = half
    _fill_particulars(obj)
    _fill_choices(obj.hull)
    obj.display_type = "WIRE"
    obj.show_in_front = True
    obj.hide_render = True
    shown_objects.ensure(obj)
    return hull_state.follow_edit(obj, scene)


def hull_object(hull, scene, collection):
    """A new hull object from hull_io's HullData, in a collection, without its variants; returns it,
    up to date."""
    scale = units.metres_per_unit(scene)
    name = letters.taken(hull.name)
    obj = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    collection.objects.link(obj)
    give_ship(obj, hull, scale)
    obj.hull.fairness.comb_rows |= bool(hull.shown_rows)
    wanted_data.give_wanted(obj.hull, hull, scale)
    field_data.give_fields(obj, hull, scale)
    plating_data.give_plating(obj, hull.plating, scale)
    curve_data.give_curves(obj, hull.curves)
    make_hull(obj, scene, hull.half)
    if hull.appendages:
        appendage_data.give_appendages(obj, hull.appendages, scale, collection)
        hull_state.follow_edit(obj, scene)
    return obj


def give_ship(obj, hull, scale, known=()):
    """Gives a hull or a variant, whose mesh is empty, what both have of a HullData; scale: metres
    of Blender's unit. known: pairs ((name, colour), material) of another hull's layers in their
    order, whose materials are shared where layers are the same."""
    mesh = obj.data
    sizes = np.array([len(face) for face in hull.faces], dtype=np.int32)
    corners = np.array([index for face in hull.faces for index in face], dtype=np.int32)
    mesh_arrays.write_faces(mesh, np.asarray(hull.points) / scale, sizes, corners)
    mesh_arrays.write_tags(mesh, hull.creases, hull.corners, hull.deck_edge)
    if hull.shown_rows:
        row_marks.store(mesh, hull.shown_rows)
    obj.hull.half = hull.half
    _add_layers(obj, hull, known, scale)
    _copy_particulars(obj.hull, hull, scale)
    loading_data.give_loading(obj.hull, hull, scale)
    if hull.lines is not None:
        line_data.give_lines(obj.hull.lines, hull.lines, scale)
    for flat in hull.flats:
        flats.mark(obj, flat.faces, (*flat.normal, flat.offset / scale))
    for region in hull.developables:
        developables.mark(
            obj, region.faces, region.warp * scale, region.distance / scale, region.keep
        )
    point_locks.write(mesh, hull.locked)
    for axis, name in enumerate(KEPT_IN):
        kept_points.set_axes(mesh, getattr(hull.kept, name), (axis,), True)
    tie_data.give_ties(mesh, hull.ties, scale)
    tie_data.give_groups(obj, hull.groups)
    _fill_particulars(obj)


def _add_layers(obj, hull, known, scale):
    for index, layer in enumerate(hull.layers):
        key, material = known[index] if index < len(known) else (None, None)
        if key != (layer.name, layer.colour):
            material = materials.layer_material(layer.name, layer.colour)
        obj.data.materials.append(material)
        entry = obj.hull.layers.add()
        entry.name = layer.name
        entry.material = material
        entry.in_hydrostatics = layer.in_hydrostatics
        entry.thickness, entry.density = layer.thickness / scale, layer.density
    if hull.layers:
        slots = np.array(hull.face_layers, dtype=np.int32)
        obj.data.polygons.foreach_set("material_index", slots)


def _copy_particulars(settings, hull, scale):
    for name in _PARTICULARS:
        value = getattr(hull.particulars, name)
        if value:
            setattr(settings, name, value / scale)
    if hull.particulars.water_density:
        settings.water_density = hull.particulars.water_density
    settings.source = hull.source
    settings.scheme = hull.scheme


def _fill_particulars(obj):
    """Particulars not given are the extent of the mesh; draft and KG are guesses, six tenths of the
    depth."""
    settings = obj.hull
    points = mesh_arrays.read_mesh(obj.data).points
    if not len(points):
        return
    low, high = points.min(axis=0), points.max(axis=0)
    extent = {
        "length_pp": high[0] - low[0],
        "beam": 2.0 * max(abs(low[1]), abs(high[1])),
        "depth": max(high[2], 0.0),
        "draft": 0.6 * max(high[2], 0.0),
    }
    for name, value in extent.items():
        if getattr(settings, name) <= 0.0:
            setattr(settings, name, value)
    if settings.loading.kg <= 0.0:
        settings.loading.kg = 0.6 * settings.depth
        settings.loading.kg_is_guess = True  # as long as nobody sets it


def _fill_choices(settings):
    """What nobody gave is as the add-on's preferences have it."""
    lines = settings.lines
    for group, name, preference in (
        (settings, "samples", "samples"),
        (settings, "water_density", "water_density"),
        (lines, "station_count", "station_count"),
        (lines, "width", "line_width"),
    ):
        if not group.is_property_set(name):
            setattr(group, name, preferences.value(preference))
    for name, extent, preference in (
        ("waterline_spacing", settings.depth, "waterline_count"),
        ("buttock_spacing", 0.5 * settings.beam, "buttock_count"),
    ):
        if not lines.is_property_set(name):
            parts = preferences.value(preference)
            spacing = line_places.handy_spacing(extent, parts) if parts else 0.0
            setattr(lines, name, spacing)
