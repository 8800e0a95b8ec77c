# SPDX-License-Identifier: GPL-3.0-or-later
"""What was computed of the hull."""

import bpy

from ..bridge import hull_objects, hull_state
from ..bridge.units import format_length, format_mass
from .shared import HullPanel, label_value, label_wrapped


class HULL_PT_hydrostatics(HullPanel, bpy.types.Panel):
    bl_label = "Hydrostatics"

    def draw(self, context):
        layout = self.layout
        state = hull_state.state_of(hull_objects.hull_of(context.object))
        if state is None:
            return
        found = state.hydrostatics
        if found is None:
            label_wrapped(
                layout, context, state.hydrostatics_status or "No surface yet", icon="INFO"
            )
            return
        scene = context.scene
        column = layout.column(align=True)
        column.scale_y = 0.8
        label_value(column, "Draft", format_length(scene, found.draft))
        label_value(column, "Volume", format_length(scene, found.displaced_volume, 3))
        label_value(column, "Displacement", format_mass(scene, found.displacement_t))
        label_value(column, "LCB", format_length(scene, found.lcb))
        label_value(column, "KB", format_length(scene, found.kb))
        label_value(column, "KMt", format_length(scene, found.kmt))
        label_value(column, "LCF", format_length(scene, found.lcf))
        label_value(column, "Waterplane", format_length(scene, found.waterplane_area, 2))
        label_value(column, "Wetted", format_length(scene, found.wetted_surface, 2))
        layout.operator("hull.export_hydrostatics", text="Export Table", icon="EXPORT")


CLASSES = (HULL_PT_hydrostatics,)
