# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls of others mended: split, parts set aside, brought to port, particulars that are none."""

import bmesh
import bpy
from bpy.props import BoolProperty, EnumProperty

from ..bridge.blender import units
from ..bridge.counts import counted
from ..features.hull import hull_state, plausible
from ..features.modelling import joining, mirroring, splitting
from .shared import HullOperator, in_object_mode


class HULL_OT_split(bpy.types.Operator, HullOperator):
    """Split the points and edges where faces join without making one surface. What stands on the
    shell, as a bulkhead, comes off; nothing moves"""

    bl_idname = "hull.split"
    bl_label = "Split"

    def run_on(self, hull, context):
        done = splitting.split(hull, context.scene)
        text = f"{done.points} points and {done.edges} edges split"
        if done.standing:
            text += (
                f"; {done.standing} faces stand on others: Set Aside takes them out of the shell"
            )
        self.tell("WARNING" if done.standing else "INFO", text)


class HULL_OT_set_aside(bpy.types.Operator, HullOperator):
    """Take the selected faces out of the shell into a layer of their own; in object mode those that
    stand on others, as bulkheads and decks on the shell"""

    bl_idname = "hull.set_aside"
    bl_label = "Set Aside"

    def run_on(self, hull, context):
        faces = None
        if hull.mode == "EDIT":
            edited = bmesh.from_edit_mesh(hull.data).faces
            edited.index_update()
            faces = [face.index for face in edited if face.select]
        count = splitting.set_aside(hull, context.scene, faces or None)
        self.tell("INFO", f'{count} faces are in the layer "{splitting.SET_ASIDE}", not the shell')


class HULL_OT_mirror_to_port(bpy.types.Operator, HullOperator):
    """Mirror a half hull that lies to starboard (y < 0) to port"""

    bl_idname = "hull.mirror_to_port"
    bl_label = "Mirror to Port"

    needs = (in_object_mode, *HullOperator.needs)

    def run_on(self, hull, context):
        mirroring.to_port(hull, context.scene)
        self.tell("INFO", f"{hull.name} is to port now")


class HULL_OT_put_on_centre_plane(bpy.types.Operator, HullOperator):
    """Put points of the centre line that are beside the centre plane on it (y = 0), so that both
    sides of the half hull join"""

    bl_idname = "hull.put_on_centre_plane"
    bl_label = "Put on Centre Plane"

    def run_on(self, hull, context):
        count = mirroring.put_centre_line_on_plane(hull, context.scene)
        self.tell("INFO", f"{counted(count, 'point')} put on the centre plane")


class HULL_OT_join_centre_line(bpy.types.Operator, HullOperator):
    """Join the sides of a whole hull along the centre line, where each has points of its own at the
    same places. Nothing moves; the joined edges become creases"""

    bl_idname = "hull.join_centre_line"
    bl_label = "Join Centre Line"

    def run_on(self, hull, context):
        done = joining.join_centre_line(hull, context.scene)
        self.tell("INFO", f"{counted(done.points, 'point')} of the centre line joined")


class HULL_OT_join_points(bpy.types.Operator, HullOperator):
    """Join the points of borders that lie on one another, so that the faces on both sides are one
    surface. Nothing moves, creases and tags stay"""

    bl_idname = "hull.join_points"
    bl_label = "Join Points"

    smooth: BoolProperty(
        name="Smooth",
        options={"SKIP_SAVE"},
        description="Let the surface go smoothly across the joined edges, but for those that are "
        "tagged, as of a sheet that was torn apart. Else they become creases, which borders are, "
        "and the surface stays as it is",
    )

    def run_on(self, hull, context):
        done = joining.join_points(hull, context.scene, self.smooth)
        text = f"{counted(done.points, 'point')} joined"
        if done.knuckles:
            text += f"; {counted(done.knuckles, 'joined edge')} became creases: Smooth is without"
        if done.smooth:
            text += f"; the surface is another along {counted(done.smooth, 'joined edge')}"
        self.tell("INFO", text)


class HULL_OT_count_sides(bpy.types.Operator, HullOperator):
    """Count the hull as what is modelled of it"""

    bl_idname = "hull.count_sides"
    bl_label = "Count Sides"

    sides: EnumProperty(
        name="Sides",
        description="What is modelled",
        items=(
            ("WHOLE", "Whole", "Both sides are modelled: they count once"),
            ("HALF", "Half", "One side is modelled: it counts twice"),
        ),
    )

    def run_on(self, hull, context):
        hull.hull.half = self.sides == "HALF"
        hull_state.refresh(hull, context.scene)


class HULL_OT_take_from_surface(bpy.types.Operator, HullOperator):
    """Give the hull the particulars that its surface has"""

    bl_idname = "hull.take_from_surface"
    bl_label = "Take from Surface"

    names: EnumProperty(
        name="Particulars",
        description="What is taken",
        options={"ENUM_FLAG"},
        items=(
            ("length_pp", "Lpp", "The surface's length"),
            ("beam", "Beam", "The surface's breadth, both sides"),
            ("depth", "Depth", "The surface's highest point"),
        ),
        default={"length_pp", "beam"},
    )

    def run_on(self, hull, context):
        scene = context.scene
        state = hull_state.up_to_date(hull, scene)
        values = plausible.take_from_surface(hull, state, scene, sorted(self.names))
        hull_state.refresh(hull, scene)
        titles = {item.identifier: item.name for item in self.properties.bl_rna.properties[
            "names"].enum_items}  # fmt: skip
        taken = [
            f"{titles[name]} {units.format_value(scene, value, 'm')}"
            for name, value in values.items()
        ]
        self.tell("INFO", ", ".join(taken) or "Nothing is chosen")


CLASSES = (
    HULL_OT_split,
    HULL_OT_set_aside,
    HULL_OT_mirror_to_port,
    HULL_OT_put_on_centre_plane,
    HULL_OT_join_centre_line,
    HULL_OT_join_points,
    HULL_OT_count_sides,
    HULL_OT_take_from_surface,
)
