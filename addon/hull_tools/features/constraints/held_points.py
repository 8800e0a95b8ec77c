# SPDX-License-Identifier: GPL-3.0-or-later
"""Which control points stay in planes while the surface is pulled or fitted: those of flats that
are kept flat, those kept in stations, waterlines and buttocks, and those on the centre plane of a
half hull."""

import numpy as np

from ...bridge import native
from . import flats, kept_points


def held_points(obj, vertex_ids, points, size):
    """(control points (h,), normals (h, 3)) of a hull whose control points (n, 3), in m, have these
    indices in its mesh; size: of the surface, m."""
    found = [(np.array(part), plane[:3]) for part, plane in flats.flat_planes(obj)]
    pairs = [(np.flatnonzero(np.isin(vertex_ids, part)), normal) for part, normal in found]
    kept = kept_points.read(obj.data)
    for axis, normal in enumerate(np.eye(3)):
        pairs.append((np.flatnonzero(np.isin(vertex_ids, kept.along(axis))), normal))
    if obj.hull.half:
        pairs.append((np.flatnonzero(on_centre(points, size)), (0.0, 1.0, 0.0)))
    held = [np.empty(0, dtype=np.int64)] + [part for part, _ in pairs]
    normals = [np.empty((0, 3))] + [np.tile(normal, (len(part), 1)) for part, normal in pairs]
    return np.concatenate(held), np.concatenate(normals)


def on_centre(points, size):
    """(n,) which points are on the centre plane."""
    return np.abs(points[:, 1]) <= native.require().tolerances.ON_CENTRE_PLANE * size
