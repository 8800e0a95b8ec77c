# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell of a hull, the faces whose layer counts in hydrostatics, as arrays."""

from dataclasses import dataclass

import numpy as np

from .hull_data import edge_key, face_edges
from .real_points import real_points


@dataclass
class ShellArrays:
    """The shell as the arrays that `hull_native.ControlMesh` takes.

    points float64 (n, 3); face_sizes int32 (f,); face_vertices int32 (sum of sizes,); creases
    int32 (m, 2); corners int32 (k,). point_indices (n,) and face_indices (f,) lead back to the
    HullData's points and faces.
    """

    points: np.ndarray
    face_sizes: np.ndarray
    face_vertices: np.ndarray
    creases: np.ndarray
    corners: np.ndarray
    point_indices: np.ndarray
    face_indices: np.ndarray

    def arguments(self):
        """The arguments of `hull_native.ControlMesh`."""
        return self.points, self.face_sizes, self.face_vertices, self.creases, self.corners


def shell_face_indices(data):
    """Indices of the faces whose layer counts in hydrostatics, in order."""
    return [
        index for index, layer in enumerate(data.face_layers) if data.layers[layer].in_hydrostatics
    ]


def shell_arrays(data):
    """The shell's faces with the points, creases and corners that belong to them.

    Points that no shell face uses are left out and the others keep their order; so are creases
    that are no edge of a shell face and corners that are no point of one. ValueError for points
    that are no real numbers.
    """
    face_indices = shell_face_indices(data)
    faces = [data.faces[index] for index in face_indices]
    used = sorted({point for face in faces for point in face})
    new_index = {old: new for new, old in enumerate(used)}
    edges = {edge_key(a, b) for face in faces for a, b in face_edges(face)}
    creases = [(new_index[a], new_index[b]) for a, b in data.creases if edge_key(a, b) in edges]
    corners = [new_index[point] for point in data.corners if point in new_index]
    vertices = [new_index[point] for face in faces for point in face]
    return ShellArrays(
        points=np.ascontiguousarray(real_points(data.points)[used]),
        face_sizes=np.array([len(face) for face in faces], dtype=np.int32),
        face_vertices=np.array(vertices, dtype=np.int32),
        creases=np.array(creases, dtype=np.int32).reshape(-1, 2),
        corners=np.array(corners, dtype=np.int32),
        point_indices=np.array(used, dtype=np.int32),
        face_indices=np.array(face_indices, dtype=np.int32),
    )
