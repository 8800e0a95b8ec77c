# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields of the hull: panel."""

import bpy

from ..bridge.blender import units
from ..bridge.objects import field_rows, hull_objects
from ..features.fields import before, preview, shaping
from .shared import HullPanel, draw_entries, label_value, label_wrapped, text_field


class HULL_UL_fields(bpy.types.UIList):
    """Whether a field counts, its colour, its name and what it does."""

    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        row = layout.row(align=True)
        row.prop(item, "use", text="")
        line = row.row(align=True)
        line.active = item.use
        colour = line.row()
        colour.ui_units_x = 0.8
        colour.prop(item, "colour", text="")
        line.prop(item, "name", text="", emboss=False)
        if item.role == "PROTECT":
            line.label(text="", icon="LOCKED")


class HULL_PT_fields(HullPanel, bpy.types.Panel):
    """Shift regions of the hull smoothly, and protect others"""

    bl_label = "Fields"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        settings = hull_objects.hull_of(context.object).hull.fields
        field = draw_entries(layout, settings, "fields", "active_field", "field")
        row = layout.row(align=True)
        row.operator_menu_enum("hull.add_field_recipe", "recipe", text="Recipes")
        if field is None:
            return
        row.operator("hull.duplicate_field", text="", icon="DUPLICATE")
        row.operator("hull.copy_fields", text="", icon="COPYDOWN")
        row.operator("hull.move_field", text="", icon="TRIA_UP").direction = "UP"
        row.operator("hull.move_field", text="", icon="TRIA_DOWN").direction = "DOWN"
        row = layout.row(align=True)
        row.prop(settings, "show_fields", text="", icon="HIDE_OFF", toggle=True)
        handles = row.row(align=True)
        handles.active = settings.show_fields
        handles.operator("hull.drag_field", icon="HANDLE_AUTO")
        layout.row(align=True).prop(field, "role", expand=True)
        self._draw_base(layout, field)
        self._draw_values(layout, field)
        layout.row(align=True).prop(field, "axes", toggle=True)
        hull = hull_objects.hull_of(context.object)
        if settings.is_previewed:
            row = layout.row(align=True)
            row.prop(settings, "show_before", text="", icon="GHOST_ENABLED", toggle=True)
            row.operator("hull.apply_fields", text="Apply", icon="CHECKMARK")
            row.operator("hull.cancel_fields", text="Cancel", icon="X")
        else:
            layout.operator("hull.preview_fields", text="Preview", icon="HIDE_OFF")
            layout.operator("hull.apply_fields", text="Apply", icon="CHECKMARK")
        self._draw_preview(context, preview.of_hull(hull))

    def _draw_values(self, layout, field):
        varies, has_shift = field_rows.varies(field), field.role == "MOVE"
        has_shift = has_shift and not field_rows.becomes_another(field)
        if field.base in field_rows.CURVES:
            if field.role == "MOVE":
                text_field(layout, field, "becomes")
            layout.prop(field, "varies")
        if field.base != "PLANE":
            layout.prop(field, "along_surface")
        for end in ("", "_end") if varies else ("",):
            column = layout.column(align=True)
            column.prop(field, f"extent{end}")
            column.prop(field, f"falloff{end}", slider=True)
            if has_shift:
                layout.column(align=True).prop(field, f"shift{end}")

    def _draw_preview(self, context, shown):
        layout = self.layout
        if shown is None:
            return
        if shown.problem:
            label_wrapped(layout, context, shown.problem, icon="ERROR")
        elif shown.applied is None:
            label_wrapped(layout, context, "The fields shift nothing of the hull", icon="INFO")
        else:
            if not shown.applied.is_followed:
                label_wrapped(layout, context, shaping.advice(shown.applied), icon="INFO")
                column = layout.column(align=True)
                column.operator("hull.subdivide_for_fields", icon="MOD_SUBSURF")
                column.operator("hull.insert_row_for_fields", icon="MOD_EDGESPLIT")
            self._draw_numbers(layout.column(align=True), context, shown.applied)

    def _draw_numbers(self, column, context, applied):
        result = applied.result
        label_value(column, "Residual, RMS", units.format_mm(result.rms))
        label_value(column, "Residual, largest", units.format_mm(result.largest))
        if applied.crease_distance is not None:
            label_value(column, "Creases off theirs", units.format_mm(applied.crease_distance))
        hull = hull_objects.hull_of(context.object)
        for name, change in before.changes(hull):
            label_value(column, name, change)

    def _draw_base(self, layout, field):
        text_field(layout, field, "base")
        if field.base == "CURVE":
            text_field(layout, field, "curve")
            return
        if field.base == "FACES":
            layout.operator("hull.take_field_faces", icon="FACESEL")
            return
        if field.base in ("PLANE", "SECTION"):
            text_field(layout, field, "axis")
        layout.column(align=True).prop(field, "place")
        layout.operator("hull.place_field", text="Place Here", icon="PIVOT_CURSOR")


CLASSES = (HULL_UL_fields, HULL_PT_fields)
