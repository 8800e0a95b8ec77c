# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance and power over speeds."""

import math

import bpy

from ...hull_io import ship_data
from ..bridge.blender.units import imperial, in_unit, is_imperial
from ..bridge.objects import hull_objects
from ..features.analyses import live_analyses
from ..features.resistance import resistance_curves
from ..features.variants import other_hull
from ..properties.shared import field_or, metric_field
from .shared import HullPanel, export_buttons, label_wrapped, latest_result, text_field

_ROWS = 12  # of the table; the file has all

_PLANING = (
    ("planing_mass_t", "mass_t", "t"),
    ("planing_lcg", "lcg", "m"),
    ("chine_beam", "beam", "m"),
    ("deadrise", "deadrise_deg", "°"),
)


def _inputs(method):
    """Settings that stand for what the hull has, the names hull_native has for them, and their
    units."""
    if method == "SAVITSKY":
        return _PLANING
    units = {
        "HOLTROP": ship_data.HOLTROP_UNITS,
        "DELFT": ship_data.DELFT_UNITS,
        "MICHELL": ship_data.MICHELL_UNITS,
    }
    return [(f"{method.lower()}.{name}", name, unit) for name, unit in units[method].items()]


class HULL_PT_resistance(HullPanel, bpy.types.Panel):
    """Resistance and power of the upright hull"""

    bl_label = "Resistance"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        own = hull.hull.resistance
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
            for name in ("shaft_angle", "thrust_arm"):
                column.prop(own, name)
        else:
            self._draw_ship(layout, own)
        result, place = latest_result(layout, context, "resistance_curves", "Over speed", _ROWS + 1)
        if result is not None:
            self._draw_table(place, context, result)
        layout.prop(hull.hull.plots, "resistance_curves")
        if other_hull.is_chosen(hull):
            layout.prop(hull.hull.variants, "resistance_beside")
        export_buttons(layout, "resistance_curves")

    def _draw_ship(self, layout, own):
        text_field(layout, own, "stern")
        column = layout.column(align=True)
        metric_field(column, own, "appendage_area")
        column.prop(own, "appendage_factor")
        column = layout.column(align=True)
        column.prop(own, "propeller_diameter")
        if own.propeller_diameter:
            column.prop(own, "open_water_efficiency")
            if own.open_water_efficiency:
                column.prop(own, "shaft_efficiency")
            column.prop(own, "twin_screw")
            if own.twin_screw:
                column.prop(own, "pitch_ratio")
            else:
                column.prop(own, "open_stern")
                if not own.open_stern:
                    column.prop(own, "blade_area_ratio")

    def _draw_table(self, layout, context, result):
        row = layout.row(align=True)
        row.scale_y = 0.8
        chosen = [result.rows[i] for i in resistance_curves.shown(len(result.rows), _ROWS)]
        draw_column(row, "kn", [line["speed_kn"] for line in chosen])
        for name, column, unit in _COLUMNS:
            if column in chosen[0]:
                self._draw_quantity(row, context, name, unit, [line[column] for line in chosen])
        if resistance_curves.is_compared(result):
            found = [result.other.row_at(line["speed_m_s"]) for line in chosen]
            totals = [line and line["total_kN"] for line in found]
            self._draw_quantity(row, context, "other", "kN", totals)

    def _draw_quantity(self, row, context, name, unit, values):
        is_there = [v is not None and not math.isnan(v) for v in values]
        cells = [
            in_unit(context.scene, v, unit)[0] if ok else None for v, ok in zip(values, is_there)
        ]
        draw_column(row, f"{name} {in_unit(context.scene, 0.0, unit)[1]}", cells)


# Of the table: symbols, columns of hull_native's rows, units; PD is there where asked for.
_COLUMNS = (
    ("RT", "total_kN", "kN"),
    ("PE", "effective_power_kW", "kW"),
    ("PD", "delivered_power_kW", "kW"),
)


def draw_column(layout, heading, numbers):
    column = layout.column(align=True)
    column.alignment = "RIGHT"
    column.label(text=heading)
    for number in numbers:
        if number is None:
            column.label(text="–")
        else:
            column.label(text=f"{number:.4g}" if number < 1e4 else f"{number:.0f}")


