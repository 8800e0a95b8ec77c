# SPDX-License-Identifier: GPL-3.0-or-later
"""The studio around a hull: set up, look from its cameras, turn, take down."""

import bpy
from bpy.props import EnumProperty

from ..bridge.objects import hull_objects
from ..features import studio
from ..features.studio import views
from .shared import BaseOperator, HullOperator, in_object_mode, make_active


def _has_studio(cls, context):
    if studio.find(context.scene) is None:
        cls.poll_message_set("Set up a studio first")
        return False
    return True


class HULL_OT_make_studio(bpy.types.Operator, HullOperator):
    """Set up water, light, paint, lines and cameras around the hull, in place of a studio that
    there is. Pictures show this hull alone, and not its control mesh"""

    bl_idname = "hull.make_studio"
    bl_label = "Set Up Studio"

    needs = (in_object_mode, *HullOperator.needs)

    def run_on(self, hull, context):
        # What goes with the studio of before may be what is active.
        make_active(context, hull)
        studio.make(hull, context.scene)
        self.tell("INFO", f"Studio of {hull.name}: F12 makes the picture")


class HULL_OT_remove_studio(bpy.types.Operator, BaseOperator):
    """Take the studio down with all that was made for it, and give the scene its settings back"""

    bl_idname = "hull.remove_studio"
    bl_label = "Remove Studio"

    needs = (in_object_mode, _has_studio)

    def run(self, context):
        hull = hull_objects.hull_of(context.object) or studio.hull_of(context.scene)
        studio.remove(context.scene)
        if hull is not None and hull.name in context.view_layer.objects:
            make_active(context, hull)


class HULL_OT_studio_view(bpy.types.Operator, BaseOperator):
    """Take pictures from one of the studio's cameras, framed to the hull as it is now and to the
    shape of the picture"""

    bl_idname = "hull.studio_view"
    bl_label = "Studio View"

    view: EnumProperty(
        name="View",
        description="Where from one looks",
        items=[(name, view.label, view.description) for name, view in views.VIEWS.items()],
    )

    needs = (_has_studio,)

    def run(self, context):
        studio.look_from(context.scene, self.view)
        if context.region_data is not None:
            context.region_data.view_perspective = "CAMERA"


class HULL_OT_studio_turntable(bpy.types.Operator, BaseOperator):
    """Have a camera go round the hull once in the frames given; Ctrl F12 makes the film"""

    bl_idname = "hull.studio_turntable"
    bl_label = "Turntable"

    needs = (_has_studio,)

    def run(self, context):
        hull = studio.hull_of(context.scene)
        if hull is None:
            raise ValueError("The studio's hull is gone: remove the studio")
        studio.turn(context.scene, hull.hull.studio.turntable_frames)


CLASSES = (
    HULL_OT_make_studio,
    HULL_OT_remove_studio,
    HULL_OT_studio_view,
    HULL_OT_studio_turntable,
)
