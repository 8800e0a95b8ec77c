# SPDX-License-Identifier: GPL-3.0-or-later
"""A network made a hull, and where its curves are farthest from that."""

import bpy
from bpy.props import IntProperty

from ..bridge.blender import view_target
from ..bridge.objects import networks
from ..features.networks import to_hull
from .networks import NetworkTask, has_network
from .shared import (
    BaseOperator,
    collection_for_new,
    in_object_mode,
    make_active,
    native_is_there,
    suit_views,
)


class HULL_OT_network_to_hull(bpy.types.Operator, NetworkTask):
    """Lay a control mesh over the network's curves, with points in rows of one x, and fit it to
    them: a new hull, beside which the curves stay as they are"""

    bl_idname = "hull.network_to_hull"
    bl_label = "To Hull"
    bl_options = {"REGISTER", "UNDO"}

    needs = (native_is_there, in_object_mode, has_network)

    def begin(self, network, scene):
        return to_hull.Laying(network, scene)

    def outcome(self, laid, scene):
        self._made, report = self._task.write(scene, collection_for_new(bpy.context))
        return to_hull.summary(report), not report.is_within

    def show(self, context):
        make_active(context, self._made)
        suit_views(context)


class HULL_OT_show_network_miss(bpy.types.Operator, BaseOperator):
    """Set the 3D cursor where this curve is farthest from the hull, and bring it into view"""

    bl_idname = "hull.show_network_miss"
    bl_label = "Show"

    index: IntProperty(name="Number", description="In the list, from 0", default=0)

    needs = (native_is_there, has_network)

    def run(self, context):
        place = to_hull.place_of(networks.at_hand(context), context.scene, self.index)
        context.scene.cursor.location = place
        view_target.look_at(context.region_data, place)


CLASSES = (HULL_OT_network_to_hull, HULL_OT_show_network_miss)
