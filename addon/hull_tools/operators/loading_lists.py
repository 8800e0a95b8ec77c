# SPDX-License-Identifier: GPL-3.0-or-later
"""Load cases and openings come and go."""

import bpy

from ..bridge import hull_objects, loading
from .shared import has_hull, native_is_there, reporting_errors


class LoadingList:
    @classmethod
    def poll(cls, context):
        return native_is_there(cls) and has_hull(cls, context)


class HULL_OT_add_load_case(bpy.types.Operator, LoadingList):
    """Add a load case: at first the ship as she is afloat, later what you make of it"""

    bl_idname = "hull.add_load_case"
    bl_label = "Add Load Case"
    bl_options = {"REGISTER", "UNDO"}

    @reporting_errors
    def execute(self, context):
        loading.add_load_case(hull_objects.hull_of(context.object), context.scene)
        return {"FINISHED"}


class HULL_OT_remove_load_case(bpy.types.Operator, LoadingList):
    """Remove the load case that is chosen in the list"""

    bl_idname = "hull.remove_load_case"
    bl_label = "Remove Load Case"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        if not hull_objects.hull_of(context.object).hull.loading.load_cases:
            cls.poll_message_set("There is no load case")
            return False
        return True

    def execute(self, context):
        loading.remove_load_case(hull_objects.hull_of(context.object))
        return {"FINISHED"}


class HULL_OT_add_flooding_point(bpy.types.Operator, LoadingList):
    """Add an opening that floods the ship: at first amidships at the side of the deck"""

    bl_idname = "hull.add_flooding_point"
    bl_label = "Add Opening"
    bl_options = {"REGISTER", "UNDO"}

    @reporting_errors
    def execute(self, context):
        loading.add_flooding_point(hull_objects.hull_of(context.object))
        return {"FINISHED"}


class HULL_OT_remove_flooding_point(bpy.types.Operator, LoadingList):
    """Remove the opening that is chosen in the list"""

    bl_idname = "hull.remove_flooding_point"
    bl_label = "Remove Opening"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        if not hull_objects.hull_of(context.object).hull.loading.flooding_points:
            cls.poll_message_set("There is no opening")
            return False
        return True

    def execute(self, context):
        loading.remove_flooding_point(hull_objects.hull_of(context.object))
        return {"FINISHED"}


CLASSES = (
    HULL_OT_add_load_case,
    HULL_OT_remove_load_case,
    HULL_OT_add_flooding_point,
    HULL_OT_remove_flooding_point,
)
