# SPDX-License-Identifier: GPL-3.0-or-later
"""Control points around a row that came or went, fitted to the surface of before, and how far that
is from it then."""

import numpy as np

from ...bridge import native
from ...bridge.mesh.face_sides import ends_of_sides
from ..constraints import move_limits

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


def refitted(obj, old, surface, control, rows, longest):
    """(indices (k,) of control points around the rows (r,), their points (k, 3) by which the
    surface is nearest to the old one), m. What may not move stays: locked points, flats, points in
    their planes. control: mesh_arrays.ControlArrays of the surface; longest: of the row's edges."""
    hull_native = native.require()
    limits = move_limits.of_hull(obj, control.vertex_ids, control.points)
    free = _around(control, rows)
    free[limits.locked] = False
    points = old.tessellate(_SAMPLES).points
    low, high = control.points[rows].min(axis=0), control.points[rows].max(axis=0)
    reach = _NEAR * longest
    points = points[((points > low - reach) & (points < high + reach)).all(axis=1)]
    curves = []
    for curve in hull_native.crease_curves(old):
        t = np.linspace(0.0, curve.edge_count, _CURVE_SAMPLES * curve.edge_count + 1)
        curves.append((curve.evaluate(t)[0], None, False))
    found = hull_native.fit_surface(
        surface,
        points,
        curves=curves,
        fairness=0.0,
        stiffness=_STIFFNESS,
        reach=reach,
        most_steps=_MOST_STEPS,
        **limits.with_locked(np.flatnonzero(~free)).reshape_arguments(surface),
    )
    return np.flatnonzero(free), found.points[free]


def change(old, surface):
    """The largest distance of a surface from the old one, m, at points all over it."""
    points = surface.tessellate(_COMPARED).points
    return float(native.require().SurfaceTree(old).closest_points(points).distances.max())


def select(bm, vertices):
    """Selects exactly these points, with the edges and faces between them."""
    for part in (*bm.faces, *bm.edges, *bm.verts):
        part.select_set(False)
    for vertex in vertices:
        vertex.select_set(True)
    bm.select_flush(True)


def _around(control, rows):
    """(n,) which control points are within _RINGS edges of the rows."""
    edges = ends_of_sides(control.face_sizes, control.face_vertices)
    near = np.zeros(len(control.points), dtype=bool)
    near[rows] = True
    for _ in range(_RINGS):
        near[edges[near[edges].any(axis=1)]] = True
    return near
