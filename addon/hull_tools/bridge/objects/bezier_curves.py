# SPDX-License-Identifier: GPL-3.0-or-later
"""Curve objects of one Bézier spline as points in the world with handles, and back, in edit mode
or not.

Of a point's handles only their kind is the user's: free ones, and such that point to the
neighbours, make a knuckle; with aligned or automatic ones the curve goes on smoothly.
"""

from dataclasses import dataclass

import bpy
import numpy as np

_KNUCKLED = frozenset(("FREE", "VECTOR"))
_SIDES = ("left", "right")


@dataclass(frozen=True, eq=False)
class BezierPoints:
    """points (n, 3) and handles (n, 2, 3), left and right, in the world, Blender's units; weights
    (n,); knuckles: numbers of points between the ends."""

    points: np.ndarray
    handles: np.ndarray
    weights: np.ndarray
    knuckles: tuple


def refusal(obj):
    """Why a curve object is no single open line of Bézier points, as a sentence; "" when it is."""
    splines = obj.data.splines
    if len(splines) != 1:
        return (
            f'"{obj.name}" has {len(splines)} splines, and a curve of a network is one: separate '
            "them in edit mode (P), or delete the object"
        )
    if splines[0].type != "BEZIER":
        return f'"{obj.name}" is no Bézier curve: take it with Curves to Network'
    if splines[0].use_cyclic_u:
        return f'"{obj.name}" is closed: open it in edit mode (Alt C)'
    if len(splines[0].bezier_points) < 2:
        return f'"{obj.name}" has a single point: extrude it (E), or delete the object'
    if abs(obj.matrix_world.determinant()) < 1e-12:
        return f'"{obj.name}" is scaled to nothing: clear its scale (Alt S)'
    return ""


def read(obj):
    """The BezierPoints of a curve object that is not refused; ValueError where a coordinate is no
    number."""
    knots = obj.data.splines[0].bezier_points
    places = _vectors(knots, "co")
    handles = np.stack([_vectors(knots, f"handle_{side}") for side in _SIDES], axis=1)
    if not (np.isfinite(places).all() and np.isfinite(handles).all()):
        raise ValueError(f'"{obj.name}" has a point without a place: delete it')
    weights = np.empty(len(knots), dtype=np.float32)
    knots.foreach_get("weight_softbody", weights)
    weights[weights <= 0.0] = 1.0  # as Blender leaves those of new points
    matrix = np.array(obj.matrix_world, dtype=np.float64)
    return BezierPoints(
        _moved(places, matrix),
        _moved(handles.reshape(-1, 3), matrix).reshape(-1, 2, 3),
        weights.astype(np.float64),
        _knuckles(knots),
    )


def _knuckles(knots):
    # One by one: Blender has no way to tell of kinds of handles all at once.
    kinds = [(knot.handle_left_type, knot.handle_right_type) for knot in knots]
    inner = enumerate(kinds[1:-1], 1)
    return tuple(number for number, own in inner if not _KNUCKLED.isdisjoint(own))


def write(obj, points, handles, knuckles):
    """Gives a curve object points (n, 3), handles (n, 2, 3) in the world, and kinds of handles; it
    has as many points."""
    knots = obj.data.splines[0].bezier_points
    matrix = np.linalg.inv(np.array(obj.matrix_world, dtype=np.float64))
    # Kinds first: Blender may move handles when theirs change.
    for number, knot in enumerate(knots):
        kind = "FREE" if number in knuckles else "ALIGNED"
        if knot.handle_left_type != kind or knot.handle_right_type != kind:
            knot.handle_left_type = knot.handle_right_type = kind
    _set(knots, "co", _moved(points, matrix))
    for index, side in enumerate(_SIDES):
        _set(knots, f"handle_{side}", _moved(handles[:, index], matrix))
    obj.data.update_tag()


def replace(obj, points, knuckles, weights=None):
    """Gives a curve object, which is not in edit mode, one spline through points (n, 3) in the
    world; its handles wait to be set."""
    splines = obj.data.splines
    splines.clear()
    spline = splines.new("BEZIER")
    spline.bezier_points.add(len(points) - 1)
    chords = np.diff(points, axis=0) / 3.0
    handles = np.stack([points, points], axis=1)
    handles[1:, 0] -= chords
    handles[:-1, 1] += chords
    handles[0, 0] -= chords[0]
    handles[-1, 1] += chords[-1]
    write(obj, points, handles, knuckles)
    weights = np.ones(len(points)) if weights is None else weights
    spline.bezier_points.foreach_set("weight_softbody", weights.astype(np.float32))
    spline.resolution_u = 12


def made(name, points, knuckles, collection):
    """A new curve object, of one spline, in a collection."""
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    obj = bpy.data.objects.new(name, data)
    collection.objects.link(obj)
    replace(obj, np.asarray(points, dtype=np.float64), knuckles)
    return obj


def rounded(obj, points):
    """Points (n, 3) in the world as they come back when the object has them: Blender keeps them in
    single precision, in the object's own coordinates."""
    matrix = np.array(obj.matrix_world, dtype=np.float64)
    own = _moved(points, np.linalg.inv(matrix)).astype(np.float32).astype(np.float64)
    return _moved(own, matrix)


def rounding(obj, points):
    """What single precision leaves of points (n, 3) in the world, some times over."""
    matrix = np.array(obj.matrix_world, dtype=np.float64)
    own = np.abs(_moved(points, np.linalg.inv(matrix))).max() * np.abs(matrix[:3, :3]).max()
    return 2.0 * float(np.spacing(np.float32(max(np.abs(points).max(), own, 1e-6))))


def _moved(points, matrix):
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def _vectors(knots, name):
    values = np.empty((len(knots), 3), dtype=np.float32)
    knots.foreach_get(name, values.reshape(-1))
    return values.astype(np.float64)


def _set(knots, name, values):
    knots.foreach_set(name, np.ascontiguousarray(values, dtype=np.float32).reshape(-1))
