# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell in plates: rules of seams, frames, the list."""

import bpy

from ..bridge.blender.units import shown_in
from ..bridge.objects import hull_objects
from ..features.conversion import conversions
from ..features.production import plate_files
from ..properties.shared import metric_field, show_imperial
from .conversion import draw_task
from .shared import HullPanel, label_value, label_wrapped, text_field

# So many plates are listed here; files have all.
_MOST_LISTED = 60


class HULL_PT_plates(HullPanel, bpy.types.Panel):
    """Divide the shell into plates and lay them out flat"""

    bl_label = "Plates"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        settings = hull.hull.plates
        if not settings.rules:
            layout.operator("hull.suggest_seams", icon="MOD_LATTICE")
        self._draw_rules(settings)
        column = layout.column(align=True)
        column.prop(settings, "along_knuckles")
        column.prop(settings, "across_centre")
        metric_field(layout, settings, "thickness")
        if not draw_task(layout, hull):
            column = layout.column(align=True)
            column.operator("hull.lay_out_plates", icon="MESH_GRID")
            column.operator("hull.export_plates", icon="EXPORT")
        self._draw_list(context, hull)

    def _draw_rules(self, settings):
        column = self.layout.column(align=True)
        for index, rule in enumerate(settings.rules):
            row = column.row(align=True)
            row.prop(rule, "on", text="")
            row.prop(rule, "kind", text="")
            number = row.row(align=True)
            number.scale_x = 0.85
            number.prop(rule, "line" if rule.kind == "projected" else "value", text="")
            _draw_removal(row, "REMOVE_RULE", index)
            if rule.kind != "projected":
                show_imperial(column, rule, ["value"], "m")
        column.operator("hull.change_plate_list", text="Add Rule", icon="ADD").action = "ADD_RULE"

    def _draw_list(self, context, hull):
        report, is_current = plate_files.last_plates(hull)
        if report is None:
            return
        self.layout.prop(hull.hull.plates, "show_seams")
        column = self.layout.column(align=True)
        column.active = is_current
        label_wrapped(column, context, report.text)
        if not is_current:
            column.label(text="Of the hull as it was", icon="INFO")
        column.scale_y = 0.8
        shown = shown_in(context.scene)
        for row in report.rows[:_MOST_LISTED]:
            name, words, settled = plate_files.plate_words(row, shown)
            line = column.row()
            line.alert = not settled
            label_value(line, name, words)


class HULL_PT_plate_drawings(HullPanel, bpy.types.Panel):
    """What else is written of the plates"""

    bl_label = "Marks and Drawings"
    bl_parent_id = "HULL_PT_plates"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        hull = hull_objects.hull_of(context.object)
        column = self.layout.column(align=True)
        column.label(text="Marked besides frames")
        column.prop(hull.hull.plates, "mark_waterlines")
        column.prop(hull.hull.plates, "mark_buttocks")
        if conversions.running(hull) is None:
            column = self.layout.column(align=True)
            for name in ("templates", "stretch", "nesting"):
                column.operator(f"hull.export_{name}", icon="EXPORT")


class HULL_PT_frames(HullPanel, bpy.types.Panel):
    """Frames that are marked on plates: spacings by ranges"""

    bl_label = "Frames"
    bl_parent_id = "HULL_PT_plates"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        hull = hull_objects.hull_of(context.object)
        settings = hull.hull.plates
        column = self.layout.column(align=True)
        column.prop(settings, "first_frame")
        for index, each in enumerate(settings.ranges):
            row = column.row(align=True)
            row.prop(each, "last", text="To")
            row.prop(each, "spacing", text="m")
            _draw_removal(row, "REMOVE_RANGE", index)
            show_imperial(column, each, ["spacing"], "m")
        column.operator("hull.change_plate_list", text="Add Range", icon="ADD").action = "ADD_RANGE"
        text_field(self.layout, settings, "numbered_from")
        self.layout.prop(settings, "in_roman")
        if settings.ranges and conversions.running(hull) is None:
            column = self.layout.column(align=True)
            column.operator("hull.export_frames", icon="EXPORT")
            column.operator("hull.export_frame_table", icon="EXPORT")


def _draw_removal(row, action, index):
    button = row.operator("hull.change_plate_list", text="", icon="REMOVE")
    button.action, button.index = action, index


CLASSES = (HULL_PT_plates, HULL_PT_plate_drawings, HULL_PT_frames)
