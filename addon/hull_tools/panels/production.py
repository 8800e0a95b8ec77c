# SPDX-License-Identifier: GPL-3.0-or-later
"""Models for printers and mills, panels and parts for programs that compute waves and flow."""

import bpy

from ..bridge.objects import hull_objects
from ..features.production import model_figures
from ..properties.shared import field_or, metric_field, metric_fields
from .conversion import draw_task
from .shared import HullPanel, label_value, label_wrapped


class HULL_PT_model(HullPanel, bpy.types.Panel):
    """The closed hull at a scale"""

    bl_label = "Model"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout, hull = self.layout, hull_objects.hull_of(context.object)
        own = hull.hull.model
        column = layout.column(align=True)
        column.prop(own, "scale")
        metric_field(column, own, "tolerance")
        field_or(layout, own, "wall", "solid")
        layout.prop(own, "in_segments")
        if own.in_segments:
            column = layout.column(align=True)
            metric_fields(column, own, ("machine_x", "machine_y", "machine_z"))
            field_or(layout, own, "dowel", "none")
        else:
            metric_field(layout, own, "layer")
        if not draw_task(layout, hull):
            row = layout.row(align=True)
            row.operator("hull.make_model", text="Make", icon="MESH_ICOSPHERE")
            row.operator("hull.export_model", text="Export", icon="EXPORT")
        _draw_figures(layout, context, *model_figures.model_figures(hull))


class HULL_PT_panel_mesh(HullPanel, bpy.types.Panel):
    """The hull below the water in panels, and all of it in parts"""

    bl_label = "Panels"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout, hull = self.layout, hull_objects.hull_of(context.object)
        own = hull.hull.panel_mesh
        column = layout.column(align=True)
        column.prop(own, "along")
        column.prop(own, "grading")
        is_free = not draw_task(layout, hull)
        if is_free:
            row = layout.row(align=True)
            row.operator("hull.make_panels", text="Make", icon="MESH_GRID")
            row.operator("hull.export_panels", text="Export", icon="EXPORT")
        try:
            figures = model_figures.panel_figures(hull, context.scene)
        except ValueError as error:
            label_wrapped(layout, context, str(error), "ERROR")
        else:
            _draw_figures(layout, context, *figures)
        layout.separator()
        layout.label(text="For flow")
        metric_field(layout, own, "part_tolerance")
        if is_free:
            layout.operator("hull.export_parts", text="Named Parts", icon="EXPORT")


def _draw_figures(layout, context, figures, is_current):
    """Pale where they are of the hull or the settings as they were."""
    if figures is None:
        return
    column = layout.column(align=True)
    column.active = is_current
    for name, value in figures.rows:
        label_value(column, name, value)
    if figures.remark:
        label_wrapped(column, context, figures.remark, "ERROR")
    if not is_current:
        column.label(text="Of the hull as it was")


CLASSES = (HULL_PT_model, HULL_PT_panel_mesh)
