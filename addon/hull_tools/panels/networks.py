# SPDX-License-Identifier: GPL-3.0-or-later
"""Networks of curves: panel."""

import bpy

from ..bridge.blender import sentence_units, units
from ..bridge.counts import counted
from ..bridge.objects import hull_objects, networks
from ..features.networks import network_state, to_hull
from ..properties.shared import field_or, metric_field
from .shared import HullTab, label_value, label_wrapped, text_field

# Of problems, and of curves that are off a hull, how many are listed.
_MOST_LISTED, _MOST_CURVES = 12, 5


class HULL_PT_networks(HullTab, bpy.types.Panel):
    """Curves that make a hull: drawn, tied, smoothed, with the surface between them"""

    bl_label = "Networks"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        network = networks.at_hand(context)
        if network is None:
            self._draw_beginnings(layout, context)
            return
        self._draw_network(context, network)
        settings = network.hull_network
        column = layout.column(align=True)
        column.operator_menu_enum("hull.add_network_curve", "kind", icon="ADD")
        column.operator_menu_enum("hull.draw_network_curve", "kind", icon="GREASEPENCIL")
        column.operator_menu_enum("hull.add_network_section", "kind", icon="MOD_BOOLEAN")
        column = layout.column(align=True)
        column.operator("hull.tie_curves", icon="SNAP_ON")
        column.prop(settings, "tolerance")
        column.prop(settings, "tie")
        column = layout.column(align=True)
        column.operator("hull.smooth_network_curve", icon="MOD_SMOOTH")
        metric_field(column, settings, "deviation_mm", text="M in mm")
        column = layout.column(align=True)
        column.prop(settings, "show_surface")
        row = column.row()
        row.active = settings.show_surface
        row.prop(settings, "samples")
        column.prop(settings, "show_curves")
        self._draw_beginnings(layout.column(align=True), context)

    def _draw_beginnings(self, layout, context):
        layout.operator("hull.new_network", icon="OUTLINER_COLLECTION")
        if hull_objects.hull_of(context.object) is not None:
            layout.operator("hull.network_from_hull", icon="MESH_DATA")
        layout.operator("hull.curves_to_network", icon="CURVE_DATA")

    def _draw_network(self, context, network):
        layout = self.layout
        layout.label(text=network.name, icon="OUTLINER_COLLECTION")
        reason = networks.locked(network)
        if reason:
            label_wrapped(layout, context, reason, icon="INFO")
        state = network_state.state_of(network)
        if state is None:
            return
        column = layout.column(align=True)
        column.scale_y = 0.8
        label_value(column, "Curves", str(len(state.curves)))
        if state.network is not None:
            label_value(column, "Regions", str(state.network.region_count))


def _curve_at_hand(context):
    """The active object where it is a curve of a network; None for others."""
    obj = context.object
    if obj is None or obj.type != "CURVE" or networks.network_of(obj) is None:
        return None
    return obj


class HULL_PT_network_curve(HullTab, bpy.types.Panel):
    """What the active curve of a network is"""

    bl_label = "Curve of Network"
    bl_parent_id = "HULL_PT_networks"

    @classmethod
    def poll(cls, context):
        return _curve_at_hand(context) is not None

    def draw(self, context):
        layout = self.layout
        obj = _curve_at_hand(context)
        settings = obj.hull.curve
        layout.label(text=obj.name, icon="CURVE_DATA")
        text_field(layout, settings, "kind")
        text_field(layout, settings, "plane")
        if settings.plane == "OWN":
            layout.column(align=True).prop(settings, "normal")
        if settings.plane != "NONE":
            layout.prop(settings, "position")
        text_field(layout, settings, "role")
        self._draw_found_role(layout, obj)
        text_field(layout, settings, "shape")
        if settings.shape == "CONIC":
            layout.prop(settings, "fullness")
        for end in ("start", "end"):
            column = layout.column(align=True)
            text_field(column, settings, end)
            kind = getattr(settings, end)
            if kind == "TANGENT":
                column.prop(settings, f"{end}_direction", text="")
            elif kind.startswith("SLAVE"):
                text_field(column, settings, f"{end}_master")
        self._draw_distance(layout, obj)
        layout.prop(settings, "show_comb")
        if settings.show_comb:
            layout.prop(networks.network_of(obj).hull_network, "comb_factor")
        layout.operator("hull.remove_from_network", icon="UNLINKED")

    def _draw_distance(self, layout, obj):
        distance = to_hull.of_curve(networks.network_of(obj), obj.name)
        if distance is not None:
            rms, largest = units.format_mm(distance.rms), units.format_mm(distance.largest)
            text = f"Off the hull: RMS {rms}, at most {largest}"
            layout.label(text=sentence_units.in_scene_units(bpy.context.scene, text))

    def _draw_found_role(self, layout, obj):
        state = network_state.state_of(networks.network_of(obj))
        if state is None or obj.name not in state.joined or not state.is_joined:
            return
        border, crease, smooth = state.roles[state.joined.index(obj.name)]
        found = [(border, "border"), (crease, "knuckle"), (smooth, "smooth")]
        told = ", ".join(f"{count} {name}" for count, name in found if count)
        if told:
            layout.label(text=f"Edges: {told}")


