# SPDX-License-Identifier: GPL-3.0-or-later
"""A sectional area curve that is wanted: taken, read, changed, and the hull brought to it."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from ..bridge import limits
from ..bridge.blender import units
from ..bridge.objects import hull_objects
from ..features.area_curves import handles, matching, reports, sources, stored
from ..properties.outline_settings import KeptOutline
from ..properties.shared import field_or
from .shared import HullOperator, can_change, property_column
from .tasks import TaskOperator

_SKIP = {"SKIP_SAVE"}


def _has_target(cls, context):
    if not stored.is_there(hull_objects.hull_of(context.object)):
        cls.poll_message_set("There is no target: take the present curve first, or read a table")
        return False
    return True


def _handles():
    return IntProperty(
        name="Handles",
        description="Points on the curve by which it is changed, as far from one another",
        default=11,
        min=3,
        max=limits.MOST_AREA_HANDLES,
    )


def _told(operator, curve, scene):
    volume, centre = curve.volume()
    operator.tell(
        "INFO",
        f"Target: ∇ {units.format_value(scene, volume, 'm3')}, "
        f"LCB {units.format_value(scene, centre, 'm')}",
    )


class HULL_OT_take_area_curve(bpy.types.Operator, HullOperator):
    """Make the present sectional area curve the target, with handles to change it by"""

    bl_idname = "hull.take_area_curve"
    bl_label = "Take Present Curve"

    handles: _handles()

    def run_on(self, hull, context):
        curve = sources.take_present(hull, context.scene, self.handles)
        hull.hull.plots.sectional_areas = True
        _told(self, curve, context.scene)


class HULL_OT_take_other_area_curve(bpy.types.Operator, HullOperator):
    """Make the sectional area curve of another hull in the scene the target, at that one's draft"""

    bl_idname = "hull.take_other_area_curve"
    bl_label = "Take Curve of Hull"

    other: StringProperty(name="Hull", description="The object whose curve is taken", options=_SKIP)
    to_length: BoolProperty(
        name="To own length",
        description="Scale x by the ratio of the lengths between perpendiculars",
        default=True,
    )
    areas_as: EnumProperty(
        name="Areas",
        description="What the other hull's areas are multiplied by",
        items=(
            ("VOLUME", "To own ∇", "So that the target has this hull's volume"),
            ("LARGEST", "To own largest section", "So that the largest areas are the same"),
            ("SAME", "As they are", "Areas of the other hull"),
        ),
    )
    handles: _handles()

    def invoke(self, context, event):
        if not self.other:
            hull = hull_objects.hull_of(context.object)
            others = [one for one in hull_objects.hulls(context.scene.objects) if one != hull]
            self.other = others[0].name if others else ""
        return context.window_manager.invoke_props_dialog(self, width=300)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop_search(self, "other", context.scene, "objects")
        for name in ("to_length", "areas_as", "handles"):
            layout.prop(self, name)

    def run_on(self, hull, context):
        other = hull_objects.hull_of(context.scene.objects.get(self.other))
        curve = sources.take_from_hull(
            hull, context.scene, other, self.handles, self.to_length, self.areas_as
        )
        hull.hull.plots.sectional_areas = True
        _told(self, curve, context.scene)


class HULL_OT_load_area_curve(bpy.types.Operator, HullOperator, ImportHelper):
    """Read the target from a CSV table: x in metres from the after perpendicular, and the section's
    area in m², a line for each station"""

    bl_idname = "hull.load_area_curve"
    bl_label = "Load Area Curve"

    filter_glob: StringProperty(default="*.csv;*.txt;*.tsv;*.dat", options={"HIDDEN"})
    handles: _handles()

    def run_on(self, hull, context):
        curve = sources.take_from_table(hull, context.scene, self.filepath, self.handles)
        hull.hull.plots.sectional_areas = True
        _told(self, curve, context.scene)


class HULL_OT_scale_area_curve(bpy.types.Operator, HullOperator):
    """Multiply the target's areas so that its volume is as wanted: at first that of the hull"""

    bl_idname = "hull.scale_area_curve"
    bl_label = "Scale to Volume"

    volume: FloatProperty(
        name="∇ in m³",
        description="The target's volume; 0: that of the hull as it is",
        min=0.0,
        precision=2,
        step=1000,
        options=_SKIP,
    )

    needs = (*HullOperator.needs, _has_target)

    def draw(self, context):
        field_or(property_column(self), self, "volume", "that of the hull as it is")

    def run_on(self, hull, context):
        volume = units.as_typed(self.volume) or None
        curve = sources.scale_to_volume(hull, context.scene, volume)
        _told(self, curve, context.scene)


