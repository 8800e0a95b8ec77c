# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull in edit mode, and what is selected of it."""

import bmesh
import bpy
import numpy as np
from expect import edited_points
from mathutils import Vector
from window import FROM_PORT


def editing_a_hull(window, mode="VERT"):
    """A sample hull in edit mode, seen from port; nothing is selected, the mouse in the middle."""
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
    hull = bpy.context.view_layer.objects.active
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_mode(type=mode)
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.ed.undo_push(message="begin")
    window.space.shading.type = "WIREFRAME"
    window.look(hull, FROM_PORT)
    return hull


def bilge_point(hull):
    """(index, place) of the control point that stands out most to port amidships."""
    points = edited_points(hull)
    middle = 0.5 * (points[:, 0].min() + points[:, 0].max())
    index = int(np.argmin(np.abs(points[:, 0] - middle) - 2.0 * points[:, 1]))
    return index, Vector(points[index].tolist())


def select(hull, *indices, kind="verts"):
    """Selects elements ("verts", "edges" or "faces") of the select mode; an undo step follows."""
    bm = bmesh.from_edit_mesh(hull.data)
    elements = getattr(bm, kind)
    elements.ensure_lookup_table()
    for index in indices:
        elements[index].select_set(True)
    bm.select_flush_mode()
    bmesh.update_edit_mesh(hull.data, loop_triangles=False, destructive=False)
    bpy.ops.ed.undo_push(message="select")


def editing_a_bilge_point(window):
    """A sample hull in edit mode with only its bilge point selected: (hull, index, place)."""
    hull = editing_a_hull(window)
    index, place = bilge_point(hull)
    select(hull, index)
    return hull, index, place


def selected_indices(hull):
    return [v.index for v in bmesh.from_edit_mesh(hull.data).verts if v.select]


def hull_at_hand():
    """The active object: the one there was is another one after an undo."""
    return bpy.context.view_layer.objects.active