class HULL_PT_network_surface(HullTab, bpy.types.Panel):
    """How good the surface of the network is, and files of it"""

    bl_label = "Surface of Network"
    bl_parent_id = "HULL_PT_networks"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return network_state.state_of(networks.at_hand(context)) is not None

    def draw(self, context):
        layout = self.layout
        network = networks.at_hand(context)
        state = network_state.state_of(network)
        column = layout.column(align=True)
        column.prop(network.hull_network, "draft")
        column.operator("hull.measure_network", icon="DRIVER_DISTANCE")
        measured = state.measured
        if measured is not None:
            if measured.revision != state.revision:
                label_wrapped(layout, context, "Of the curves as they were", icon="INFO")
            box = layout.column(align=True)
            for line in measured.lines:
                label_wrapped(box, context, line)
        layout.operator("hull.export_network", icon="EXPORT")


class HULL_PT_network_hull(HullTab, bpy.types.Panel):
    """A hull laid over the network, and how far the curves are from it"""

    bl_label = "Hull of Network"
    bl_parent_id = "HULL_PT_networks"

    @classmethod
    def poll(cls, context):
        return networks.at_hand(context) is not None

    def draw(self, context):
        layout = self.layout
        network = networks.at_hand(context)
        settings = network.hull_network
        column = layout.column(align=True)
        column.prop(settings, "hull_points")
        field_or(column, settings, "hull_tolerance", "3e-4 of the length")
        text_field(layout, settings, "layout_hull")
        layout.operator("hull.network_to_hull", icon="MESH_DATA")
        report, is_current = to_hull.last_report(network)
        if report is None:
            return
        if not is_current:
            label_wrapped(layout, context, "Out of date: of before the last change", icon="ERROR")
        column = layout.column(align=True)
        column.active = is_current
        column.scale_y = 0.8
        for name, value in to_hull.rows(report):
            label_value(column, name, value)
        if is_current:
            self._draw_curves(layout, report)

    def _draw_curves(self, layout, report):
        column = layout.column(align=True)
        for index, curve in enumerate(report.curves[:_MOST_CURVES]):
            row = column.row(align=True)
            label_value(row, curve.name, units.format_mm(curve.largest))
            row.operator("hull.show_network_miss", text="", icon="HIDE_OFF").index = index


class HULL_PT_network_problems(HullTab, bpy.types.Panel):
    """What is wrong with the network, and the way there"""

    bl_label = "Network Check"
    bl_parent_id = "HULL_PT_networks"

    @classmethod
    def poll(cls, context):
        return network_state.state_of(networks.at_hand(context)) is not None

    def draw(self, context):
        layout = self.layout
        state = network_state.state_of(networks.at_hand(context))
        if not state.curves and not state.problems:
            layout.label(text="There are no curves yet", icon="INFO")
        elif not state.problems:
            layout.label(text="No problems", icon="CHECKMARK")
        for index, problem in enumerate(state.problems[:_MOST_LISTED]):
            box = layout.box()
            label_wrapped(box, context, problem.text, "INFO" if problem.is_note else "ERROR")
            if problem.curves or len(problem.places):
                box.operator("hull.select_network_problem").index = index
        left = len(state.problems) - _MOST_LISTED
        if left > 0:
            layout.label(text=f"and {counted(left, 'more problem')}")


CLASSES = (
    HULL_PT_networks,
    HULL_PT_network_curve,
    HULL_PT_network_surface,
    HULL_PT_network_hull,
    HULL_PT_network_problems,
)
