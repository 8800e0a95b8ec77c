# SPDX-License-Identifier: GPL-3.0-or-later
"""Add > Mesh > Ship Hull: a new hull of a type, to its main dimensions and form."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

from ...hull_io import new_hulls
from ...hull_io.new_hulls import type_ships
from ..bridge.blender import units
from ..features.hull import hull_creation
from ..features.transformation import reports
from ..features.transformation import type_ships as made_after
from .shared import (
    BaseOperator,
    asked_length,
    asked_number,
    collection_for_new,
    in_object_mode,
    make_active,
    native_is_there,
    show_all,
)

_DIMENSIONS = ("length", "beam", "draft", "depth")
_COUNTS = ("sections", "points")
# What may be asked of a hull after a type ship, by its property and how it is called.
_FORM = {"block": "Cb", "lcb_percent": "LCB, % of Lpp", "parallel": "Parallel body"}


def _types():
    """Items of the types there are, those of their own mesh first."""
    made = {**new_hulls.TYPES, **type_ships.TYPE_SHIPS}
    return [(key, each.name, each.description) for key, each in made.items()]


def _take_type(self, context):
    """Another type comes with its own dimensions."""
    for name, value in _usual(self.kind, context.scene).items():
        setattr(self, name, value)


def _usual(kind, scene):
    """What a type has where nothing else is asked for; lengths in Blender's units."""
    scale = units.metres_per_unit(scene)
    if kind in type_ships.TYPE_SHIPS:
        ship, form = made_after.usual(kind)
        lengths = (ship.length_pp, ship.beam, ship.draft, ship.depth)
        found = {name: length / scale for name, length in zip(_DIMENSIONS, lengths)}
        rest = (form.block, form.lcb_percent, form.parallel / scale)
        return {**found, **{name: float(f"{value:.5g}") for name, value in zip(_FORM, rest)}}
    hull_type = new_hulls.TYPES[kind]
    lengths = {name: getattr(hull_type.dimensions, name) / scale for name in _DIMENSIONS}
    return {**lengths, "sections": hull_type.sections, "points": hull_type.points}


def _asked(name):
    return BoolProperty(
        name=_FORM[name],
        description="Shift the sections along the ship until it is as wanted; else it is as it "
        "comes with the dimensions",
        options={"SKIP_SAVE"},
    )


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
        items=_types(),
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
    use_block: _asked("block")
    block: asked_number("Block coefficient", "On length, beam and draft", 4, 0.1)
    use_lcb_percent: _asked("lcb_percent")
    lcb_percent: asked_number(
        "LCB in % of Lpp", "Centre of buoyancy, forward of midship", 3, 1, minimum=-50.0
    )
    use_parallel: _asked("parallel")
    parallel: asked_length("Length of it", "Of the parallel middle body", minimum=0.0)

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
        obj, text = (self._after_ship if self._is_after_ship() else self._of_own_mesh)(context)
        make_active(context, obj)
        self.tell("INFO", f"{obj.name}: {len(obj.data.vertices)} control points{text}")

    def _is_after_ship(self):
        return self.kind in type_ships.TYPE_SHIPS

    def _lengths(self, scene, names=_DIMENSIONS):
        scale = units.metres_per_unit(scene)
        return [units.as_typed(getattr(self, name)) * scale for name in names]

    def _of_own_mesh(self, context):
        lengths = self._lengths(context.scene)
        hull = new_hulls.new_hull(self.kind, *lengths, self.sections, self.points)
        return hull_creation.hull_object(hull, context.scene, collection_for_new(context)), ""

    def _after_ship(self, context):
        scene = context.scene
        values = [units.as_typed(self.block), units.as_typed(self.lcb_percent)]
        values += self._lengths(scene, ("parallel",))
        asked = [getattr(self, f"use_{name}") for name in _FORM]
        form = made_after.Form(*(value if use else None for value, use in zip(values, asked)))
        lengths = self._lengths(scene)
        obj, found = made_after.add(self.kind, lengths, form, scene, collection_for_new(context))
        return obj, f"; {reports.form_parameters(found, scene)}"

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "kind")
        is_after_ship = self._is_after_ship()
        for names in (_DIMENSIONS, () if is_after_ship else _COUNTS):
            column = layout.column(align=True)
            for name in names:
                column.prop(self, name)
        for name in _FORM if is_after_ship else ():
            row = layout.row(heading=_FORM[name])
            row.prop(self, f"use_{name}", text="")
            field = row.row()
            field.active = getattr(self, f"use_{name}")
            field.prop(self, name, text="")


CLASSES = (HULL_OT_add_hull,)
