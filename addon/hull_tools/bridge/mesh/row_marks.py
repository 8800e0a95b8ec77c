# SPDX-License-Identifier: GPL-3.0-or-later
"""The edges of a Blender mesh whose rows are to be shown with combs."""

import bmesh
import numpy as np

from . import edge_marks, mesh_arrays

ATTRIBUTE = "hull_row"


def marked(mesh):
    """(k, 2) the points of the marked edges, in edit mode or not."""
    if not mesh.is_editmode:
        marks = edge_marks.stored_marks(mesh, ATTRIBUTE)
        if not marks.any():
            return np.empty((0, 2), dtype=np.int64)
        return edge_marks.edges_of(mesh)[marks]
    bm = bmesh.from_edit_mesh(mesh)
    marks = edge_marks.edited_marks(bm, ATTRIBUTE)
    if marks.any():
        bm.verts.index_update()
    pairs = [[v.index for v in edge.verts] for edge, mark in zip(bm.edges, marks) if mark]
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)


def store(mesh, edges):
    """Marks exactly the edges between pairs of points; `mesh` is not in edit mode."""
    keys = mesh_arrays.edge_keys(edge_marks.edges_of(mesh))
    edge_marks.store_marks(mesh, ATTRIBUTE, np.isin(keys, mesh_arrays.edge_keys(edges)))


def mark(mesh, edges):
    """Marks, in edit mode, exactly the edges between pairs of points."""
    bm = bmesh.from_edit_mesh(mesh)
    bm.verts.index_update()
    wanted = {tuple(sorted(edge)) for edge in edges}
    marks = [tuple(sorted(v.index for v in edge.verts)) in wanted for edge in bm.edges]
    edge_marks.edit_marks(bm, ATTRIBUTE, marks)
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)
