# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves of a network: added, drawn, cut from the surface, smoothed."""

from math import radians

import bpy
import numpy as np
from bpy.props import EnumProperty, FloatProperty, StringProperty

from ..bridge.blender import units
from ..bridge.counts import counted
from ..bridge.objects import networks
from ..features.networks import adding, drawing, smoothing
from ..properties.network_settings import KINDS
from ..properties.shared import angle, length, metric_field
from .networks import NetworkOperator, selected_curves
from .shared import in_object_mode, make_active, property_column, suit_views
from .view_drag import DONE, ViewDrag

_AXIS_OF_KIND = {"STATION": 0, "BUTTOCK": 1, "WATERLINE": 2, "DIAGONAL": 2}
_HELP = (
    "Click: a point, near another curve on it    K: knuckle    Backspace: take back    Enter: done"
    "    Esc: cancel"
)


def _kind():
    return EnumProperty(name="Kind", description="What it is on the hull", items=KINDS)


def _position():
    return length(
        "Position", "x of a station, y of a buttock, z of a waterline, height of a diagonal in the "
        "centre plane", minimum=None, update=None, options={"SKIP_SAVE"},
    )  # fmt: skip


def _angle():
    return angle("Angle", "Of a diagonal below the horizontal", radians(45.0), radians(1.0),
                 radians(89.0), update=None)  # fmt: skip


class CurveOperator(NetworkOperator):
    """A curve of a kind and place; where that is not told it is the 3D cursor's."""

    needs = (*NetworkOperator.needs, in_object_mode)

    placed_as: StringProperty(
        name="Placed As",
        description="The kind of curve for which the position is the 3D cursor's",
        options={"SKIP_SAVE", "HIDDEN"},
    )

    def placed(self, context):
        """Done again as another kind, what was placed at the 3D cursor is so once more."""
        cursor = context.scene.cursor.location
        is_cursors = not self.properties.is_property_set("position") or (
            self.placed_as in _AXIS_OF_KIND
            and self.position == cursor[_AXIS_OF_KIND[self.placed_as]]
        )
        if self.kind in _AXIS_OF_KIND and is_cursors:
            self.position, self.placed_as = cursor[_AXIS_OF_KIND[self.kind]], self.kind
        return units.as_typed(self.position)

    def show(self, context, made):
        make_active(context, made)
        suit_views(context)

    def draw(self, context):
        column = property_column(self)
        column.prop(self, "kind")
        if self.kind in _AXIS_OF_KIND:
            column.prop(self, "position")
        if self.kind == "DIAGONAL":
            column.prop(self, "angle")


class HULL_OT_add_network_curve(bpy.types.Operator, CurveOperator):
    """Add a curve to the network: through the curves that its plane meets, or straight where there
    are none yet; at the 3D cursor, if no position is given"""

    bl_idname = "hull.add_network_curve"
    bl_label = "Add Curve"

    kind: _kind()
    position: _position()
    angle: _angle()
    points: StringProperty(
        name="Points",
        description="For scripts: x y z of one point after another, between ; in the scene's units",
        options={"SKIP_SAVE"},
    )

    def run_on(self, network, context):
        points = drawing.points_from(self.points) if self.points else None
        position = self.placed(context)
        made = adding.add(network, context.scene, self.kind, position, self.angle, points)
        self.show(context, made)
        self.tell("INFO", f'"{made.name}" is added')


class HULL_OT_add_network_section(bpy.types.Operator, CurveOperator):
    """Add the section of the network's surface as curves, tied to those that it meets; at the 3D
    cursor, if no position is given"""

    bl_idname = "hull.add_network_section"
    bl_label = "New Section"

    kind: EnumProperty(name="Kind", description="What it is on the hull", items=KINDS[:4])
    position: _position()
    angle: _angle()

    def run_on(self, network, context):
        position = self.placed(context)
        made = adding.add_section(network, context.scene, self.kind, position, self.angle)
        self.show(context, made[0])
        self.tell("INFO", f"{counted(len(made), 'curve')} through the surface")


