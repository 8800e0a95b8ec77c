# SPDX-License-Identifier: GPL-3.0-or-later
"""Control curves come and go, are selected and smoothed."""

import bpy
from bpy.props import BoolProperty, StringProperty

from ..bridge.counts import counted
from ..features.fairing import control_curves
from .fairing import FairRow
from .shared import EditModeOperator


class HULL_OT_add_curve(bpy.types.Operator, EditModeOperator):
    """Add a control curve of the selected edges, or of the row of a single one. It keeps its name
    and its edges through all that is done to the mesh"""

    bl_idname = "hull.add_curve"
    bl_label = "Add Control Curve"

    name: StringProperty(
        name="Name", description="Of the curve; none: its number", options={"SKIP_SAVE"}
    )

    def run_on(self, hull, context):
        entry = control_curves.add(hull, context.scene, self.name)
        self.tell("INFO", f"{entry.name} added")


class HULL_OT_remove_curve(bpy.types.Operator, EditModeOperator):
    """Remove the control curve that is chosen in the list; the mesh stays as it is"""

    bl_idname = "hull.remove_curve"
    bl_label = "Remove Control Curve"

    def run_on(self, hull, context):
        self.tell("INFO", f"{control_curves.remove(hull, context.scene)} removed")


class HULL_OT_select_curve(bpy.types.Operator, EditModeOperator):
    """Select the edges of the control curve that is chosen in the list"""

    bl_idname = "hull.select_curve"
    bl_label = "Select Control Curve"

    extend: BoolProperty(name="Extend", description="Besides the edges that are selected already")

    def run_on(self, hull, context):
        count = control_curves.select(context, hull, self.extend)
        self.tell("INFO", f"{counted(count, 'edge')} selected")


class HULL_OT_fair_curve(bpy.types.Operator, FairRow):
    """Move the points of the control curve that is chosen in the list so that it is as smooth as
    can be, within a mean deviation. Locked points stay, flats stay flat"""

    bl_idname = "hull.fair_curve"
    bl_label = "Fair Control Curve"

    def run_on(self, hull, context):
        control_curves.select(context, hull)
        super().run_on(hull, context)


CLASSES = (HULL_OT_add_curve, HULL_OT_remove_curve, HULL_OT_select_curve, HULL_OT_fair_curve)
