# SPDX-License-Identifier: GPL-3.0-or-later
"""Add > Mesh > Ship Hull, Ship Appendage."""

import bpy


class HULL_MT_add(bpy.types.Menu):
    """Add the control mesh of a new hull of a type"""

    bl_label = "Ship Hull"

    def draw(self, context):
        # Invoked, the operator also shows the new hull whole.
        self.layout.operator_context = "INVOKE_REGION_WIN"
        self.layout.operator_enum("hull.add_hull", "kind")


class HULL_MT_add_appendage(bpy.types.Menu):
    """Add a keel, rudder, shaft or tunnel to the hull at hand"""

    bl_label = "Ship Appendage"

    def draw(self, context):
        self.layout.operator_enum("hull.add_appendage", "kind")


def _draw_in_add_menu(self, context):
    self.layout.separator()
    self.layout.menu(HULL_MT_add.__name__, icon="MOD_OCEAN")
    self.layout.menu(HULL_MT_add_appendage.__name__, icon="MOD_SKIN")


CLASSES = (HULL_MT_add, HULL_MT_add_appendage)

# By the name of Blender's menu.
DRAWN_IN = {"VIEW3D_MT_mesh_add": _draw_in_add_menu}
