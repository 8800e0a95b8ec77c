# SPDX-License-Identifier: GPL-3.0-or-later
"""New networks, and Blender's curves of any kind taken into one."""

import bpy
import numpy as np

from ...bridge.objects import bezier_curves, networks
from . import choosing_points, network_state, planes

# What turns by more than this at a point of a curve is a knuckle: the cosine of 2°.
_STRAIGHT = 0.99939
# Of a B-spline's size: how near to it the curve is that is made of it.
_NEAR = 1e-5
# Of a curve's size: points nearer to one another are one.
_SAME = 1e-7


def new(scene, name):
    """A new network, without curves, in a scene."""
    network = bpy.data.collections.new(name)
    scene.collection.children.link(network)
    network.hull_network.is_network = True
    return network


def take(objects, network, scene):
    """Takes curve objects into a network, or with None into a new one: each of their splines
    becomes a curve, of a kind by the plane it lies in. Returns the new objects; ValueError where
    there is nothing to take, and then nothing is made."""
    curves = [obj for obj in objects if obj.type == "CURVE"]
    own = [obj for obj in curves if network is None or networks.network_of(obj) != network]
    if not own:
        raise ValueError("Select curve objects that are in no network yet")
    for obj in own:
        for block in (obj, obj.data):
            if block.library is not None or block.override_library is not None:
                raise ValueError(f'"{block.name}" is linked from another file: make it local first')
    lines = [(obj, *line) for obj in own for line in _lines(obj)]
    if not lines:
        raise ValueError("The selected curves have no line of two points or more")
    size = max(np.ptp(np.concatenate([points for _, points, _ in lines]), axis=0).max(), 1e-9)
    network = network or new(scene, "Network")
    made = []
    for obj, points, knuckles in lines:
        curve = bezier_curves.made(obj.name, points, knuckles, network)
        plane, normal, position = planes.found_in(points)
        planes.give(
            curve.hull.curve, planes.kind_of(plane, position, size), plane, normal, position
        )
        made.append(curve)
    for obj in own:
        bpy.data.objects.remove(obj)
    network_state.follow(network, scene)
    return made


def _lines(obj):
    """Pairs (points (n, 3) in the world, knuckles) of the splines of a curve object."""
    matrix = np.array(obj.matrix_world, dtype=np.float64)
    found = []
    for spline in obj.data.splines:
        points, knuckles = _points_and_knuckles(obj, spline)
        points, knuckles = _apart(points @ matrix[:3, :3].T + matrix[:3, 3], knuckles)
        if len(points) > 1 and np.isfinite(points).all():
            found.append((points, knuckles))
    return found


def _points_and_knuckles(obj, spline):
    if spline.type == "BEZIER":
        return _bezier(spline)
    if spline.type == "NURBS" and spline.order_u > 2:
        points = _shown_points(obj, spline)
        if len(points) > 2:
            tolerance = _NEAR * np.ptp(points, axis=0).max()
            points = points[choosing_points.chosen(points, (), (), tolerance)]
        return points, []
    points = np.array([point.co[:3] for point in spline.points], dtype=np.float64).reshape(-1, 3)
    return _closed(spline, points, [])


def _shown_points(obj, spline):
    """Points (n, 3) along a B-spline, in the object's coordinates, as Blender shows it."""
    number = list(obj.data.splines).index(spline)
    data = obj.data.copy()
    data.bevel_depth = data.extrude = 0.0
    for other in [one for i, one in enumerate(data.splines) if i != number]:
        data.splines.remove(other)
    alone = bpy.data.objects.new(data.name, data)
    try:
        found = [tuple(vertex.co) for vertex in alone.to_mesh().vertices]
    finally:
        bpy.data.objects.remove(alone)
        bpy.data.curves.remove(data)
    return np.array(found, dtype=np.float64).reshape(-1, 3)


def _bezier(spline):
    knots = spline.bezier_points
    points = np.array([knot.co for knot in knots], dtype=np.float64)
    left = points - np.array([knot.handle_left for knot in knots])
    right = np.array([knot.handle_right for knot in knots]) - points
    lengths = np.linalg.norm(left, axis=1) * np.linalg.norm(right, axis=1)
    along = (left * right).sum(axis=1)
    return _closed(spline, points, np.flatnonzero(along < _STRAIGHT * lengths).tolist())


def _closed(spline, points, knuckles):
    """A closed line begins and ends in one place."""
    if spline.use_cyclic_u and len(points) > 2:
        points = np.concatenate([points, points[:1]])
    return points, [k for k in knuckles if 0 < k < len(points) - 1]


def _apart(points, knuckles):
    """Without points that are where the one before is."""
    if len(points) < 2:
        return points, knuckles
    size = max(np.ptp(points, axis=0).max(), 1e-12)
    kept = np.append(True, np.linalg.norm(np.diff(points, axis=0), axis=1) > _SAME * size)
    numbers = np.cumsum(kept) - 1
    knuckles = sorted({int(numbers[k]) for k in knuckles})
    points = points[kept]
    return points, [k for k in knuckles if 0 < k < len(points) - 1]
