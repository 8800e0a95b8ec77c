# SPDX-License-Identifier: GPL-3.0-or-later
"""How the surface becomes patches and how good these are, in the sidebar and beside the file
dialog."""

from ..bridge.blender import units
from ..features.conversion import conversions, patches, worst_spots
from ..features.exchange import step_size
from ..features.hull import hull_state
from ..properties.shared import field_or, metric_field
from .shared import label_value, label_wrapped, text_field


def draw_choice(layout, settings):
    """By what the surface is converted."""
    text_field(layout, settings, "conversion")
    if settings.conversion == patches.PER_CELL:
        layout.prop(settings, "control_points")
    column = layout.column(align=True)
    metric_field(column, settings, "tolerance_mm")
    asked = patches.asked_of(settings)
    label_value(column, "Of length", f"{asked.tolerance:.3g}")
    column = layout.column(align=True)
    column.prop(settings, "seam_angle")
    if not settings.seam_angle:
        label_value(column, "As tolerance", units.format_small_angle(asked.seam_angle))
    if settings.conversion != patches.PER_CELL:
        column = layout.column(align=True)
        column.prop(settings, "matched_knots")
        column.prop(settings, "bezier")
        field_or(column, settings, "most_control_points", "as many as there are")


def draw_task(layout, hull):
    """How far the task of a hull is; whether there is one."""
    task = conversions.running(hull)
    if task is None:
        return False
    row = layout.row(align=True)
    row.prop(hull.hull.export, "progress", text=task.text, slider=True)
    row.operator("hull.cancel_task", text="", icon="CANCEL")
    return True


def draw_report(layout, context, hull):
    """What came of the last conversion; whether it is of the hull and settings as they are."""
    outcome, is_current = conversions.last_outcome(hull)
    state = hull_state.state_of(hull)
    if state is not None and state.status:
        label_wrapped(layout, context, state.status, icon="ERROR")
    if outcome is None:
        return False
    if not is_current:
        label_wrapped(layout, context, "Out of date: of before the last change", icon="ERROR")
    if outcome.converted is None:
        label_wrapped(layout, context, outcome.message, icon="ERROR")
        return is_current
    quality = outcome.converted.quality
    if is_current:
        for text in patches.warnings(quality, patches.asked_of(hull.hull.export)):
            label_wrapped(layout, context, text, icon="ERROR")
        remark = step_size.remark(hull, outcome.converted)
        if remark:
            label_wrapped(layout, context, remark, icon="INFO")
    column = layout.column(align=True)
    column.active = is_current
    column.scale_y = 0.8
    for name, value in patches.rows(outcome.converted):
        label_value(column, name, value)
    return is_current


def draw_spots(layout, hull):
    """Buttons that mark where the patches are worst, and take the mark away again."""
    state = hull_state.state_of(hull)
    column = layout.column(align=True)
    column.label(text="Show worst spot")
    for kind, (name, _) in worst_spots.KINDS.items():
        is_shown = worst_spots.marked(state).kind == kind
        icon = "HIDE_OFF" if is_shown else "HIDE_ON"
        row = column.row(align=True)
        row.enabled = worst_spots.is_known(state, kind)
        button = row.operator("hull.show_worst_spot", text=name, icon=icon, depress=is_shown)
        button.kind = "NONE" if is_shown else kind
