# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact shape in edit mode: flat regions, and points in planes of the ship."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty

from ..bridge.blender import units
from ..bridge.counts import counted
from ..features.hull import hull_state
from ..features.modelling import flat_making, point_places, valence
from .shared import EditModeOperator


def _position(description):
    return FloatProperty(
        name="Position",
        description=description,
        unit="LENGTH",
        subtype="DISTANCE",
        precision=5,
        options={"SKIP_SAVE"},
    )


class HULL_OT_make_flat(bpy.types.Operator, EditModeOperator):
    """Bring the points of the selected faces into one plane and keep them there"""

    bl_idname = "hull.make_flat"
    bl_label = "Make Flat"

    kind: EnumProperty(
        name="Plane",
        description="Which way the plane faces",
        items=(
            ("SIDE", "Side", "Parallel to the centre plane: flat side"),
            ("BOTTOM", "Bottom", "Level: flat bottom or deck"),
            ("TRANSOM", "Transom", "Upright across the ship: transom, bulkhead"),
            ("RAKED", "Raked", "Across the ship but raked, as most of the points lie"),
            ("BEST", "Best Plane", "The plane that fits the points best"),
        ),
    )
    place: EnumProperty(
        name="Place",
        description="Where the plane lies",
        options={"SKIP_SAVE"},
        items=(
            ("MOST", "Most points", "Where most of the points are"),
            ("OUTERMOST", "Outermost point", "Through the point furthest from the hull's middle"),
            ("ACTIVE", "Active point", "Through the point that was selected last"),
            ("POSITION", "Position", "At the position given; side, bottom and transom only"),
        ),
    )
    position: _position("Of the plane: y of a side, z of a bottom, x of a transom")
    keep: BoolProperty(
        name="Keep flat",
        options={"SKIP_SAVE"},
        description="Keep the points in the plane when they are moved",
        default=True,
    )
    crease_rim: BoolProperty(
        name="Crease rim",
        options={"SKIP_SAVE"},
        description="Make the edges around the faces knuckles: the surface is flat up to them",
    )

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "kind")
        layout.prop(self, "place")
        if self.place == "POSITION":
            layout.prop(self, "position")
        layout.prop(self, "keep")
        layout.prop(self, "crease_rim")

    def run_on(self, hull, context):
        made = flat_making.make_flat(
            hull, context.scene, self.kind, self.place, self.position, self.keep, self.crease_rim
        )
        if made.position is not None:
            self.position = made.position  # where a position that is typed afterwards begins
        self.tell("INFO", made.message)


class HULL_OT_select_flat(bpy.types.Operator, EditModeOperator):
    """Select all faces of the flat regions that selected faces are of; of all regions if none is"""

    bl_idname = "hull.select_flat"
    bl_label = "Select Flat Regions"

    def run_on(self, hull, context):
        context.tool_settings.mesh_select_mode = (False, False, True)
        count = flat_making.select_regions(hull)
        if not count:
            raise ValueError("No faces are kept flat")
        self.tell("INFO", f"{count} flat regions selected")


class HULL_OT_release_flat(bpy.types.Operator, EditModeOperator):
    """Faces that are selected, or else those at selected points, are not kept flat any longer;
    their points stay where they are"""

    bl_idname = "hull.release_flat"
    bl_label = "Release Flat"

    def run_on(self, hull, context):
        count = flat_making.release_selected(hull)
        hull_state.follow_edit(hull, context.scene)
        self.tell("INFO", f"No longer kept flat: {counted(count, 'face')}")


class HULL_OT_put_in_plane(bpy.types.Operator, EditModeOperator):
    """Move the selected points along one axis into a plane of the ship"""

    bl_idname = "hull.put_in_plane"
    bl_label = "Put in Plane"

    plane: EnumProperty(
        name="Plane",
        description="Which way the plane faces",
        items=(
            ("STATION", "Station", "Across the ship: one x"),
            ("WATERLINE", "Waterline", "Level: one z"),
            ("BUTTOCK", "Buttock", "Along the ship, upright: one y"),
        ),
    )
    place: EnumProperty(
        name="Place",
        description="Where the plane lies",
        options={"SKIP_SAVE"},
        items=(
            ("MEAN", "Mean", "In the middle of the points"),
            ("ACTIVE", "Active point", "Through the point that was selected last"),
            ("NEAREST", "Nearest line", "The nearest of the hull's lines under Sections"),
            ("POSITION", "Position", "At the position given"),
        ),
    )
    position: _position("Of the plane: x of a station, z of a waterline, y of a buttock")

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "plane")
        layout.prop(self, "place")
        if self.place == "POSITION":
            layout.prop(self, "position")

    def run_on(self, hull, context):
        scene = context.scene
        position, count = point_places.put_in_plane(
            hull, scene, self.plane, self.place, self.position
        )
        self.position = position  # where one that is typed afterwards begins
        metres = units.format_value(scene, position * units.metres_per_unit(scene), "m")
        self.tell("INFO", f"{counted(count, 'point')} at {self.plane.lower()} {metres}")


class HULL_OT_reduce_valence(bpy.types.Operator, EditModeOperator):
    """Make fewer faces meet at the selected points: join triangles, or part points in two. The
    surface is smoothest where four faces meet"""

    bl_idname = "hull.reduce_valence"
    bl_label = "Reduce Valence"

    def run_on(self, hull, context):
        found = valence.reduce_selected(hull, context.scene)
        text = f"At most {found.after} faces around a point instead of {found.before}"
        if found.added:
            text += f", {found.added} points added"
        if found.change is not None:
            moved = units.format_value(context.scene, found.change, "m")
            text += f"; the surface moved by up to {moved}"
        self.tell("INFO", text)


CLASSES = (
    HULL_OT_make_flat,
    HULL_OT_select_flat,
    HULL_OT_release_flat,
    HULL_OT_put_in_plane,
    HULL_OT_reduce_valence,
)
