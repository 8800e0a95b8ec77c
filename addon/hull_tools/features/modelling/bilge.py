# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections of the control mesh rounded to a circle between flat bottom and flat side.

A section is a row of control points across the ship, from a border of the flat bottom to one of the
flat side; what is selected in edit mode says which. A border is a crease, or the last but one of
the points that lie in the flat: the surface is straight up to there then.
"""

from dataclasses import dataclass
from functools import lru_cache

import bmesh
import numpy as np

from ...bridge import native
from ...bridge.blender import units
from ...bridge.counts import counted_are
from ...bridge.mesh import mesh_points
from ...bridge.objects import hull_mesh
from ..constraints import kept_points, point_locks
from ..hull import hull_state
from . import bilge_corners
from .bilge_sections import beyond, in_plane, sections_of


@dataclass(frozen=True)
class Rounded:
    """A section that was rounded: x and radius in m; count of points between the borders; best: the
    deviation of the control points' own curve; found: that of the surface's section there, None
    where it has none; both in m."""

    x: float
    radius: float
    count: int
    best: float
    found: object


def present_radius(obj, scene):
    """The radius, in Blender's units, that the bilge of the selected section amidships has now,
    about; ValueError as round_selected."""
    scale, control, mesh = _control(obj, scene)
    sections = _selected_sections(obj, control, mesh)
    radius = bilge_corners.present_radius(sections[len(sections) // 2], control.points) / scale
    return max(float(f"{radius:.3g}"), 1e-3)


def round_selected(obj, scene, radius, move_borders):
    """Rounds the selected sections; returns a Rounded for each, from aft forward.

    radius in Blender's units. ValueError where that cannot be: nothing moves then.
    """
    scale, control, mesh = _control(obj, scene)
    sections = _selected_sections(obj, control, mesh)
    places, rounded = {}, []
    for section in sections:
        corner, arc = _fit(section, control.points, scale * radius, move_borders)
        moved = corner.places(arc.points)
        indices = section.row
        if section.bottom.is_moved:
            indices = [section.bottom.outer, *indices]
            moved = np.concatenate([beyond(moved[0], moved[1]), moved])
        if section.side.is_moved:
            indices = [*indices, section.side.outer]
            moved = np.concatenate([moved, beyond(moved[-1], moved[-2])])
        for index, (y, z) in zip(indices, moved):
            places[index] = (control.points[index, 0], y, z)
        rounded.append((section, corner, arc))
    _refuse_held(obj, control, places)
    indices = np.array(list(places))
    points = np.array(list(places.values())) / scale
    mesh_points.write(obj.data, control.vertex_ids[indices], points)
    state = hull_state.follow_edit(obj, scene).checked()
    return [_outcome(state.ship.surface, control, *one) for one in rounded]


def _control(obj, scene):
    """(metres per unit, ControlArrays, hull_native.ControlMesh)."""
    scale = units.metres_per_unit(scene)
    control = hull_mesh.read(obj).control(scale)
    return scale, control, native.require().ControlMesh(*control.arguments())


def _selected_sections(obj, control, mesh):
    bm = bmesh.from_edit_mesh(obj.data)
    chosen = np.array([vertex.select and not vertex.hide for vertex in bm.verts], dtype=bool)
    return sections_of(control.points, mesh, np.flatnonzero(chosen[control.vertex_ids]))


def _fit(section, points, radius, move_borders):
    """(Corner, hull_native.BilgeArc) of a section."""
    if not radius > 0.0:
        raise ValueError("Give a radius above zero")
    corner = bilge_corners.corner_of(section, points, radius)
    outer = [None, None]
    for k, end in enumerate((section.bottom, section.side)):
        if not end.is_crease and not end.is_moved:
            outer[k] = corner.outer_distance(k, points[end.outer])
    moves = move_borders or section.bottom.is_moved or section.side.is_moved
    arc = _arc(len(section.row) - 2, corner.angle, moves, *outer)
    corner.refuse_beyond_flats(section, points, arc.points)
    return corner, arc


# Equal sections have equal arcs, and the redo panel asks for the same again.
@lru_cache(maxsize=64)
def _arc(count, angle, moves, outer_bottom, outer_side):
    return native.require().bilge_arc(
        count, angle, move_borders=moves, outer_bottom=outer_bottom, outer_side=outer_side
    )


def _refuse_held(obj, control, places):
    locked = np.intersect1d(control.vertex_ids[list(places)], point_locks.locked_points(obj.data))
    if len(locked):
        raise ValueError(f"{len(locked)} points of the bilge are locked: unlock them first")
    kept = kept_points.read(obj.data)
    across = np.union1d(kept.along(1), kept.along(2))
    held = np.intersect1d(control.vertex_ids[list(places)], across)
    if len(held):
        raise ValueError(
            f"In the bilge {counted_are(len(held), 'point')} kept in a buttock or waterline: free "
            "them first"
        )


def _outcome(surface, control, section, corner, arc):
    x = float(np.median(control.points[section.row, 0]))
    hull_native = native.require()
    (curves,) = hull_native.sections(
        surface, [hull_native.plane_across("x", x)], 1e-5 * corner.radius
    )
    found = [corner.deviation(in_plane(curve.points)) for curve in curves]
    found = [value for value in found if value is not None]
    return Rounded(
        x,
        corner.radius,
        len(section.row) - 2,
        arc.deviation * corner.radius,
        max(found, default=None),
    )
