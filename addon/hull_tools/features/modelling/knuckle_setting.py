# SPDX-License-Identifier: GPL-3.0-or-later
"""The angle of knuckles set to a value: control points beside them move, the knuckles stay."""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.blender import units
from ...bridge.mesh import mesh_points, selection
from ..constraints import move_limits
from ..hull import hull_state, tags

# How near to the angle asked for is near enough, rad.
TOLERANCE = np.radians(0.1)


@dataclass(frozen=True)
class Outcome:
    """What came of it: how many control points moved, the longest move in m, and the largest
    deviation of the exact surface from the angle, rad; whether that is within TOLERANCE."""

    count: int
    longest: float
    deviation: float
    met: bool


def present_angle(obj, scene):
    """The mean angle, rad, along the selected knuckles; ValueError as set_selected."""
    state = hull_state.up_to_date(obj, scene)
    hull_native = native.require()
    found = [
        hull_native.knuckle_angles(state.ship.surface, number, edges=edges)
        for number, edges in _selected_knuckles(obj, state)
    ]
    lengths = [one.length for one in found]
    return float(np.average([one.mean for one in found], weights=lengths))


def set_selected(obj, scene, angle):
    """Gives the selected edges of knuckles an angle, rad; returns the Outcome. In edit mode.

    Locked points stay, flats stay flat, and so do points of other creases and borders. ValueError
    where that cannot be: nothing moves then.
    """
    state = hull_state.up_to_date(obj, scene)
    surface, ids = state.ship.surface, state.ship.source.control.vertex_ids
    chosen = _selected_knuckles(obj, state)
    limits = move_limits.of_hull(obj, ids, surface.mesh.points)
    limits = limits.with_locked(np.flatnonzero(surface.mesh.vertex_kinds > 0))
    hull_native = native.require()
    before = surface.mesh.points
    points, found = before.copy(), []
    for number, edges in chosen:
        trial = hull_native.LimitSurface(surface.mesh.with_points(points), surface.scheme)
        one = hull_native.set_knuckle_angle(
            trial,
            number,
            angle,
            edges=edges,
            tolerance=TOLERANCE,
            **limits.reshape_arguments(surface),
        )
        points[one.points] += one.moves
        found.append(one)
    moved = np.flatnonzero((points != before).any(axis=1))
    mesh_points.write(obj.data, ids[moved], points[moved] / units.metres_per_unit(scene))
    hull_state.follow_edit(obj, scene)
    longest = np.linalg.norm(points - before, axis=1).max(initial=0.0)
    deviation = max(one.deviation for one in found)
    return Outcome(len(moved), float(longest), deviation, all(one.met for one in found))


def _selected_knuckles(obj, state):
    """[(number of a crease curve, its selected edges)]; ValueError without any."""
    ids = state.ship.source.control.vertex_ids.tolist()
    selected = {tags.edge_key(*edge) for edge in selection.selected(obj, "edge")}
    found = []
    for number, curve in enumerate(native.require().crease_curves(state.ship.surface)):
        if curve.kind != "crease":
            continue
        points = [ids[point] for point in curve.vertices.tolist()]
        following = points[1:] + (points[:1] if curve.closed else [])
        pairs = zip(points, following)
        edges = [i for i, (a, b) in enumerate(pairs) if tags.edge_key(a, b) in selected]
        if edges:
            found.append((number, edges))
    if not found:
        raise ValueError("Select edges of a knuckle first: creases with a surface on both sides")
    return found
