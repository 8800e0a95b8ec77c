# SPDX-License-Identifier: GPL-3.0-or-later
"""By what fairness is judged: combs and their marks, colours, knuckles, reflection lines, flat
regions."""

from math import degrees

import bpy

from ..bridge.blender.units import format_value, imperial, in_unit, is_imperial, metric_symbol
from ..bridge.objects import hull_objects
from ..features.analyses import live_analyses
from ..features.conversion import conversions
from ..features.fairing import seen_marks
from ..features.fairness import combs
from ..features.hull import form_before, hull_state
from ..features.surface import colours
from ..properties.shared import field_or
from .conversion import draw_task
from .shared import HullPanel, choice_below, export_buttons, label_value, label_wrapped

_MARK_NAMES = {"inflection": "○ Inflections", "maximum": "▲ Most bent", "minimum": "▼ Least bent"}

_NAMES = {
    "station": "Stations",
    "waterline": "Waterlines",
    "buttock": "Buttocks",
    "diagonal": "Diagonals",
    "plane": "Planes",
    "feature": "Knuckles, borders",
    "row": "Rows of points",
}


def _at_hand(context):
    hull = hull_objects.hull_of(context.object)
    return hull.hull.fairness, hull_state.state_of(hull)


class HULL_PT_fairness(HullPanel, bpy.types.Panel):
    bl_label = "Fairness"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        fairness, state = _at_hand(context)
        layout = self.layout
        if state is not None and state.fairness.status:
            label_wrapped(layout, context, state.fairness.status, icon="ERROR")
        choice_below(layout, fairness, "colours")
        if fairness.colours != "NONE":
            column = layout.column(align=True)
            if fairness.colours not in ("SLOPE", "DISTANCE"):
                column.prop(fairness, "logarithmic")
            draw_colour_limit(column, context, fairness)
        layout.operator("hull.check_flat", icon="MESH_PLANE")


def draw_colour_limit(layout, context, fairness):
    """The greatest value that colours tell apart, which is metric in any scene."""
    unit = colours.unit_of(fairness)
    is_other = imperial(unit) is not None and is_imperial(context.scene)
    shown = {"text": f"Limit {metric_symbol(unit)}"} if is_other else {}
    field_or(layout, fairness, "colour_limit", "by the hull", unit if is_other else None, **shown)


class HULL_PT_combs(HullPanel, bpy.types.Panel):
    """Curvature combs, inflections and extrema"""

    bl_label = "Combs"
    bl_parent_id = "HULL_PT_fairness"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        fairness, state = _at_hand(context)
        layout = self.layout
        flow = layout.grid_flow(columns=1, align=True)
        for switch in combs.SWITCHES.values():
            flow.prop(fairness, switch)
        flow.prop(fairness, "comb_rows")
        column = layout.column(align=True)
        column.prop(fairness, "comb_factor")
        field_or(column, fairness, "comb_step", "a 200th of the hull")
        row = layout.row(align=True)
        row.prop(fairness, "show_inflections")
        row.prop(fairness, "show_extrema")
        if state is None or not state.fairness.combs:
            return
        column = layout.column(align=True)
        column.scale_y = 0.8
        column.active = not state.status  # else they are of the hull as it was
        bend, symbol = in_unit(context.scene, 1.0, "1/m")
        column.label(text=f"Tooth for {symbol}")
        for kind, group in state.fairness.combs.items():
            tooth = group.scale * fairness.comb_factor / bend
            label_value(column, _NAMES[kind], format_value(context.scene, tooth, "m"))
        for mark, name in _MARK_NAMES.items():
            count = sum(group.mark_counts[mark] for group in state.fairness.combs.values())
            label_value(column, name, str(count))


def draw_marks_compared(layout, hull):
    """The button that tells what the last transformation did to the marks, where it is known."""
    if form_before.is_known(hull) and conversions.running(hull) is None:
        layout.operator(
            "hull.count_marks", text="Marks New and Gone", icon="VIEWZOOM"
        ).compare = True


def draw_mark_change(layout, hull):
    """The same and what it told, in the panel of what changes the form."""
    draw_marks_compared(layout, hull)
    report, is_current = seen_marks.last_report(hull)
    if is_current and report.change is not None:
        label_value(layout, "Marks", seen_marks.change_text(report))


