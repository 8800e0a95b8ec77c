# SPDX-License-Identifier: GPL-3.0-or-later
"""Turning a hull's faces so that their normals point into the water."""

import bmesh
import numpy as np

from ....hull_io import orientation
from ...bridge.mesh import mesh_arrays
from ...bridge.mesh.mesh_editing import editing
from ...bridge.objects import hull_objects


def turn_outwards(obj):
    """Turns the faces of each connected part the same way, outwards, as orientation tells; returns
    how many were turned. Faces that do not belong to the shell are parts of their own."""
    data = mesh_arrays.read_mesh(obj.data)
    loops = np.split(data.face_vertices, np.cumsum(data.face_sizes)[:-1])
    faces = [loop.tolist() for loop in loops if len(loop)]
    excluded = hull_objects.excluded_slots(obj)
    is_outside = np.isin(data.face_slots, np.array(sorted(excluded), dtype=np.int32))
    turned = []
    for part in (np.flatnonzero(~is_outside), np.flatnonzero(is_outside)):
        before = [faces[index] for index in part]
        after, _ = orientation.turn_outwards(data.points.astype(np.float64), before, obj.hull.half)
        turned += [index for index, a, b in zip(part.tolist(), before, after) if a != b]
    if turned:
        with editing(obj.data) as bm:
            bm.faces.ensure_lookup_table()
            bmesh.ops.reverse_faces(bm, faces=[bm.faces[index] for index in turned])
    return len(turned)
