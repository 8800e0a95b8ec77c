# SPDX-License-Identifier: GPL-3.0-or-later
"""The points of a Blender mesh, in edit mode or not, read and written; indices are Blender's."""

import bmesh
import numpy as np


def read(mesh, indices=None):
    """(k, 3) double: these points, or all."""
    if not mesh.is_editmode:
        points = np.empty((len(mesh.vertices), 3), dtype=np.float32)
        mesh.vertices.foreach_get("co", points.reshape(-1))
        return (points if indices is None else points[indices]).astype(np.float64)
    bm = bmesh.from_edit_mesh(mesh)
    if indices is None:
        return np.array([vertex.co for vertex in bm.verts], dtype=np.float64).reshape(-1, 3)
    bm.verts.ensure_lookup_table()
    wanted = [bm.verts[index].co for index in np.asarray(indices).tolist()]
    return np.array(wanted, dtype=np.float64).reshape(-1, 3)


def write(mesh, indices, points):
    """Moves these points (k,) to (k, 3)."""
    indices = np.asarray(indices)
    if not mesh.is_editmode:
        stored = read(mesh).astype(np.float32)
        stored[indices] = points
        mesh.vertices.foreach_set("co", stored.reshape(-1))
        # Blender shows and edits the shape key that a hull may have, its basis, in their place.
        if mesh.shape_keys is not None:
            mesh.shape_keys.reference_key.data.foreach_set("co", stored.reshape(-1))
        mesh.update()
        return
    bm = bmesh.from_edit_mesh(mesh)
    bm.verts.ensure_lookup_table()
    for index, point in zip(indices.tolist(), np.asarray(points).tolist()):
        bm.verts[index].co = point
    bm.normal_update()
    bmesh.update_edit_mesh(mesh, destructive=False)


def selected(mesh):
    """(k,) indices of the points that are selected in edit mode, hidden ones left out."""
    bm = bmesh.from_edit_mesh(mesh)
    chosen = [i for i, vertex in enumerate(bm.verts) if vertex.select and not vertex.hide]
    return np.array(chosen, dtype=np.int64)


def active(mesh):
    """The index of the point that was selected last in edit mode; None without one."""
    bm = bmesh.from_edit_mesh(mesh)
    last = bm.select_history.active
    if not isinstance(last, bmesh.types.BMVert):
        return None
    bm.verts.index_update()
    return last.index


def of_group(mesh, index):
    """(k,) indices of the points that are of a vertex group, by its index."""
    if not mesh.is_editmode:
        chosen = [any(g.group == index for g in vertex.groups) for vertex in mesh.vertices]
        return np.flatnonzero(chosen)
    bm = bmesh.from_edit_mesh(mesh)
    layer = bm.verts.layers.deform.active
    if layer is None:
        return np.empty(0, dtype=np.int64)
    return np.flatnonzero([index in vertex[layer] for vertex in bm.verts])
