# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's curve objects as lines of points, and lines as curve objects."""

from contextlib import contextmanager

import bpy
import numpy as np

from . import hull_objects

_read = None  # by curve and object, while curves are read once


@contextmanager
def read_once():
    """Within it each curve is read when it is first asked for, and not again: what is asked for
    after a mesh was written would have Blender evaluate that mesh first. Reading may have Blender
    evaluate something and tell handlers of it, which then are within it, too."""
    global _read
    outer = _read
    _read = {} if outer is None else outer
    try:
        yield
    finally:
        _read = outer


def points_of(curve, obj):
    """(points (n, 3) in another object's axes and units, whether they close) of a curve object as
    the view shows it; ValueError, naming it, where it is no single line."""
    if _read is None:
        return _points_of(curve, obj)
    key = curve.as_pointer(), obj.as_pointer()
    if key not in _read:
        _read[key] = _points_of(curve, obj)
    return _read[key]


def _points_of(curve, obj):
    if curve.type != "CURVE":
        raise ValueError(f"{curve.name} is no curve object any longer: choose another one")
    if len(curve.data.splines) != 1:
        raise ValueError(
            f"{curve.name} has {len(curve.data.splines)} splines: take a curve object of one"
        )
    shown = curve.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = shown.to_mesh()
    if mesh is None:  # one of a linked hull's that did not come along
        raise ValueError(f"{curve.name} is not in the scene: link it too")
    try:
        points = np.array([vertex.co for vertex in mesh.vertices], dtype=np.float64)
        is_line = len(mesh.polygons) == 0
    finally:
        shown.to_mesh_clear()
    if len(points) == 1:
        raise ValueError(f"{curve.name} is a single point: give its curve another one")
    if not is_line or len(points) < 2:
        raise ValueError(f"{curve.name} is no line: take off its bevel, extrusion and fill")
    matrix = np.array(hull_objects.from_world(obj) @ curve.matrix_world, dtype=np.float64)
    return points @ matrix[:3, :3].T + matrix[:3, 3], curve.data.splines[0].use_cyclic_u


def made(name, points, is_closed, obj):
    """A new curve object through points (n, 3) in another object's axes and units, in its
    collections."""
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new("POLY")
    spline.points.add(len(points) - 1)
    corners = np.ones((len(points), 4), dtype=np.float32)
    corners[:, :3] = points
    spline.points.foreach_set("co", corners.reshape(-1))
    spline.use_cyclic_u = is_closed
    curve = bpy.data.objects.new(name, data)
    curve.matrix_world = obj.matrix_world
    for collection in obj.users_collection:
        collection.objects.link(curve)
    return curve
