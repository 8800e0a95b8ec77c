# SPDX-License-Identifier: GPL-3.0-or-later
"""Points that follow others, whatever moves these."""

import bpy
from bpy.props import EnumProperty, FloatProperty

from ..bridge.counts import counted
from ..bridge.mesh import mesh_points
from ..features.constraints import ties
from ..features.hull import hull_state
from .select_tags import SelectOperator
from .shared import EditModeOperator

KINDS = (
    ("LINE", "On a Line", "On the straight line between the two that are farthest apart"),
    ("ANCHOR", "Anchored", "At the distance that they have from the point selected last"),
    ("LEVEL", "Level", "As high as the point selected last, and that as high as they are"),
    ("MIRROR", "Mirror Pairs", "The mirror image of a selected point on the other side, both ways"),
    ("CAMBER", "Deck at Side", "Below the point selected last by a share of the breadth there"),
)


class HULL_OT_tie_points(bpy.types.Operator, EditModeOperator):
    """Let the selected points follow others, whatever moves these: the mouse or any tool"""

    bl_idname = "hull.tie_points"
    bl_label = "Tie Points"

    kind: EnumProperty(name="Tie", description="Where the points then are", items=KINDS)
    share: FloatProperty(
        name="Camber / Breadth",
        description="Of Deck at Side: how much lower it is, as a share of the breadth",
        default=0.02,
        min=0.0,
        max=1.0,
        precision=4,
    )

    def draw(self, context):
        self.layout.prop(self, "kind")
        if self.kind == "CAMBER":
            self.layout.prop(self, "share")

    def run_on(self, hull, context):
        count = ties.tie_selected(hull, self.kind, self.share)
        hull_state.follow_edit(hull, context.scene)
        self.tell("INFO", f"{counted(count, 'point')} tied")


class HULL_OT_untie_points(bpy.types.Operator, EditModeOperator):
    """Let the selected points move by themselves again"""

    bl_idname = "hull.untie_points"
    bl_label = "Untie"

    def run_on(self, hull, context):
        selected = mesh_points.selected(hull.data)
        if not len(selected):
            raise ValueError("Select the points first")
        count = ties.untie(hull, selected)
        hull_state.follow_edit(hull, context.scene)
        self.tell("INFO", f"{counted(count, 'point')} untied")


class HULL_OT_select_tied(bpy.types.Operator, SelectOperator):
    """Select the points that follow others"""

    bl_idname = "hull.select_tied"
    bl_label = "Select Tied Points"

    nothing_found = "No point is tied"

    def found(self, hull, context):
        return "vertex", ties.tied_points(hull.data)


CLASSES = (HULL_OT_tie_points, HULL_OT_untie_points, HULL_OT_select_tied)
