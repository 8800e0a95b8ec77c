# SPDX-License-Identifier: GPL-3.0-or-later
"""The eye of reflection lines and silhouette, the check of what should be flat, marks counted."""

import bpy
from bpy.props import BoolProperty, FloatProperty, IntProperty

from ..bridge.counts import counted
from ..bridge.mesh import selection
from ..features.fairing import seen_marks
from ..features.hull import hull_state
from ..features.modelling import flat_check
from ..properties.shared import field_or
from .shared import EditModeOperator, HullOperator, HullReader, in_3d_view, property_column
from .tasks import TaskOperator


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

    def draw(self, context):
        field_or(property_column(self), self, "tolerance", "what single precision tells apart")

    def run_on(self, hull, context):
        found = flat_check.check_selected(hull, context.scene, self.tolerance)
        if found.at_fault:
            selection.select(context, hull, "vertex", found.at_fault, reveal=True)
        self.tell("WARNING" if found.at_fault else "INFO", found.message)


class HULL_OT_count_marks(bpy.types.Operator, TaskOperator):
    """Count what an eye sees on lines and reflection lines: inflections, flat spots, kinks and
    waves that were not accepted as what the design calls for"""

    bl_idname = "hull.count_marks"
    bl_label = "Count Marks"

    compare: BoolProperty(
        name="Compare",
        description="Tell which marks are new and which are gone since before the hull was last "
        "transformed or brought to targets; new ones are shown first",
        options={"SKIP_SAVE"},
    )

    def begin(self, hull, scene):
        return seen_marks.Judging(hull, scene, self.compare)

    def outcome(self, result, scene):
        hull = hull_state.hull_with(self._task.state, scene)
        if hull is None:
            raise ValueError("The hull is not in this scene any longer: its marks are not noted")
        return seen_marks.summary(self._task.note(hull, scene)), False


class HULL_OT_show_mark(bpy.types.Operator, HullReader):
    """Bring a mark into view, with the 3D cursor there; in edit mode the control points around it
    are selected"""

    bl_idname = "hull.show_mark"
    bl_label = "Select"

    step: IntProperty(
        name="Step", description="1: the next one, -1: the one before, 0: the same", min=-1, max=1
    )

    def run_on(self, hull, context):
        self.tell("INFO", seen_marks.show(context, hull, self.step))


class HULL_OT_accept_marks(bpy.types.Operator, HullOperator):
    """Take the mark that is shown, or all, as what the design calls for: it is not counted any
    longer, within a tenth of the beam"""

    bl_idname = "hull.accept_marks"
    bl_label = "Accept"

    all: BoolProperty(name="All", description="All marks, not the one that is shown alone")

    def run_on(self, hull, context):
        count = seen_marks.accept(hull, context.scene, self.all)
        self.tell("INFO", f"{counted(count, 'mark')} accepted")


class HULL_OT_accept_no_marks(bpy.types.Operator, HullOperator):
    """Forget what was accepted: all marks are counted again"""

    bl_idname = "hull.accept_no_marks"
    bl_label = "Accept None"

    def run_on(self, hull, context):
        count = seen_marks.accept_none(hull, context.scene)
        self.tell("INFO", f"{counted(count, 'mark')} no longer accepted")


CLASSES = (
    HULL_OT_eye_from_view,
    HULL_OT_check_flat,
    HULL_OT_count_marks,
    HULL_OT_show_mark,
    HULL_OT_accept_marks,
    HULL_OT_accept_no_marks,
)
