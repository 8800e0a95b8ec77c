# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.table and Object.hull.plots: the range of tables, and which plots are shown."""

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty

from .shared import changed, length


class HullTable(bpy.types.PropertyGroup):
    draft_from: length("From", "First draft of the table; 0: the first step", minimum=0.0)
    draft_to: length("To", "Last draft of the table; 0: the hull's draft", minimum=0.0)
    draft_step: length("Step", "Between drafts; 0: a tenth of the range", minimum=0.0)
    trims: StringProperty(
        name="Trims m",
        description="Trims by the stern in metres between perpendiculars, with blanks between: "
        "-1 0 1",
        default="0",
        update=changed,
    )


def _switch(name):
    return BoolProperty(name=name, description="Show this plot over the 3D view", update=changed)


class HullPlots(bpy.types.PropertyGroup):
    """Each switch has the name of its analysis."""

    hydrostatic_table: _switch("Hydrostatic curves")
    sectional_areas: _switch("Sectional areas")
    bonjean_curves: _switch("Bonjean curves")
    righting_levers: _switch("Righting levers GZ")
    cross_curves: _switch("Cross curves KN")
    corner: EnumProperty(
        name="Corner",
        description="The corner of the 3D view that the plots start from",
        items=(
            ("BOTTOM_LEFT", "Bottom left", ""),
            ("BOTTOM_RIGHT", "Bottom right", ""),
            ("TOP_LEFT", "Top left", ""),
            ("TOP_RIGHT", "Top right", ""),
        ),
        update=changed,
    )


CLASSES = (HullTable, HullPlots)
