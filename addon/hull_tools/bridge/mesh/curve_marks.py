# SPDX-License-Identifier: GPL-3.0-or-later
"""Which control curve each edge of a Blender mesh is of: its number, 0 for none.

The number is an attribute beside that of row_marks, which all edges of control curves have too. So
it survives saving, undo, copying and joining, and an edge that is divided leaves it on both parts.
"""

import bmesh
import numpy as np

from . import edge_marks, mesh_arrays

ATTRIBUTE = "hull_curve"


def numbered(mesh):
    """((k, 2) the points of all edges that are of a control curve, (k,) their numbers), in edit
    mode or not."""
    numbers = _numbers(mesh)
    edges = edge_marks.edges_of(mesh)
    return edges[numbers != 0], numbers[numbers != 0]


def present(mesh):
    """The numbers of the curves that edges are of, in edit mode or not."""
    return set(_numbers(mesh).tolist()) - {0}


def edges_of(mesh, number):
    """(k, 2) the points of a curve's edges."""
    edges, numbers = numbered(mesh)
    return edges[numbers == number]


def give(mesh, edges, number):
    """Gives these edges, pairs of points, a number, 0 to take theirs, in edit mode or not."""
    keys = mesh_arrays.edge_keys
    chosen = np.isin(keys(edge_marks.edges_of(mesh)), keys(edges))
    numbers = np.where(chosen, number, _numbers(mesh))
    if not mesh.is_editmode:
        edge_marks.store_marks(mesh, ATTRIBUTE, numbers)
        return
    edge_marks.edit_marks(bmesh.from_edit_mesh(mesh), ATTRIBUTE, numbers)
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


def _numbers(mesh):
    if not mesh.is_editmode:
        return edge_marks.stored_values(mesh, ATTRIBUTE)
    return edge_marks.edited_values(bmesh.from_edit_mesh(mesh), ATTRIBUTE)
