# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface faired around selected points, and rows of points smoothed: panels."""

import bpy

from ..bridge.mesh import curve_marks
from ..bridge.objects import hull_objects
from ..features.fairing import region_fairing, row_fairing
from ..features.hull import hull_state
from .conversion import draw_task
from .shared import HullPanel, draw_entries, label_value, label_wrapped


class HULL_PT_fair(HullPanel, bpy.types.Panel):
    """Fair the surface around the selected control points"""

    bl_label = "Fair"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        if context.object.mode != "EDIT":
            label_wrapped(layout, context, "In edit mode: select points", icon="INFO")
        elif not draw_task(layout, hull):
            column = layout.column(align=True)
            column.operator("hull.fair_region", icon="MOD_SMOOTH")
            column.operator("hull.fair_curvature", icon="SMOOTHCURVE")
        _draw_report(layout, context, region_fairing, hull)


class HULL_UL_curves(bpy.types.UIList):
    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        layout.prop(item, "is_shown", text="")
        layout.prop(item, "name", text="", emboss=False)

    def filter_items(self, context, data, property):
        entries = getattr(data, property)
        present = curve_marks.present(data.id_data.data)
        named = bpy.types.UI_UL_list.filter_items_by_name(
            self.filter_name, self.bitflag_filter_item, entries
        ) or [self.bitflag_filter_item] * len(entries)
        return [flag if entry.number in present else 0 for flag, entry in zip(named, entries)], []


class HULL_PT_fair_rows(HullPanel, bpy.types.Panel):
    """Rows of control points, their combs and inflections"""

    bl_label = "Rows of Points"
    bl_parent_id = "HULL_PT_fair"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        layout.prop(hull.hull.fairness, "comb_rows", text="Combs on rows")
        if context.object.mode != "EDIT":
            label_wrapped(layout, context, "In edit mode: select edges of rows", icon="INFO")
        else:
            column = layout.column(align=True)
            column.operator("hull.show_rows", icon="MOD_WIREFRAME")
            column.operator("hull.fair_row", icon="IPO_EASE_IN_OUT")
        state = hull_state.state_of(hull)
        group = None if state is None else state.fairness.combs.get("row")
        if group is not None:
            column = layout.column(align=True)
            column.scale_y = 0.8
            label_value(column, "Rows shown", str(len(group.rows)))
            label_value(column, "○ Inflections", str(group.mark_counts["inflection"]))
        _draw_report(layout, context, row_fairing, hull)


def _draw_report(layout, context, subject, hull):
    """What a subject of features.fairing tells of the last change that it made of a hull."""
    report, is_current = subject.last_report(hull)
    if report is None:
        return
    if not is_current:
        label_wrapped(layout, context, "Out of date: of before the last change", icon="ERROR")
    elif report.has_more_marks:
        label_wrapped(layout, context, "More marks than before", icon="ERROR")
    column = layout.column(align=True)
    column.active = is_current
    column.scale_y = 0.8
    for name, value in subject.rows(report):
        label_value(column, name, value)


class HULL_PT_control_curves(HullPanel, bpy.types.Panel):
    """Chains of edges with a name, a comb and smoothing of their own"""

    bl_label = "Control Curves"
    bl_parent_id = "HULL_PT_fair"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        chosen = draw_entries(layout, hull.hull.fairness, "curves", "active_curve", "curve")
        if context.object.mode != "EDIT":
            label_wrapped(layout, context, "In edit mode: select edges of a curve", icon="INFO")
        elif chosen is not None and chosen.number in curve_marks.present(hull.data):
            column = layout.column(align=True)
            column.operator("hull.select_curve", text="Select", icon="RESTRICT_SELECT_OFF")
            column.operator("hull.fair_curve", text="Fair", icon="IPO_EASE_IN_OUT")


CLASSES = (HULL_PT_fair, HULL_PT_fair_rows, HULL_UL_curves, HULL_PT_control_curves)
