# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls lengthened, and single sections made fuller."""

import bpy
from bpy.props import BoolProperty, EnumProperty

from ..bridge.blender import units
from ..bridge.objects import hull_objects
from ..features.transformation import inflating, lengthening, reports
from ..properties.shared import metric_field
from .shared import HullOperator, asked_length, asked_number, property_column

_SKIP = {"SKIP_SAVE"}


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
        column = property_column(self)
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
        self.tell("INFO", reports.lengthened(found, scene))


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
    percent: asked_number("Change in %", "Of the immersed section's area", 3, 10, minimum=-90.0)
    area: asked_number("Area in m²", "Of the immersed section, both sides", 3, 100)
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
        column = property_column(self)
        column.prop(self, "place")
        column.prop(self, "area_as")
        metric_field(column, self, self.area_as.lower())
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
        self.tell("INFO", reports.inflated(found, scene))


CLASSES = (HULL_OT_lengthen, HULL_OT_inflate_section)
