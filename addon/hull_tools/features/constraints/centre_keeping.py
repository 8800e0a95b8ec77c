# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeping the border of a half hull on the centre plane while its points are moved, as clipping
does with Blender's Mirror modifier: both halves stay joined, whichever way a point is dragged."""

import dataclasses

import numpy as np

from ...bridge.mesh import mesh_check, mesh_points
from . import flats


def kept(obj, data, control, mesh):
    """The MeshData of a hull in edit mode with the points that left the centre plane back on it, in
    Blender's mesh too.

    control: the ControlArrays of the same mesh as it was seen last; mesh: the
    hull_native.ControlMesh of these. Only points of the border that were on it are kept. Not so
    points without a face that has an area, which were just extruded, and points of flats that would
    leave their plane.
    """
    was_on = mesh_check.on_centre_plane(control.points)
    left = np.flatnonzero(was_on & (data.points[control.vertex_ids, 1] != 0.0))
    if len(left):  # else, as a rule, there is no need to know the border
        left = left[np.isin(left, mesh.border_edges)]
    if not len(left):
        return data
    left = left[_have_area(control, left)]
    indices = np.setdiff1d(control.vertex_ids[left], _of_tilted_flats(obj))
    if not len(indices):
        return data
    points = data.points.copy()
    points[indices, 1] = 0.0
    mesh_points.write(obj.data, indices, points[indices])
    return dataclasses.replace(data, points=points)


def _of_tilted_flats(obj):
    """Points that a move along y would take out of the plane that they are kept in."""
    found = [points for points, plane in flats.flat_planes(obj) if plane[1] != 0.0]
    return np.concatenate(found) if found else np.zeros(0, dtype=np.int64)


def _have_area(control, vertices):
    """(k,) whether a face at the point has an area."""
    ends = np.cumsum(control.face_sizes)
    size = np.ptp(control.points, axis=0).max(initial=0.0)
    found = np.zeros(len(control.points), dtype=bool)
    starts = ends - control.face_sizes
    is_near = np.logical_or.reduceat(np.isin(control.face_vertices, vertices), starts)
    for first, end in zip(starts[is_near], ends[is_near]):
        own = control.face_vertices[first:end]
        spokes = control.points[own] - control.points[own[0]]
        area = np.cross(spokes[1:-1], spokes[2:]).sum(axis=0)
        if np.linalg.norm(area) > 1e-12 * size * size:
            found[own] = True
    return found[vertices]
