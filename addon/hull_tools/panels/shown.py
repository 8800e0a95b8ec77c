# SPDX-License-Identifier: GPL-3.0-or-later
"""How the hull is shown: surface and layers."""

import bpy

from ..bridge.objects import hull_objects, shown_objects
from .shared import HullPanel, text_field


def _draw_shown(layout, shown):
    """Visibility of an object that shows a hull, or the button that makes it anew."""
    row = layout.row(align=True)
    if shown is None:
        row.operator("hull.update", icon="FILE_REFRESH")
        return
    row.label(text="Visible")
    row.prop(shown, "hide_viewport", text="")
    row.prop(shown, "hide_render", text="")


class HULL_PT_surface(HullPanel, bpy.types.Panel):
    bl_label = "Surface"

    def draw(self, context):
        layout = self.layout
        hull = hull_objects.hull_of(context.object)
        _draw_shown(layout, shown_objects.surface_of(hull))
        layout.prop(hull.hull, "show_net")
        layout.prop(hull.hull, "samples")
        text_field(layout, hull.hull, "scheme")
        if hull.hull.layers:
            layout.label(text="Layers in the shell")
        column = layout.column(align=True)
        for layer in hull.hull.layers:
            if layer.material is not None:
                row = column.row(align=True)
                row.prop(layer, "in_hydrostatics", text="")
                row.prop(layer, "name", text="")
        if hull.mode == "EDIT":
            layout.operator("hull.new_layer")
        elif hull.hull.layers:
            layout.operator("hull.remove_empty_layers")


CLASSES = (HULL_PT_surface,)
