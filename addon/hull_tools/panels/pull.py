# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface pulled by its points, and what is locked meanwhile: panel, and the menus where the
search of operators finds it."""

import bpy

from ..bridge.objects import hull_objects
from .shared import HullPanel


class HULL_PT_pull(HullPanel, bpy.types.Panel):
    """Pull the surface itself: the control points follow"""

    bl_label = "Pull"

    def draw(self, context):
        layout = self.layout
        column = layout.column(align=True)
        column.operator("hull.pull_surface", icon="VIEW_PAN")
        column.operator("hull.surface_to_coordinate", text="To Coordinate …")
        if context.object.mode != "EDIT":
            return
        row = layout.row(align=True)
        row.operator("hull.lock_points", text="Lock", icon="LOCKED")
        row.operator("hull.unlock_points", text="Unlock", icon="UNLOCKED")
        row.operator("hull.select_locked", text="", icon="RESTRICT_SELECT_OFF")
        layout.operator("hull.round_bilge", icon="SPHERECURVE")


def _draw_in_menu(self, context):
    if hull_objects.hull_of(context.object) is None:
        return
    layout = self.layout
    layout.separator()
    layout.operator("hull.pull_surface")
    layout.operator("hull.surface_to_coordinate", text="Surface to Coordinate …")
    if context.mode == "EDIT_MESH":
        layout.operator("hull.round_bilge")


CLASSES = (HULL_PT_pull,)

DRAWN_IN = {
    "VIEW3D_MT_edit_mesh": _draw_in_menu,
    "VIEW3D_MT_object": _draw_in_menu,
}
