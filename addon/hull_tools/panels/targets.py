# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers that the hull is to have: panel."""

import bpy

from ..bridge.blender.units import imperial, is_imperial, metric_symbol
from ..bridge.objects import hull_objects
from ..features.targets import quantities, reports, rows
from ..properties.shared import metric_field, show_imperial
from .conversion import draw_task
from .fairness import draw_mark_change
from .shared import HullPanel, draw_entries, label_value, label_wrapped, text_field

_SIGNS = {"equal": "=", "at least": "≥", "at most": "≤"}


class HULL_UL_rows(bpy.types.UIList):
    """Whether a row counts, its number, what is wanted, and what it is."""

    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        quantity = quantities.quantity_of(item)
        row = layout.row(align=True)
        row.prop(item, "use", text="")
        # A sidebar of the usual width has place for twelve and for five characters.
        split = row.split(factor=0.7)
        split.active = item.use
        size = _size(context.scene, quantity.unit)
        # Feet have a digit more before the point.
        decimals = {"%": 2, "": 4}.get(quantity.unit, 3 if size == 1.0 else 2)
        wanted = _number(item.value / size, min(decimals, 3))
        split.label(text=f"{quantity.label} {_SIGNS[item.sense]} {wanted}")
        now = rows.present(item, data.id_data, context.scene)
        right = split.row()
        right.alignment = "RIGHT"
        right.label(text="–" if now is None else _number(now / size, decimals))


def _size(scene, unit):
    """Of the unit that rows show numbers of a quantity in."""
    found = imperial(unit) if is_imperial(scene) else None
    return found[0] if found else 1.0


def _number(value, decimals):
    """A number as text, rounded to a whole one where it is long."""
    text = f"{value:.{decimals}f}"
    return f"{value:.0f}" if len(text) > 6 else text


class HULL_PT_targets(HullPanel, bpy.types.Panel):
    """Change the hull so that it has wanted numbers"""

    bl_label = "Targets"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        draw_targets(layout, context, hull, self._draw_changes, "hull.solve_targets")
        self._draw_area_curve(hull)

    def _draw_changes(self, layout, settings):
        text_field(layout, settings, "moving")
        if settings.moving != "NONE":
            column = layout.column(align=True)
            column.label(text="Stay:")
            column.prop(settings, "keep_profile")
            column.prop(settings, "keep_deck")
            column.prop(settings, "keep_side")
            layout.prop(settings, "stiffness")
        draw_free(layout, settings)

    def _draw_area_curve(self, hull):
        """A whole curve is wanted in the panel Area Curve: here is the way to it."""
        column = self.layout.column(align=True)
        column.label(text="Sectional areas:")
        if hull.hull.area_target.area_points:
            column.operator("hull.drag_area_curve", icon="HANDLE_AUTO")
            column.operator("hull.transform_to_area_curve", icon="SNAP_ON")
        else:
            column.operator("hull.take_area_curve", icon="IMPORT")


def draw_targets(layout, context, hull, draw_changes, operator):
    """What is wanted, what may change for it, by draw_changes, the operator, what came of it."""
    settings = hull.hull.targets
    row = draw_entries(layout, settings, "rows", "active_row", "target")
    if row is not None:
        _draw_row(layout, row)
    draw_changes(layout, settings)
    if not draw_task(layout, hull):
        layout.operator(operator, icon="SNAP_ON")
    _draw_report(layout, context, hull)


def _draw_row(layout, row):
    """What is wanted of one number."""
    text_field(layout, row, "quantity")
    if row.quantity == quantities.SECTION:
        layout.prop(row, "station")
    if row.quantity == quantities.WAVES:
        layout.prop(row, "speed_kn")
    line = layout.row(align=True)
    line.prop(row, "sense", expand=True)
    column = layout.column(align=True)
    line = column.row(align=True)
    unit = quantities.quantity_of(row).unit
    symbol = metric_symbol(unit)
    line.prop(row, "value", text=f"Wanted, {symbol}" if symbol else "Wanted")
    line.operator("hull.take_present_target", text="", icon="EYEDROPPER")
    unit = unit if imperial(unit) else None
    show_imperial(column, row, ["value"], unit)
    metric_field(column, row, "tolerance", unit)


def draw_free(layout, settings):
    """Which main dimensions may change."""
    column = layout.column(align=True)
    column.label(text="Free within limits:")
    for name in ("length", "beam", "draft"):
        row = column.row(align=True)
        row.prop(settings, f"free_{name}")
        if getattr(settings, f"free_{name}"):
            row.prop(settings, f"{name}_change")


def _draw_report(layout, context, hull):
    """What came of the last solution."""
    report, is_current = reports.last_report(hull)
    if report is None:
        return
    if not is_current:
        label_wrapped(layout, context, "Out of date: of before the last change", icon="ERROR")
    text = reports.warning(report, context.scene)
    label_wrapped(layout, context, text or "All targets met", icon="ERROR" if text else "CHECKMARK")
    column = layout.column(align=True)
    column.active = is_current
    column.scale_y = 0.8
    for name, value in reports.told(report, context.scene):
        label_value(column, name, value)
    draw_mark_change(layout, hull)


CLASSES = (HULL_UL_rows, HULL_PT_targets)
