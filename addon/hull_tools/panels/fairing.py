# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface faired around selected points: panel."""

import bpy

from ..bridge.objects import hull_objects
from ..features.fairing import region_fairing
from .conversion import draw_task
from .shared import HullPanel, label_value, label_wrapped


class HULL_PT_fair(HullPanel, bpy.types.Panel):
    """Fair the surface around the selected control points"""

    bl_label = "Fair"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        if context.object.mode != "EDIT":
            label_wrapped(layout, context, "In edit mode: select points", icon="INFO")
        elif not draw_task(layout, hull):
            column = layout.column(align=True)
            column.operator("hull.fair_region", icon="MOD_SMOOTH")
            column.operator("hull.fair_curvature", icon="SMOOTHCURVE")
        report, is_current = region_fairing.last_report(hull)
        if report is None:
            return
        if not is_current:
            label_wrapped(layout, context, "Out of date: of before the last change", icon="ERROR")
        elif report.has_more_marks:
            label_wrapped(layout, context, "More marks than before", icon="ERROR")
        column = layout.column(align=True)
        column.active = is_current
        column.scale_y = 0.8
        for name, value in region_fairing.rows(report):
            label_value(column, name, value)


CLASSES = (HULL_PT_fair,)
