# SPDX-License-Identifier: GPL-3.0-or-later
"""What the ship weighs without load."""

import bpy

from ..bridge.blender.units import format_value
from ..bridge.objects import hull_objects
from ..properties.shared import field_or, metric_field
from .shared import HullPanel, draw_entries, export_buttons, label_value, latest_result

_ROWS = 4  # of the sum


class HULL_UL_items(bpy.types.UIList):
    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        layout.prop(item, "name", text="", emboss=False)
        layout.label(text=format_value(context.scene, item.mass_t, "t"))


class HULL_PT_weights(HullPanel, bpy.types.Panel):
    """The shell's plating, and a list of all else"""

    bl_label = "Weights"
    bl_parent_id = "HULL_PT_stability"
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 3

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        weights = hull.hull.weights
        column = layout.column(align=True)
        column.prop(weights, "thickness")
        metric_field(column, weights, "density")
        self._draw_layers(layout, hull)
        item = draw_entries(layout, weights, "items", "active_item", "weight")
        if item is not None:
            column = layout.column(align=True)
            metric_field(column, item, "mass_t")
            for name in ("lcg", "tcg", "vcg"):
                column.prop(item, name)
        result, place = latest_result(layout, context, "weights", "Sum", _ROWS)
        self._draw_sum(place, context, None if result is None else result.total)
        export_buttons(layout, "weights")

    def _draw_layers(self, layout, hull):
        """Of each layer of the shell its own plating."""
        layers = [layer for layer in hull.hull.layers if layer.in_hydrostatics and layer.material]
        for layer in layers if len(layers) > 1 else ():
            column = layout.column(align=True)
            column.label(text=hull_objects.layer_name(layer))
            field_or(column, layer, "thickness", "that of the shell")
            field_or(column, layer, "density", "that of the shell")

    def _draw_sum(self, layout, context, total):
        column = layout.column(align=True)
        column.scale_y = 0.8
        for name, unit, of in (
            ("Mass", "t", lambda part: part.mass_t),
            ("LCG", "m", lambda part: part.centre[0]),
            ("TCG", "m", lambda part: part.centre[1]),
            ("VCG", "m", lambda part: part.centre[2]),
        ):
            value = None if total is None else of(total)
            label_value(column, name, format_value(context.scene, value, unit))


CLASSES = (HULL_UL_items, HULL_PT_weights)
