# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender meshes as arrays, and arrays as Blender meshes.

Reading takes the mesh as it is now: from the edit mesh while the object is in edit mode. Creases
are edges with crease value 1, corners are vertices with crease value 1; anything between 0 and 1
is no tag of a hull and is told apart so that it can be reported.
"""

import hashlib
from dataclasses import dataclass, replace
from itertools import chain, compress

import bmesh
import numpy as np

from ..blender import blender_versions
from . import deck_edge_marks, point_ties
from .face_sides import ends_of_sides


@dataclass(frozen=True)
class MeshData:
    """A whole Blender mesh; indices are Blender's.

    points (n, 3) float32 in Blender's units; vertex_creases (n,); face_sizes (f,); face_vertices
    (sum of face_sizes,); face_slots (f,) material slots. tagged_edges (e, 2): those with a crease
    or a mark; edge_creases (e,) of them, deck_edges (e,) whether one is marked as deck edge. ties:
    point_ties.PointTies, None without any.
    """

    points: np.ndarray
    tagged_edges: np.ndarray
    edge_creases: np.ndarray
    vertex_creases: np.ndarray
    face_sizes: np.ndarray
    face_vertices: np.ndarray
    face_slots: np.ndarray
    deck_edges: np.ndarray
    ties: object = None

    def exact_points(self):
        """(n, 3) double: the points, those that are tied where others say, of which Blender keeps
        single precision."""
        points = self.points.astype(np.float64)
        if self.ties is None:
            return points
        return self.ties.exact(points, _SINGLE * np.abs(points).max(initial=0.0))

    def topology_digest(self):
        """Equal for meshes that differ by the places of their points, and by marks, only."""
        has_crease = self.edge_creases > 0.0
        return _digest(
            np.array(len(self.points)),
            self.tagged_edges[has_crease],
            self.edge_creases[has_crease],
            self.vertex_creases,
            self.face_sizes,
            self.face_vertices,
            self.face_slots,
        )

    def deck_edge(self):
        """(k, 2) the edges that are marked as deck edge."""
        return self.tagged_edges[self.deck_edges]

    def points_digest(self):
        """Equal for equal points, of which those that are tied are more exact than the mesh's."""
        if self.ties is None:
            return _digest(self.points)
        return _digest(self.points, self.exact_points())


# Of the size: how far a point that Blender keeps may be from where it is tied.
_SINGLE = 1e-6


def _digest(*arrays):
    state = hashlib.blake2b(digest_size=16)
    for array in arrays:
        state.update(array.size.to_bytes(8, "little"))
        state.update(np.ascontiguousarray(array).data)
    return state.digest()


@dataclass(frozen=True)
class ControlArrays:
    """The shell of a hull as hull_native.ControlMesh takes it, points in metres.

    vertex_ids (n,) and face_ids (f,) are the Blender indices of its points and faces. A vertex
    without a face of the shell is left out, and so are crease and mark of an edge without one.
    deck_edge (k, 2): the points of the edges that are marked as deck edge.
    """

    points: np.ndarray
    face_sizes: np.ndarray
    face_vertices: np.ndarray
    creases: np.ndarray
    corners: np.ndarray
    vertex_ids: np.ndarray
    face_ids: np.ndarray
    deck_edge: np.ndarray

    def arguments(self):
        return self.points, self.face_sizes, self.face_vertices, self.creases, self.corners


def read_mesh(mesh):
    """MeshData of a Blender mesh, in edit mode or not."""
    return _read_edit_mesh(mesh) if mesh.is_editmode else _read_stored_mesh(mesh)


def _read_stored_mesh(mesh):
    points = np.empty((len(mesh.vertices), 3), dtype=np.float32)
    mesh.vertices.foreach_get("co", points.reshape(-1))
    creases, marks = blender_versions.edge_creases(mesh), deck_edge_marks.stored_marks(mesh)
    is_tagged = (creases > 0.0) | marks
    face_sizes = np.empty(len(mesh.polygons), dtype=np.int32)
    mesh.polygons.foreach_get("loop_total", face_sizes)
    face_slots = np.empty(len(mesh.polygons), dtype=np.int32)
    mesh.polygons.foreach_get("material_index", face_slots)
    face_vertices = np.empty(len(mesh.loops), dtype=np.int32)
    mesh.loops.foreach_get("vertex_index", face_vertices)
    return MeshData(
        points,
        _stored_edges(mesh)[is_tagged],
        creases[is_tagged],
        blender_versions.vertex_creases(mesh),
        face_sizes,
        face_vertices,
        face_slots,
        marks[is_tagged],
        point_ties.read(mesh),
    )


def _stored_edges(mesh):
    edges = np.empty((len(mesh.edges), 2), dtype=np.int32)
    mesh.edges.foreach_get("vertices", edges.reshape(-1))
    return edges