class HULL_OT_clear_area_curve(bpy.types.Operator, HullOperator):
    """Take the target away"""

    bl_idname = "hull.clear_area_curve"
    bl_label = "Clear Target"

    needs = (*HullOperator.needs, _has_target)

    def run_on(self, hull, context):
        stored.clear(hull)


class HULL_OT_add_area_point(bpy.types.Operator, HullOperator):
    """Add a point on the target curve, midway from the chosen one to the next"""

    bl_idname = "hull.add_area_point"
    bl_label = "Add Point"

    needs = (*HullOperator.needs, _has_target)

    def run_on(self, hull, context):
        x = stored.curve(hull, context.scene).x
        index = min(hull.hull.area_target.active_area_point, len(x) - 2)
        limits.at_most(len(x) + 1, "points of the target curve", limits.MOST_AREA_HANDLES)
        if handles.add_handle(hull, context.scene, 0.5 * (x[index] + x[index + 1])) is None:
            raise ValueError("There is no room for a point: choose another one")


class HULL_OT_remove_area_point(bpy.types.Operator, HullOperator):
    """Remove the chosen point of the target curve; the curve goes back to what it was there"""

    bl_idname = "hull.remove_area_point"
    bl_label = "Remove Point"

    needs = (*HullOperator.needs, _has_target)

    def run_on(self, hull, context):
        handles.remove_handle(hull, hull.hull.area_target.active_area_point)


class HULL_OT_transform_to_area_curve(bpy.types.Operator, TaskOperator, KeptOutline):
    """Move the control points so that the sections have the areas of the target curve. Locked
    points stay, flats stay flat, and what is kept in the panel Transform stays"""

    bl_idname = "hull.transform_to_area_curve"
    bl_label = "Transform to Area Curve"
    bl_options = {"REGISTER", "UNDO"}

    by: EnumProperty(
        name="By",
        description="How sections come to the areas that are wanted",
        items=(
            ("LEAST", "Least change", "By the least shift and bending of the surface"),
            ("SHIFT", "Shifts", "Sections go along the ship to where their areas are wanted"),
            ("INFLATE", "Inflating", "Sections grow or shrink along their normals"),
        ),
    )
    way: FloatProperty(
        name="Way",
        description="How far the hull goes on the way from the present curve to the target",
        default=100.0,
        min=0.1,
        max=100.0,
        precision=1,
        subtype="PERCENTAGE",
    )
    tolerance: FloatProperty(
        name="Tolerance %",
        description="By how much areas may be off, in percent of the largest one",
        default=0.2,
        min=limits.AREA_TOLERANCES[0],
        max=limits.AREA_TOLERANCES[1],
        precision=3,
        step=1,
    )
    stations: IntProperty(
        name="Stations",
        description="How many sections are brought to their areas by the least change",
        default=21,
        min=3,
        max=limits.MOST_AREA_STATIONS,
    )
    needs = (*TaskOperator.needs, can_change, _has_target)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        for name in ("by", "way", "tolerance"):
            layout.prop(self, name)
        if self.by == "LEAST":
            layout.prop(self, "stations")
            column = layout.column(heading="Keep", align=True)
            for name in ("keep_profile", "keep_deck", "keep_side"):
                column.prop(self, name)

    def begin(self, hull, scene):
        asked = matching.Asked(
            self.by,
            0.01 * units.as_typed(self.way),
            0.01 * units.as_typed(self.tolerance),
            self.stations,
            self.keep_profile,
            self.keep_deck,
            self.keep_side,
        )
        return matching.Matching(hull, scene, asked)

    def outcome(self, moved, scene):
        report = self._task.write(scene)
        return reports.summary(report, scene), report.status != "met"


CLASSES = (
    HULL_OT_take_area_curve,
    HULL_OT_take_other_area_curve,
    HULL_OT_load_area_curve,
    HULL_OT_scale_area_curve,
    HULL_OT_clear_area_curve,
    HULL_OT_add_area_point,
    HULL_OT_remove_area_point,
    HULL_OT_transform_to_area_curve,
)
