# SPDX-License-Identifier: GPL-3.0-or-later
"""What the panels have in common: their place, and texts that fit a narrow sidebar."""

import textwrap

import bpy

from ...hull_io import number_lists
from ..bridge.blender import sentence_units
from ..bridge.blender.units import in_unit, is_imperial
from ..bridge.objects import hull_objects
from ..features import analyses
from ..features.analyses import live_analyses
from ..features.hull import hull_state

# What the tabs, the margins of panel and box and an icon leave of the sidebar's width, in points,
# and the width of a letter of the interface's font on average.
_MARGINS = 75
_LETTER = 6.4

_LONGEST_LIST = 100  # letters of a list in feet, as the field beside it shows the whole

# Of the outcome of a criterion.
OUTCOME_ICONS = {"pass": "CHECKMARK", "fail": "CANCEL", "not computed": "QUESTION"}
OUTCOME_WORDS = {"pass": "met", "fail": "not met", "not computed": "not evaluated"}


class HullTab:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Hull"


class HullPanel(HullTab):
    """A panel that is there when the active object is a hull or shows one."""

    @classmethod
    def poll(cls, context):
        return hull_objects.hull_of(context.object) is not None


def label_wrapped(layout, context, text, icon="NONE", rows=0):
    """A text as labels of one line each, the icon before the first; as many lines as `rows` at
    least, where nothing below is to move with it; in the scene's units."""
    text = sentence_units.in_scene_units(context.scene, text)
    width = context.region.width / context.preferences.system.ui_scale
    column = layout.column(align=True)
    column.scale_y = 0.8
    lines = textwrap.wrap(text, max(8, int((width - _MARGINS) / _LETTER)))
    for line in lines + [""] * (rows - len(lines)):
        column.label(text=line, icon=icon)
        icon = "NONE" if icon == "NONE" else "BLANK1"


def label_value(layout, name, value):
    """A name to the left, and its value to the right, in the scene's units."""
    row = layout.row()
    left = row.row()
    left.alignment = "LEFT"
    left.label(text=name)
    right = row.row()
    right.alignment = "RIGHT"
    right.label(text=sentence_units.in_scene_units(bpy.context.scene, value))


def text_field(layout, settings, name):
    """A text or a choice after its name, which gets more room than Blender gives it."""
    split = layout.split(factor=0.4)
    split.label(text=settings.bl_rna.properties[name].name)
    split.prop(settings, name, text="")


def choice_below(layout, settings, name):
    """A choice below its name, where it has long words."""
    column = layout.column(align=True)
    column.label(text=settings.bl_rna.properties[name].name)
    column.prop(settings, name, text="")


def label_list(layout, context, text):
    """A list of lengths in m in feet, below its field in an imperial scene, as far as it can be
    understood."""
    if not text.strip() or not is_imperial(context.scene):
        return
    factor, symbol = in_unit(context.scene, 1.0, "m")
    try:
        feet = number_lists.scaled(text, factor)
    except ValueError:
        return  # which is told where the lines are
    feet = textwrap.shorten(feet, _LONGEST_LIST, placeholder=" …")
    column = layout.column()
    column.active = False
    label_wrapped(column, context, f"= {feet} {symbol}/°" if "/" in text else f"= {feet} {symbol}")


def export_buttons(layout, analysis):
    """The buttons that write the table, and the plot if there is one, of an analysis."""
    row = layout.row(align=True)
    row.operator("hull.export_table", text="Table", icon="EXPORT").analysis = analysis
    if analysis in analyses.PLOTTED:
        row.operator("hull.export_plot", text="Plot", icon="EXPORT").analysis = analysis


def latest_result(layout, context, name, heading, rows=0):
    """(the result of an analysis, where to show it) below a heading, pale while a newer one is
    computed, or there can be none as the hull is now; (None, there) and what is to be said instead,
    in as many lines as `rows` at least."""
    hull = hull_objects.hull_of(context.object)
    outcome, is_current = live_analyses.latest(hull, context.scene, name)
    layout.label(text=heading if is_current else f"{heading}: {why_old(hull)}")
    place = layout.column()
    place.active = is_current
    if outcome is None:
        return None, place
    if outcome.result is None:
        label_wrapped(place, context, outcome.message, "INFO", rows)
    return outcome.result, place


def why_old(hull):
    """Why a result is not of a hull as it is now, in few words after a heading."""
    return "hull has errors" if hull_state.is_outdated(hull) else "computing …"


def draw_entries(layout, settings, entries, active, kind):
    """A list of a property group with its buttons; returns the chosen entry, None without one.

    kind: as the operators that add and remove entries are named.
    """
    row = layout.row()
    row.template_list(f"HULL_UL_{entries}", "", settings, entries, settings, active, rows=3)
    column = row.column(align=True)
    column.operator(f"hull.add_{kind}", text="", icon="ADD")
    column.operator(f"hull.remove_{kind}", text="", icon="REMOVE")
    chosen = getattr(settings, entries)
    index = getattr(settings, active)
    return chosen[index] if 0 <= index < len(chosen) else None