def _read_edit_mesh(mesh):
    bm = bmesh.from_edit_mesh(mesh)
    bm.verts.index_update()
    edge_layer, vertex_layer = blender_versions.find_crease_layers(bm)
    # NumPy reads plain numbers much faster than Blender's vectors.
    points = np.fromiter(chain.from_iterable([v.co for v in bm.verts]), np.float32)
    creases, marks = _layer(bm.edges, edge_layer), deck_edge_marks.edited_marks(bm)
    is_tagged = (creases > 0.0) | marks
    tagged = compress(bm.edges, is_tagged.tolist()) if is_tagged.any() else ()
    return MeshData(
        points.reshape(-1, 3),
        np.array([[v.index for v in edge.verts] for edge in tagged], np.int32).reshape(-1, 2),
        creases[is_tagged],
        _layer(bm.verts, vertex_layer),
        np.fromiter([len(face.verts) for face in bm.faces], np.int32),
        np.fromiter([v.index for face in bm.faces for v in face.verts], np.int32),
        np.fromiter([face.material_index for face in bm.faces], np.int32),
        marks[is_tagged],
        point_ties.read(mesh),
    )


def _layer(elements, layer):
    """(n,) float32 of vertices or edges of a BMesh; layer None: all 0."""
    if layer is None:
        return np.zeros(len(elements), dtype=np.float32)
    return np.fromiter([one[layer] for one in elements], np.float32)


def control_arrays(data, metres_per_unit, excluded_slots=()):
    """ControlArrays of the faces whose material slot is not among `excluded_slots`."""
    in_shell = ~np.isin(data.face_slots, np.array(sorted(excluded_slots), dtype=np.int32))
    corners_in_shell = np.repeat(in_shell, data.face_sizes)
    face_sizes = data.face_sizes[in_shell]
    face_vertices = data.face_vertices[corners_in_shell]

    vertex_ids = np.unique(face_vertices)
    new_index = np.full(len(data.points), -1, dtype=np.int32)
    new_index[vertex_ids] = np.arange(len(vertex_ids), dtype=np.int32)

    shell_edges = face_edge_keys(face_sizes, face_vertices)

    def on_shell(edges):
        return new_index[with_keys(edges, shell_edges)]

    corner_ids = np.flatnonzero(data.vertex_creases >= 1.0)
    corners = new_index[corner_ids]
    return ControlArrays(
        data.exact_points()[vertex_ids] * metres_per_unit,
        face_sizes,
        new_index[face_vertices],
        on_shell(data.tagged_edges[data.edge_creases >= 1.0]),
        corners[corners >= 0],
        vertex_ids,
        np.flatnonzero(in_shell),
        on_shell(data.deck_edge()),
    )


def moved_arrays(control, data, metres_per_unit):
    """The ControlArrays `control` with the points of a mesh that differs by their places only."""
    points = data.exact_points()[control.vertex_ids] * metres_per_unit
    return replace(control, points=points)


def fractional_creases(data):
    """(edges (k, 2) as vertex pairs, vertices (m,)) whose crease lies strictly between 0 and 1."""
    edges = data.tagged_edges[(data.edge_creases > 0.0) & (data.edge_creases < 1.0)]
    vertices = np.flatnonzero((data.vertex_creases > 0.0) & (data.vertex_creases < 1.0))
    return edges, vertices


def with_keys(edges, keys):
    """(m, 2) those of edges (k, 2) whose edge_keys are among these."""
    return edges[np.isin(edge_keys(edges), keys)]


def border_edges(control):
    """(b, 2) the edges of ControlArrays that one face has."""
    keys, counts = np.unique(
        face_edge_keys(control.face_sizes, control.face_vertices), return_counts=True
    )
    keys = keys[counts == 1]
    return np.stack([keys >> 32, keys & 0xFFFFFFFF], axis=1)


def edge_keys(pairs):
    """One number for each undirected edge of (k, 2) vertex indices."""
    pairs = np.sort(np.asarray(pairs, dtype=np.int64).reshape(-1, 2), axis=1)
    return (pairs[:, 0] << 32) | pairs[:, 1]


def face_edge_keys(face_sizes, face_vertices):
    """Keys of the edges of all faces, one for each corner: from it to the next of its face."""
    return edge_keys(ends_of_sides(face_sizes, face_vertices))


def write_faces(mesh, points, face_sizes, face_vertices):
    """Replaces a mesh's geometry by these faces; points (n, 3) in Blender's units."""
    mesh.clear_geometry()
    mesh.vertices.add(len(points))
    mesh.vertices.foreach_set("co", np.ascontiguousarray(points, dtype=np.float32).reshape(-1))
    mesh.loops.add(len(face_vertices))
    mesh.loops.foreach_set("vertex_index", np.ascontiguousarray(face_vertices, dtype=np.int32))
    mesh.polygons.add(len(face_sizes))
    blender_versions.set_face_ranges(mesh, np.asarray(face_sizes, dtype=np.int32))
    mesh.update(calc_edges=True)


def write_tags(mesh, creases, corners, deck_edge=()):
    """Tags creases (k, 2) vertex pairs, corners (m,) vertices and the deck edge (l, 2) of a mesh
    without tags.

    What is between two vertices that no edge joins is left out: files may name such.
    """
    keys = edge_keys(_stored_edges(mesh))
    crease_edges = np.flatnonzero(np.isin(keys, edge_keys(creases)))
    if len(crease_edges) or len(corners):
        blender_versions.set_creases(mesh, crease_edges, corners)
    if len(deck_edge):
        deck_edge_marks.store_marks(mesh, np.isin(keys, edge_keys(deck_edge)))
