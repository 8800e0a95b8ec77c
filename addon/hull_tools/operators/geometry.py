# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls that exist, as mesh objects or files, made control meshes."""

import textwrap

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from ..bridge import limits
from ..bridge.blender import sentence_units, units, view_target
from ..bridge.objects import hull_objects
from ..features.geometry import making, sources
from ..properties.shared import field_or
from .shared import (
    HullReader,
    asked_length,
    collection_for_new,
    in_object_mode,
    make_active,
    native_is_there,
    property_column,
    show_all,
)
from .tasks import TaskOperator

_GUESSED = "GUESSED"
_AXES = [(_GUESSED, "As Guessed", "As the form tells")] + [
    (sign + axis, f"{sign}{axis.upper()}", f"The axis {axis.upper()}, {way}")
    for axis in "xyz"
    for sign, way in (("+", "as it points"), ("-", "turned round"))
]
_SIDES = [
    (_GUESSED, "As Guessed", "Whole where it is symmetric"),
    ("HALF", "One Side", "It is one side of a hull"),
    ("WHOLE", "Both Sides", "It is a whole hull"),
]
_UNITS = [(_GUESSED, "As Guessed", "As the file tells, else by the hull's length")] + [
    (unit, unit, f"Numbers of the file are in {unit}") for unit in ("m", "cm", "mm", "ft", "in")
]
_DIALOG, _WIDTH = 380, 62  # of the dialog, and of its lines in letters


def _axis(name, description):
    return EnumProperty(name=name, description=description, items=_AXES, default=_GUESSED)


class FromGeometry(TaskOperator):
    """Subclasses: source(context) → a features.geometry.sources.Source; keeps_source, as
    features.geometry.making.Asked has it; _choices: names of what else is asked.

    It can't be done anew by other values: that takes half a minute."""

    bl_options = {"UNDO"}
    needs = (native_is_there, in_object_mode)

    points: IntProperty(
        name="Points at Most",
        description="Control points that the hull may have",
        default=150,
        min=limits.NETWORK_HULL_POINTS[0],
        max=limits.NETWORK_HULL_POINTS[1],
        soft_min=60,
        soft_max=300,
    )
    tolerance: asked_length(
        "Tolerance", "No more points where the hull is nearer than this; 0: 3e-4 of the length"
    )
    draft: asked_length(
        "Draft", "At which the hull floats, over its base line; 0: 60 % of the depth"
    )
    forward: _axis("Forward", "Which axis points to the bow")
    up: _axis("Up", "Which axis points up")
    sides: EnumProperty(
        name="Sides",
        description="Whether it is the whole hull or one side of it",
        items=_SIDES,
        default=_GUESSED,
    )

    stern_post: BoolProperty(
        name="Stern Post",
        description="Where a post is found below the counter, rows and columns are laid out for it",
        default=True,
    )
    knuckles: BoolProperty(
        name="Knuckles",
        description="Knuckles that are found become creases",
        default=True,
    )

    def run(self, context):
        return self.run_on(self.source(context), context)

    def known(self):
        """What hull_io.geometry.guess_hull is given."""
        told = {name: getattr(self, name) for name in ("forward", "up")}
        told = {name: value for name, value in told.items() if value != _GUESSED}
        if self.sides != _GUESSED:
            told["is_half"] = self.sides == "HALF"
        return told

    def begin(self, source, scene):
        scale = units.metres_per_unit(scene)
        tolerance, draft = (
            units.as_typed(value) * scale or None for value in (self.tolerance, self.draft)
        )
        asked = making.Asked(
            self.points, tolerance, draft, self.known(), self.keeps_source, self.stern_post,
            self.knuckles,
        )  # fmt: skip
        return making.Making(source, asked)

    def outcome(self, made, scene):
        self._made, report = self._task.write(scene, collection_for_new(bpy.context))
        return making.summary(report)

    def show(self, context):
        make_active(context, self._made)
        show_all(context)

    def draw(self, context):
        column = property_column(self)
        column.prop(self, "points")
        field_or(column, self, "tolerance", "3e-4 of the length")
        field_or(column, self, "draft", "60 % of the depth")
        column.separator()
        column = column.column(heading="Lay Out")
        for name in ("stern_post", "knuckles"):
            column.prop(self, name)
        column = column.column()
        for name in self._choices:
            column.prop(self, name)


class HULL_OT_hull_from_mesh(bpy.types.Operator, FromGeometry):
    """Lay a control mesh over the active mesh object, of whatever triangles, and fit it to that: a
    new hull, beside which the mesh stays as it is"""

    bl_idname = "hull.hull_from_mesh"
    bl_label = "Hull from Mesh"

    keeps_source = True  # that is an object already, where it is on a ship's axes
    _choices = ("forward", "up", "sides")
    _lines = ()

    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        obj = context.object
        if obj is None or obj.type != "MESH" or hull_objects.hull_of(obj) is not None:
            cls.poll_message_set("Select a mesh object that is no hull first")
            return False
        return True

    def invoke(self, context, event):
        self._is_in_window = not bpy.app.background
        return self.reporting(self._open, context)

    def _open(self, context):
        self._source = self.source(context)
        self._understand()
        return context.window_manager.invoke_props_dialog(self, width=_DIALOG)

    def check(self, context):
        self._understand()
        return True

    def _understand(self):
        try:
            self._lines = sources.understood(self._source, self.known())
        except ValueError as error:
            self._lines = [str(error)]

    def draw(self, context):
        FromGeometry.draw(self, context)
        column = self.layout.column(align=True)
        column.scale_y = 0.8
        for sentence in self._lines:
            shown = sentence_units.in_scene_units(context.scene, sentence)
            for line in textwrap.wrap(shown, _WIDTH):
                column.label(text=line)

    def source(self, context):
        return sources.of_object(context.object, context.scene)


class HULL_OT_hull_from_file(bpy.types.Operator, FromGeometry, ImportHelper):
    """Read a hull's surface (STL, OBJ, STEP, IGES) or table of offsets (CSV, text), lay a control
    mesh over it and fit it to that: a new hull"""

    bl_idname = "hull.hull_from_file"
    bl_label = "Hull from File"

    filter_glob: StringProperty(
        default="*.stl;*.gz;*.obj;*.step;*.stp;*.iges;*.igs;*.csv;*.txt;*.fbm;*.ftm;*.geo",
        options={"HIDDEN"},
    )
    unit: EnumProperty(
        name="Unit",
        description="Of the numbers in the file",
        items=_UNITS,
        default=_GUESSED,
    )
    keeps_source: BoolProperty(
        name="Keep the Source",
        description="What the hull is fitted to becomes an object, hidden: the target of the panel "
        "Fit",
        default=True,
    )

    _choices = ("forward", "up", "sides", "unit", "keeps_source")

    def invoke(self, context, event):
        self._is_in_window = not bpy.app.background
        return ImportHelper.invoke(self, context, event)

    def known(self):
        told = super().known()
        return told if self.unit == _GUESSED else {**told, "unit": self.unit}

    def source(self, context):
        return sources.of_file(self.filepath)


class HULL_OT_show_source_miss(bpy.types.Operator, HullReader):
    """Set the 3D cursor where the hull is farthest from what it was made of, and bring it into
    view"""

    bl_idname = "hull.show_source_miss"
    bl_label = "Show Largest"

    def run_on(self, hull, context):
        place = making.place_of(hull, context.scene)
        context.scene.cursor.location = place
        view_target.look_at(context.region_data, place)


CLASSES = (HULL_OT_hull_from_mesh, HULL_OT_hull_from_file, HULL_OT_show_source_miss)
