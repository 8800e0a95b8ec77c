# SPDX-License-Identifier: GPL-3.0-or-later
"""Stability of a load, equilibrium of load cases, plots."""

from math import degrees

import bpy

from ..bridge.blender.units import format_value
from ..bridge.objects import hull_objects
from ..features import analyses
from ..features.analyses import live_analyses
from ..features.flotation import afloat
from ..features.stability import righting_levers
from .shared import (
    HullPanel,
    draw_entries,
    export_buttons,
    field_or,
    label_value,
    label_wrapped,
    latest_result,
    text_field,
)

_LEVER_ROWS = 8  # beside the areas
_EQUILIBRIUM_ROWS = 6
_MESSAGE_ROWS = 2  # of a load that floats


def _degrees(angle):
    return f"{degrees(angle):.4g}°"


def _outcome(context, name):
    """The last Outcome of an analysis of the hull at hand, or None."""
    hull = hull_objects.hull_of(context.object)
    return live_analyses.latest(hull, context.scene, name)[0]


class HULL_PT_stability(HullPanel, bpy.types.Panel):
    bl_label = "Stability"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        loading = hull_objects.hull_of(context.object).hull.loading
        self._draw_load(layout, loading)
        layout.separator()
        areas = righting_levers.intervals(afloat.as_typed_angle(loading.heel_greatest))
        rows = _LEVER_ROWS + len(areas)
        result, place = latest_result(layout, context, "righting_levers", "Righting levers", rows)
        if result is not None or not _outcome(context, "righting_levers"):
            self._draw_levers(place, context, areas, result)
        export_buttons(layout, "righting_levers")

    def _draw_load(self, layout, loading):
        layout.prop(loading, "use_displacement")
        column = layout.column(align=True)
        if not loading.use_displacement:
            column.prop(loading, "mass_t")
        column.prop(loading, "kg")
        layout.prop(loading, "use_lcb")
        if not loading.use_lcb:
            layout.prop(loading, "lcg")
        layout.prop(loading, "free_trim")
        column = layout.column(align=True)
        column.prop(loading, "heel_greatest", text="Heels to")
        column.prop(loading, "heel_step")

    def _draw_levers(self, layout, context, areas, result):
        """The numbers; before they are there a dash for each, lest what is below moves then."""
        if result is None:
            found = load = None
            areas = [(*ends, None) for ends in areas]
        else:
            found, load, areas = result.levers, result.load, result.areas()
        column = layout.column(align=True)
        column.scale_y = 0.8

        def line(name, of, attribute, unit):
            value = getattr(of, attribute, None)
            label_value(column, name, format_value(context.scene, value, unit))

        line("Mass", load, "mass_t", "t")
        line("LCG", load, "lcg", "m")
        line("GM", found, "gm", "m")
        line("Greatest GZ", found, "greatest_lever", "m")
        line(f"– at heel{self._note(found)}", found, "greatest_lever_heel", "deg")
        line("Vanishing at", found, "vanishing_heel", "deg")
        line("Deck edge at", found, "deck_edge_heel", "deg")
        line("Downflooding at", found, "downflooding_heel", "deg")
        for start, end, area in areas:
            name = f"Area {degrees(start):.3g}–{_degrees(end)}"
            label_value(column, name, format_value(context.scene, area, "m rad"))

    def _note(self, found):
        """That the greatest GZ is at the last heel: at a further one it may be greater."""
        is_open = found and found.greatest_lever_at_end and found.greatest_lever_heel
        return " (last)" if is_open else ""


class HULL_PT_levers(HullPanel, bpy.types.Panel):
    bl_label = "Table of GZ"
    bl_parent_id = "HULL_PT_stability"
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 0

    def draw(self, context):
        heels = righting_levers.heels_of(hull_objects.hull_of(context.object).hull.loading)
        result, place = latest_result(
            self.layout, context, "righting_levers", "GZ over heel", len(heels)
        )
        if result is None and _outcome(context, "righting_levers"):
            return
        levers = [None] * len(heels)
        if result is not None:
            heels, levers = result.levers.heels, result.levers.levers
        column = place.column(align=True)
        column.scale_y = 0.8
        for heel, lever in zip(heels, levers):
            label_value(column, _degrees(heel), format_value(context.scene, lever, "m"))


class HULL_UL_downflooding_points(bpy.types.UIList):
    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        layout.prop(item, "name", text="", emboss=False, icon_value=icon)