class HULL_OT_draw_network_curve(bpy.types.Operator, CurveOperator, ViewDrag):
    """Draw a curve of the network, point by point, in its plane. Points near another curve snap
    onto it and are tied"""

    bl_idname = "hull.draw_network_curve"
    bl_label = "Draw Curve"
    help_text = _HELP

    kind: _kind()
    position: _position()
    angle: _angle()
    points: StringProperty(
        name="Points", description="As of Add Curve", options={"SKIP_SAVE", "HIDDEN"}
    )
    knuckles: StringProperty(
        name="Knuckles", description="Numbers of points", options={"SKIP_SAVE", "HIDDEN"}
    )

    def invoke(self, context, event):
        return ViewDrag.invoke(self, context, event)

    def begin(self, context):
        network = networks.at_hand(context)
        position = self.placed(context)
        self._pen = drawing.begin(network, context.scene, self.kind, position, self.angle)

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            return self._give_up(context)
        if event.type in DONE and event.value == "PRESS":
            return self._done(context)
        if event.type in ("MOUSEMOVE", "LEFTMOUSE"):
            self._take_view(event)
            self._pen.look(self._region(), self._view(), self._mouse(event))
        if event.type == "LEFTMOUSE" and event.value == "PRESS":
            self._pen.put()
        elif event.type in ("BACK_SPACE", "DEL") and event.value == "PRESS":
            self._pen.take_back()
        elif event.type == "K" and event.value == "PRESS":
            self._pen.turn_knuckle()
        self._say(self._pen.text)
        return self._rest(event)

    def _done(self, context):
        points, knuckles = self._pen.points, self._pen.knuckles
        self._leave(context)
        self.points = "; ".join(" ".join(f"{value:.9g}" for value in point) for point in points)
        self.knuckles = " ".join(map(str, knuckles))
        return self.execute(context)

    def take_back(self, context):
        """Nothing is made before it is done."""

    def leave(self, context):
        drawing.end()

    def run_on(self, network, context):
        points = drawing.points_from(self.points)
        is_knuckle = np.isin(np.arange(len(points)), [int(k) for k in self.knuckles.split()])
        position = self.placed(context)
        made = adding.add(
            network, context.scene, self.kind, position, self.angle, points, is_knuckle
        )
        self.show(context, made)
        self.tell("INFO", f'"{made.name}" is drawn')


class HULL_OT_smooth_network_curve(bpy.types.Operator, NetworkOperator):
    """Make the selected curves as smooth as can be within a mean deviation M of their points; ends
    and knuckles stay, curves tied to them follow"""

    bl_idname = "hull.smooth_network_curve"
    bl_label = "Smooth"

    deviation_mm: FloatProperty(
        name="Mean Deviation M",
        description="In mm: how far points may move, in the mean",
        default=10.0,
        min=0.0,
        soft_max=1000.0,
        precision=2,
    )

    needs = (*NetworkOperator.needs, in_object_mode)

    def draw(self, context):
        metric_field(property_column(self), self, "deviation_mm", "mm")

    def invoke(self, context, event):
        if not self.properties.is_property_set("deviation_mm"):
            self.deviation_mm = networks.at_hand(context).hull_network.deviation_mm
        return self.execute(context)

    def run_on(self, network, context):
        own = selected_curves(network, context)
        deviation = 1e-3 * units.as_typed(self.deviation_mm)
        told = smoothing.smooth_all(own, context.scene, deviation)
        mean = units.format_mm(max(one.mean for one in told))
        most = units.format_mm(max(one.largest for one in told))
        text = f"M = {units.format_mm(deviation)}: moved by {mean} in the mean, {most} at most"
        fairer = min(one.before / max(one.after, 1e-300) for one in told)
        if fairer > 1.0:
            text += f"; jumps of the third derivative {min(fairer, 1e6):.3g} times smaller"
        self.tell("INFO", text)


CLASSES = (
    HULL_OT_add_network_curve,
    HULL_OT_add_network_section,
    HULL_OT_draw_network_curve,
    HULL_OT_smooth_network_curve,
)