class HULL_PT_resistance_inputs(HullPanel, bpy.types.Panel):
    """What the method asks of the hull, as measured, and what is given in its place"""

    bl_label = "Inputs"
    bl_parent_id = "HULL_PT_resistance"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout, hull = self.layout, hull_objects.hull_of(context.object)
        own = hull.hull.resistance
        if own.method == "HOLTROP":
            column = layout.column(align=True)
            column.prop(own, "thruster_diameter")
            if own.thruster_diameter:
                column.prop(own, "thruster_coefficient")
            metric_field(column, own, "roughness_um")
        if own.method != "MICHELL":  # which has no ranges of form that they would be out of
            text_field(layout, own, "hulls")
        rows = _inputs(own.method)
        if own.method == "MICHELL":
            text = "Waves are those of the exact surface, friction goes by these:"
            label_wrapped(layout, context, text, icon="INFO")
        outcome, is_current = live_analyses.latest(hull, context.scene, "resistance_curves")
        result = outcome.result if outcome else None
        measured = result.measured if result and result.given.method == own.method else {}
        column = layout.column(align=True)
        _draw_columns(column, "", "Given", "Hull")
        for place, name, unit in rows:
            value = measured.get(name)
            _draw_input(column, context, own, place, name, value, unit, is_current)
        label_wrapped(layout, context, "0: what the hull has")
        zeros = [name for _, name, _ in rows if name in ship_data.ZERO_INPUTS]
        if zeros:
            layout.label(text="Count as 0:")
            row = layout.row(align=True)
            for name in zeros:
                row.prop_enum(own, "zeros", name)


def _draw_columns(column, name, given, hull):
    """Three texts beside one another; returns the layouts of the last two."""
    split = column.split(factor=0.305, align=True)
    split.label(text=name)
    split = split.split(factor=0.545, align=True)
    places = split.row(align=True), split.row()
    for place, text in zip(places, (given, hull)):
        if text:
            place.label(text=text)
    return places


def _draw_input(column, context, own, place, input_name, value, unit, is_current):
    group, _, name = place.rpartition(".")
    settings = getattr(own, group) if group else own
    field, right = _draw_columns(column, settings.bl_rna.properties[name].name, "", "")
    field.prop(settings, name, text="")
    given = getattr(settings, name)
    right.active = is_current and not (given or input_name in own.zeros)
    right.label(text=_measured(context.scene, value, unit))
    if unit != "m" and imperial(unit) and is_imperial(context.scene):
        _draw_imperial(column.column(align=True), context, given, value, unit)


def _draw_imperial(column, context, given, value, unit):
    """Below a row in a metric unit what the numbers are in feet or their like."""
    column.active = False
    column.scale_y = 0.8

    def text(metric):
        if not metric:
            return ""
        number, _ = in_unit(context.scene, metric, unit)
        return f"{number:.3f}" if abs(number) < 100.0 else f"{number:.0f}"

    _draw_columns(column, in_unit(context.scene, 0.0, unit)[1], text(given), text(value))


def _measured(scene, value, unit):
    """As the setting beside it is typed: lengths in the scene's unit, others in those that their
    names have."""
    if value is None:
        return "–"
    if unit == "m":
        number, symbol = in_unit(scene, value, unit)
        return f"{number:.2f} {symbol}"
    return f"{value:.3f}" if abs(value) < 100.0 else f"{value:.1f}"


class HULL_PT_resistance_waves(HullPanel, bpy.types.Panel):
    """The waves behind the hull at a speed, by Michell's integral"""

    bl_label = "Waves"
    bl_parent_id = "HULL_PT_resistance"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout, hull = self.layout, hull_objects.hull_of(context.object)
        field_or(layout, hull.hull.resistance, "wave_speed_kn", "the last speed")
        for name in ("wave_pattern", "wave_spectrum"):
            layout.prop(hull.hull.plots, name)
            if getattr(hull.hull.plots, name):
                outcome = live_analyses.latest(hull, context.scene, name)[0]
                if outcome and outcome.message:
                    label_wrapped(layout, context, outcome.message, icon="INFO")
            export_buttons(layout, name)


class HULL_PT_resistance_remarks(HullPanel, bpy.types.Panel):
    """The last part: what it says comes and goes, and nothing is to move with it"""

    bl_label = "Remarks"
    bl_parent_id = "HULL_PT_resistance"

    def draw(self, context):
        hull = hull_objects.hull_of(context.object)
        outcome, self.layout.active = live_analyses.latest(hull, context.scene, "resistance_curves")
        result = outcome.result if outcome else None
        remarks = tuple(result.remarks()) if result else ()
        for remark in remarks:
            label_wrapped(self.layout, context, remark, icon="INFO")
        if result and not remarks:
            self.layout.label(text="None")


CLASSES = (
    HULL_PT_resistance,
    HULL_PT_resistance_inputs,
    HULL_PT_resistance_waves,
    HULL_PT_resistance_remarks,
)
