# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a mesh with errors makes a surface, to be looked at until it is mended."""

from dataclasses import replace

import numpy as np

from ....hull_io import splitting
from .. import native


def valid_part(control):
    """(ControlArrays, hull_native.ControlMesh) of the faces of ControlArrays that are some, split
    where they join without making one surface; (None, None) where that is none yet.

    Points that are split are in vertex_ids several times.
    """
    faces = faces_of(control.face_sizes, control.face_vertices)
    kept = [index for index, face in enumerate(faces) if len(set(face)) == len(face) >= 3]
    made = splitting.split(
        control.points, [faces[i] for i in kept], [0] * len(kept), range(len(kept))
    )
    if not kept:
        return None, None
    part = replace(
        control,
        points=control.points[made.origins],
        face_sizes=np.array([len(face) for face in made.faces], dtype=np.int32),
        face_vertices=np.concatenate(made.faces).astype(np.int32),
        creases=_pairs(made.carried_edges(control.creases.tolist())),
        corners=np.array(made.carried_points(control.corners.tolist()), dtype=np.int32),
        vertex_ids=control.vertex_ids[made.origins],
        face_ids=control.face_ids[kept],
        deck_edge=_pairs(made.carried_edges(control.deck_edge.tolist())),
    )
    hull_native = native.require()
    if any(found.severity == "error" for found in hull_native.check_mesh(*part.arguments())):
        return None, None
    return part, hull_native.ControlMesh(*part.arguments())


def faces_of(sizes, vertices):
    """Lists of indices of faces that are given one after the other."""
    ends = np.cumsum(sizes)
    listed = vertices.tolist()
    return [listed[end - size : end] for size, end in zip(sizes.tolist(), ends.tolist())]


def _pairs(edges):
    return np.array(edges, dtype=np.int32).reshape(-1, 2)
