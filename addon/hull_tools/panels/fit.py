# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface fitted to a shape: panel."""

import bpy

from ..bridge.objects import hull_objects
from ..features.fitting import fitting
from ..properties.shared import field_or
from .conversion import draw_task
from .shared import HullPanel, label_value, label_wrapped, text_field


class HULL_PT_fit(HullPanel, bpy.types.Panel):
    """Fit the surface to a mesh, an STL file or points"""

    bl_label = "Fit"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        settings = hull.hull.fit
        row = layout.row(align=True)
        text_field(row, settings, "target")
        row.operator("hull.load_stl", text="", icon="FILE_FOLDER")
        text_field(layout, settings, "lines")
        column = layout.column(align=True)
        column.prop(settings, "use_edges")
        if settings.use_edges:
            column.prop(settings, "edge_angle")
        column.prop(settings, "draw_border")
        if hull.hull.half:
            column.prop(settings, "stay_square")
        column = layout.column(align=True)
        column.prop(settings, "fairness")
        column.prop(settings, "stiffness")
        field_or(column, settings, "reach", "a twentieth of the length")
        column.prop(settings, "samples")
        if not draw_task(layout, hull):
            layout.operator("hull.fit", icon="MOD_SHRINKWRAP")
        self._draw_report(context, hull)

    def _draw_report(self, context, hull):
        layout = self.layout
        report, is_current = fitting.last_report(hull)
        if report is None:
            return
        if not is_current:
            label_wrapped(layout, context, "Out of date: of before the last change", icon="ERROR")
        if fitting.warning(report):
            label_wrapped(layout, context, fitting.warning(report), icon="ERROR")
        column = layout.column(align=True)
        column.active = is_current
        column.scale_y = 0.8
        for name, value in fitting.rows(report):
            label_value(column, name, value)
        if is_current:
            layout.operator("hull.show_fit_worst", icon="HIDE_OFF")


CLASSES = (HULL_PT_fit,)
