# SPDX-License-Identifier: GPL-3.0-or-later
"""The criteria of the 2008 IS Code, and what the wind meets."""

import bpy

from ..bridge.blender.units import format_value
from ..bridge.objects import hull_objects
from ..features.analyses import live_analyses
from ..features.stability import criteria
from ..properties.shared import field_or, metric_field
from .shared import (
    OUTCOME_ICONS,
    OUTCOME_WORDS,
    HullPanel,
    draw_entries,
    export_buttons,
    label_value,
    label_wrapped,
    latest_result,
    text_field,
)

_BOUNDS = {"at least": "≥", "at most": "≤"}


class HULL_PT_criteria(HullPanel, bpy.types.Panel):
    """2008 IS Code, Part A, 2.2 and 2.3"""

    bl_label = "IS Code Criteria"
    bl_parent_id = "HULL_PT_stability"
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 6

    def draw(self, context):
        result, layout = latest_result(self.layout, context, "criteria", "IS Code, Part A")
        if result is None:
            return
        for paragraph, outcome, failed in result.outcomes():
            self._draw_outcome(layout, context, paragraph, outcome, failed)
        if result.no_weather:
            label_wrapped(layout, context, result.no_weather, icon="INFO")
        for note in result.notes():
            label_wrapped(layout, context, note, icon="INFO")
        for one in result.criteria:
            self._draw_criterion(layout, context, one)
        export_buttons(self.layout, "criteria")

    def _draw_outcome(self, layout, context, paragraph, outcome, failed):
        text = f"{paragraph} {criteria.NAMES[paragraph]}: {OUTCOME_WORDS[outcome]}"
        if failed:
            text += f" ({', '.join(failed)})"
        label_wrapped(layout, context, text, icon=OUTCOME_ICONS[outcome])

    def _draw_criterion(self, layout, context, one):
        column = layout.column(align=True)
        column.scale_y = 0.8
        text = f"{one.paragraph} {OUTCOME_WORDS[one.outcome]}: {one.name}"
        label_wrapped(column, context, text, icon=OUTCOME_ICONS[one.outcome])
        unit = {"rad": "deg", "m·rad": "m rad"}.get(one.unit, one.unit)
        value, limit = (format_value(context.scene, x, unit) for x in (one.value, one.limit))
        label_value(column, value, f"{_BOUNDS[one.bound]} {limit}")
        if one.outcome == "fail" and criteria.is_within_limit(one):
            label_wrapped(column, context, one.note, icon="BLANK1")


class HULL_UL_areas(bpy.types.UIList):
    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        layout.prop(item, "name", text="", emboss=False)
        layout.label(text=format_value(context.scene, item.area, "m2"))


class HULL_PT_wind(HullPanel, bpy.types.Panel):
    """For the severe wind and rolling criterion, 2.3"""

    bl_label = "Wind and Rolling"
    bl_parent_id = "HULL_PT_stability"
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 2

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        wind = hull.hull.wind
        text_field(layout, wind, "source")
        if wind.source == "NONE":
            return
        area = draw_entries(layout, wind, "areas", "active_area", "wind_area")
        if area is not None:
            column = layout.column(align=True)
            metric_field(column, area, "area")
            column.prop(area, "z")
        column = layout.column(align=True)
        field_or(column, wind, "lever", "by the heights of the areas")
        metric_field(column, wind, "pressure")
        metric_field(column, wind, "keel_area")
        field_or(column, wind, "roll_period", "by the IS Code")
        layout.prop(wind, "sharp_bilges")
        self._draw_numbers(layout, context, hull)

    def _draw_numbers(self, layout, context, hull):
        outcome, is_current = live_analyses.latest(hull, context.scene, "criteria")
        if outcome is None or outcome.result is None or outcome.result.weather is None:
            return
        column = layout.column(align=True)
        column.scale_y = 0.8
        column.active = is_current
        for _, name, value, unit in criteria.weather_numbers(outcome.result.weather):
            unit = {"rad": "deg", "m·rad": "m rad"}.get(unit, unit)
            label_value(column, name, format_value(context.scene, value, unit))


CLASSES = (HULL_UL_areas, HULL_PT_criteria, HULL_PT_wind)
