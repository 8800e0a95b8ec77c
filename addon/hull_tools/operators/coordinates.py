# SPDX-License-Identifier: GPL-3.0-or-later
"""Coordinates of the selected points as a table to type in."""

import bpy
from bpy.props import BoolProperty, CollectionProperty, FloatVectorProperty

from ..bridge.blender import units
from ..bridge.counts import counted, counted_are
from ..bridge.objects import hull_objects
from ..features.modelling import point_places
from .shared import EditModeOperator

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
        for index, place in rows:
            row = self.points.add()
            row.name, row.co = str(index), place
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
            self.report({"WARNING"}, text)


def _number(row):
    if not row.name.isdecimal():
        raise ValueError(f'"{row.name}" is no point: name rows by the points\' numbers, as "12"')
    return int(row.name)


CLASSES = (HullPoint, HULL_OT_set_coordinates)
