# SPDX-License-Identifier: GPL-3.0-or-later
"""Load cases: how the ship floats with each, and her stability."""

import bpy

from ..bridge.blender.units import format_value
from ..bridge.objects import hull_objects
from ..features import analyses
from ..features.analyses import live_analyses
from ..features.hull import hull_state
from ..properties.shared import metric_field
from .shared import (
    OUTCOME_ICONS,
    OUTCOME_WORDS,
    HullPanel,
    draw_entries,
    export_buttons,
    label_value,
    label_wrapped,
    latest_result,
)

_EQUILIBRIUM_ROWS = 11
_STABILITY_ROWS = 4  # of these
_MESSAGE_ROWS = 2  # of a load that floats


def _equilibrium_icon(found):
    """Whether the ship floats, floats but not as she was meant to, or does not."""
    if found.draft_mean is None:
        return "CANCEL"
    return "ERROR" if found.message else "CHECKMARK"


def _icon_in_list(found):
    """The same, and where she floats as she was meant to, whether she meets the criteria."""
    icon = _equilibrium_icon(found)
    if icon != "CHECKMARK" or found.stability is None:
        return icon
    return {**OUTCOME_ICONS, "fail": "ERROR"}[found.stability.outcome()]


class HULL_UL_load_cases(bpy.types.UIList):
    """Names, whether the criteria are met, and the mean drafts, as far as they are known."""

    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        outcome, is_current = analyses.last_outcome(data.id_data, context.scene, "load_cases")
        is_current = is_current and not hull_state.is_outdated(data.id_data)
        equilibria = outcome.result if is_current and outcome is not None else None
        if equilibria is None or index >= len(equilibria):
            layout.prop(item, "name", text="", emboss=False)
            return
        found = equilibria[index]
        layout.prop(item, "name", text="", emboss=False, icon=_icon_in_list(found))
        if found.draft_mean is not None:
            layout.label(text=format_value(context.scene, found.draft_mean, "m"))


class HULL_PT_load_cases(HullPanel, bpy.types.Panel):
    bl_label = "Load Cases"
    bl_parent_id = "HULL_PT_stability"
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 4

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        loading = hull.hull.loading
        case = draw_entries(layout, loading, "load_cases", "active_load_case", "load_case")
        if case is None:
            return
        column = layout.column(align=True)
        metric_field(column, case, "mass_t")
        for name in ("lcg", "tcg", "vcg", "with_weights"):
            column.prop(case, name)
        rows = _MESSAGE_ROWS + _EQUILIBRIUM_ROWS
        equilibria, place = latest_result(layout, context, "load_cases", "Equilibrium", rows)
        index = loading.active_load_case
        if equilibria is not None and index < len(equilibria):
            self._draw_equilibrium(place, context, equilibria[index])
        elif (
            equilibria is not None or not live_analyses.latest(hull, context.scene, "load_cases")[0]
        ):
            label_wrapped(place, context, "", rows=rows)
        export_buttons(layout, "load_cases")

    def _draw_equilibrium(self, layout, context, found):
        """In as many lines, whatever became of the load, lest what is below moves."""
        text, icon = found.message or "Floats, stable", _equilibrium_icon(found)
        if found.draft_mean is None:
            label_wrapped(layout, context, text, icon, _MESSAGE_ROWS + _EQUILIBRIUM_ROWS)
            return
        label_wrapped(layout, context, text, icon, _MESSAGE_ROWS)
        column = layout.column(align=True)
        column.scale_y = 0.8
        for name, attribute, unit in (
            ("Mean draft", "draft_mean", "m"),
            ("Draft aft", "draft_aft", "m"),
            ("Draft forward", "draft_forward", "m"),
            ("Trim", "trim_m", "m"),
            ("Heel", "heel", "deg"),
            ("GM", "gm", "m"),
        ):
            value = getattr(found, attribute)
            label_value(column, name, format_value(context.scene, value, unit))
        vcg = format_value(context.scene, found.case.centre[2], "m")
        label_value(column, "VCG", f"{vcg}, a guess" if found.case.vcg_is_guess else vcg)
        self._draw_stability(column, context, found)

    def _draw_stability(self, column, context, found):
        """Of the load; where it has none, the reason in as many lines."""
        if found.stability is None:
            return label_wrapped(column, context, found.no_stability, "INFO", _STABILITY_ROWS)
        for name, attribute, unit in (
            ("Greatest GZ", "greatest_lever", "m"),
            ("– at heel", "greatest_lever_heel", "deg"),
        ):
            value = getattr(found.stability, attribute)
            label_value(column, name, format_value(context.scene, value, unit))
        for paragraph, outcome, _ in found.stability.outcomes:
            label_value(column, f"IS Code {paragraph}", OUTCOME_WORDS[outcome])


CLASSES = (HULL_UL_load_cases, HULL_PT_load_cases)
