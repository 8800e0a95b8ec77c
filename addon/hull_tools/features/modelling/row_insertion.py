# SPDX-License-Identifier: GPL-3.0-or-later
"""A row of control points inserted, and the control points around fitted to the surface of before.

Uniform B-splines have no knot insertion in one place: a row that is cut into the mesh halves the
knot spans there, and draws the surface to another shape. What the same points can do when they are
placed anew is nearly the old surface.
"""

from dataclasses import dataclass

import bmesh
import numpy as np

from ...bridge import native
from ...bridge.blender import blender_versions, units
from ...bridge.mesh import mesh_points
from ...bridge.objects import hull_mesh
from ..constraints import held_points, point_locks
from ..hull import hull_state
from ..lines import lines

# Points so many edges away from the row are placed anew.
_RINGS = 2
# Of the fit: what keeps points from sliding along the surface, where its shape does not tell.
_STIFFNESS = 1e-5
_MOST_STEPS = 20
# Points of the old surface that count: as near as so many of the row's edges; samples of a cell and
# of a crease's edge.
_NEAR = 3.0
_SAMPLES = 4
_CURVE_SAMPLES = 8
# So many squares along the side of a cell it is looked at how far the surface moved.
_COMPARED = 6


@dataclass(frozen=True)
class Inserted:
    """How many points the rows have; how far the surface is from that of before, m, at most: as
    cut, and as fitted."""

    count: int
    cut_change: float
    change: float


def insert_rows(obj, scene):
    """Inserts a row across each ring of edges that has a selected one, in edit mode; returns what
    came of it. Locked points stay, flats stay flat.

    ValueError when no edge is selected, the mesh has errors, or no ring leads through quads.
    """
    state = hull_state.up_to_date(obj, scene)
    old = native.require().LimitSurface(state.ship.surface.mesh, state.ship.surface.scheme)
    bm = bmesh.from_edit_mesh(obj.data)
    new, longest = _cut_rings(bm)
    bm.normal_update()
    bmesh.update_edit_mesh(obj.data)
    scale = units.metres_per_unit(scene)
    control = hull_mesh.read(obj).control(scale)
    surface = native.require().LimitSurface(
        native.require().ControlMesh(*control.arguments()), old.scheme
    )
    before = _change(old, surface)
    rows = np.flatnonzero(np.isin(control.vertex_ids, new))
    free = _around(control, rows) & ~np.isin(
        control.vertex_ids, point_locks.locked_points(obj.data)
    )
    points = _fitted(obj, old, surface, control, rows, free, longest * scale)
    mesh_points.write(obj.data, control.vertex_ids[free], points[free] / scale)
    state = hull_state.follow_edit(obj, scene).checked()
    return Inserted(len(new), before, _change(old, state.ship.surface))


def _cut_rings(bm):
    """(indices of the new points, the longest of the edges cut in Blender's units)."""
    chosen = [edge for edge in bm.edges if edge.select and not edge.hide]
    if not chosen:
        raise ValueError("Select an edge that the row is to run across")
    done, new, longest = set(), [], 0.0
    for edge in chosen:
        # One ring after the other: the first may cut edges of the next.
        ring = [] if edge in done else _ring(edge)
        if len(ring) > 1:
            longest = max(longest, *(each.calc_length() for each in ring))
            done |= set(ring)
            new += _cut(bm, ring)
    if not new:
        raise ValueError("Beside the selected edges there are no faces with four sides to cut")
    bm.verts.index_update()
    _select(bm, new)
    return np.array([vertex.index for vertex in new]), longest


def _select(bm, vertices):
    for vertex in bm.verts:
        vertex.select_set(False)
    for vertex in vertices:
        vertex.select_set(True)
    bm.select_flush(True)


def _ring(edge):
    """The edges that lie across quads from one another, an edge among them."""
    ring, waiting, seen = [], [edge], {edge}
    while waiting:
        ring.append(waiting.pop())
        for face in ring[-1].link_faces:
            other = _opposite(face, ring[-1])
            if other is not None and other not in seen:
                seen.add(other)
                waiting.append(other)
    return ring


def _opposite(face, edge):
    """The edge across from one of a quad; None of other faces."""
    if len(face.verts) != 4:
        return None
    (other,) = (each for each in face.edges if not set(each.verts) & set(edge.verts))
    return other


def _cut(bm, ring):
    """Halves the edges of a ring and joins the halves' points across faces; returns the points."""
    quads = {face for edge in ring for face in edge.link_faces if len(face.verts) == 4}
    _, corner_layer = blender_versions.find_crease_layers(bm)
    lock_layer = bm.verts.layers.int.get(point_locks.ATTRIBUTE)
    new = []
    for edge in ring:
        _, vertex = bmesh.utils.edge_split(edge, edge.verts[0], 0.5)
        # Between a corner and another point Blender puts half a corner.
        if corner_layer is not None:
            vertex[corner_layer] = 0.0
        if lock_layer is not None:
            vertex[lock_layer] = 0
        new.append(vertex)
    fresh = set(new)
    for face in quads:
        ends = [vertex for vertex in face.verts if vertex in fresh]
        if len(ends) == 2:
            bmesh.utils.face_split(face, *ends)
    return new


def _around(control, rows):
    """(n,) which control points are within _RINGS edges of the rows."""
    following = np.roll(control.face_vertices, -1)
    ends = np.cumsum(control.face_sizes)
    following[ends - 1] = control.face_vertices[ends - control.face_sizes]
    edges = np.stack([control.face_vertices, following], axis=1)
    near = np.zeros(len(control.points), dtype=bool)
    near[rows] = True
    for _ in range(_RINGS):
        near[edges[near[edges].any(axis=1)]] = True
    return near


def _fitted(obj, old, surface, control, rows, free, longest):
    """(n, 3) the control points with the free ones fitted to the old surface."""
    hull_native = native.require()
    size = lines.size_of(old)
    points = old.tessellate(_SAMPLES).points
    low, high = control.points[rows].min(axis=0), control.points[rows].max(axis=0)
    reach = _NEAR * longest
    points = points[((points > low - reach) & (points < high + reach)).all(axis=1)]
    curves = []
    for curve in hull_native.crease_curves(old):
        t = np.linspace(0.0, curve.edge_count, _CURVE_SAMPLES * curve.edge_count + 1)
        curves.append((curve.evaluate(t)[0], None, False))
    held, normals = held_points.held_points(obj, control.vertex_ids, control.points, size)
    return hull_native.fit_surface(
        surface,
        points,
        curves=curves,
        locked=np.flatnonzero(~free),
        held_points=held,
        held_normals=normals,
        fairness=0.0,
        stiffness=_STIFFNESS,
        reach=reach,
        most_steps=_MOST_STEPS,
    ).points


def _change(old, surface):
    """The largest distance of a surface from the old one, m, at points all over it."""
    points = surface.tessellate(_COMPARED).points
    return float(native.require().SurfaceTree(old).closest_points(points).distances.max())
