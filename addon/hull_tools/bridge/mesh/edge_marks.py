# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks of a Blender mesh's edges.

They are attributes of the mesh, so that they survive saving, undo, copying and joining, and an edge
that is divided leaves its mark on both parts.
"""

import bmesh
import numpy as np

from . import own_attributes


def edges_of(mesh):
    """(edges, 2) the points of all edges, int64, in edit mode or not."""
    if mesh.is_editmode:
        bm = bmesh.from_edit_mesh(mesh)
        bm.verts.index_update()
        pairs = [[vertex.index for vertex in edge.verts] for edge in bm.edges]
        return np.array(pairs, dtype=np.int64).reshape(-1, 2)
    edges = np.empty((len(mesh.edges), 2), dtype=np.int32)
    mesh.edges.foreach_get("vertices", edges.reshape(-1))
    return edges.astype(np.int64)


def stored_values(mesh, name):
    """(edges,) int32, 0 without a mark; `mesh` is not in edit mode."""
    values = np.zeros(len(mesh.edges), dtype=np.int32)
    attribute = own_attributes.found(mesh, name, "INT", "EDGE")
    if attribute is not None:
        attribute.data.foreach_get("value", values)
    return values


def edited_values(bm, name):
    """The same of a BMesh."""
    layer = bm.edges.layers.int.get(name)
    if layer is None:
        return np.zeros(len(bm.edges), dtype=np.int32)
    return np.array([edge[layer] for edge in bm.edges], dtype=np.int32)


def stored_marks(mesh, name):
    """(edges,) bool; `mesh` is not in edit mode."""
    return stored_values(mesh, name) != 0


def edited_marks(bm, name):
    """(edges,) bool of a BMesh."""
    return edited_values(bm, name) != 0


def store_marks(mesh, name, marks):
    """Marks exactly the edges of (edges,) bool, or gives each its number; `mesh` is not in edit
    mode."""
    attribute = own_attributes.made(mesh, name, "INT", "EDGE")
    attribute.data.foreach_set("value", np.ascontiguousarray(marks, dtype=np.int32))


def edit_marks(bm, name, marks):
    """The same of a BMesh. Every BMEdge that the caller holds may become invalid."""
    layers = bm.edges.layers.int
    layer = layers.get(name) or layers.new(name)
    for edge, mark in zip(bm.edges, marks):
        edge[layer] = int(mark)
