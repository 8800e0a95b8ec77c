# SPDX-License-Identifier: GPL-3.0-or-later
"""Targets of a hull's form: rows come and go, and the hull is changed to meet them."""

import bpy

from ..bridge.objects import hull_objects
from ..features.targets import reports, rows, targets
from .shared import HullOperator, can_change
from .tasks import TaskOperator


class HULL_OT_add_target(bpy.types.Operator, HullOperator):
    """Add a number that the hull is to have"""

    bl_idname = "hull.add_target"
    bl_label = "Add Target"

    def run_on(self, hull, context):
        rows.take_present(rows.add_row(hull), hull, context.scene)


def _has_row(cls, context):
    if not hull_objects.hull_of(context.object).hull.targets.rows:
        cls.poll_message_set("There is no target")
        return False
    return True


class HULL_OT_remove_target(bpy.types.Operator, HullOperator):
    """Remove the target that is chosen in the list"""

    bl_idname = "hull.remove_target"
    bl_label = "Remove Target"

    needs = (*HullOperator.needs, _has_row)

    def run_on(self, hull, context):
        rows.remove_row(hull)


class HULL_OT_take_present_target(bpy.types.Operator, HullOperator):
    """Make the present value of the chosen target the wanted one"""

    bl_idname = "hull.take_present_target"
    bl_label = "Take Present"

    needs = (*HullOperator.needs, _has_row)

    def run_on(self, hull, context):
        rows.take_present(rows.chosen_row(hull), hull, context.scene)


class TargetsTask(TaskOperator):
    """Subclasses begin a task that brings a hull to what is wanted in the panel Targets."""

    def outcome(self, found, scene):
        report = self._task.write(scene)
        return reports.summary(report, scene), not report.is_met


class HULL_OT_solve_targets(bpy.types.Operator, TargetsTask):
    """Move the control points so that the hull has the wanted numbers, at the least shift and
    bending of the surface. What cannot be met is told, and its nearest value is reached"""

    bl_idname = "hull.solve_targets"
    bl_label = "Solve"
    bl_options = {"REGISTER", "UNDO"}

    needs = (*TaskOperator.needs, can_change, _has_row)

    def begin(self, hull, scene):
        return targets.Solving(hull, scene)


CLASSES = (
    HULL_OT_add_target,
    HULL_OT_remove_target,
    HULL_OT_take_present_target,
    HULL_OT_solve_targets,
)
