# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole form changed to a wanted displacement and centre of buoyancy."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty

from ..bridge import limits
from ..bridge.blender import units
from ..bridge.objects import hull_objects
from ..features.transformation import form_parameters, halves, least_change, reports, section_shifts
from ..properties.outline_settings import keep_deck, keep_profile, keep_side
from ..properties.shared import metric_field
from .shared import HullOperator, asked_length, asked_number, can_change, property_column
from .tasks import TaskOperator

_SKIP = {"SKIP_SAVE"}
MEASURES = (
    ("BLOCK", "Cb", "Block coefficient on Lpp, beam and draft"),
    ("PRISMATIC", "Cp", "Prismatic coefficient on Lpp and the station amidships"),
    ("VOLUME", "∇", "Displaced volume in m³"),
    ("DISPLACEMENT", "Δ", "Displacement in t"),
)
_HALVES = ("HALVES", "Cp of halves", "Prismatic coefficients of fore and aft body, each on its "
           "half of Lpp and the station amidships")  # fmt: skip
_KEPT = ("parallel", "heights", "length", "side", "profile", "deck")
NO_MEASURE = ("NONE", "As it comes", "Only the centre of buoyancy is wanted")


def measure_property(*items):
    """The property of the measures MEASURES, and others."""
    return EnumProperty(
        name="Displacement",
        description="How the displacement is said that is wanted",
        items=items,
        options=_SKIP,
    )


class Displacement:
    """What operators ask for; a mix-in. A dialog begins with the hull as it is."""

    block: asked_number("Cb", "Block coefficient wanted", 4, 0.1)
    prismatic: asked_number("Cp", "Prismatic coefficient wanted", 4, 0.1)
    volume: asked_number("∇ in m³", "Displaced volume wanted", 2, 1000)
    displacement: asked_number("Δ in t", "Displacement wanted", 2, 1000)
    lcb_as: EnumProperty(
        name="LCB",
        description="How the centre of buoyancy is said that is wanted",
        items=(
            ("PERCENT", "% of Lpp", "Forward of midship, in percent of Lpp"),
            ("LENGTH", "From AP", "From the after perpendicular"),
            ("NONE", "As it comes", "Only the displacement is wanted"),
        ),
        options=_SKIP,
    )
    lcb_percent: asked_number(
        "LCB in % of Lpp", "Centre of buoyancy wanted, forward of midship", 3, 1, minimum=-50.0
    )
    lcb: asked_length("LCB from AP", "Centre of buoyancy wanted, from the after perpendicular")

    def invoke(self, context, event):
        return self.reporting(self._open_dialog, context)

    def _open_dialog(self, context):
        hull = hull_objects.hull_of(context.object)
        for name, value in self.present(hull, context.scene).items():
            if hasattr(self, name) and not self.properties.is_property_set(name):
                setattr(self, name, float(f"{value:.6g}"))
        return context.window_manager.invoke_props_dialog(self, width=320)

    def present(self, hull, scene):
        """What the properties begin with, by their names."""
        scale = units.metres_per_unit(scene)
        found, parallel_length = form_parameters.of_hull(hull, scene)
        return {
            "block": found.block,
            "prismatic": found.prismatic,
            "volume": found.volume,
            "displacement": found.displacement_t,
            "lcb_percent": found.lcb_percent,
            "lcb": found.lcb / scale,
            "parallel_length": parallel_length / scale,
        }

    def draw_wanted(self, column):
        if self.measure != "NONE":
            metric_field(column, self, self.measure.lower())
        column.prop(self, "lcb_as")
        if self.lcb_as != "NONE":
            column.prop(self, "lcb_percent" if self.lcb_as == "PERCENT" else "lcb")

    def wanted(self, hull, scene):
        """({name of the measure: value} or {}, LCB as x in m or None)."""
        scale = units.metres_per_unit(scene)
        name = {"DISPLACEMENT": "displacement_t"}.get(self.measure, self.measure.lower())
        volume, lcb = {}, None
        if self.measure != "NONE":
            volume[name] = units.as_typed(getattr(self, self.measure.lower()))
        if self.lcb_as == "LENGTH":
            lcb = scale * units.as_typed(self.lcb)
        elif self.lcb_as == "PERCENT":
            length = scale * units.as_typed(hull.hull.length_pp)
            if not length > 0.0:
                raise ValueError("Give Lpp first: LCB is wanted in % of it")
            lcb = length * (0.5 + 0.01 * units.as_typed(self.lcb_percent))
        return volume, lcb


class DisplacementTask(Displacement, TaskOperator):
    """The same as a task, which begins when the dialog is left."""

    def invoke(self, context, event):
        self._is_in_window = not bpy.app.background
        return Displacement.invoke(self, context, event)


