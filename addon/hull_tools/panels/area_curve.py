# SPDX-License-Identifier: GPL-3.0-or-later
"""The sectional area curve that is wanted: panel."""

import bpy

from ..bridge.blender.units import format_value, metres_per_unit
from ..bridge.objects import hull_objects
from ..features.area_curves import live_target, reports
from ..properties.shared import metric_field
from .conversion import draw_task
from .shared import HullPanel, draw_entries, label_value, label_wrapped, latest_result


class HULL_UL_area_points(bpy.types.UIList):
    """x and area of each point, rounded: fields would cut their last digits off."""

    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        x = item.x * metres_per_unit(context.scene)
        split = layout.split(factor=0.5)
        for value, unit in ((x, "m"), (item.area, "m2")):
            number, _, _ = format_value(context.scene, value, unit).partition(" ")
            place = split.row()
            place.alignment = "RIGHT"
            place.label(text=number)


class HULL_PT_area_curve(HullPanel, bpy.types.Panel):
    """The hull brought to a sectional area curve"""

    bl_label = "Area Curve"
    bl_parent_id = "HULL_PT_transform"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        settings = hull.hull.area_target
        column = layout.column(align=True)
        column.operator("hull.take_area_curve", icon="IMPORT")
        column.operator("hull.take_other_area_curve", text="Of Another Hull …")
        column.operator("hull.load_area_curve", text="From Table …")
        if not settings.area_points:
            return
        self._draw_target(context, hull)
        if not draw_task(layout, hull):
            layout.operator("hull.transform_to_area_curve", icon="SNAP_ON")

    def _draw_target(self, context, hull):
        layout, settings = self.layout, hull.hull.area_target
        if settings.source:
            label_value(layout, "Target from", settings.source)
        layout.operator("hull.drag_area_curve", icon="HANDLE_AUTO")
        layout.prop(settings, "show_target")
        point = draw_entries(layout, settings, "area_points", "active_area_point", "area_point")
        if point is not None:
            column = layout.column(align=True)
            column.prop(point, "x")
            metric_field(column, point, "area")
        row = layout.row(align=True)
        row.operator("hull.scale_area_curve")
        row.operator("hull.clear_area_curve", text="", icon="X")
        live = live_target.known(hull)
        if live is None or live.curve is None:
            label_wrapped(layout, context, "computing …" if live is None else live.status, "INFO")
            return
        self._draw_numbers(context, live)

    def _draw_numbers(self, context, live):
        scene = context.scene
        result, place = latest_result(
            self.layout, context, live_target.ANALYSIS, "Hull less target"
        )
        if result is None:
            return
        column = place.column(align=True)
        column.scale_y = 0.8
        found = live.difference(result.areas)
        label_value(column, "Area, most", reports.percent(found))
        label_value(column, "at x", format_value(scene, found.at, "m"))
        volume, centre = live_target.volume_of(hull_objects.hull_of(context.object), result)
        label_value(column, "∇", f"{100.0 * (volume / live.volume - 1.0):+.2f} %")
        label_value(column, "LCB", format_value(scene, centre - live.centre, "m"))
        label_value(column, "∇ of target", format_value(scene, live.volume, "m3"))
        label_value(column, "LCB of target", format_value(scene, live.centre, "m"))


CLASSES = (HULL_UL_area_points, HULL_PT_area_curve)
