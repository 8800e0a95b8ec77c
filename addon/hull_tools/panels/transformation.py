# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole form changed to given particulars: panel."""

import bpy

from ..bridge.objects import hull_objects
from ..features.hull import form_before
from ..properties.shared import field_or
from .conversion import draw_task
from .fairness import draw_mark_change
from .shared import HullPanel, text_field


class HULL_PT_transform(HullPanel, bpy.types.Panel):
    """Change the whole form to given particulars"""

    bl_label = "Transform"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        column = layout.column(align=True)
        column.operator("hull.shift_sections", text="Displacement, LCB …", icon="FULLSCREEN_ENTER")
        column.operator("hull.change_displacement", text="The Same by Least Change …")
        column.operator("hull.fewest_marks", text="With Fewest New Marks …")
        column.operator("hull.lengthen", text="Lengthen …")
        column.operator("hull.inflate_section", text="Inflate Section …")
        settings = hull.hull.transform
        column = layout.column(align=True)
        text_field(column, settings, "kept_group")
        column.prop(settings, "kept_aft")
        column.prop(settings, "kept_fore")
        if settings.kept_aft or settings.kept_fore:
            field_or(column, settings, "kept_fade", "a tenth of the length")
        if not draw_task(layout, hull):
            draw_mark_change(layout, hull)
            if form_before.is_known(hull):
                layout.operator("hull.fair_new_marks")


CLASSES = (HULL_PT_transform,)
