# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks of a Blender mesh's edges.

They are attributes of the mesh, so that they survive saving, undo, copying and joining, and an edge
that is divided leaves its mark on both parts.
"""

import numpy as np

from . import own_attributes


def stored_marks(mesh, name):
    """(edges,) bool; `mesh` is not in edit mode."""
    attribute = own_attributes.found(mesh, name, "INT", "EDGE")
    if attribute is None:
        return np.zeros(len(mesh.edges), dtype=bool)
    values = np.zeros(len(mesh.edges), dtype=np.int32)
    attribute.data.foreach_get("value", values)
    return values != 0


def edited_marks(bm, name):
    """(edges,) bool of a BMesh."""
    layer = bm.edges.layers.int.get(name)
    if layer is None:
        return np.zeros(len(bm.edges), dtype=bool)
    return np.array([edge[layer] != 0 for edge in bm.edges], dtype=bool)


def store_marks(mesh, name, marks):
    """Marks exactly the edges of (edges,) bool; `mesh` is not in edit mode."""
    attribute = own_attributes.made(mesh, name, "INT", "EDGE")
    attribute.data.foreach_set("value", np.ascontiguousarray(marks, dtype=np.int32))


def edit_marks(bm, name, marks):
    """The same of a BMesh. Every BMEdge that the caller holds may become invalid."""
    layers = bm.edges.layers.int
    layer = layers.get(name) or layers.new(name)
    for edge, mark in zip(bm.edges, marks):
        edge[layer] = int(mark)
