# SPDX-License-Identifier: GPL-3.0-or-later
"""The studio around the hull, for pictures and films of it."""

import bpy

from ..bridge.objects import hull_objects
from ..features import studio
from ..properties.shared import field_or
from .shared import HullPanel, choice_below, label_wrapped, text_field


class HULL_PT_studio(HullPanel, bpy.types.Panel):
    bl_label = "Studio"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        settings = hull_objects.hull_of(context.object).hull.studio
        column = layout.column(align=True)
        for name in ("ground", "light", "lines", "engine"):
            choice_below(column, settings, name)
        layout.prop(settings, "deck")
        layout.prop(settings, "paint")
        if settings.paint:
            column = layout.column(align=True)
            for name in ("topside", "antifouling", "boot_top"):
                text_field(column, settings, name)
            field_or(column, settings, "boot_top_height", "by the freeboard")
        row = layout.row(align=True)
        row.operator("hull.make_studio", icon="OUTLINER_OB_LIGHT")
        row.operator("hull.remove_studio", text="", icon="TRASH")
        if studio.find(context.scene) is not None:
            self._draw_studio(context, settings)

    def _draw_studio(self, context, settings):
        layout = self.layout
        hull = studio.hull_of(context.scene)
        if hull is not None and hull != hull_objects.hull_of(context.object):
            label_wrapped(layout, context, f"The studio is that of {hull.name}", icon="INFO")
            return
        flow = layout.grid_flow(columns=2, align=True, row_major=True)
        for name, view in studio.VIEWS.items():
            if name != studio.TURNTABLE:
                flow.operator("hull.studio_view", text=view.label).view = name
        column = layout.column(align=True)
        column.prop(settings, "turntable_frames")
        column.operator("hull.studio_turntable")


CLASSES = (HULL_PT_studio,)
