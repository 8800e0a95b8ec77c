# SPDX-License-Identifier: GPL-3.0-or-later
"""The half hull that counts twice, and the whole one."""

import bpy
from bpy.props import BoolProperty, EnumProperty

from ..bridge.blender import units
from ..bridge.counts import counted
from ..features.modelling import mirroring
from .shared import HullOperator, in_object_mode


class SidesOperator(HullOperator):
    """Subclasses end by telling what the hull consists of."""

    needs = (in_object_mode, *HullOperator.needs)

    def tell_faces(self, hull, which):
        self.tell("INFO", f"{hull.name}: {counted(len(hull.data.polygons), 'face')}, {which}")


class HULL_OT_make_whole(bpy.types.Operator, SidesOperator):
    """Give the half hull its other side. Its edges in the centre plane become creases: surface and
    numbers stay the same"""

    bl_idname = "hull.make_whole"
    bl_label = "Make Whole"

    def run_on(self, hull, context):
        mirroring.to_whole(hull, context.scene)
        self.tell_faces(hull, "both sides")


class HULL_OT_make_half(bpy.types.Operator, SidesOperator):
    """Leave one side of the whole hull, which counts twice"""

    bl_idname = "hull.make_half"
    bl_label = "Make Half"

    side: EnumProperty(
        name="Keep",
        options={"SKIP_SAVE"},
        description="The side that is kept",
        items=(
            ("PORT", "Port", "Keep the port side (y > 0)"),
            ("STARBOARD", "Starboard", "Keep the starboard side (y < 0), turned to port"),
        ),
    )
    cut: BoolProperty(
        name="Cut across",
        options={"SKIP_SAVE"},
        description="Cut faces that reach across the centre plane; the surface changes there",
    )

    def run_on(self, hull, context):
        scene = context.scene
        made = mirroring.to_half(hull, scene, self.side, self.cut)
        notes = []
        size = max(hull.dimensions) or 1.0
        if made.difference > mirroring.ALIKE * size:
            metres = made.difference * units.metres_per_unit(scene)
            apart = units.format_value(scene, metres, "m")
            notes.append(f"the sides were not alike: points differed by up to {apart}")
        if made.overlap:
            far = units.format_value(scene, made.overlap * units.metres_per_unit(scene), "m")
            notes.append(f"the other side, which went, reached up to {far} across the centre plane")
        if made.smooth_edges:
            notes.append(
                f"{made.smooth_edges} edges in the centre plane were smooth and are borders now: "
                "look at the surface there"
            )
        if notes:
            self.tell("WARNING", ". ".join(note[0].upper() + note[1:] for note in notes))
        else:
            self.tell_faces(hull, "one side")


CLASSES = (HULL_OT_make_whole, HULL_OT_make_half)
