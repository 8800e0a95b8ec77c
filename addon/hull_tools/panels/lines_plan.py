# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines plan on paper: which sheet, what its title block says."""

import bpy

from ..bridge.objects import hull_objects
from ..properties.shared import field_or, metric_fields
from .shared import HullPanel, text_field


class HULL_PT_lines_plan(HullPanel, bpy.types.Panel):
    bl_label = "Lines Plan"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        plan = hull_objects.hull_of(context.object).hull.plan
        layout.label(text="Of the lines in Sections")
        column = layout.column(align=True)
        column.prop(plan, "paper")
        if plan.paper == "OWN":
            metric_fields(column, plan, ("width", "height"), "mm")
        field_or(column, plan, "scale", "the largest that fits")
        column = layout.column(align=True)
        for name in ("profile", "half_breadth", "body_plan", "offsets"):
            column.prop(plan, name)
        column = layout.column(align=True)
        for name in ("drawn", "date", "number"):
            text_field(column, plan, name)
        layout.prop(plan, "dxf_unit")
        row = layout.row(align=True)
        row.operator("hull.export_lines", text="Lines Plan", icon="EXPORT")
        row.operator("hull.export_table", text="Offsets", icon="EXPORT").analysis = "offset_table"
        row = layout.row(align=True)
        row.operator("hull.export_view", text="View", icon="EXPORT")
        row.operator("hull.export_curves", text="3D Lines", icon="EXPORT")
        row = layout.row(align=True)
        row.operator("hull.export_curvature", text="Curvature", icon="EXPORT")
        row.operator("hull.export_figures", text="Figures", icon="EXPORT")


CLASSES = (HULL_PT_lines_plan,)
