# SPDX-License-Identifier: GPL-3.0-or-later
"""The faces of a Blender mesh that are kept flat: each has the number of its region, 0 for none."""

from dataclasses import dataclass

import bmesh
import numpy as np

from ...bridge.mesh import face_numbers

ATTRIBUTE = "hull_flat"


@dataclass(frozen=True, eq=False)
class FlatFaces:
    """Those that have a number; indices are Blender's.

    faces (k,); regions (k,) their numbers; sizes (k,) and vertices (sum of sizes,) their points;
    vertex_count: of the whole mesh.
    """

    faces: np.ndarray
    regions: np.ndarray
    sizes: np.ndarray
    vertices: np.ndarray
    vertex_count: int

    def key(self):
        """Equal, but for a chance of 2**-64, for the same faces with the same numbers."""
        arrays = (self.faces, self.regions, self.sizes, self.vertices)
        return hash((self.vertex_count, *(array.tobytes() for array in arrays)))

    def of_region(self, region):
        """(faces (m,), their points (p,) each once)."""
        own = self.regions == region
        return self.faces[own], np.unique(self.vertices[np.repeat(own, self.sizes)])


def read(mesh):
    """FlatFaces of a Blender mesh, in edit mode or not; None without any."""
    return _read_edited(mesh) if mesh.is_editmode else _read_stored(mesh)


def _read_edited(mesh):
    bm = bmesh.from_edit_mesh(mesh)
    layer = bm.faces.layers.int.get(ATTRIBUTE)
    if layer is None:
        return None
    found = [(index, face) for index, face in enumerate(bm.faces) if face[layer]]
    if not found:
        return None
    bm.verts.index_update()
    loops = [[vertex.index for vertex in face.verts] for _, face in found]
    return FlatFaces(
        np.array([index for index, _ in found], dtype=np.int64),
        np.array([face[layer] for _, face in found], dtype=np.int64),
        np.array([len(loop) for loop in loops], dtype=np.int64),
        np.array([index for loop in loops for index in loop], dtype=np.int64),
        len(bm.verts),
    )


def _read_stored(mesh):
    numbers = face_numbers.stored(mesh, ATTRIBUTE)
    faces = np.flatnonzero(numbers)
    if not len(faces):
        return None
    sizes = np.empty(len(mesh.polygons), dtype=np.int32)
    mesh.polygons.foreach_get("loop_total", sizes)
    vertices = np.empty(len(mesh.loops), dtype=np.int32)
    mesh.loops.foreach_get("vertex_index", vertices)
    return FlatFaces(
        faces.astype(np.int64),
        numbers[faces].astype(np.int64),
        sizes[faces].astype(np.int64),
        vertices[np.repeat(numbers != 0, sizes)].astype(np.int64),
        len(mesh.vertices),
    )


def write(mesh, faces, regions):
    """Gives numbers (k,) to faces (k,) of a Blender mesh, in edit mode or not; one number may be
    given for all. In edit mode every BMFace that the caller holds may become invalid."""
    face_numbers.write(mesh, ATTRIBUTE, faces, regions)
