# SPDX-License-Identifier: GPL-3.0-or-later
"""New curves of a network: through the curves that its plane meets, through the surface, by points,
or straight."""

from math import cos, sin

import numpy as np

from ...bridge.objects import bezier_curves, networks
from . import choosing_points, crossings, curve_shapes, network_state, planes, sections

_NAMES = {
    "STATION": "Station",
    "WATERLINE": "Waterline",
    "BUTTOCK": "Buttock",
    "DIAGONAL": "Diagonal",
    "FREE": "Curve",
    "PROFILE": "Profile",
    "DECK_EDGE": "Deck edge",
}
_PARTS = 8  # of a span between knots, in which a plane is looked for
_HALVINGS = 50
# Of a section's length: how far a new curve may be from the surface between its points.
_SECTION_TOLERANCE = 2e-5


def plane_for(kind, position, angle):
    """(plane of Object.hull.curve, normal (3,) or None, position) of a new curve. Diagonals go
    through the height `position` in the centre plane, and fall to the side by an angle."""
    plane = planes.PLANE_OF_KIND[kind]
    if plane != "OWN":
        return plane, None, position if kind != "PROFILE" else 0.0
    normal = np.array([0.0, sin(angle), cos(angle)])
    return plane, normal, float(position * normal[2])


def add(network, scene, kind, position=0.0, angle=0.0, points=None, is_knuckle=None):
    """A new curve, tied to those that it meets; returns its object. points (n, 3) in the world, of
    which knuckles are is_knuckle; without them it runs through the curves that its plane meets, in
    their order, or straight where that are fewer than two. ValueError where it cannot be."""
    _check(network)
    state = network_state.follow(network, scene)
    plane, normal, position = plane_for(kind, position, angle)
    if points is None:
        points = _through_curves(state, planes.carrier(plane, normal, position), kind)
    if points is None:
        points = _straight(network, kind, position, angle)
    points = np.array(points, dtype=np.float64)
    knuckles = [] if is_knuckle is None else np.flatnonzero(is_knuckle).tolist()
    _check_points(points)
    obj = _made(network, kind, (plane, normal, position), points, knuckles)
    _tie(network, scene, obj)
    return obj


def add_section(network, scene, kind, position, angle=0.0):
    """New curves where a plane cuts the surface of a network, tied to the curves there; returns
    their objects. ValueError where it does not."""
    _check(network)
    state = network_state.up_to_date(network, scene)
    placed = plane_for(kind, position, angle)
    carrier = planes.carrier(*placed)
    if carrier is None:
        raise ValueError("A free curve has no plane: choose a station, waterline or buttock")
    found = sections.chains(state.network, *carrier, state.scale)
    if not found:
        raise ValueError("The plane does not cut the surface of the network: move it")
    made = []
    for points, kept in found:
        length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
        numbers = choosing_points.chosen(points, kept, (), _SECTION_TOLERANCE * length)
        knuckles = _knuckles(points, kept, numbers)
        made.append(_made(network, kind, placed, points[numbers], knuckles))
    _tie(network, scene, *made)
    return made


def _check(network):
    reason = networks.locked(network)
    if reason:
        raise ValueError(reason)


def _check_points(points):
    if len(points) < 2:
        raise ValueError("A curve has two points or more")
    if not np.isfinite(points).all():
        raise ValueError("A point of the curve has no place")
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    if steps.min() <= 1e-7 * max(np.ptp(points, axis=0).max(), 1e-9):
        raise ValueError("Two points of the curve, one after the other, are in the same place")


def _made(network, kind, placed, points, knuckles):
    plane, normal, position = placed
    carrier = planes.carrier(plane, normal, position)
    if carrier is not None:
        points = planes.onto(points, [carrier])
    obj = bezier_curves.made(name_of(kind, placed), points, knuckles, network)
    planes.give(obj.hull.curve, kind, plane, normal, position)
    return obj


def name_of(kind, placed):
    plane, normal, position = placed
    name = _NAMES[kind]
    if kind in ("STATION", "WATERLINE", "BUTTOCK"):
        return f"{name} {position:g}"
    return f"{name} {position / normal[2]:g}" if plane == "OWN" else name


