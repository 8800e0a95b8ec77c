# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface pulled by one of its points, with the mouse."""

import bpy
import numpy as np
from bpy.props import BoolProperty, FloatProperty, FloatVectorProperty

from ..bridge.blender import units
from ..bridge.counts import counted
from ..bridge.objects import hull_objects
from ..features.hull import hull_state
from ..features.modelling import drags, pull_lines, pulling
from ..properties.shared import field_or
from .shared import HullOperator, property_column
from .view_drag import ViewDrag

AXES = {"X": 0, "Y": 1, "Z": 2}
# The planes that a point may be dragged in, by key; and the axis each is across.
_PLANES = {"S": ("station plane", 0), "B": ("buttock plane", 1), "W": ("waterplane", 2)}
_DIGITS = "0123456789.-"
# A mouse that moved further than this many pixels while its button was down has dragged.
_DRAGGED = 4
# Sine of the angle between view and the plane of a line, for it to be pulled in this at first.
_LEAST_SINE = 0.2
_PICK_HELP = (
    "Click or drag: a point of the surface or of a line   Ctrl: of the surface   Esc: cancel"
)
_DRAG_HELP = (
    "V: view   N: normal   S, W, B: station, waterplane, buttock   L: plane of the line   "
    "X, Y, Z: axis   0-9: exact   Wheel: radius   Enter: done   Esc: cancel"
)
# What the wheel, or Page Up and Down, does to the radius, as in Blender's proportional editing.
_WIDER = 1.1
_RADIUS_KEYS = {"WHEELDOWNMOUSE": 1, "PAGE_UP": 1, "WHEELUPMOUSE": -1, "PAGE_DOWN": -1}


def place(name, description):
    """Of the surface, or where it is to be."""
    return FloatVectorProperty(
        name=name,
        description=description,
        unit="LENGTH",
        subtype="XYZ",
        precision=5,
        options={"SKIP_SAVE"},
    )


def hold_creases():
    return BoolProperty(
        name="Hold creases",
        description="Points of creases and borders stay, unless the point pulled is on one",
        default=True,
    )


def radius():
    return FloatProperty(
        name="Radius",
        description="Control points this near to the point follow, the less the farther they are; "
        "0: only those that the point depends on",
        min=0.0,
        unit="LENGTH",
        subtype="DISTANCE",
        precision=3,
    )


def draw_reach(layout, operator):
    """What follows a point that is pulled."""
    field_or(layout, operator, "radius", "what the point depends on")
    layout.prop(operator, "hold_creases")


