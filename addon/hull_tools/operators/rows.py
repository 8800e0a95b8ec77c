# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of control points that keep the surface."""

import bpy

from ..bridge.blender import units
from ..features.modelling import row_insertion
from .shared import EditModeOperator


class HULL_OT_insert_row(bpy.types.Operator, EditModeOperator):
    """Insert a row of control points across the selected edges, and place the points around it so
    that the surface stays as nearly as may be. Blender's own loop cut changes the surface"""

    bl_idname = "hull.insert_row"
    bl_label = "Insert Row"

    def run_on(self, hull, context):
        found = row_insertion.insert_rows(hull, context.scene)
        self.report(
            {"INFO"},
            f"{found.count} points: the surface changed by {units.format_mm(found.change)} at "
            f"most; a cut alone changes it by {units.format_mm(found.cut_change)}",
        )


CLASSES = (HULL_OT_insert_row,)
