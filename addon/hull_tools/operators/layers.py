# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers of the control mesh, made and removed."""

import bpy
from bpy.props import StringProperty

from ..bridge.counts import counted
from ..features.modelling import layering
from .shared import EditModeOperator, HullOperator, in_object_mode


class HULL_OT_new_layer(bpy.types.Operator, EditModeOperator):
    """Put the selected faces into a layer of their own: a material slot, with plating of its own in
    Weights, and a part of its own in Named Parts"""

    bl_idname = "hull.new_layer"
    bl_label = "New Layer"

    name: StringProperty(name="Name", description="What the layer is called", default="Layer")

    def run_on(self, hull, context):
        count = layering.make_layer(hull, context.scene, self.name)
        self.tell("INFO", f"{counted(count, 'face')} in a layer of their own")


class HULL_OT_remove_empty_layers(bpy.types.Operator, HullOperator):
    """Remove the layers that have no faces, with their material slots"""

    bl_idname = "hull.remove_empty_layers"
    bl_label = "Remove Empty Layers"

    needs = (in_object_mode, *HullOperator.needs)

    def run_on(self, hull, context):
        count = layering.remove_empty(hull, context.scene)
        self.tell("INFO", f"{counted(count, 'layer')} without faces removed")


CLASSES = (HULL_OT_new_layer, HULL_OT_remove_empty_layers)
