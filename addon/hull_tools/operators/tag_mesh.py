# SPDX-License-Identifier: GPL-3.0-or-later
"""Creases, corners and smooth again, for the selection in edit mode; any mesh, hull or not."""

import bmesh
import bpy

from ..bridge import blender_versions
from .shared import BaseOperator, in_mesh_edit_mode


def _tag_selection(context, edge_value, vertex_value, nothing_selected):
    """Gives crease values to selected edges and vertices; None leaves their values.

    ValueError with the text `nothing_selected` when no element is to be tagged.
    """
    tagged = 0
    for obj in context.objects_in_mode_unique_data:
        bm = bmesh.from_edit_mesh(obj.data)
        edge_layer, vertex_layer = blender_versions.ensure_crease_layers(bm)
        count = 0
        if edge_value is not None:
            count += _set_selected(bm.edges, edge_layer, edge_value)
        if vertex_value is not None:
            count += _set_selected(bm.verts, vertex_layer, vertex_value)
        if count:
            bmesh.update_edit_mesh(obj.data, loop_triangles=False, destructive=False)
        tagged += count
    if not tagged:
        raise ValueError(nothing_selected)


def _set_selected(elements, layer, value):
    selected = [element for element in elements if element.select]
    for element in selected:
        element[layer] = value
    return len(selected)


class TagOperator(BaseOperator):
    needs = (in_mesh_edit_mode,)


class HULL_OT_tag_crease(bpy.types.Operator, TagOperator):
    """Make the selected edges creases: knuckles of the surface"""

    bl_idname = "hull.tag_crease"
    bl_label = "Crease"

    def run(self, context):
        _tag_selection(context, 1.0, None, "Select the edges of the knuckle first")


class HULL_OT_tag_corner(bpy.types.Operator, TagOperator):
    """Make the selected points corners: the surface passes through them with a kink"""

    bl_idname = "hull.tag_corner"
    bl_label = "Corner"

    def run(self, context):
        _tag_selection(context, None, 1.0, "Select the points that become corners first")


class HULL_OT_tag_smooth(bpy.types.Operator, TagOperator):
    """Make the selected edges and points smooth: no crease, no corner"""

    bl_idname = "hull.tag_smooth"
    bl_label = "Smooth"

    def run(self, context):
        _tag_selection(context, 0.0, 0.0, "Select the edges or points to smooth first")


CLASSES = (HULL_OT_tag_crease, HULL_OT_tag_corner, HULL_OT_tag_smooth)
