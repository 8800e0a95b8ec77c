# SPDX-License-Identifier: GPL-3.0-or-later
"""Stability of a load, plots."""

from math import degrees

import bpy

from ..bridge.blender.units import format_value
from ..bridge.objects import hull_objects
from ..features import analyses
from ..features.analyses import live_analyses
from ..features.flotation import afloat
from ..features.stability import righting_levers
from ..properties.shared import field_or, metric_field
from .shared import (
    HullPanel,
    draw_entries,
    export_buttons,
    label_value,
    label_wrapped,
    latest_result,
    text_field,
    why_old,
)

_LEVER_ROWS = 9  # beside the areas


def _degrees(angle):
    return f"{degrees(angle):.4g}°"


def _outcome(context, name):
    """The last Outcome of an analysis of the hull at hand, or None."""
    hull = hull_objects.hull_of(context.object)
    return live_analyses.latest(hull, context.scene, name)[0]


def _chosen_case(context):
    """What is known of the load case that is chosen in the list, or None: nothing is asked for."""
    hull = hull_objects.hull_of(context.object)
    outcome, is_current = analyses.last_outcome(hull, context.scene, "load_cases")
    found = outcome.result if outcome is not None and is_current else None
    index = hull.hull.loading.active_load_case
    return found[index] if found and 0 <= index < len(found) else None


class HULL_PT_stability(HullPanel, bpy.types.Panel):
    bl_label = "Stability"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        loading = hull_objects.hull_of(context.object).hull.loading
        self._draw_load(layout, context, loading)
        layout.separator()
        areas = righting_levers.intervals(afloat.as_typed_angle(loading.heel_greatest))
        rows = _LEVER_ROWS + len(areas)
        result, place = latest_result(layout, context, "righting_levers", "Righting levers", rows)
        if result is not None or not _outcome(context, "righting_levers"):
            self._draw_levers(place, context, areas, result)
        export_buttons(layout, "righting_levers")

    def _draw_load(self, layout, context, loading):
        text_field(layout, loading, "loaded")
        if loading.loaded == "TYPED":
            self._draw_typed(layout, context, loading)
        elif loading.loaded == "CASE":
            split = layout.split(factor=0.4)
            split.label(text="Load case")
            split.prop_search(loading, "loaded_case", loading, "load_cases", text="")
        layout.prop(loading, "free_trim")
        column = layout.column(align=True)
        column.prop(loading, "heel_greatest", text="Heels to")
        column.prop(loading, "heel_step")

    def _draw_typed(self, layout, context, loading):
        layout.prop(loading, "use_displacement")
        column = layout.column(align=True)
        if not loading.use_displacement:
            metric_field(column, loading, "mass_t")
        column.prop(loading, "kg")
        layout.prop(loading, "use_lcb")
        if not loading.use_lcb:
            layout.prop(loading, "lcg")

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
        line("VCG", load, "kg", "m")
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
        case = _chosen_case(context)
        if case is not None and case.stability is not None:
            self.layout.label(text=f"{case.case.name}:")
            for note in case.stability.notes:
                label_wrapped(self.layout, context, note, icon="INFO")
        elif result and not remarks:
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
            layout.label(text=why_old(hull).capitalize())
        elif outcome is not None and outcome.message:
            label_wrapped(layout, context, outcome.message, icon="INFO")


CLASSES = (
    HULL_UL_downflooding_points,
    HULL_PT_stability,
    HULL_PT_levers,
    HULL_PT_downflooding_points,
    HULL_PT_cross_curves,
    HULL_PT_stability_remarks,
    HULL_PT_plots,
)