def _equilibrium_icon(found):
    """Whether the ship floats, floats but not as she was meant to, or does not."""
    if found.draft_mean is None:
        return "CANCEL"
    return "ERROR" if found.message else "CHECKMARK"


class HULL_UL_load_cases(bpy.types.UIList):
    """Names, and the mean drafts as far as they are known."""

    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        outcome, is_current = analyses.last_outcome(data.id_data, context.scene, "load_cases")
        equilibria = outcome.result if is_current and outcome is not None else None
        if equilibria is None or index >= len(equilibria):
            layout.prop(item, "name", text="", emboss=False)
            return
        found = equilibria[index]
        layout.prop(item, "name", text="", emboss=False, icon=_equilibrium_icon(found))
        if found.draft_mean is not None:
            layout.label(text=format_value(context.scene, found.draft_mean, "m"))


class HULL_PT_downflooding_points(HullPanel, bpy.types.Panel):
    bl_label = "Openings"
    bl_parent_id = "HULL_PT_stability"
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 1

    def draw(self, context):
        loading = hull_objects.hull_of(context.object).hull.loading
        point = draw_entries(
            self.layout,
            loading,
            "downflooding_points",
            "active_downflooding_point",
            "downflooding_point",
        )
        if point is not None:
            self.layout.column(align=True).prop(point, "position")


class HULL_PT_load_cases(HullPanel, bpy.types.Panel):
    bl_label = "Load Cases"
    bl_parent_id = "HULL_PT_stability"
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 4

    def draw(self, context):
        layout = self.layout
        loading = hull_objects.hull_of(context.object).hull.loading
        case = draw_entries(layout, loading, "load_cases", "active_load_case", "load_case")
        if case is None:
            return
        column = layout.column(align=True)
        for name in ("mass_t", "lcg", "tcg", "vcg", "with_weights"):
            column.prop(case, name)
        rows = _MESSAGE_ROWS + _EQUILIBRIUM_ROWS
        equilibria, place = latest_result(layout, context, "load_cases", "Equilibrium", rows)
        index = loading.active_load_case
        if equilibria is not None and index < len(equilibria):
            self._draw_equilibrium(place, context, equilibria[index])
        elif equilibria is not None or not _outcome(context, "load_cases"):
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


class HULL_PT_cross_curves(HullPanel, bpy.types.Panel):
    bl_label = "Cross Curves KN"
    bl_parent_id = "HULL_PT_stability"
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 5

    def draw(self, context):
        loading = hull_objects.hull_of(context.object).hull.loading
        column = self.layout.column(align=True)
        field_or(column, loading, "least_t", "a quarter of the load")
        field_or(column, loading, "greatest_t", "5/4 of the load")
        column.prop(loading, "displacement_count")
        export_buttons(self.layout, "cross_curves")


class HULL_PT_stability_remarks(HullPanel, bpy.types.Panel):
    """The last part: what it says comes and goes while points are dragged, and nothing is to move
    with it."""

    bl_label = "Remarks"
    bl_parent_id = "HULL_PT_stability"
    bl_order = 7

    def draw(self, context):
        outcome = _outcome(context, "righting_levers")
        result = outcome.result if outcome else None
        remarks = tuple(result.remarks()) if result else ()
        for remark in remarks:
            label_wrapped(self.layout, context, remark, icon="INFO")
        if result and not remarks:
            self.layout.label(text="None")


class HULL_PT_plots(HullPanel, bpy.types.Panel):
    """Plots over the 3D view, and their files"""

    bl_label = "Plots"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        plots = hull.hull.plots
        for name in analyses.PLOTTED:
            row = layout.row(align=True)
            row.prop(plots, name)
            row.operator("hull.export_table", text="", icon="SPREADSHEET").analysis = name
            row.operator("hull.export_plot", text="", icon="EXPORT").analysis = name
            if getattr(plots, name):
                self._draw_reason(layout, context, hull, name)
        text_field(layout, plots, "corner")
        layout.prop(plots, "size")

    def _draw_reason(self, layout, context, hull, name):
        outcome, is_current = live_analyses.latest(hull, context.scene, name)
        if not is_current:
            layout.label(text="Computing …")
        elif outcome is not None and outcome.message:
            label_wrapped(layout, context, outcome.message, icon="INFO")


CLASSES = (
    HULL_UL_downflooding_points,
    HULL_UL_load_cases,
    HULL_PT_stability,
    HULL_PT_levers,
    HULL_PT_downflooding_points,
    HULL_PT_load_cases,
    HULL_PT_cross_curves,
    HULL_PT_stability_remarks,
    HULL_PT_plots,
)
