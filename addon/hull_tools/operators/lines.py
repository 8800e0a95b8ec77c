# SPDX-License-Identifier: GPL-3.0-or-later
"""Planes to cut the hull by, and its lines as Blender's curves."""

import bpy
from bpy.props import EnumProperty

from ..bridge.blender import units
from ..bridge.counts import counted
from ..bridge.objects import hull_objects
from ..features.hull import hull_state
from ..features.lines import cut_planes, line_curves
from .shared import HullOperator, in_object_mode, set_active


class HULL_OT_add_plane(bpy.types.Operator, HullOperator):
    """Cut the hull by a plane through the 3D cursor"""

    bl_idname = "hull.add_plane"
    bl_label = "Section at 3D Cursor"

    direction: EnumProperty(
        name="Plane",
        description="How the plane lies",
        items=(
            ("X", "Across the ship", "As a station"),
            ("Z", "Level", "As a waterline"),
            ("Y", "Along the ship", "As a buttock"),
            ("CURSOR", "As the cursor", "Across the z axis of the 3D cursor"),
        ),
    )

    def run_on(self, hull, context):
        cut_planes.add(hull, context.scene.cursor.matrix, self.direction)
        hull_state.refresh(hull, context.scene)


def _has_plane(cls, context):
    hull = hull_objects.hull_of(context.object)
    return hull is not None and bool(hull.hull.lines.planes)


class HULL_OT_remove_plane(bpy.types.Operator, HullOperator):
    """Cut the hull by the chosen plane no longer"""

    bl_idname = "hull.remove_plane"
    bl_label = "Remove Plane"

    needs = (*HullOperator.needs, _has_plane)

    def run_on(self, hull, context):
        cut_planes.remove(hull)
        hull_state.refresh(hull, context.scene)


class HULL_OT_lines_as_curves(bpy.types.Operator, HullOperator):
    """Make curve objects of the lines that are shown, one a kind, in place of those made before"""

    bl_idname = "hull.lines_as_curves"
    bl_label = "Lines as Curves"

    form: EnumProperty(
        name="Form",
        description="What the curves are made of",
        items=(
            ("BEZIER", "Splines", "Bézier curves, the same as the B-splines of the lines"),
            ("POLY", "Polylines", "Straight pieces"),
        ),
    )

    needs = (in_object_mode, *HullOperator.needs)

    def run_on(self, hull, context):
        state = hull_state.refresh(hull, context.scene)
        reason = state.status or state.lines.status
        if reason:
            raise ValueError(reason)
        # One of the curves that go may be what is active.
        set_active(context, hull)
        scale = units.metres_per_unit(context.scene)
        count = line_curves.make_curves(
            hull, state.ship.surface, state.lines.groups.values(), scale, self.form == "BEZIER"
        )
        if not count:
            raise ValueError("No lines are shown: switch some on")
        self.tell("INFO", counted(count, "curve"))


CLASSES = (HULL_OT_add_plane, HULL_OT_remove_plane, HULL_OT_lines_as_curves)
