# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls with tied points, and whether these are where they belong, by formulas of its own."""

import bpy
import numpy as np
from addon_under_test import part, state_of

SINGLE = 3e-7  # of the size: what Blender's single precision leaves


def ties():
    return part("features.constraints.ties")


def tie(hull, kind, points, *leaders, share=0.02):
    kinds = part("bridge.mesh.point_ties").KINDS
    to = [(leaders[0], leaders[-1])] * len(points)
    ties().tie_points(hull, kinds.index(kind), np.array(points), np.array(to), share)
    part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)


def miss_of(kind, point, to, numbers, points):
    """How far a tie is from holding at points (n, 3)."""
    at, first, last = points[point], points[to[0]], points[to[-1]]
    x, y, z = numbers
    if kind == "LINE":
        way = (last - first) / np.linalg.norm(last - first)
        return np.linalg.norm(np.cross(at - first, way))
    if kind == "ANCHOR":
        return np.linalg.norm(at - first - numbers)
    if kind == "LEVEL":
        return abs(at[2] - first[2] - z)
    if kind == "MIRROR":
        return np.linalg.norm(at - (first[0] + x, y - first[1], first[2] + z))
    return abs(first[2] - at[2] - x * 2.0 * abs(at[1]))


def misses(hull):
    """{kind: the largest miss of the control points that the surface is of, as parts of the
    hull's length}."""
    control = state_of(hull).ship.source.control
    points = np.zeros((control.vertex_ids.max() + 1, 3))
    points[control.vertex_ids] = control.points
    size, found = np.ptp(control.points[:, 0]), {}
    for kind, point, to, numbers in ties().stored_ties(hull.data):
        miss = miss_of(kind, point, to, np.array(numbers), points) / size
        found[kind] = max(found.get(kind, 0.0), miss)
    return found


def stored_misses(hull):
    """The same of the points that Blender keeps."""
    points = part("bridge.mesh.mesh_points").read(hull.data)
    size = np.ptp(points[:, 0])
    return [
        miss_of(kind, point, to, np.array(numbers), points) / size
        for kind, point, to, numbers in ties().stored_ties(hull.data)
    ]
