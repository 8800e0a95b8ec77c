# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole form changed to given particulars."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty

from ..bridge.blender import units
from ..bridge.objects import hull_objects
from ..features.transformation import halves, inflating, lengthening, reports, section_shifts
from .shared import HullOperator, asked_length

_SKIP = {"SKIP_SAVE"}


def _number(name, description, precision, step=10, minimum=0.0, **more):
    return FloatProperty(
        name=name,
        description=description,
        precision=precision,
        step=step,
        min=minimum,
        options=_SKIP,
        **more,
    )


class HULL_OT_shift_sections(bpy.types.Operator, HullOperator):
    """Shift the sections along the ship until the hull has the displacement and the centre of
    buoyancy that are wanted. Sections keep their form"""

    bl_idname = "hull.shift_sections"
    bl_label = "Displacement and LCB"

    measure: EnumProperty(
        name="Displacement",
        description="How the displacement is said that is wanted",
        items=(
            ("BLOCK", "Cb", "Block coefficient on Lpp, beam and draft"),
            ("PRISMATIC", "Cp", "Prismatic coefficient on Lpp and the station amidships"),
            ("VOLUME", "∇", "Displaced volume in m³"),
            ("DISPLACEMENT", "Δ", "Displacement in t"),
            ("HALVES", "Cp of halves", "Prismatic coefficients of fore and aft body, each on its "
             "half of Lpp and the station amidships"),
            ("NONE", "As it comes", "Only the centre of buoyancy is wanted"),
        ),
        options=_SKIP,
    )  # fmt: skip
    block: _number("Cb", "Block coefficient wanted", 4, 0.1)
    prismatic: _number("Cp", "Prismatic coefficient wanted", 4, 0.1)
    prismatic_fore: _number("Cp fore", "Prismatic coefficient of the fore body wanted", 4, 0.1)
    prismatic_aft: _number("Cp aft", "Prismatic coefficient of the aft body wanted", 4, 0.1)
    volume: _number("∇ in m³", "Displaced volume wanted", 2, 1000)
    displacement: _number("Δ in t", "Displacement wanted", 2, 1000)
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
    lcb_percent: _number(
        "LCB in % of Lpp", "Centre of buoyancy wanted, forward of midship", 3, 1, minimum=-50.0
    )
    lcb: asked_length("LCB from AP", "Centre of buoyancy wanted, from the after perpendicular")
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
        "Its length", "Of the parallel middle body, as wanted", minimum=0.0
    )

    def invoke(self, context, event):
        return self.reporting(self._open_dialog, context)

    def _open_dialog(self, context):
        hull = hull_objects.hull_of(context.object)
        scale = units.metres_per_unit(context.scene)
        found = section_shifts.particulars(hull, context.scene)
        present = {
            "block": found.block,
            "prismatic": found.prismatic,
            "volume": found.volume,
            "displacement": found.displacement_t,
            "lcb_percent": found.lcb_percent,
            "lcb": found.lcb / scale,
            "parallel_length": section_shifts.parallel_length(hull, context.scene) / scale,
        }
        if found.prismatic:
            apart = section_shifts.prismatics(hull, context.scene)
            present.update(prismatic_fore=apart.fore, prismatic_aft=apart.aft)
        for name, value in present.items():
            if not self.properties.is_property_set(name):
                setattr(self, name, float(f"{value:.6g}"))
        return context.window_manager.invoke_props_dialog(self, width=320)

    def draw(self, context):
        column = _column(self)
        column.prop(self, "measure")
        if self.measure == "HALVES":
            for name in ("fore", "aft"):
                if self.part.lower() in (name, "whole", "fair", "apart"):
                    column.prop(self, f"prismatic_{name}")
        else:
            self._draw_whole(column)
        column.prop(self, "part")
        column.prop(self, "parallel")
        if self.parallel == "LENGTH":
            column.prop(self, "parallel_length")

    def _draw_whole(self, column):
        if self.measure != "NONE":
            column.prop(self, self.measure.lower())
        column.prop(self, "lcb_as")
        if self.lcb_as != "NONE":
            column.prop(self, "lcb_percent" if self.lcb_as == "PERCENT" else "lcb")

    def run_on(self, hull, context):
        found = section_shifts.shift(hull, context.scene, self._wanted(hull, context))
        self.report({"INFO"}, reports.shifted(found, context.scene))

    def _wanted(self, hull, context):
        scale = units.metres_per_unit(context.scene)
        name = {"DISPLACEMENT": "displacement_t"}.get(self.measure, self.measure.lower())
        volume, lcb, apart = {}, None, None
        if self.measure == "HALVES":
            both = self.prismatic_fore, self.prismatic_aft
            apart = halves.Prismatics(*map(units.as_typed, both))
        elif self.measure != "NONE":
            volume[name] = units.as_typed(getattr(self, self.measure.lower()))
        if apart is None and self.lcb_as == "LENGTH":
            lcb = scale * units.as_typed(self.lcb)
        elif apart is None and self.lcb_as == "PERCENT":
            length = scale * units.as_typed(hull.hull.length_pp)
            lcb = length * (0.5 + 0.01 * units.as_typed(self.lcb_percent))
        return section_shifts.Wanted(
            volume,
            lcb,
            self.part.lower(),
            self.parallel,
            scale * units.as_typed(self.parallel_length),
            apart,
        )


