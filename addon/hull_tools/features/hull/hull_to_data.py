# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull object as hull_io's HullData: what a hull file keeps of it."""

import numpy as np
from mathutils import Color

from ....hull_io.hull_data import KEPT_IN, Developable, Flat, HullData, Kept, Layer, Particulars
from ...bridge.blender import units
from ...bridge.mesh import mesh_arrays, row_marks
from ...bridge.objects import hull_objects
from ..constraints import developables, flats, kept_points, point_locks
from ..flotation import loading_data
from ..lines import line_data
from . import appendage_data, curve_data, field_data, plating_data, tie_data, wanted_data


def hull_data(obj, scene):
    """The HullData of a hull without its variants, in metres; ValueError when it is refused.

    Numbers have the digits that Blender keeps of them, so that reading brings the same hull.
    """
    reason = hull_objects.refusal(obj)
    if reason:
        raise ValueError(reason)
    scale = units.metres_per_unit(scene)
    made = ship_data(obj, scale)
    for name, value in wanted_data.take_wanted(obj.hull, scale).items():
        setattr(made, name, value)
    made.fields = field_data.take_fields(obj, scale)
    made.appendages = appendage_data.take_appendages(obj, scale)
    made.plating = plating_data.take_plating(obj, scale)
    made.curves = curve_data.take_curves(obj, made.faces)
    return made


def ship_data(obj, scale):
    """The same of what a hull has in common with its variants, of either; scale: metres of
    Blender's unit."""
    settings = obj.hull
    data = mesh_arrays.read_mesh(obj.data)
    ends = np.cumsum(data.face_sizes)
    faces = [
        data.face_vertices[end - size : end].tolist() for size, end in zip(data.face_sizes, ends)
    ]
    keys = mesh_arrays.face_edge_keys(data.face_sizes, data.face_vertices)

    def pairs(edges):
        own = mesh_arrays.with_keys(edges, keys)
        return sorted(map(tuple, np.sort(own, axis=1).tolist()))

    layers = _layers(obj, scale)
    return HullData(
        name=obj.name,
        points=units.all_as_stored(data.points) * scale,
        faces=faces,
        creases=pairs(data.tagged_edges[data.edge_creases >= 1.0]),
        corners=np.flatnonzero(data.vertex_creases >= 1.0).tolist(),
        half=settings.half,
        layers=layers,
        face_layers=np.clip(data.face_slots, 0, len(layers) - 1).tolist(),
        particulars=_particulars(settings, scale),
        scheme=settings.scheme,
        deck_edge=pairs(data.deck_edge()),
        shown_rows=pairs(row_marks.marked(obj.data)),
        flats=_flats(obj, scale),
        developables=_developables(obj, scale),
        locked=point_locks.locked_points(obj.data).tolist(),
        kept=_kept(obj.data),
        ties=tie_data.take_ties(obj.data, scale),
        groups=tie_data.take_groups(obj),
        source=settings.source,
        lines=line_data.take_lines(settings.lines, scale),
        **loading_data.take_loading(settings, scale),
    )


def _flats(obj, scale):
    return [
        Flat(
            region.faces.tolist(),
            tuple(units.as_stored(part) for part in region.plane[:3]),
            units.as_stored(region.plane[3]) * scale,
        )
        for region in flats.regions(obj)
    ]


def _developables(obj, scale):
    return [
        Developable(
            region.faces.tolist(),
            units.as_stored(region.warp) / scale,
            units.as_stored(region.distance) * scale,
            region.kept,
        )
        for region in developables.regions(obj)
    ]


def _kept(mesh):
    found = kept_points.read(mesh)
    return Kept(**{name: found.along(axis).tolist() for axis, name in enumerate(KEPT_IN)})


def _layers(obj, scale):
    excluded = hull_objects.excluded_slots(obj)
    found = [
        _layer(slot.material, name, index not in excluded)
        for index, (slot, name) in enumerate(zip(obj.material_slots, hull_objects.slot_names(obj)))
    ] or [Layer()]
    plating = {entry.material: entry for entry in obj.hull.layers}
    for layer, slot in zip(found, obj.material_slots):
        if slot.material in plating:
            entry = plating[slot.material]
            layer.thickness = units.as_stored(entry.thickness) * scale
            layer.density = units.as_stored(entry.density)
    return found


def _layer(material, name, in_hydrostatics):
    if material is None:
        return Layer(name, in_hydrostatics)
    colour = Color(material.diffuse_color[:3]).from_scene_linear_to_srgb()
    parts = tuple(round(min(max(part, 0.0), 1.0), 4) for part in colour)
    return Layer(name, in_hydrostatics, parts)


def _particulars(settings, scale):
    lengths = {
        name: units.as_stored(getattr(settings, name)) * scale
        for name in ("length_pp", "beam", "draft", "depth")
    }
    return Particulars(**lengths, water_density=units.as_stored(settings.water_density))
