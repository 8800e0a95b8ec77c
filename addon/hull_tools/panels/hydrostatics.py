# SPDX-License-Identifier: GPL-3.0-or-later
"""Hydrostatics at the draft, trim and heel of the sliders, and their table."""

import bpy

from ..bridge.blender.units import format_value
from ..bridge.objects import hull_objects
from ..features.flotation import hydrostatics
from ..features.hull import hull_state
from ..properties.shared import field_or
from .doubts import draw_volume_mending
from .shared import HullPanel, export_buttons, label_list, label_value, label_wrapped, text_field

_ROWS = 2 + len(hydrostatics.KEY_FIGURES)  # of numbers in the panel itself

# Open from the start; the others unfold.
_OPEN_GROUPS = {"Displacement", "Centres", "Stability"}


def _state(context):
    hull = hull_objects.hull_of(context.object)
    return hull, hull_state.state_of(hull)


class HULL_PT_hydrostatics(HullPanel, bpy.types.Panel):
    bl_label = "Hydrostatics"

    def draw(self, context):
        layout = self.layout
        hull, state = _state(context)
        column = layout.column(align=True)
        for name in ("draft", "trim_m", "heel"):
            column.prop(hull.hull, name)
        layout.prop(hull.hull, "deck_closed")
        if state is None:
            return
        found = state.hydrostatics.values
        if found is None:
            said = state.status or state.hydrostatics.status or "No surface yet"
            label_wrapped(layout, context, said, icon="INFO")
            draw_volume_mending(layout, hull, state)
            return
        if found.remark and not state.status:
            label_wrapped(layout, context, found.remark, icon="ERROR")
            draw_volume_mending(layout, hull, state)
        self._draw_appendages(layout, context, hull, state.ship)
        if state.status:  # numbers would be those of the hull as it was
            label_wrapped(layout, context, state.status, "ERROR", _ROWS)
            return
        column = layout.column(align=True)
        column.scale_y = 0.8
        scene = context.scene
        label_value(column, "Draft aft", format_value(scene, found.draft_aft, "m"))
        label_value(column, "Draft forward", format_value(scene, found.draft_forward, "m"))
        units = {quantity.name: quantity.unit for quantity in hydrostatics.QUANTITIES}
        for name, label in hydrostatics.KEY_FIGURES:
            label_value(column, label, format_value(scene, getattr(found, name), units[name]))

    def _draw_appendages(self, layout, context, hull, ship):
        if ship.not_joined:
            label_wrapped(
                layout, context, f"Appendages not counted: {ship.not_joined}", icon="ERROR"
            )
        elif ship.appendages_key:
            names = ", ".join(body.name for body in ship.appendages_key)
            label_wrapped(layout, context, f"With {names}")
        if ship.added_up:
            label_wrapped(layout, context, f"{ship.overlap}, which count twice", icon="ERROR")
        elif ship.overlap:
            often = "once" if ship.source.once else "twice, being so little"
            label_wrapped(layout, context, f"{ship.overlap}, which count {often}")


class _GroupPanel(HullPanel):
    """The numbers of one group of hydrostatics; dashes where the hull has none, as it is now."""

    bl_parent_id = "HULL_PT_hydrostatics"

    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        _, state = _state(context)
        return state is not None and state.hydrostatics.values is not None

    def draw(self, context):
        hull, state = _state(context)
        note = hydrostatics.GROUP_NOTES.get(self.bl_label)
        if note:
            label_wrapped(self.layout, context, note)
        column = self.layout.column(align=True)
        column.scale_y = 0.8
        values = None if state.status else state.hydrostatics.values
        for quantity in hydrostatics.QUANTITIES:
            if quantity.group == self.bl_label:
                value = getattr(values, quantity.name, None)
                label_value(
                    column, quantity.label, format_value(context.scene, value, quantity.unit)
                )


def _group_panel(group):
    name = group.lower().replace(", ", "_").replace(" ", "_")
    options = set() if group in _OPEN_GROUPS else {"DEFAULT_CLOSED"}
    contents = {"bl_label": group, "bl_options": options}
    return type(f"HULL_PT_hydrostatics_{name}", (_GroupPanel, bpy.types.Panel), contents)


class HULL_PT_hydrostatic_table(HullPanel, bpy.types.Panel):
    bl_label = "Table over Drafts"
    bl_parent_id = "HULL_PT_hydrostatics"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        table = hull_objects.hull_of(context.object).hull.table
        column = layout.column(align=True)
        field_or(column, table, "draft_from", "the first step")
        field_or(column, table, "draft_to", "the draft")
        field_or(column, table, "draft_step", "a tenth of the range")
        text_field(layout, table, "trims")
        label_list(layout, context, table.trims)
        export_buttons(layout, "hydrostatic_table")


CLASSES = (
    HULL_PT_hydrostatics,
    *(_group_panel(group) for group in hydrostatics.GROUPS),
    HULL_PT_hydrostatic_table,
)
