# SPDX-License-Identifier: GPL-3.0-or-later
"""Where curves of a network meet: they are tied there, each by a point of its own in the one
place."""

from collections import defaultdict

import numpy as np

from ...bridge import native
from ...bridge.objects import bezier_curves
from . import choosing_points, curve_shapes, network_state, planes

_PARTS = 16  # of a span between points, along which a place is looked for


def tie(network, scene, reach, only=()):
    """Gives all curves of a network that come within `reach`, Blender's units, of one another a
    point in the same place there, between those at hand where they do not meet exactly; only:
    names of curves, of which one has to be there. Returns how many places there are.

    ValueError where curves are no curves.
    """
    state = network_state.up_to_date(network, scene)
    names, scale = state.joined, state.scale
    reach = max(reach * scale, state.tolerance)
    curves = [state.curves[name].native for name in names]
    found = native.require().network_meetings(curves, reach)
    visits, nodes = _visits(found, names, only, reach)
    places = _places(network, visits, nodes / scale)
    by_curve = defaultdict(list)
    for node, own in visits.items():
        for name in own if places[node] is not None else ():
            by_curve[name].append(places[node])
    for name, own in by_curve.items():
        _put_in(network.objects[name], state, np.array(own), reach / scale)
    network_state.follow(network, scene)
    return sum(place is not None for place in places.values())


def _visits(found, names, only, reach):
    """(names of the curves that meet at each node, the nodes (n, 3), m): meetings that are within
    the reach of one another are one node."""
    nodes, visits = [], {}
    for first, second, places in found:
        own = {names[first], names[second]}
        if len(own) < 2 or (only and not own & set(only)):
            continue
        place = np.asarray(places).mean(axis=0)
        near = [i for i, node in enumerate(nodes) if np.linalg.norm(node - place) <= reach]
        if near:
            visits[near[0]] |= own
        else:
            visits[len(nodes)] = own
            nodes.append(place)
    return visits, np.array(nodes).reshape(-1, 3)


def _places(network, visits, nodes):
    """By node: a place in the planes of all its curves, None where they have none in common."""
    found = {}
    for node, curves in visits.items():
        own = [planes.plane_of(network.objects[name].hull.curve) for name in curves]
        place = planes.onto(nodes[node][None], [one for one in own if one is not None])
        found[node] = None if place is None else place[0]
    return found


def _put_in(obj, state, places, reach):
    """Gives a curve object points at places (k, 3)."""
    known = state.curves[obj.name]
    lines = span_lines(known, state.scale)
    points, _, old = choosing_points.with_places(known.points, lines, places, reach)
    write_points(obj, points, [int(old[k]) for k in known.knuckles], old)


def span_lines(known, scale):
    """Polylines (k, 3), Blender's units, of a network_state.KnownCurve between its points."""
    ends = [0, *known.knuckles, len(known.points) - 1]
    if len(known.pieces) != len(ends) - 1:
        return [known.points[i : i + 2] for i in range(len(known.points) - 1)]
    lines, shares = [], np.arange(_PARTS + 1) / _PARTS
    for piece, first, last in zip(known.pieces, ends, ends[1:]):
        t = curve_shapes.parameters_at(piece, known.points[first : last + 1] * scale)
        for low, high in zip(t, t[1:]):
            lines.append(curve_shapes.evaluate(piece, low + shares * (high - low))[0] / scale)
    return lines


def write_points(obj, points, knuckles, old=None):
    """Gives a curve object other points; weights stay with the points that have the numbers
    `old`. In edit mode points are only moved, as Blender then keeps its own."""
    weights = np.ones(len(points), dtype=np.float32)
    before = bezier_curves.read(obj)
    if old is not None:
        weights[old] = before.weights
    if len(points) == len(before.points):
        handles = before.handles + (points - before.points)[:, None]
        bezier_curves.write(obj, points, handles, knuckles)
        return
    if obj.mode == "EDIT":
        raise ValueError(f'"{obj.name}" gets points: leave edit mode first (Tab)')
    bezier_curves.replace(obj, points, knuckles, weights)
