# SPDX-License-Identifier: GPL-3.0-or-later
"""Creases, corners and smooth again, for the selection in edit mode; any mesh, hull or not."""

from math import radians

import bmesh
import bpy
import numpy as np
from bpy.props import FloatProperty

from ..bridge.blender import blender_versions
from .shared import BaseOperator, in_mesh_edit_mode


def _edited(context):
    """The objects in edit mode that are seen; ValueError where none is."""
    objects = context.objects_in_mode_unique_data
    if not objects:
        raise ValueError("What is edited is hidden here: show it in the outliner first")
    return objects


def _tag_selection(context, edge_value, vertex_value, nothing_selected):
    """Gives crease values to selected edges and vertices; None leaves their values.

    ValueError with the text `nothing_selected` when no element is to be tagged.
    """
    tagged = 0
    for obj in _edited(context):
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


class HULL_OT_tag_automatic(bpy.types.Operator, TagOperator):
    """Leave it to the creases what the selected points are: two make a crease, three or more a
    corner, one fades out there"""

    bl_idname = "hull.tag_automatic"
    bl_label = "Automatic"

    def run(self, context):
        _tag_selection(context, None, 0.0, "Select the points that are no corners of their own")


class HULL_OT_tag_by_angle(bpy.types.Operator, TagOperator):
    """Make creases of those selected edges whose faces meet at no less than an angle, and smooth
    ones of the others"""

    bl_idname = "hull.tag_by_angle"
    bl_label = "Crease by Angle"

    angle: FloatProperty(
        name="Angle",
        description="Between the normals of the two faces of an edge",
        default=radians(30.0),
        min=0.0,
        max=radians(180.0),
        subtype="ANGLE",
        unit="ROTATION",
    )

    def run(self, context):
        judged, creased = np.sum([self._tag(obj) for obj in _edited(context)], 0)
        if not judged:
            raise ValueError("Select the edges to judge by their angle first")
        self.tell("INFO", f"{creased} of {judged} edges are creases")

    def _tag(self, obj):
        """(how many edges were judged, how many became creases); those with other than two faces
        are left alone."""
        bm = bmesh.from_edit_mesh(obj.data)
        edge_layer, _ = blender_versions.ensure_crease_layers(bm)
        judged = [edge for edge in bm.edges if edge.select and len(edge.link_faces) == 2]
        is_sharp = [edge.calc_face_angle(0.0) >= self.angle for edge in judged]
        for edge, sharp in zip(judged, is_sharp):
            edge[edge_layer] = float(sharp)
        bmesh.update_edit_mesh(obj.data, loop_triangles=False, destructive=False)
        return len(judged), sum(is_sharp)


class HULL_OT_tag_smooth(bpy.types.Operator, TagOperator):
    """Make the selected edges and points smooth: no crease, no corner"""

    bl_idname = "hull.tag_smooth"
    bl_label = "Smooth"

    def run(self, context):
        _tag_selection(context, 0.0, 0.0, "Select the edges or points to smooth first")


CLASSES = (
    HULL_OT_tag_crease,
    HULL_OT_tag_corner,
    HULL_OT_tag_smooth,
    HULL_OT_tag_automatic,
    HULL_OT_tag_by_angle,
)
