# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface pulled by its points, and what is locked meanwhile."""

import bpy

from .shared import HullPanel


class HULL_PT_pull(HullPanel, bpy.types.Panel):
    """Pull the surface itself: the control points follow"""

    bl_label = "Pull"

    def draw(self, context):
        layout = self.layout
        column = layout.column(align=True)
        column.operator("hull.pull_surface", icon="GRAB")
        column.operator("hull.surface_to_coordinate", text="To Coordinate …")
        if context.object.mode != "EDIT":
            return
        row = layout.row(align=True)
        row.operator("hull.lock_points", text="Lock", icon="LOCKED")
        row.operator("hull.unlock_points", text="Unlock", icon="UNLOCKED")
        row.operator("hull.select_locked", text="Select")


CLASSES = (HULL_PT_pull,)