class HULL_OT_pull_surface(bpy.types.Operator, ViewDrag, HullOperator):
    """Pull the surface by one of its points, or by a point of a section line: the control points
    around follow, as far as the radius says. Locked points stay, flats stay flat"""

    bl_idname = "hull.pull_surface"
    bl_label = "Pull Surface"

    help_text = _PICK_HELP

    point: place("Point", "The point of the surface nearest to this place is pulled")
    target: place("To", "Where this point of the surface comes to lie")
    radius: radius()
    hold_creases: hold_creases()

    def draw(self, context):
        column = property_column(self)
        for name in ("point", "target"):
            column.prop(self, name)
        draw_reach(column, self)

    def run_on(self, hull, context):
        if not all(map(self.properties.is_property_set, ("point", "target"))):
            raise ValueError("Say which point of the surface goes where: give point and target")
        pull = pulling.SurfacePull(hull, context.scene, self.hold_creases)
        grip = pull.nearest(pull.scale * np.array(self.point))
        count, longest = pull.pull(
            grip, pull.scale * np.array(self.target), pull.scale * self.radius
        )
        hull_state.follow_edit(hull, context.scene)
        self._tell(context, count, longest)

    def _tell(self, context, count, longest):
        length = units.format_value(context.scene, longest, "m")
        self.tell("INFO", f"{counted(count, 'control point')} moved, {length} at most")

    def begin(self, context):
        hull = hull_objects.hull_of(context.object)
        self._pull = pulling.SurfacePull(hull, context.scene, self.hold_creases)
        self._held = pull_lines.held(hull, context.scene)
        self._grip, self._target, self._typed = None, None, ""
        self._mode, self._is_pressed, self._pressed_at = "V", False, (0, 0)

    def modal(self, context, event):
        if event.type in ("ESC", "RIGHTMOUSE") and event.value == "PRESS":
            return self._give_up(context)
        handle = self._pick if self._grip is None else self._drag
        return handle(context, event)

    def take_back(self, context):
        self._pull.restore()
        hull_state.follow_edit(self._pull.obj, context.scene)

    # Before a point is held

    def _pick(self, context, event):
        if event.type == "MOUSEMOVE":
            grip = self._under_mouse(event)
            self._show(context, grip, None if grip is None else grip.point)
            return {"RUNNING_MODAL"}
        if event.type != "LEFTMOUSE" or event.value != "PRESS":
            return self._rest(event)
        grip = self._under_mouse(event)
        if grip is None:
            return {"RUNNING_MODAL"}
        self._grip, self._target = grip, grip.point
        self._mode = "L" if self._is_seen_flat(grip.plane) else "V"
        self._is_pressed, self._pressed_at = True, (event.mouse_x, event.mouse_y)
        context.workspace.status_text_set(_DRAG_HELP)
        return {"RUNNING_MODAL"}

    def _is_seen_flat(self, normal):
        """Whether the view looks at a plane, if there is one, rather than along it."""
        return normal is not None and abs(normal @ self._eye().direction) > _LEAST_SINE

    def _under_mouse(self, event):
        self._take_view(event)
        eye, mouse = self._eye(), self._mouse(event)
        if not (0 <= mouse[0] < eye.size[0] and 0 <= mouse[1] < eye.size[1]):
            return None
        scale = bpy.context.preferences.system.ui_scale
        return pull_lines.grip_at(self._pull, eye, mouse, scale, takes_lines=not event.ctrl)

    # While it is held

    def _drag(self, context, event):
        if event.type == "MOUSEMOVE":
            if not self._typed:
                self._follow_mouse(context, event)
        elif event.type in _RADIUS_KEYS:
            if event.value == "PRESS":
                self._widen(context, _RADIUS_KEYS[event.type])
        elif event.type == "LEFTMOUSE":
            has_dragged = self._distance(event) > _DRAGGED
            if event.value == "PRESS" or (self._is_pressed and has_dragged):
                return self._finish(context)
            self._is_pressed = False
        elif event.value != "PRESS":
            return {"RUNNING_MODAL"}
        elif event.type in ("RET", "NUMPAD_ENTER"):
            return self._finish(context)
        elif event.type in AXES or event.type in _PLANES or event.type in ("V", "N"):
            self._choose(context, event, event.type)
        elif event.type == "L" and self._grip.plane is not None:
            self._choose(context, event, "L")
        elif event.type == "BACK_SPACE":
            self._type(context, self._typed[:-1])
        elif event.unicode and event.unicode in _DIGITS:
            self._type(context, self._typed + event.unicode)
        return {"RUNNING_MODAL"}

    def _widen(self, context, steps):
        """The next larger or smaller radius; below what the point depends on there is none."""
        least = self._pull.smallest_radius(self._grip) / self._pull.scale
        if self.radius < least:
            self.radius = least if steps > 0 else 0.0
        else:
            wider = self.radius * _WIDER**steps
            self.radius = wider if wider >= 0.999 * least else 0.0
        self._go(context, self._target)

    def _choose(self, context, event, mode):
        self._mode, self._typed = mode, ""
        self._follow_mouse(context, event)

    def _follow_mouse(self, context, event):
        ray = self._eye().ray(self._mouse(event))
        start = self._grip.point
        along = self._line_direction()
        if along is None:
            target = drags.on_plane(*ray, start, self._plane_normal())
        else:
            target = drags.on_line(*ray, start, along)
        if target is not None:
            self._go(context, target)

    def _line_direction(self):
        """The direction of the line that the point is dragged along; None in a plane."""
        if self._mode in AXES:
            return np.eye(3)[AXES[self._mode]]
        return self._grip.normal if self._mode == "N" and self._grip.normal.any() else None

    def _plane_normal(self):
        if self._mode in _PLANES:
            return np.eye(3)[_PLANES[self._mode][1]]
        if self._mode == "L":
            return self._grip.plane
        return self._eye().direction

    def _type(self, context, text):
        if self._line_direction() is None:
            return
        self._typed = text
        try:
            number = float(text) * self._pull.scale
        except ValueError:
            self._show(context, self._grip, self._target)
            return
        target = np.array(self._grip.point)
        if self._mode in AXES:
            target[AXES[self._mode]] = number
        else:
            target += number * self._grip.normal
        self._go(context, target)

    def _go(self, context, target):
        """Pulls to a place, as the property for it can keep it."""
        target = np.float32(target / self._pull.scale).astype(np.float64) * self._pull.scale
        try:
            self._pull.pull(self._grip, target, self._pull.scale * self.radius)
            self._target, trouble = target, ""
        except ValueError as error:
            trouble = str(error)
        self._show(context, self._grip, self._target, trouble)

    def _finish(self, context):
        self._leave(context)
        pull = self._pull
        if np.array_equal(self._target, self._grip.point):
            pull.restore()
            return {"CANCELLED"}
        self.point, self.target = self._grip.point / pull.scale, self._target / pull.scale
        count, longest = pull.pull(self._grip, self._target, pull.scale * self.radius)
        hull_state.follow_edit(pull.obj, context.scene)
        self._tell(context, count, longest)
        return {"FINISHED"}

    # What the view shows

    def _show(self, context, grip, now, trouble=""):
        if grip is None:
            self._held.mark = None
            text = _PICK_HELP
        else:
            text = trouble or self._words(context.scene, grip, now)
            place = tuple(now), tuple(grip.point)
            radius = 0.0 if self._grip is None else self._pull.scale * self.radius
            self._held.mark = pull_lines.Mark(place[1], place[0], text, radius)
        self._say(text)

    def _words(self, scene, grip, now):
        places = "  ".join(
            f"{axis} {units.format_value(scene, number, 'm')}" for axis, number in zip("xyz", now)
        )
        if self._grip is None:
            return places + ("    On a crease, which moves too" if grip.moves_creases else "")
        mode = {"V": "in the view's plane", "N": "along the normal", "L": "in the line's plane"}
        where = mode.get(self._mode) or f"along {self._mode.lower()}"
        if self._mode in _PLANES:
            where = f"in the {_PLANES[self._mode][0]}"
        radius = units.format_value(scene, self.radius * self._pull.scale, "m")
        within = f"    Radius {radius}" if self.radius else ""
        typed = f"    [{self._typed}]" if self._typed else ""
        return f"{places}    {where}{within}{typed}"

    def leave(self, context):
        self._held.mark = None

    def _eye(self):
        return self._eye_on(self._pull.obj, bpy.context.scene)

    def _distance(self, event):
        return np.hypot(event.mouse_x - self._pressed_at[0], event.mouse_y - self._pressed_at[1])


CLASSES = (HULL_OT_pull_surface,)