class HULL_OT_shift_sections(bpy.types.Operator, Displacement, HullOperator):
    """Shift the sections along the ship until the hull has the displacement and the centre of
    buoyancy that are wanted. Sections keep their form"""

    bl_idname = "hull.shift_sections"
    bl_label = "Displacement and LCB"

    measure: measure_property(*MEASURES, _HALVES, NO_MEASURE)
    prismatic_fore: asked_number("Cp fore", "Prismatic coefficient of the fore body wanted", 4, 0.1)
    prismatic_aft: asked_number("Cp aft", "Prismatic coefficient of the aft body wanted", 4, 0.1)
    part: EnumProperty(
        name="Shift",
        description="Which sections are shifted",
        items=(
            ("WHOLE", "Whole hull", "Lackenby's shifts: by x sin(π|x|), and by sectional area"),
            ("FAIR", "Whole hull, fair", "The shifts that bend the hull's lines the least"),
            ("APART", "Halves apart", "Fore and aft body each by a shift of its own"),
            ("FORE", "Fore body", "The aft body stays"),
            ("AFT", "Aft body", "The fore body stays"),
        ),
        options=_SKIP,
    )
    parallel: EnumProperty(
        name="Parallel body",
        description="What becomes of the parallel middle body",
        items=(
            ("FREE", "As it comes", "It stays parallel; its length comes out"),
            ("KEEP", "Length kept", "It stays as long as it is"),
            ("LENGTH", "Length given", "It becomes as long as is wanted, about its middle"),
        ),
        options=_SKIP,
    )
    parallel_length: asked_length(
        "Parallel length", "Of the parallel middle body, as wanted", minimum=0.0
    )

    def present(self, hull, scene):
        found = super().present(hull, scene)
        if found["prismatic"]:
            apart = section_shifts.prismatics(hull, scene)
            found.update(prismatic_fore=apart.fore, prismatic_aft=apart.aft)
        return found

    def draw(self, context):
        column = property_column(self)
        column.prop(self, "measure")
        if self.measure == "HALVES":
            for name in ("fore", "aft"):
                if self.part.lower() in (name, "whole", "fair", "apart"):
                    column.prop(self, f"prismatic_{name}")
        else:
            self.draw_wanted(column)
        column.prop(self, "part")
        column.prop(self, "parallel")
        if self.parallel == "LENGTH":
            column.prop(self, "parallel_length")

    def run_on(self, hull, context):
        found = section_shifts.shift(hull, context.scene, self._wanted(hull, context.scene))
        self.tell("INFO", reports.shifted(found, context.scene))

    def _wanted(self, hull, scene):
        volume, lcb, apart = {}, None, None
        if self.measure == "HALVES":
            both = self.prismatic_fore, self.prismatic_aft
            apart = halves.Prismatics(*map(units.as_typed, both))
        else:
            volume, lcb = self.wanted(hull, scene)
        return section_shifts.Wanted(
            volume,
            lcb,
            self.part.lower(),
            self.parallel,
            units.metres_per_unit(scene) * units.as_typed(self.parallel_length),
            apart,
        )


class HULL_OT_change_displacement(bpy.types.Operator, DisplacementTask):
    """Change the hull to the displacement and the centre of buoyancy that are wanted so that its
    surface shifts and bends the least. Sections change their form"""

    bl_idname = "hull.change_displacement"
    bl_label = "Displacement and LCB, Least Change"
    bl_options = {"REGISTER", "UNDO"}

    needs = (*TaskOperator.needs, can_change)

    measure: measure_property(*MEASURES, NO_MEASURE)
    keep_parallel: BoolProperty(
        name="Parallel body",
        description="Control points of the parallel middle body stay",
        default=True,
    )
    keep_heights: BoolProperty(
        name="Base line",
        description="Points on the centre plane keep their heights",
        default=True,
    )
    keep_length: BoolProperty(
        name="Length",
        description="Points within a fiftieth of the length from the ends keep their x",
        default=True,
    )
    keep_profile: keep_profile(False)
    keep_deck: keep_deck(False)
    keep_side: keep_side(True)
    stiffness: FloatProperty(
        name="Fairness",
        description="How wide changes are spread, in parts of the hull's size",
        default=1.0,
        min=0.0,
        max=limits.GREATEST_TARGET_STIFFNESS,
        soft_max=1.0,
        precision=3,
        step=1,
    )

    def draw(self, context):
        column = property_column(self)
        column.prop(self, "measure")
        self.draw_wanted(column)
        column.prop(self, "stiffness")
        column = column.column(heading="Keep", align=True)
        for name in _KEPT:
            column.prop(self, f"keep_{name}")

    def begin(self, hull, scene):
        volume, lcb = self.wanted(hull, scene)
        kept = {name: getattr(self, f"keep_{name}") for name in _KEPT}
        stiffness = units.as_typed(self.stiffness)
        asked = least_change.Asked(volume, lcb, **kept, stiffness=stiffness)
        return least_change.LeastChange(hull, scene, asked)

    def outcome(self, reached, scene):
        return reports.changed(self._task.write(scene), scene), False


CLASSES = (HULL_OT_shift_sections, HULL_OT_change_displacement)
