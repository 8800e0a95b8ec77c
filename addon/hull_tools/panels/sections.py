# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines in the 3D view: which are shown, where they lie, how many there are."""

import bpy

from ..bridge.objects import hull_objects
from ..features.hull import hull_state
from ..features.lines import lines
from ..properties.shared import field_or
from .shared import HullPanel, label_list, label_wrapped, text_field


class HULL_PT_sections(HullPanel, bpy.types.Panel):
    bl_label = "Sections"

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        settings, state = hull.hull.lines, hull_state.state_of(hull)
        if state is not None and state.lines.status:
            label_wrapped(layout, context, state.lines.status, icon="ERROR")
        found = state.lines.groups if state is not None else {}
        is_current = not hull_state.is_outdated(hull)
        for kind, fields in (
            ("station", ("station_count", "stations")),
            ("waterline", ("waterline_spacing", "waterlines")),
            ("buttock", ("buttock_spacing", "buttocks")),
            ("diagonal", ("diagonals",)),
        ):
            column = self._draw_switch(layout, settings, found, kind, is_current)
            for name in fields:
                column.prop(settings, name)
            if kind == "station" and settings.stations:
                text_field(column, settings, "stations_in")
            if kind != "station" or settings.stations_in == "METRES":
                label_list(column, context, getattr(settings, fields[-1]))
        for kind in ("draft", "flat", "feature"):
            self._draw_switch(layout, settings, found, kind, is_current)
        if hull.hull.plates.ranges:
            layout.label(text="Frames: by the ranges of Plates")
        else:
            field_or(layout, settings, "frame_spacing", "no frames")
        layout.prop(settings, "in_front")
        layout.prop(settings, "width")
        layout.operator("hull.lines_as_curves", icon="OUTLINER_OB_CURVE")

    def _draw_switch(self, layout, settings, found, kind, is_current):
        """A kind's switch, and beside it how many are shown, pale where they are of the hull as it
        was; returns where more of it goes."""
        column = layout.column(align=True)
        row = column.row(align=True)
        row.prop(settings, lines.SWITCHES[kind])
        if kind in found:
            count = row.row()
            count.active = is_current
            count.alignment = "RIGHT"
            count.label(text=count_of(found[kind]))
        rest = column.column(align=True)
        rest.active = getattr(settings, lines.SWITCHES[kind])
        return rest


def count_of(group):
    """How many planes meet the hull, or how many curves of other kinds there are."""
    is_cut = group.kind not in ("flat", "feature")
    return str(group.cut_count if is_cut else len(group.features))


class HULL_UL_planes(bpy.types.UIList):
    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        layout.prop(item, "is_shown", text="")
        layout.prop(item, "name", text="", emboss=False)


class HULL_PT_planes(HullPanel, bpy.types.Panel):
    """Sections by planes of one's own"""

    bl_label = "Planes"
    bl_parent_id = "HULL_PT_sections"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        settings = hull_objects.hull_of(context.object).hull.lines
        layout.prop(settings, "show_planes")
        row = layout.row()
        row.template_list(
            "HULL_UL_planes", "", settings, "planes", settings, "active_plane", rows=3
        )
        column = row.column(align=True)
        column.operator_menu_enum("hull.add_plane", "direction", text="", icon="ADD")
        column.operator("hull.remove_plane", text="", icon="REMOVE")
        if 0 <= settings.active_plane < len(settings.planes):
            plane = settings.planes[settings.active_plane]
            layout.column(align=True).prop(plane, "normal")
            layout.column(align=True).prop(plane, "point")


CLASSES = (HULL_PT_sections, HULL_UL_planes, HULL_PT_planes)