class HULL_PT_marks(HullPanel, bpy.types.Panel):
    """What an eye sees that is not fair, counted"""

    bl_label = "Marks"
    bl_parent_id = "HULL_PT_fairness"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        if not draw_task(layout, hull):
            layout.operator("hull.count_marks", icon="VIEWZOOM").compare = False
            draw_marks_compared(layout, hull)
        report, is_current = seen_marks.last_report(hull)
        if report is not None:
            if not is_current:
                label_wrapped(layout, context, "Out of date: of before the last change", "ERROR")
            column = layout.column(align=True)
            column.active = is_current
            column.scale_y = 0.8
            for name, value in seen_marks.rows(report):
                label_value(column, name, value)
            self._draw_places(context, hull, report)
        if len(hull.hull.fairness.accepted):
            layout.operator("hull.accept_no_marks")

    def _draw_places(self, context, hull, report):
        if not report.places:
            return
        layout = self.layout
        row = layout.row(align=True)
        row.operator("hull.show_mark", text="", icon="TRIA_LEFT").step = -1
        row.operator("hull.show_mark", icon="RESTRICT_SELECT_OFF").step = 0
        row.operator("hull.show_mark", text="", icon="TRIA_RIGHT").step = 1
        number, place = seen_marks.shown_place(hull)
        text = "" if place is None else seen_marks.text_of(*place)
        if text:
            text = f"{number + 1} of {len(report.places)}: {text}"
            label_wrapped(layout, context, text, rows=3)
        row = layout.row(align=True)
        part = row.row(align=True)
        part.active = place is not None
        part.operator("hull.accept_marks").all = False
        row.operator("hull.accept_marks", text="Accept All").all = True


class HULL_PT_knuckles(HullPanel, bpy.types.Panel):
    """The angle along knuckles, between the surface's normals on both sides"""

    bl_label = "Knuckles"
    bl_parent_id = "HULL_PT_fairness"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        outcome, is_current = live_analyses.latest(hull, context.scene, "knuckle_angles")
        if outcome is not None and outcome.result is None:
            label_wrapped(layout, context, outcome.message, icon="INFO")
        elif outcome is not None:
            column = layout.column(align=True)
            column.active = is_current
            column.scale_y = 0.8
            column.label(text="Least, mean, largest angle")
            for place, one in enumerate(outcome.result):
                # A knuckle across the ship is at one place.
                ends = dict.fromkeys(format_value(context.scene, x, "m") for x in one.reach)
                reach = " – ".join(ends)
                column.label(text=f"{place + 1}: x {reach}")
                column.label(text=_angles(one), icon="BLANK1")
        layout.prop(hull.hull.plots, "knuckle_angles", text="Plot over the view")
        if context.object.mode == "EDIT":
            layout.operator("hull.set_knuckle_angle", text="Set Angle …", icon="MOD_SIMPLEDEFORM")
        export_buttons(layout, "knuckle_angles")


def _angles(knuckle):
    return "  ".join(
        f"{degrees(angle):.1f}°" for angle in (knuckle.least, knuckle.mean, knuckle.largest)
    )


class HULL_PT_reflections(HullPanel, bpy.types.Panel):
    """Reflection lines, isophotes and silhouette"""

    bl_label = "Light and Outline"
    bl_parent_id = "HULL_PT_fairness"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        fairness, state = _at_hand(context)
        layout = self.layout
        layout.prop(fairness, "show_reflections")
        if fairness.show_reflections:
            column = layout.column(align=True)
            column.prop(fairness, "reflection_spacing")
            layout.column(align=True).prop(fairness, "line_direction")
            layout.column(align=True).prop(fairness, "light_direction")
        layout.prop(fairness, "show_isophotes")
        if fairness.show_isophotes:
            layout.prop(fairness, "isophote_spacing")
            layout.column(align=True).prop(fairness, "isophote_direction")
        layout.prop(fairness, "show_silhouette")
        if fairness.show_reflections or fairness.show_silhouette:
            layout.column(align=True).prop(fairness, "eye_direction")
            layout.operator("hull.eye_from_view", icon="HIDE_OFF")
        layout.prop(fairness, "divisions")


CLASSES = (
    HULL_PT_fairness,
    HULL_PT_combs,
    HULL_PT_marks,
    HULL_PT_knuckles,
    HULL_PT_reflections,
)
