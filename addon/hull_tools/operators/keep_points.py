# SPDX-License-Identifier: GPL-3.0-or-later
"""Points that are kept in their station, waterline or buttock, in edit mode and by all tools."""

import bpy
from bpy.props import BoolProperty, EnumProperty

from ..bridge.counts import counted
from ..bridge.mesh import mesh_points
from ..features.constraints import kept_points
from ..features.hull import hull_state
from .select_tags import SelectOperator
from .shared import EditModeOperator, HullOperator

_PLANES = (
    ("STATION", "Station", "At their x, across the ship"),
    ("WATERLINE", "Waterline", "At their z, level"),
    ("BUTTOCK", "Buttock", "At their y, along the ship"),
)
_ALL = ("ALL", "All", "Stations, waterlines and buttocks")


def _planes():
    return EnumProperty(name="Plane", description="What points are kept in", items=_PLANES)


def _axes(plane):
    return range(3) if plane == "ALL" else (kept_points.PLANES[plane],)


class HULL_OT_keep_points(bpy.types.Operator, EditModeOperator):
    """Keep the selected points in their station, waterline or buttock: they slide in it when they
    are moved, and all tools heed it"""

    bl_idname = "hull.keep_points"
    bl_label = "Keep Points"

    plane: _planes()

    def run_on(self, hull, context):
        count = kept_points.set_selected(hull, _axes(self.plane), True)
        hull_state.follow_edit(hull, context.scene)
        self.tell("INFO", f"{counted(count, 'point')} more kept in their {self.plane.lower()}")


class HULL_OT_keep_all_points(bpy.types.Operator, HullOperator):
    """Keep all points of the hull in their stations"""

    bl_idname = "hull.keep_all_points"
    bl_label = "Keep All in Stations"

    plane: _planes()

    def run_on(self, hull, context):
        indices = range(len(mesh_points.read(hull.data)))
        count = kept_points.set_axes(hull.data, indices, _axes(self.plane), True)
        hull_state.follow_edit(hull, context.scene)
        self.tell("INFO", f"{counted(count, 'point')} more kept in their {self.plane.lower()}")


class HULL_OT_free_points(bpy.types.Operator, EditModeOperator):
    """Let the selected points leave their station, waterline or buttock again"""

    bl_idname = "hull.free_points"
    bl_label = "Free Points"

    plane: EnumProperty(
        name="Plane",
        description="What points are no longer kept in",
        items=(*_PLANES, _ALL),
        default="ALL",
    )
    everything: BoolProperty(
        name="All points", description="All points of the hull, not the selected ones alone"
    )

    def run_on(self, hull, context):
        axes = _axes(self.plane)
        if self.everything:
            indices = kept_points.read(hull.data).indices
            count = kept_points.set_axes(hull.data, indices, axes, False)
        else:
            count = kept_points.set_selected(hull, axes, False)
        self.tell("INFO", f"{counted(count, 'point')} freed")


class HULL_OT_select_kept(bpy.types.Operator, SelectOperator):
    """Select the points that are kept in their station, waterline or buttock"""

    bl_idname = "hull.select_kept"
    bl_label = "Select Kept Points"

    nothing_found = "No point is kept so"

    plane: EnumProperty(
        name="Plane",
        description="What the points are kept in",
        items=(*_PLANES, _ALL),
        default="ALL",
    )

    def found(self, hull, context):
        kept = kept_points.read(hull.data)
        axes = _axes(self.plane)
        return "vertex", kept.indices[kept.is_kept[:, list(axes)].any(axis=1)]


CLASSES = (
    HULL_OT_keep_points,
    HULL_OT_keep_all_points,
    HULL_OT_free_points,
    HULL_OT_select_kept,
)
