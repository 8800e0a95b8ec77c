# SPDX-License-Identifier: GPL-3.0-or-later
"""A curve that is drawn in a 3D view: points in its plane, snapped to curves of the network."""

import numpy as np
from bpy_extras.view3d_utils import region_2d_to_origin_3d, region_2d_to_vector_3d
from mathutils import Vector

from ...bridge.objects import networks
from . import adding, curve_shapes, network_state, planes

# Dots: what is nearer to the mouse is snapped to.
_SNAP = 12.0
_PARTS = 6  # of a span between knots, of what is snapped to

_pen = None


def begin(network, scene, kind, position, angle):
    """The Pen of a curve that is to be drawn; ValueError where the network cannot take one."""
    global _pen
    reason = networks.locked(network)
    if reason:
        raise ValueError(reason)
    state = network_state.follow(network, scene)
    placed = adding.plane_for(kind, position, angle)
    cursor = np.array(scene.cursor.location, dtype=np.float64)
    _pen = Pen(state, planes.carrier(*placed), cursor, scene.name_full)
    return _pen


def at_hand(scene):
    """The Pen that draws in a scene; None without one."""
    return _pen if _pen is not None and _pen.scene_name == scene.name_full else None


def end():
    global _pen
    _pen = None


class Pen:
    """points: lists of 3 in the world; knuckles: their numbers; place: where the next one would be,
    None where the view looks along the plane. scene_name: of the scene that it draws in."""

    def __init__(self, state, carrier, cursor, scene_name):
        self.scene_name = scene_name
        self.points, self.knuckles, self.place, self.is_snapped = [], [], None, False
        self._carrier, self._cursor = carrier, cursor
        self._targets = _targets(state, carrier)

    @property
    def text(self):
        if self.place is None:
            return "The view looks along the curve's plane: turn it"
        place = "  ".join(f"{axis} {value:.3f}" for axis, value in zip("xyz", self.place))
        return f"{place}    {'on a curve' if self.is_snapped else ''}"

    def look(self, region, view, mouse):
        """Finds the place below the mouse (2,), dots in the region."""
        origin = np.array(region_2d_to_origin_3d(region, view, mouse))
        ray = np.array(region_2d_to_vector_3d(region, view, mouse))
        normal, offset = self._carrier or self._facing(view)
        slope = float(normal @ ray)
        self.place = None
        if abs(slope) > 1e-3:
            self.place = origin + (offset - normal @ origin) / slope * ray
        self._snap(region, view, mouse)

    def _facing(self, view):
        """The plane that faces the eye, through the last point, or the 3D cursor."""
        normal = np.array(view.view_rotation @ Vector((0.0, 0.0, 1.0)))
        through = self.points[-1] if self.points else self._cursor
        return normal, float(normal @ through)

    def _snap(self, region, view, mouse):
        self.is_snapped = False
        if not len(self._targets):
            return
        seen = in_picture(region, view, self._targets)
        distances = np.linalg.norm(seen - mouse, axis=1)
        distances[~np.isfinite(distances)] = np.inf
        nearest = int(distances.argmin())
        if distances[nearest] <= _SNAP:
            self.place, self.is_snapped = self._targets[nearest], True

    def put(self):
        """Puts a point where the place is, unless that is the last one."""
        if self.place is None:
            return
        if not self.points or np.linalg.norm(self.place - self.points[-1]) > 0.0:
            self.points.append(self.place)

    def take_back(self):
        if self.points:
            self.points.pop()
            self.knuckles = [k for k in self.knuckles if k < len(self.points)]

    def turn_knuckle(self):
        """Makes the last point a knuckle, or none."""
        last = len(self.points) - 1
        if last in self.knuckles:
            self.knuckles.remove(last)
        elif last > 0:
            self.knuckles.append(last)


def _targets(state, carrier):
    """(k, 3): where curves cross the plane; of a curve in space all points along curves."""
    if carrier is not None:
        return adding.crossing_points(state, *carrier)
    found = [np.empty((0, 3))]
    for known in state.curves.values():
        found.append(known.points)
        if known.pieces:
            found.append(curve_shapes.samples(known.pieces, _PARTS) / state.scale)
    return np.concatenate(found)


def in_picture(region, view, points):
    """(n, 2) dots in the region of points (n, 3) in the world; NaN behind the eye."""
    matrix = np.array(view.perspective_matrix, dtype=np.float64)
    clip = np.column_stack([points, np.ones(len(points))]) @ matrix.T
    with np.errstate(divide="ignore", invalid="ignore"):
        flat = clip[:, :2] / np.where(clip[:, 3:] > 0.0, clip[:, 3:], np.nan)
    return 0.5 * (flat + 1.0) * [region.width, region.height]


def points_from(text):
    """(n, 3) of a text of numbers; ValueError, telling how it is written."""
    rows = [row.replace(",", " ").split() for row in text.split(";") if row.strip()]
    try:
        points = np.array([[float(value) for value in row] for row in rows], dtype=np.float64)
    except ValueError:
        points = np.empty((0, 0))
    if points.ndim != 2 or points.shape[1:] != (3,):
        raise ValueError("Give points as x y z; x y z; …")
    return points
