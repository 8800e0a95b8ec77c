# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh check, selecting what it found, and turning faces outwards."""

import bmesh
import bpy
from bpy.props import IntProperty

from ..bridge import face_turning, hull_state
from .shared import HullOperator

_SELECT_MODES = {
    "vertex": (True, False, False),
    "edge": (False, True, False),
    "face": (False, False, True),
}


class HULL_OT_check_mesh(bpy.types.Operator, HullOperator):
    """Check the control mesh and say how many problems it has"""

    bl_idname = "hull.check_mesh"
    bl_label = "Check Mesh"
    bl_options = {"REGISTER"}

    def run_on(self, hull, context):
        problems = hull_state.refresh(hull, context.scene).check.problems
        if problems:
            self.report({"WARNING"}, f"{len(problems)} found, first: {problems[0].message}")
        else:
            self.report({"INFO"}, "The mesh is sound")


class HULL_OT_select_problem(bpy.types.Operator, HullOperator):
    """Select the points, edges or faces of this problem in edit mode"""

    bl_idname = "hull.select_problem"
    bl_label = "Select"

    index: IntProperty(name="Problem", description="Its place in the list", default=0, min=0)

    def run_on(self, hull, context):
        problems = hull_state.refresh(hull, context.scene).check.problems
        if self.index >= len(problems):
            raise ValueError("This problem is no longer there")
        problem = problems[self.index]
        _enter_edit_mode(context, hull)
        if problem.elements:
            _select(context, hull.data, problem.kind, problem.elements)
        self.report({"INFO"}, problem.message)


class HULL_OT_turn_outwards(bpy.types.Operator, HullOperator):
    """Turn all faces the same way, outwards, into the water"""

    bl_idname = "hull.turn_outwards"
    bl_label = "Turn Faces Outwards"

    def run_on(self, hull, context):
        face_turning.turn_outwards(hull)
        hull_state.refresh(hull, context.scene)


def _enter_edit_mode(context, hull):
    if hull.mode == "EDIT":
        return
    if context.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    context.view_layer.objects.active = hull
    bpy.ops.object.mode_set(mode="EDIT")


def _select(context, mesh, kind, elements):
    """Selects exactly these elements, and only points, edges or faces."""
    context.tool_settings.mesh_select_mode = _SELECT_MODES[kind]
    bm = bmesh.from_edit_mesh(mesh)
    for sequence in (bm.faces, bm.edges, bm.verts):
        sequence.ensure_lookup_table()
        for element in sequence:
            element.select_set(False)
    for element in _find(bm, kind, elements):
        element.hide_set(False)
        element.select_set(True)
    bm.select_mode = {kind.upper().replace("VERTEX", "VERT")}
    bm.select_flush_mode()
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


def _find(bm, kind, elements):
    if kind == "vertex":
        return [bm.verts[index] for index in elements]
    if kind == "face":
        return [bm.faces[index] for index in elements]
    found = (bm.edges.get([bm.verts[index] for index in pair]) for pair in elements)
    return [edge for edge in found if edge is not None]


CLASSES = (HULL_OT_check_mesh, HULL_OT_select_problem, HULL_OT_turn_outwards)
