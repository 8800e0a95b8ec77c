# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull was made of, and how near it is to that: panel."""

import bpy

from ..bridge.objects import hull_objects
from ..features.geometry import making
from .shared import HullTab, label_value, label_wrapped


class HULL_PT_made_of(HullTab, bpy.types.Panel):
    """How near the hull is to the mesh or file that it was made of"""

    bl_label = "Made of"
    bl_parent_id = "HULL_PT_hull"

    @classmethod
    def poll(cls, context):
        hull = hull_objects.hull_of(context.object)
        return hull is not None and making.last_report(hull)[0] is not None

    def draw(self, context):
        layout = self.layout
        report, is_current = making.last_report(hull_objects.hull_of(context.object))
        layout.label(text=report.told["source"], icon="MESH_DATA")
        if not is_current:
            label_wrapped(layout, context, "Of the hull as it was made", icon="INFO")
        column = layout.column(align=True)
        column.active = is_current
        column.scale_y = 0.8
        for name, value in making.rows(report):
            label_value(column, name, value)
        if is_current:
            layout.operator("hull.show_source_miss", icon="HIDE_OFF")
        for sentence in (*report.doubts, *report.told["left_out"]):
            label_wrapped(layout, context, sentence, icon="INFO")


CLASSES = (HULL_PT_made_of,)
