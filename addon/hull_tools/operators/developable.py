# SPDX-License-Identifier: GPL-3.0-or-later
"""Developable surfaces in edit mode: regions made of a row of faces and released, strips, cones and
cylinders from chains of edges."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty, IntProperty

from ..bridge.counts import counted
from ..features.hull import hull_state
from ..features.modelling import developable_making, developable_shells
from ..properties.shared import metric_field
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
        metric_field(layout, self, "warp")
        for name in ("distance", "keep"):
            layout.prop(self, name)

    def run_on(self, hull, context):
        text = developable_making.make_developable(
            hull, context.scene, self.warp, self.distance, self.keep
        )
        self.tell("INFO", text)


class HULL_OT_release_developable(bpy.types.Operator, EditModeOperator):
    """Faces that are selected, or else those at selected points, are of no developable region any
    longer; their points stay where they are"""

    bl_idname = "hull.release_developable"
    bl_label = "Release Developable"

    def run_on(self, hull, context):
        count = developable_making.release_selected(hull)
        hull_state.follow_edit(hull, context.scene)
        self.tell("INFO", f"No longer a developable region: {counted(count, 'face')}")


class HULL_OT_developable_strip(bpy.types.Operator, EditModeOperator):
    """Make a mesh object with the rulings of the developable surface between two chains of selected
    edges, or of the cone or cylinder from one chain; leaves edit mode"""

    bl_idname = "hull.developable_strip"
    bl_label = "Developable Strip"

    form: EnumProperty(
        name="Form",
        description="What is made of the selected edges",
        items=(
            ("STRIP", "Between two chains", "The developable surface between two chains of edges"),
            ("CONE", "Cone to cursor", "From a chain of edges to the 3D cursor"),
            ("CYLINDER", "Cylinder", "From a chain of edges along a direction"),
        ),
    )
    shift: FloatVectorProperty(
        name="Shift",
        description="From the chain to the cylinder's other end, along the hull's axes",
        default=(0.0, 0.0, 1.0),
        subtype="XYZ_LENGTH",
        unit="LENGTH",
    )
    count: IntProperty(
        name="Rulings", description="About how many are made", default=60, min=4, max=2000
    )

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        for name in ("form", "shift", "count") if self.form == "CYLINDER" else ("form", "count"):
            layout.prop(self, name)

    def run_on(self, hull, context):
        _, text = developable_shells.make_shell(
            hull, context.scene, self.form, self.shift, self.count
        )
        # Blender's undo in edit mode knows nothing of objects.
        bpy.ops.object.mode_set(mode="OBJECT")
        self.tell("INFO", text)


CLASSES = (
    HULL_OT_make_developable,
    HULL_OT_release_developable,
    HULL_OT_developable_strip,
)
