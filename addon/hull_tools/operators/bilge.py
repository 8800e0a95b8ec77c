# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections rounded to a circle between flat bottom and flat side."""

import bpy
from bpy.props import BoolProperty, FloatProperty

from ..bridge.blender import units
from ..bridge.counts import counted
from ..bridge.objects import hull_objects
from ..features.modelling import bilge
from .shared import EditModeOperator


class HULL_OT_round_bilge(bpy.types.Operator, EditModeOperator):
    """Place the points of the selected sections so that the bilge is nearest to a circle. Select
    each section from the border of the flat bottom to that of the flat side"""

    bl_idname = "hull.round_bilge"
    bl_label = "Bilge Radius"

    radius: FloatProperty(
        name="Radius",
        description="Of the circle between flat bottom and flat side",
        default=1.0,
        min=1e-3,
        unit="LENGTH",
        subtype="DISTANCE",
        precision=4,
        options={"SKIP_SAVE"},
    )
    move_borders: BoolProperty(
        name="Best borders",
        description="Creases along the flats lie a little further out than where the circle "
        "touches: the section is nearer to the circle, and its curvature more even",
    )

    def invoke(self, context, event):
        return self.reporting(self._open_dialog, context)

    def _open_dialog(self, context):
        if not self.properties.is_property_set("radius"):
            hull = hull_objects.hull_of(context.object)
            self.radius = bilge.present_radius(hull, context.scene)
        return context.window_manager.invoke_props_dialog(self, width=240)

    def run_on(self, hull, context):
        found = bilge.round_selected(hull, context.scene, self.radius, self.move_borders)
        worst = max(found, key=lambda one: one.best if one.found is None else one.found)
        self.tell("INFO", _words(found, worst, context.scene))


def _words(found, worst, scene):
    sections = counted(len(found), "section")
    if worst.found is None:
        return f"{sections}: the surface has no section there; at best {_part(worst, worst.best)}"
    at = units.format_value(scene, worst.x, "m")
    return (
        f"{sections}, {counted(worst.count, 'point')}: off the circle by "
        f"{_part(worst, worst.found)} at x = "
        f"{at}; between equal sections {_part(worst, worst.best)}"
    )


def _part(one, deviation):
    return f"{units.format_mm(deviation)} ({100.0 * deviation / one.radius:.3f} %)"


CLASSES = (HULL_OT_round_bilge,)
