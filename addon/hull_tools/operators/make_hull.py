# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh becomes a hull; a hull's surface is made anew."""

import bpy
from bpy.props import BoolProperty

from ..bridge.mesh import mesh_arrays
from ..bridge.objects import hull_objects, modifiers, shown_objects
from ..features.hull import hull_creation, hull_state
from .shared import BaseOperator, HullOperator, native_is_there

# Of the half-breadth: a mesh that reaches no further to starboard is offered as a half. It is a
# guess, which a person may overrule, not what is in the centre plane.
_TO_STARBOARD = 1e-3


def _can_be_hull(cls, context):
    obj = context.object
    reason = hull_objects.refusal(obj) or hull_objects.locked(obj)
    if reason:
        cls.poll_message_set(reason)
    return not reason


class HULL_OT_make_hull(bpy.types.Operator, BaseOperator):
    """Make the active mesh the control mesh of a hull and show its surface and lines"""

    bl_idname = "hull.make_hull"
    bl_label = "Make This Mesh a Hull"

    half: BoolProperty(
        name="Half hull",
        description="The mesh is the port half (y ≥ 0) and is mirrored on the centre plane",
        default=True,
    )

    needs = (_can_be_hull, native_is_there)

    def invoke(self, context, event):
        points = mesh_arrays.read_mesh(context.object.data).points
        if len(points) and not self.properties.is_property_set("half"):
            is_mirrored = any(map(modifiers.mirrors_sides, context.object.modifiers))
            self.half = is_mirrored or bool(
                points[:, 1].min() > -_TO_STARBOARD * points[:, 1].max()
            )
        return self.execute(context)

    def run(self, context):
        state = hull_creation.make_hull(context.object, context.scene, self.half)
        if state.status:
            self.tell("WARNING", state.status)


class HULL_OT_update(bpy.types.Operator, HullOperator):
    """Make the hull's surface and lines anew, also when the surface was deleted"""

    bl_idname = "hull.update"
    bl_label = "Update Surface and Lines"

    def run_on(self, hull, context):
        shown_objects.ensure(hull)
        hull_state.forget(hull)
        hull.update_tag(refresh={"DATA"})  # what else follows a change, as previews, does so anew
        hull_state.up_to_date(hull, context.scene)


CLASSES = (HULL_OT_make_hull, HULL_OT_update)
