# SPDX-License-Identifier: GPL-3.0-or-later
"""The chosen shape field changed by its handles in the 3D view."""

import bpy
from bpy.props import FloatVectorProperty

from ..bridge.blender import units
from ..bridge.objects import hull_objects
from ..features.fields import field_list, handles
from .fields import FieldOperator
from .shared import asked_length
from .view_drag import DONE, ViewDrag

_HELP = "Drag: a handle   X, Y, Z: along one axis   Enter: done   Esc: cancel"
_AXES = ("X", "Y", "Z")


class HULL_OT_drag_field(bpy.types.Operator, ViewDrag, FieldOperator):
    """Drag the chosen field's handles in the view: the tip of its shift, and its extent"""

    bl_idname = "hull.drag_field"
    bl_label = "Handles in the View"

    help_text = _HELP

    shift: FloatVectorProperty(
        name="Shift",
        description="Of the base",
        unit="LENGTH",
        subtype="XYZ",
        precision=5,
        options={"SKIP_SAVE"},
    )
    extent: asked_length("Extent", "How far from its base the field works", 0.0, 0.0)

    def run_on(self, hull, context):
        given = [name for name in ("shift", "extent") if self.properties.is_property_set(name)]
        if not given:
            raise ValueError("Say what becomes of the field: give shift or extent")
        row = field_list.chosen(hull)
        for name in given:
            setattr(row, name, getattr(self, name))

    def begin(self, context):
        hull = hull_objects.hull_of(context.object)
        self._was_shown = hull.hull.fields.show_fields
        hull.hull.fields.show_fields = True
        try:
            row, _ = handles.at_hand(hull, context.scene)
        except ValueError:
            hull.hull.fields.show_fields = self._was_shown
            raise
        self._hull, self._number = hull, hull.hull.fields.active_field
        self._before = _values(row)
        self._held, self._drag, self._axis = handles.held(hull), None, None
        self._held.is_on = True

    def modal(self, context, event):
        if event.type in ("ESC", "RIGHTMOUSE") and event.value == "PRESS":
            return self._give_up(context)
        if event.type in DONE and event.value == "PRESS":
            return self._finish(context)
        if event.type == "MOUSEMOVE":
            self._follow_mouse(context, event)
        elif event.type == "LEFTMOUSE":
            self._take_or_leave(context, event)
        elif event.type in _AXES and event.value == "PRESS" and self._drag is not None:
            axis = _AXES.index(event.type)
            self._axis = None if self._axis == axis else axis
            self._follow_mouse(context, event)
        return self._rest(event)

    def take_back(self, context):
        row = self._row()
        if _values(row) != self._before:
            row.shift, row.extent = self._before
        self._hull.hull.fields.show_fields = self._was_shown

    def _finish(self, context):
        self.shift, self.extent = values = _values(self._row())
        self._leave(context)
        return {"CANCELLED"} if values == self._before else {"FINISHED"}

    def _row(self):
        return self._hull.hull.fields.fields[self._number]

    def _take_or_leave(self, context, event):
        if event.value == "PRESS":
            self._follow_mouse(context, event)
            if self._held.kind is not None:
                self._drag = handles.Drag(
                    self._hull, context.scene, self._held.kind, self._eye(), self._mouse(event)
                )
        elif event.value == "RELEASE":
            self._drag = self._axis = None
        self._held.is_dragged = self._drag is not None
        self._tell(context)

    def _follow_mouse(self, context, event):
        if self._drag is None:
            self._take_view(event)
        eye, mouse = self._eye(), self._mouse(event)
        if self._drag is not None:
            self._drag.move(eye, mouse, self._axis)
        else:
            row, base = handles.at_hand(self._hull, context.scene)
            found = handles.places(row, base, eye, units.metres_per_unit(context.scene))
            reach = handles.NEAR * context.preferences.system.ui_scale
            self._held.kind = handles.nearest(found, eye, mouse, reach)
        self._tell(context)

    def _tell(self, context):
        text = _HELP
        if self._held.kind is not None:
            text = handles.words(self._row(), self._held.kind, context.scene)
            if self._axis is not None:
                text += f"    along {'xyz'[self._axis]}"
        self._say(text)

    def _eye(self):
        return self._eye_on(self._hull, bpy.context.scene)

    def leave(self, context):
        self._held.is_on = self._held.is_dragged = False
        self._held.kind = None


def _values(row):
    return tuple(row.shift), row.extent


CLASSES = (HULL_OT_drag_field,)
