# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh check, selecting what it found, and turning faces outwards."""

import bpy
from bpy.props import IntProperty

from ..bridge.counts import counted
from ..bridge.mesh import selection
from ..features.hull import hull_state
from ..features.modelling import face_turning
from .shared import HullOperator, HullReader, enter_edit_mode


class HULL_OT_check_mesh(bpy.types.Operator, HullReader):
    """Check the control mesh and say how many problems it has"""

    bl_idname = "hull.check_mesh"
    bl_label = "Check Mesh"
    bl_options = {"REGISTER"}

    def run_on(self, hull, context):
        problems = hull_state.refresh(hull, context.scene).ship.check.problems
        if problems:
            self.tell("WARNING", f"{len(problems)} found, first: {problems[0].message}")
        else:
            self.tell("INFO", "The mesh is sound")


class HULL_OT_select_problem(bpy.types.Operator, HullOperator):
    """Select the points, edges or faces of this problem in edit mode"""

    bl_idname = "hull.select_problem"
    bl_label = "Select"

    index: IntProperty(name="Problem", description="Its place in the list", default=0, min=0)

    def run_on(self, hull, context):
        problems = hull_state.refresh(hull, context.scene).ship.check.problems
        if self.index >= len(problems):
            raise ValueError("This problem is no longer there")
        problem = problems[self.index]
        enter_edit_mode(context, hull)
        if problem.elements:
            selection.select(context, hull, problem.kind, problem.elements, reveal=True)
        self.tell("INFO", problem.message)


class HULL_OT_turn_outwards(bpy.types.Operator, HullOperator):
    """Turn all faces the same way, outwards, into the water"""

    bl_idname = "hull.turn_outwards"
    bl_label = "Turn Faces Outwards"

    def run_on(self, hull, context):
        count = face_turning.turn_outwards(hull)
        hull_state.follow_edit(hull, context.scene)
        self.tell("INFO", f"{counted(count, 'face')} turned")


CLASSES = (HULL_OT_check_mesh, HULL_OT_select_problem, HULL_OT_turn_outwards)
