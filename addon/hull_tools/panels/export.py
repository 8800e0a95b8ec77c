# SPDX-License-Identifier: GPL-3.0-or-later
"""The hull's way out."""

import bpy

from .shared import HullPanel


class HULL_PT_export(HullPanel, bpy.types.Panel):
    bl_label = "Export"

    def draw(self, context):
        column = self.layout.column(align=True)
        column.operator("hull.export_step", icon="EXPORT")
        column.operator("hull.export_lines", icon="EXPORT")
        column.operator("hull.export_hull", icon="EXPORT")


CLASSES = (HULL_PT_export,)
