# SPDX-License-Identifier: GPL-3.0-or-later
"""Selecting in edit mode by what edges, points and faces are to the surface."""

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty

from ..bridge.mesh import selection
from ..features.hull import hull_state, tags
from .shared import EditModeOperator, HullOperator, enter_edit_mode


class SelectOperator(EditModeOperator):
    """Subclasses: found(hull, context) returns (kind of elements, elements), and nothing_found says
    that there are none."""

    extend: BoolProperty(name="Extend", description="Keep what is selected", default=False)

    def run_on(self, hull, context):
        kind, elements = self.found(hull, context)
        if not len(elements):
            raise ValueError(self.nothing_found)
        count = selection.select(context, hull, kind, elements, extend=self.extend)
        hidden = len(elements) - count
        self.tell("INFO", f"{count} selected" + (f", {hidden} are hidden" if hidden else ""))


class HULL_OT_select_creases(bpy.types.Operator, SelectOperator):
    """Select the knuckles, borders or the deck edge of the hull"""

    bl_idname = "hull.select_creases"
    bl_label = "Select Creases"

    nothing_found = "The hull has none"
    needs = HullOperator.needs  # edit mode is entered

    kind: EnumProperty(
        name="Which",
        description="Which creases are selected",
        items=(
            ("ALL", "All", "All edges that are creases to the surface"),
            ("KNUCKLE", "Knuckles", "Creases within the surface"),
            ("BORDER", "Borders", "Edges with a face on one side only"),
            ("DECK_EDGE", "Deck edge", "Edges that are marked as deck edge"),
        ),
    )

    def run_on(self, hull, context):
        if len(self.found(hull, context)[1]):
            enter_edit_mode(context, hull)
        super().run_on(hull, context)

    def found(self, hull, context):
        kinds = tags.EDGE_KINDS if self.kind == "ALL" else (self.kind.lower(),)
        return "edge", tags.of_hull(hull, context.scene).blender_edges(kinds)


class HULL_OT_select_chains(bpy.types.Operator, SelectOperator):
    """Select all of the creases and borders, from end to end, that selected edges belong to"""

    bl_idname = "hull.select_chains"
    bl_label = "Select Crease Chain"

    nothing_found = "Select an edge of a crease or border first"

    def found(self, hull, context):
        return "edge", tags.chains_through(hull, context.scene, selection.selected(hull, "edge"))


class HULL_OT_select_points(bpy.types.Operator, SelectOperator):
    """Select corners, darts or irregular points of the hull"""

    bl_idname = "hull.select_points"
    bl_label = "Select Points by Tag"

    nothing_found = "The hull has none"

    kind: EnumProperty(
        name="Which",
        description="Which points are selected",
        items=(
            ("IRREGULAR", "Irregular", "Points around which the surface is no B-spline"),
            ("CORNER", "Tagged corners", "Points that are tagged as corners"),
            ("AUTOMATIC_CORNER", "Other corners", "Points where three or more creases meet"),
            ("DART", "Darts", "Points where a crease fades out"),
        ),
    )
    least_edges: IntProperty(
        name="Least edges",
        description="Of irregular points, those with at least so many edges",
        default=2,
        min=2,
        soft_max=12,
    )

    def found(self, hull, context):
        found = tags.of_hull(hull, context.scene)
        points = found.points[self.kind.lower()]
        if self.kind == "IRREGULAR":
            points = points[found.valences >= self.least_edges]
        return "vertex", found.vertex_ids[points]


class HULL_OT_select_odd_faces(bpy.types.Operator, SelectOperator):
    """Select the faces of the hull that are no quadrilaterals"""

    bl_idname = "hull.select_odd_faces"
    bl_label = "Select Other than Quads"

    nothing_found = "All faces are quadrilaterals"

    def found(self, hull, context):
        found = tags.of_hull(hull, context.scene)
        return "face", found.face_ids[found.odd_faces]


class HULL_OT_select_problems(bpy.types.Operator, SelectOperator):
    """Select the points of all that the mesh check found wrong; of errors only, if there are any"""

    bl_idname = "hull.select_problems"
    bl_label = "Select Mesh Problems"

    nothing_found = "The mesh check found nothing to select"

    def found(self, hull, context):
        check = hull_state.refresh(hull, context.scene).ship.check
        problems = check.errors or check.problems
        return "vertex", selection.vertices_of(
            hull, ((problem.kind, problem.elements) for problem in problems)
        )


CLASSES = (
    HULL_OT_select_creases,
    HULL_OT_select_chains,
    HULL_OT_select_points,
    HULL_OT_select_odd_faces,
    HULL_OT_select_problems,
)
