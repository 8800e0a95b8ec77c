# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell in plates: its rules and frames, and the list of plates."""

import bpy
from bpy.props import EnumProperty, IntProperty

from ..bridge.blender import units
from ..features.production import plate_files, plate_rules
from .shared import HullOperator
from .tasks import TaskOperator


class HULL_OT_suggest_seams(bpy.types.Operator, HullOperator):
    """Begin the list of rules with strakes and butts after the hull's dimensions"""

    bl_idname = "hull.suggest_seams"
    bl_label = "Suggest Seams"
    bl_options = {"REGISTER", "UNDO"}

    def run_on(self, hull, context):
        scale = units.metres_per_unit(context.scene)
        ship = [scale * getattr(hull.hull, name) for name in ("length_pp", "beam", "depth")]
        rules = hull.hull.plates.rules
        rules.clear()
        for kind, value in plate_rules.suggested(ship):
            rule = rules.add()
            rule.kind, rule.value = kind, value
        self.tell("INFO", f"{len(rules)} rules: strakes from the deck edge, staggered butts")


class HULL_OT_change_plate_list(bpy.types.Operator, HullOperator):
    """Add a rule of seams or a range of frames, or take one out"""

    bl_idname = "hull.change_plate_list"
    bl_label = "Change List"
    bl_options = {"REGISTER", "UNDO"}

    action: EnumProperty(
        name="Action",
        description="What is done with the list",
        items=(
            ("ADD_RULE", "Add Rule", "One more rule of seams or butts"),
            ("REMOVE_RULE", "Remove Rule", "Without this rule"),
            ("ADD_RANGE", "Add Range", "One more range of frames"),
            ("REMOVE_RANGE", "Remove Range", "Without this range"),
        ),
    )
    index: IntProperty(name="Index", description="Which one is taken out", min=0)

    def run_on(self, hull, context):
        settings = hull.hull.plates
        entries = settings.rules if self.action.endswith("RULE") else settings.ranges
        if self.action.startswith("REMOVE"):
            if self.index >= len(entries):
                raise ValueError("There is no such entry")
            entries.remove(self.index)
        else:
            made = entries.add()
            if self.action == "ADD_RANGE" and len(entries) > 1:
                made.last = entries[-2].last + 50
        hull.update_tag(refresh={"DATA"})  # stations in frames follow


class HULL_OT_lay_out_plates(bpy.types.Operator, TaskOperator):
    """Divide the shell by the rules and lay all plates out flat: areas, weights, stretch"""

    bl_idname = "hull.lay_out_plates"
    bl_label = "Lay Out Plates"

    def begin(self, hull, scene):
        if not hull.hull.plates.rules:
            raise ValueError("There are no rules of seams yet: press Suggest Seams")
        return plate_files.PlateTask(
            hull,
            scene,
            strake=0.0,
            plate_length=0.0,
            thickness=hull.hull.plates.thickness / 1000.0,
            frame_spacing=0.0,
        )

    def outcome(self, result, scene):
        return result.text, bool(result.unsettled)


CLASSES = (HULL_OT_suggest_seams, HULL_OT_change_plate_list, HULL_OT_lay_out_plates)
