# SPDX-License-Identifier: GPL-3.0-or-later
"""The angle of knuckles set to a value."""

from math import radians

import bpy
from bpy.props import FloatProperty

from ..bridge.blender import units
from ..bridge.counts import counted
from ..bridge.objects import hull_objects
from ..features.modelling import knuckle_setting
from .shared import EditModeOperator


class HULL_OT_set_knuckle_angle(bpy.types.Operator, EditModeOperator):
    """Give the selected edges of knuckles one angle along their length: the control points beside
    them move as little as may be, the knuckles stay"""

    bl_idname = "hull.set_knuckle_angle"
    bl_label = "Knuckle Angle"

    angle: FloatProperty(
        name="Angle",
        description="Between the surface's normals on both sides: 0 is smooth, a chine is "
        "positive, a hollow negative",
        min=radians(-170.0),
        max=radians(170.0),
        unit="ROTATION",
        subtype="ANGLE",
        precision=2,
        step=100,
        options={"SKIP_SAVE"},
    )

    def invoke(self, context, event):
        return self.reporting(self._open_dialog, context)

    def _open_dialog(self, context):
        if not self.properties.is_property_set("angle"):
            hull = hull_objects.hull_of(context.object)
            self.angle = knuckle_setting.present_angle(hull, context.scene)
        return context.window_manager.invoke_props_dialog(self, width=240)

    def run_on(self, hull, context):
        found = knuckle_setting.set_selected(hull, context.scene, self.angle)
        longest = units.format_value(context.scene, found.longest, "m")
        off = units.format_small_angle(found.deviation)
        moved = counted(found.count, "control point")
        words = f"{moved} moved, {longest} at most; the angle is {off} off"
        if found.met:
            self.tell("INFO", f"{words} at most")
        else:
            self.tell(
                "WARNING",
                f"{words} where it is worst: unlock points beside the knuckle, or add rows across",
            )


CLASSES = (HULL_OT_set_knuckle_angle,)
