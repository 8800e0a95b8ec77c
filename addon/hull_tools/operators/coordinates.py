# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact coordinates: of selected points, a table to type in, and of the surface at a place."""

import bpy
import numpy as np
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
)

from ..bridge.blender import units
from ..bridge.counts import counted, counted_are
from ..bridge.objects import hull_objects
from ..features.hull import hull_state
from ..features.modelling import point_places, pulling
from .pull import AXES, draw_reach, hold_creases, place, radius
from .shared import EditModeOperator, HullOperator

_MOST_ROWS = 40


class HullPoint(bpy.types.PropertyGroup):
    """A row of the table; its name is the number that the point has in the mesh."""

    co: FloatVectorProperty(
        name="Coordinates",
        description="x forward from the after perpendicular, y to port, z up from the base line. "
        "Expressions and units can be typed: 12.5/3, 11ft 6in",
        unit="LENGTH",
        subtype="XYZ",
        precision=5,
    )


class HULL_OT_set_coordinates(bpy.types.Operator, EditModeOperator):
    """Type the exact coordinates of the selected points in a table"""

    bl_idname = "hull.set_coordinates"
    bl_label = "Coordinates"

    points: CollectionProperty(type=HullPoint, options={"SKIP_SAVE"})
    in_metres: BoolProperty(
        name="In metres",
        description="For scripts: the numbers are metres, whatever the scene's units",
        options={"HIDDEN", "SKIP_SAVE"},
    )

    def invoke(self, context, event):
        return self.reporting(self._open_table, context)

    def _open_table(self, context):
        rows = point_places.selected_points(hull_objects.hull_of(context.object))
        if len(rows) > _MOST_ROWS:
            raise ValueError(
                f"{counted_are(len(rows), 'point')} selected: the table has {_MOST_ROWS} rows"
            )
        self.points.clear()
        for index, co in rows:
            row = self.points.add()
            row.name, row.co = str(index), co
        return context.window_manager.invoke_props_dialog(self, width=420)

    def draw(self, context):
        table = self.layout.column(align=True)
        table.label(text="Point")
        for point in self.points:
            split = table.split(factor=0.15, align=True)
            split.label(text=point.name)
            split.row(align=True).prop(point, "co", text="")

    def run_on(self, hull, context):
        scale = units.metres_per_unit(context.scene) if self.in_metres else 1.0
        places = {_number(row): [part / scale for part in row.co] for row in self.points}
        held = point_places.set_points(hull, context.scene, places)
        if held:
            text = f"In a region that is kept flat: {held} of {counted(len(places), 'point')}"
            self.tell("WARNING", text)


def _number(row):
    if not row.name.isdecimal():
        raise ValueError(f'"{row.name}" is no point: name rows by the points\' numbers, as "12"')
    return int(row.name)


class HULL_OT_surface_to_coordinate(bpy.types.Operator, HullOperator):
    """Pull the surface so that it has an exact coordinate at a place: y = 12.35 at this x and z,
    say. The place is the 3D cursor's at first"""

    bl_idname = "hull.surface_to_coordinate"
    bl_label = "Surface to Coordinate"

    axis: EnumProperty(
        name="Along",
        description="Which coordinate of the surface is given",
        items=(
            ("X", "x", "At a place given by y and z"),
            ("Y", "y", "At a place given by x and z"),
            ("Z", "z", "At a place given by x and y"),
        ),
        default="Y",
    )
    place: place("Place", "The line through here, along the axis, meets the surface at the point")
    value: FloatProperty(
        name="Value",
        description="The coordinate that the surface is to have there",
        unit="LENGTH",
        subtype="DISTANCE",
        precision=5,
        options={"SKIP_SAVE"},
    )
    radius: radius()
    hold_creases: hold_creases()

    def invoke(self, context, event):
        hull = hull_objects.hull_of(context.object)
        if not self.properties.is_property_set("place"):
            try:
                self.place = hull_objects.from_world(hull) @ context.scene.cursor.location
            except ValueError as error:
                self.tell("ERROR", str(error))
                return {"CANCELLED"}
        if not self.properties.is_property_set("value"):
            self.value = self.place[AXES[self.axis]]
        return context.window_manager.invoke_props_dialog(self)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.row().prop(self, "axis", expand=True)
        column = layout.column(align=True)
        for name, index in AXES.items():
            if name != self.axis:
                column.prop(self, "place", index=index, text=f"At {name.lower()}")
        layout.prop(self, "value", text=f"Surface {self.axis.lower()}")
        draw_reach(layout, self)

    def run_on(self, hull, context):
        axis = AXES[self.axis]
        pull = pulling.SurfacePull(hull, context.scene, self.hold_creases)
        wanted = pull.scale * np.array(self.place)
        wanted[axis] = pull.scale * self.value
        grip = pull.across(wanted, axis)
        before = units.format_value(context.scene, float(grip.point[axis]), "m")
        pull.pull(grip, wanted, pull.scale * self.radius)
        hull_state.follow_edit(hull, context.scene)
        after = units.format_value(context.scene, float(wanted[axis]), "m")
        self.tell("INFO", f"{self.axis.lower()} was {before} and is {after}")


CLASSES = (HullPoint, HULL_OT_set_coordinates, HULL_OT_surface_to_coordinate)
