# SPDX-License-Identifier: GPL-3.0-or-later
"""The eye of reflection lines and silhouette, and the check of what should be flat."""

import bpy
from bpy.props import FloatProperty

from ..bridge.mesh import selection
from ..features.hull import hull_state
from ..features.modelling import flat_check
from .shared import EditModeOperator, HullOperator, in_3d_view


class HULL_OT_eye_from_view(bpy.types.Operator, HullOperator):
    """Take the direction of this 3D view for the eye of reflection lines and silhouette"""

    bl_idname = "hull.eye_from_view"
    bl_label = "Eye as in This View"

    needs = (in_3d_view, *HullOperator.needs)

    def run_on(self, hull, context):
        # The view looks along its own -z.
        hull.hull.fairness.eye_direction = context.region_data.view_matrix.to_3x3()[2]
        hull_state.refresh(hull, context.scene)


class HULL_OT_check_flat(bpy.types.Operator, EditModeOperator):
    """How far the surface of the selected faces is from the plane that fits it best; the control
    points at fault are selected"""

    bl_idname = "hull.check_flat"
    bl_label = "Check Flatness"

    tolerance: FloatProperty(
        name="Tolerance",
        description="Control points further than this from the plane are at fault; 0: what single "
        "precision tells apart",
        min=0.0,
        unit="LENGTH",
        subtype="DISTANCE",
        precision=5,
    )

    def run_on(self, hull, context):
        found = flat_check.check_selected(hull, context.scene, self.tolerance)
        if found.at_fault:
            selection.select(context, hull, "vertex", found.at_fault, reveal=True)
        self.report({"WARNING" if found.at_fault else "INFO"}, found.message)


CLASSES = (HULL_OT_eye_from_view, HULL_OT_check_flat)
