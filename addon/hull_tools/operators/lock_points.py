# SPDX-License-Identifier: GPL-3.0-or-later
"""Points that stay when the surface is pulled."""

import bpy
from bpy.props import BoolProperty

from ..bridge.counts import counted
from ..bridge.mesh import selection
from ..features.constraints import point_locks
from .shared import EditModeOperator


class SetLocks(EditModeOperator):
    """Subclasses: is_locked, what the selected points are afterwards; done, the word for that;
    everything: whether all points are meant."""

    everything = False

    def run_on(self, hull, context):
        count = point_locks.set_selected(hull, self.is_locked, self.everything)
        self.tell("INFO", f"{counted(count, 'point')} {self.done}")


class HULL_OT_lock_points(bpy.types.Operator, SetLocks):
    """Lock the selected points: they stay when the surface is pulled or a bilge is rounded"""

    bl_idname = "hull.lock_points"
    bl_label = "Lock Points"

    is_locked, done = True, "locked"


class HULL_OT_unlock_points(bpy.types.Operator, SetLocks):
    """Let the selected points move again when the surface is pulled"""

    bl_idname = "hull.unlock_points"
    bl_label = "Unlock Points"

    is_locked, done = False, "unlocked"

    everything: BoolProperty(
        name="All points", description="All points of the hull, not the selected ones alone"
    )


class HULL_OT_select_locked(bpy.types.Operator, EditModeOperator):
    """Select the locked points, and no others"""

    bl_idname = "hull.select_locked"
    bl_label = "Select Locked Points"

    def run_on(self, hull, context):
        locked = point_locks.locked_points(hull.data)
        if not len(locked):
            raise ValueError("No point is locked")
        count = selection.select(context, hull, "vertex", locked)
        self.tell("INFO", f"{count} locked points selected")


CLASSES = (HULL_OT_lock_points, HULL_OT_unlock_points, HULL_OT_select_locked)
