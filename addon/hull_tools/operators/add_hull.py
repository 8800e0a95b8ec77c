# SPDX-License-Identifier: GPL-3.0-or-later
"""Add > Mesh > Ship Hull: a new hull of a type, to its main dimensions."""

import bpy
from bpy.props import EnumProperty, FloatProperty, IntProperty

from ...hull_io import new_hulls
from ..bridge.blender import units
from ..features.hull import hull_creation
from .shared import BaseOperator, in_object_mode, make_active, native_is_there, show_all

_DIMENSIONS = ("length", "beam", "draft", "depth")
_COUNTS = ("sections", "points")


def _take_type(self, context):
    """Another type comes with its own dimensions."""
    for name, value in _usual(self.kind, context.scene).items():
        setattr(self, name, value)


def _usual(kind, scene):
    """What a type has where nothing else is asked for; lengths in Blender's units."""
    hull_type = new_hulls.TYPES[kind]
    scale = units.metres_per_unit(scene)
    lengths = {name: getattr(hull_type.dimensions, name) / scale for name in _DIMENSIONS}
    return {**lengths, "sections": hull_type.sections, "points": hull_type.points}


def _dimension(name, description):
    return FloatProperty(
        name=name,
        description=description,
        min=0.0,
        unit="LENGTH",
        subtype="DISTANCE",
        precision=3,
        step=10,
        options={"SKIP_SAVE"},
    )


class HULL_OT_add_hull(bpy.types.Operator, BaseOperator):
    """Add the control mesh of a new hull, its aft perpendicular and base line at the origin"""

    bl_idname = "hull.add_hull"
    bl_label = "Add Ship Hull"

    kind: EnumProperty(
        name="Type",
        description="What the hull is to be; another type comes with its own dimensions",
        items=[(key, each.name, each.description) for key, each in new_hulls.TYPES.items()],
        default="ROUND_BILGE",
        update=_take_type,
        options={"SKIP_SAVE"},
    )
    length: _dimension("Length", "Length of the design waterline, between the perpendiculars")
    beam: _dimension("Beam", "Greatest moulded breadth")
    draft: _dimension("Draft", "Height of the design waterline over the lowest point")
    depth: _dimension("Depth", "Height of the deck edge over the lowest point, where it is lowest")
    sections: IntProperty(
        name="Sections",
        description="Rows of control points across the hull, transom and stem included",
        min=new_hulls.SECTIONS[0],
        max=new_hulls.SECTIONS[1],
        options={"SKIP_SAVE"},
    )
    points: IntProperty(
        name="Points",
        description="Control points in a section, from the keel to the deck edge",
        min=new_hulls.POINTS[0],
        max=new_hulls.POINTS[1],
        options={"SKIP_SAVE"},
    )

    needs = (native_is_there, in_object_mode)

    def invoke(self, context, event):
        """From a menu; shows all of the hull."""
        result = self.execute(context)
        if result == {"FINISHED"}:
            show_all(context)
        return result

    def run(self, context):
        for name, value in _usual(self.kind, context.scene).items():
            if not self.properties.is_property_set(name):
                setattr(self, name, value)
        scale = units.metres_per_unit(context.scene)
        lengths = [units.as_typed(getattr(self, name)) * scale for name in _DIMENSIONS]
        hull = new_hulls.new_hull(self.kind, *lengths, self.sections, self.points)
        obj = hull_creation.hull_object(hull, context.scene, context.collection)
        make_active(context, obj)
        self.report({"INFO"}, f"{obj.name}: {len(hull.points)} control points")

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "kind")
        for names in (_DIMENSIONS, _COUNTS):
            column = layout.column(align=True)
            for name in names:
                column.prop(self, name)


CLASSES = (HULL_OT_add_hull,)
