# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance and power over speeds."""

import bpy

from ..bridge.blender.units import in_unit
from ..bridge.objects import hull_objects
from ..features.analyses import live_analyses
from ..features.resistance import resistance_curves
from .shared import HullPanel, export_buttons, label_wrapped, latest_result, text_field

_ROWS = 12  # of the table; the file has all


class HULL_PT_resistance(HullPanel, bpy.types.Panel):
    """Resistance and power of the upright hull"""

    bl_label = "Resistance"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        own = hull_objects.hull_of(context.object).hull.resistance
        text_field(layout, own, "method")
        column = layout.column(align=True)
        for name in ("speed_from", "speed_to", "speed_step"):
            column.prop(own, name)
        if own.method in ("MICHELL", "DELFT"):
            column = layout.column(align=True)
            column.prop(own, "form_factor")
            if own.method == "DELFT":
                column.prop(own, "heel")
        elif own.method == "SAVITSKY":
            column = layout.column(align=True)
            for name in ("deadrise", "chine_beam", "shaft_angle", "thrust_arm"):
                column.prop(own, name)
        else:
            self._draw_ship(layout, own)
        result, place = latest_result(layout, context, "resistance_curves", "Over speed", _ROWS + 1)
        if result is not None:
            self._draw_table(place, context, result)
        layout.prop(hull_objects.hull_of(context.object).hull.plots, "resistance_curves")
        export_buttons(layout, "resistance_curves")

    def _draw_ship(self, layout, own):
        text_field(layout, own, "stern")
        column = layout.column(align=True)
        column.prop(own, "appendage_area")
        column.prop(own, "appendage_factor")
        column = layout.column(align=True)
        column.prop(own, "propeller_diameter")
        if own.propeller_diameter:
            column.prop(own, "twin_screw")

    def _draw_table(self, layout, context, result):
        row = layout.row(align=True)
        row.scale_y = 0.8
        chosen = [result.rows[i] for i in resistance_curves.shown(len(result.rows), _ROWS)]
        self._draw_column(row, "kn", [line["speed_kn"] for line in chosen])
        for name, column, unit in (
            ("RT", "total_kN", "kN"),
            ("PE", "effective_power_kW", "kW"),
        ):
            cells = [in_unit(context.scene, line[column], unit) for line in chosen]
            self._draw_column(row, f"{name} {cells[0][1]}", [number for number, _ in cells])

    def _draw_column(self, layout, heading, numbers):
        column = layout.column(align=True)
        column.alignment = "RIGHT"
        column.label(text=heading)
        for number in numbers:
            column.label(text=f"{number:.4g}" if number < 1e4 else f"{number:.0f}")


class HULL_PT_resistance_remarks(HullPanel, bpy.types.Panel):
    """The last part: what it says comes and goes, and nothing is to move with it"""

    bl_label = "Remarks"
    bl_parent_id = "HULL_PT_resistance"

    def draw(self, context):
        hull = hull_objects.hull_of(context.object)
        outcome = live_analyses.latest(hull, context.scene, "resistance_curves")[0]
        result = outcome.result if outcome else None
        remarks = tuple(result.remarks()) if result else ()
        for remark in remarks:
            label_wrapped(self.layout, context, remark, icon="INFO")
        if result and not remarks:
            self.layout.label(text="None")


CLASSES = (HULL_PT_resistance, HULL_PT_resistance_remarks)
