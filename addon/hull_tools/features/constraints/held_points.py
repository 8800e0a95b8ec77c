# SPDX-License-Identifier: GPL-3.0-or-later
"""Which control points stay in planes while the surface is pulled or fitted: those of flats that
are kept flat, those kept in stations, waterlines and buttocks, and those on the centre plane of a
half hull."""

import numpy as np

from ...bridge import native
from ...bridge.mesh.mesh_check import on_centre_plane
from . import flats, kept_points, planes


def held_points(obj, vertex_ids, points):
    """(control points (h,), normals (h, 3)) of a hull whose control points (n, 3), in m, have these
    indices in its mesh."""
    found = [(np.array(part), plane[:3]) for part, plane in flats.flat_planes(obj)]
    pairs = [(np.flatnonzero(np.isin(vertex_ids, part)), normal) for part, normal in found]
    kept = kept_points.read(obj.data)
    for axis, normal in enumerate(np.eye(3)):
        pairs.append((np.flatnonzero(np.isin(vertex_ids, kept.along(axis))), normal))
    if obj.hull.half:
        pairs.append((np.flatnonzero(on_centre_plane(points)), (0.0, 1.0, 0.0)))
    held = [np.empty(0, dtype=np.int64)] + [part for part, _ in pairs]
    normals = [np.empty((0, 3))] + [np.tile(normal, (len(part), 1)) for part, normal in pairs]
    return np.concatenate(held), np.concatenate(normals)


# Of the hull's beam: points that are as far out as any.
_AS_FAR_OUT = 1e-3


def of_outline(surface, points, profile, deck, side):
    """(control points (h,), normals (h, 3)) of what keeps a hull's outlines, where these are asked
    for: profile, points on the centre plane stay; deck, those of the borders beside it; side, those
    as far out as any keep their breadth; solver() sees to what is beside them. surface:
    hull_native.LimitSurface of points (n, 3)."""
    stays = np.zeros(len(points), dtype=bool)
    at_centre = on_centre_plane(points)
    border = np.zeros(len(points), dtype=bool)
    border[np.unique(np.asarray(surface.mesh.border_edges))] = True
    if profile:
        stays |= at_centre
    if deck:
        stays |= border & ~at_centre
    held, normals = all_ways(np.flatnonzero(stays))
    if side:
        far = np.abs(points[:, 1])
        widest = np.flatnonzero(far >= (1.0 - _AS_FAR_OUT) * far.max())
        held = np.concatenate([held, widest])
        normals = np.concatenate([normals, np.tile((0.0, 1.0, 0.0), (len(widest), 1))])
    return held, normals


def solver(keeps_side):
    """hull_native.reach_targets, or where the greatest breadth is kept what lets the surface become
    no wider either; returns (TargetsReached, whether that binds)."""
    hull_native = native.require()
    if keeps_side:
        return hull_native.reach_within_breadth

    def solve(surface, targets, **options):
        return hull_native.reach_targets(surface, targets, **options), False

    return solve


def all_ways(points):
    """(control points (3 k,), normals (3 k, 3)) that hold points (k,) along all axes."""
    return np.tile(points, 3), np.repeat(np.eye(3), len(points), axis=0)


def in_plane(part, points):
    """(control points (k,), normals (k, 3)) that hold a part (k,) of control points (n, 3), which
    lie in a plane, in it: by the normal of the plane that fits them best."""
    normal = planes.fit(points[part], "BEST")[:3]
    return np.asarray(part), np.tile(normal, (len(part), 1))