def _tie(network, scene, *made):
    """Where the network cannot be joined the curves stay as they are: problems tell why."""
    reach = network.hull_network.tolerance
    try:
        crossings.tie(network, scene, reach, [obj.name for obj in made])
    except ValueError:
        network_state.follow(network, scene)


def crossing_points(state, normal, offset):
    """(k, 3), Blender's units: where a plane meets the curves of a NetworkState."""
    found = []
    for known in state.curves.values():
        for piece in known.pieces:
            found += _on_plane(piece, normal, offset * state.scale)
    return _apart(np.array(found).reshape(-1, 3) / state.scale)


def _on_plane(piece, normal, offset):
    t = curve_shapes.parameters_of(piece, _PARTS)
    height = curve_shapes.evaluate(piece, t)[0] @ normal - offset
    above = height >= 0.0
    at = np.flatnonzero(above[:-1] != above[1:])
    low, high, is_above = t[at], t[at + 1], above[at]
    for _ in range(_HALVINGS if len(at) else 0):
        middle = 0.5 * (low + high)
        is_first = (curve_shapes.evaluate(piece, middle)[0] @ normal >= offset) == is_above
        low, high = np.where(is_first, middle, low), np.where(is_first, high, middle)
    return list(curve_shapes.evaluate(piece, 0.5 * (low + high))[0]) if len(at) else []


def _apart(points):
    """Without those that are where another one is."""
    kept = []
    size = max(np.ptp(points, axis=0).max(), 1e-9) if len(points) else 1.0
    for point in points:
        if all(np.abs(point - other).max() > 1e-5 * size for other in kept):
            kept.append(point)
    return np.array(kept).reshape(-1, 3)


def _through_curves(state, carrier, kind):
    """Points in the order in which a curve passes them; None where they are fewer than two."""
    if carrier is None:
        return None
    points = crossing_points(state, *carrier)
    if len(points) < 2:
        return None
    # From the keel up, or from aft forward: always on to what is nearest.
    axis = 2 if kind in ("STATION", "FREE") else 0
    left = points[np.argsort(points[:, axis], kind="stable")].tolist()
    line = [left.pop(0)]
    while left:
        nearest = min(
            range(len(left)), key=lambda i: np.linalg.norm(np.subtract(left[i], line[-1]))
        )
        line.append(left.pop(nearest))
    return np.array(line)


def _straight(network, kind, position, angle):
    """Points of a first curve of its kind, over the sizes that the network's settings tell."""
    settings = network.hull_network
    length, breadth, depth = settings.length, settings.half_breadth, settings.depth
    if kind == "STATION":
        return [(position, 0.0, 0.0), (position, breadth, 0.35 * depth), (position, breadth, depth)]
    if kind == "DIAGONAL":
        reach = min(breadth, position / max(sin(angle), 1e-6))
        down = position - reach * sin(angle) / max(cos(angle), 1e-6)
        return [(0.0, 0.0, position), (0.5 * length, reach, down), (length, 0.0, position)]
    if kind == "PROFILE":
        return [(0.0, 0.0, 0.0), (0.5 * length, 0.0, 0.0), (0.9 * length, 0.0, 0.0),
                (length, 0.0, depth)]  # fmt: skip
    side = {"WATERLINE": (breadth, position), "BUTTOCK": (position, 0.0)}
    y, z = side.get(kind, (breadth, depth))
    return [(0.0, y, z), (0.5 * length, y, z), (length, y if kind == "BUTTOCK" else 0.0, z)]


# What turns by more than this at a curve of the network is a knuckle: rad.
_KNUCKLE = 0.05


def _knuckles(points, kept, numbers):
    """Of chosen numbers of points, those on curves of the network at which a section has a
    knuckle, by their places among the chosen ones."""
    found = []
    for k in kept:
        if 2 <= k < len(points) - 2:
            a, b = points[k] - points[k - 1], points[k + 1] - points[k]
            before, after = points[k - 1] - points[k - 2], points[k + 2] - points[k + 1]
            turn = _angle(a, b) - 0.5 * (_angle(before, a) + _angle(b, after))
            if turn > _KNUCKLE:
                found.append(int(np.searchsorted(numbers, k)))
    return found


def _angle(one, other):
    return float(np.arctan2(np.linalg.norm(np.cross(one, other)), one @ other))
