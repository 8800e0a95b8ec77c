# SPDX-License-Identifier: GPL-3.0-or-later
"""Developable regions in edit mode: made of a row of faces, and released."""

import bpy
from bpy.props import BoolProperty, FloatProperty

from ..bridge.counts import counted
from ..features.hull import hull_state
from ..features.modelling import developable_making
from .shared import EditModeOperator


class HULL_OT_make_developable(bpy.types.Operator, EditModeOperator):
    """Make the selected row of faces between two knuckles developable: points move along the
    knuckles, and a little aside, until its straight rulings have next to no warp"""

    bl_idname = "hull.make_developable"
    bl_label = "Make Developable"

    warp: FloatProperty(
        name="Warp °/m",
        description="The most that a plate may be twisted by along a ruling, in degrees per metre",
        default=1.0,
        min=0.001,
        max=90.0,
        precision=3,
    )
    distance: FloatProperty(
        name="Distance",
        description="How far the knuckles may move from where they are",
        default=0.02,
        min=0.0001,
        soft_max=10.0,
        unit="LENGTH",
        subtype="DISTANCE",
        precision=4,
    )
    keep: BoolProperty(
        name="Keep developable",
        description="Move the points again whenever others of the region are moved",
        default=True,
        options={"SKIP_SAVE"},
    )

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        for name in ("warp", "distance", "keep"):
            layout.prop(self, name)

    def run_on(self, hull, context):
        text = developable_making.make_developable(
            hull, context.scene, self.warp, self.distance, self.keep
        )
        self.report({"INFO"}, text)


class HULL_OT_release_developable(bpy.types.Operator, EditModeOperator):
    """Faces that are selected, or else those at selected points, are of no developable region any
    longer; their points stay where they are"""

    bl_idname = "hull.release_developable"
    bl_label = "Release Developable"

    def run_on(self, hull, context):
        count = developable_making.release_selected(hull)
        hull_state.follow_edit(hull, context.scene)
        self.report({"INFO"}, f"No longer a developable region: {counted(count, 'face')}")


CLASSES = (HULL_OT_make_developable, HULL_OT_release_developable)