def _column(operator):
    layout = operator.layout
    layout.use_property_split = True
    layout.use_property_decorate = False
    return layout.column()


class HULL_OT_lengthen(bpy.types.Operator, HullOperator):
    """Lengthen the hull by parallel middle body, or shorten it; or stretch a range of it"""

    bl_idname = "hull.lengthen"
    bl_label = "Lengthen"

    length: asked_length("Length", "Inserted; below zero: taken out", 1.0)
    place: asked_length("At x", "From the after perpendicular: where the length is inserted")
    use_range: BoolProperty(
        name="Stretch a range",
        description="Stretch the hull smoothly between two places, whatever its form there",
        options=_SKIP,
    )
    range_aft: asked_length("From x", "Aft end of the range, from the after perpendicular")
    range_fore: asked_length("To x", "Fore end of the range, from the after perpendicular")

    def invoke(self, context, event):
        return self.reporting(self._open_dialog, context)

    def _open_dialog(self, context):
        length = hull_objects.hull_of(context.object).hull.length_pp
        for name, share in (("place", 0.5), ("range_aft", 0.3), ("range_fore", 0.7)):
            if not self.properties.is_property_set(name):
                setattr(self, name, share * length)
        return context.window_manager.invoke_props_dialog(self, width=280)

    def draw(self, context):
        column = _column(self)
        column.prop(self, "length")
        column.prop(self, "place")
        column.prop(self, "use_range")
        if self.use_range:
            column.prop(self, "range_aft")
            column.prop(self, "range_fore")

    def run_on(self, hull, context):
        scene = context.scene
        scale = units.metres_per_unit(scene)
        values = [self.length, self.place, self.range_aft, self.range_fore]
        length, place, aft, fore = (scale * units.as_typed(value) for value in values)
        stretched = (aft, fore) if self.use_range else None
        found = lengthening.lengthen(hull, scene, place, length, stretched)
        self.report({"INFO"}, reports.lengthened(found, scene))


class HULL_OT_inflate_section(bpy.types.Operator, HullOperator):
    """Inflate a section along its normals to a wanted area, or deflate it; sections beside it go
    with it"""

    bl_idname = "hull.inflate_section"
    bl_label = "Inflate Section"

    place: asked_length("At x", "The section's distance from the after perpendicular")
    area_as: EnumProperty(
        name="Area",
        description="How the area is said that is wanted",
        items=(
            ("PERCENT", "Change in %", "More, or less, than there is, in percent"),
            ("AREA", "In m²", "The immersed section's area"),
        ),
        options=_SKIP,
    )
    percent: _number("Change in %", "Of the immersed section's area", 3, 10, minimum=-90.0)
    area: _number("Area in m²", "Of the immersed section, both sides", 3, 100)
    use_extent: BoolProperty(
        name="Limit extent",
        description="Sections beside it go with it less and less; else all by as much",
        default=True,
        options=_SKIP,
    )
    extent: asked_length("Extent", "Up to which sections go with it, forward and aft", minimum=0.0)

    def invoke(self, context, event):
        return self.reporting(self._open_dialog, context)

    def _open_dialog(self, context):
        hull = hull_objects.hull_of(context.object)
        for name, share in (("place", 0.5), ("extent", 0.25)):
            if not self.properties.is_property_set(name):
                setattr(self, name, share * hull.hull.length_pp)
        if not self.properties.is_property_set("area"):
            scale = units.metres_per_unit(context.scene)
            area = inflating.section_area(hull, context.scene, scale * self.place)
            self.area = float(f"{area:.6g}")
        return context.window_manager.invoke_props_dialog(self, width=280)

    def draw(self, context):
        column = _column(self)
        column.prop(self, "place")
        column.prop(self, "area_as")
        column.prop(self, self.area_as.lower())
        column.prop(self, "use_extent")
        if self.use_extent:
            column.prop(self, "extent")

    def run_on(self, hull, context):
        scene = context.scene
        scale = units.metres_per_unit(scene)
        by_area = self.area_as == "AREA"
        found = inflating.inflate(
            hull,
            scene,
            scale * units.as_typed(self.place),
            units.as_typed(self.area) if by_area else None,
            units.as_typed(self.percent),
            scale * units.as_typed(self.extent) if self.use_extent else None,
        )
        self.report({"INFO"}, reports.inflated(found, scene))


CLASSES = (HULL_OT_shift_sections, HULL_OT_lengthen, HULL_OT_inflate_section)
