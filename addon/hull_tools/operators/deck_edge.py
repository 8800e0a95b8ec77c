# SPDX-License-Identifier: GPL-3.0-or-later
"""The deck edge is marked in edit mode of a hull, and found again."""

import bpy

from ..bridge.counts import counted
from ..features.hull import deck_edge
from .shared import EditModeOperator


class HULL_OT_mark_deck_edge(bpy.types.Operator, EditModeOperator):
    """Make the creases and borders of the selected edges, from end to end, the deck edge: the angle
    at which it comes under water is told with the righting levers"""

    bl_idname = "hull.mark_deck_edge"
    bl_label = "Mark as Deck Edge"

    def run_on(self, hull, context):
        count = deck_edge.mark(hull, context.scene)
        self.tell("INFO", f"The deck edge has {counted(count, 'edge')}")


class HULL_OT_clear_deck_edge(bpy.types.Operator, EditModeOperator):
    """Take the marks of the deck edge away: it is the borders along the ship again"""

    bl_idname = "hull.clear_deck_edge"
    bl_label = "Clear Deck Edge"

    def run_on(self, hull, context):
        deck_edge.clear(hull)


class HULL_OT_select_deck_edge(bpy.types.Operator, EditModeOperator):
    """Select the edges that are marked as deck edge, and no others"""

    bl_idname = "hull.select_deck_edge"
    bl_label = "Select Deck Edge"

    def run_on(self, hull, context):
        if not deck_edge.select(context, hull):
            raise ValueError("No edge is marked: the deck edge is the borders along the ship")


CLASSES = (HULL_OT_mark_deck_edge, HULL_OT_clear_deck_edge, HULL_OT_select_deck_edge)
