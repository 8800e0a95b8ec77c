# SPDX-License-Identifier: GPL-3.0-or-later
"""The control points that are locked: they stay when the surface is pulled or bilges are rounded.

The locks are an attribute of the mesh's points, so that they survive saving, undo, copying and
joining. Blender's own tools move locked points as any others.
"""

import bmesh
import numpy as np

from ...bridge.mesh import own_attributes

ATTRIBUTE = "hull_locked"


def locked_points(mesh):
    """(k,) indices of the locked points of a Blender mesh, in edit mode or not, rising."""
    if mesh.is_editmode:
        bm = bmesh.from_edit_mesh(mesh)
        layer = bm.verts.layers.int.get(ATTRIBUTE)
        if layer is None:
            return np.empty(0, dtype=np.int64)
        return np.flatnonzero([vertex[layer] for vertex in bm.verts])
    attribute = own_attributes.found(mesh, ATTRIBUTE, "INT", "POINT")
    if attribute is None:
        return np.empty(0, dtype=np.int64)
    values = np.zeros(len(mesh.vertices), dtype=np.int32)
    attribute.data.foreach_get("value", values)
    return np.flatnonzero(values)


def write(mesh, indices):
    """Locks points (k,) of a Blender mesh that is not in edit mode."""
    if not len(indices):
        return
    attribute = own_attributes.made(mesh, ATTRIBUTE, "INT", "POINT")
    values = np.zeros(len(mesh.vertices), dtype=np.int32)
    values[indices] = 1
    attribute.data.foreach_set("value", values)


def set_selected(obj, is_locked, everything=False):
    """Locks the points that are selected in edit mode, or frees them; everything: all points,
    selected or not. Returns how many changed.

    ValueError when none is selected.
    """
    bm = bmesh.from_edit_mesh(obj.data)
    layers = bm.verts.layers.int
    layer = layers.get(ATTRIBUTE) or layers.new(ATTRIBUTE)
    chosen = [vertex for vertex in bm.verts if everything or vertex.select]
    if not chosen:
        raise ValueError("Select the points first")
    changed = [vertex for vertex in chosen if bool(vertex[layer]) != is_locked]
    for vertex in changed:
        vertex[layer] = int(is_locked)
    bmesh.update_edit_mesh(obj.data, loop_triangles=False, destructive=False)
    return len(changed)
