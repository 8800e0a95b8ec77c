# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of a hull as a network: its sections, creases and borders, by few points, with one at
each place where they meet."""

from collections import defaultdict
from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.background import jobs
from ...bridge.blender import units
from ...bridge.objects import bezier_curves
from ..hull import hull_state
from ..lines.line_places import line_places
from . import choosing_points, curve_shapes, making, network_state, planes

# Of the hull's size: how exactly sections are cut, and joined; how near curves are to them.
_CUT, _JOIN, _CHOOSE = 1e-5, 3e-5, 5e-5
_TURN = 0.02  # rad: how far they are turned where others meet them
_SHARE_CUT = 0.3  # of the work


@dataclass(frozen=True)
class _Line:
    name: str
    kind: str
    role: str
    plane: tuple  # of planes.found_in
    points: np.ndarray
    knuckles: tuple


class Taking(jobs.JobTask):
    """Takes a hull's lines, where its settings have them, in a thread; `write` makes the network.
    positions: (stations, waterlines, buttocks) in m in place of those; text: what is done."""

    text = "Network from hull"

    def __init__(self, hull, scene, positions=None):
        state = hull_state.up_to_date(hull, scene)
        self._name, self._scale = hull.name, units.metres_per_unit(scene)
        points = np.asarray(state.ship.surface.mesh.points)
        own = positions or line_places(hull.hull, self._scale).positions(points)
        if not any(len(one) for one in own):
            raise ValueError("There are no stations, waterlines or buttocks: give some (panel "
                             "Sections)")  # fmt: skip
        self._place = np.array(hull.matrix_world.translation, dtype=np.float64)
        source = state.ship.source
        self._job = jobs.Job(lambda progress: _taken(source.new_surface(), own, progress))

    def write(self, scene):
        """Makes the network of the lines; returns it."""
        lines = self.result()
        if not lines:
            raise ValueError(f'No line is on "{self._name}": give positions that meet it')
        network = making.new(scene, f"{self._name} network")
        for line in lines:
            points = line.points / self._scale + self._place
            obj = bezier_curves.made(line.name, points, line.knuckles, network)
            plane, normal, position = line.plane
            if plane != "NONE":
                along, _ = planes.carrier(*line.plane)
                position = position / self._scale + float(along @ self._place)
                planes.give(obj.hull.curve, line.kind, plane, normal, position)
            else:
                obj.hull.curve.kind = line.kind
            obj.hull.curve.role = line.role
        _set_sizes(network, lines, self._scale)
        network_state.follow(network, scene)
        return network


def _set_sizes(network, lines, scale):
    every = np.concatenate([line.points for line in lines]) / scale
    settings = network.hull_network
    settings.tolerance = max(1e-5 * float(np.ptp(every, axis=0).max()), 1e-5)
    settings.length = float(every[:, 0].max())
    settings.half_breadth = max(float(every[:, 1].max()), 1e-3)
    settings.depth = max(float(every[:, 2].max()), 1e-3)


def _taken(surface, positions, progress):
    """_Lines of a LimitSurface; in the thread."""
    hull_native = native.require()
    size = surface.mesh.size
    stations, waterlines, buttocks = positions
    curves = hull_native.network_curves(
        surface, stations=stations, waterlines=waterlines, buttocks=buttocks, tolerance=_CUT * size
    )
    progress(0.5 * _SHARE_CUT)
    network = hull_native.CurveNetwork(curves, _JOIN * size)
    progress(_SHARE_CUT)
    meeting = _meetings(network)
    lines, nodes = [], np.asarray(network.nodes)
    found = [_plane_of(curve, size) for curve in curves]
    places = {node: _common(nodes[node], [found[c] for c in cs]) for node, cs in meeting.items()}
    for number, curve in enumerate(curves):
        own = [places[node] for node, cs in meeting.items() if number in cs]
        lines.append(_line(curve, found[number], own, network.pieces(number), size))
        progress(_SHARE_CUT + (1.0 - _SHARE_CUT) * (number + 1) / len(curves))
    return [line for line in lines if line is not None]


def _meetings(network):
    """Numbers of the curves at each node at which two meet."""
    found = defaultdict(set)
    for (start, end), curve in zip(network.edges, network.edge_curves):
        found[int(start)].add(int(curve))
        found[int(end)].add(int(curve))
    return {node: curves for node, curves in found.items() if len(curves) > 1}


def _plane_of(curve, size):
    points = np.asarray(curve.points)
    plane, normal, position = planes.found_in(points)
    if curve.kind in ("station", "waterline", "buttock"):
        return plane, normal, position
    # Creases and borders that happen to be in a plane are kept in the centre plane alone.
    in_centre = plane == "Y" and abs(position) <= native.require().tolerances.ON_CENTRE_PLANE * size
    return (plane, normal, 0.0) if in_centre else ("NONE", None, 0.0)


def _common(place, found):
    own = [planes.carrier(*one) for one in found if one[0] != "NONE"]
    moved = planes.onto(place[None], own)
    return place if moved is None else moved[0]


def _line(curve, plane, places, pieces, size):
    dense, knuckles = [], []
    for piece in pieces:
        part = curve_shapes.evaluate(piece, curve_shapes.parameters_of(piece, 4))[0]
        if dense:
            knuckles.append(sum(map(len, dense)) - 1)
            part = part[1:]
        dense.append(part)
    if not dense:
        return None
    dense = np.concatenate(dense)
    spans = [dense[i : i + 2] for i in range(len(dense) - 1)]
    points, numbers, old = choosing_points.with_places(dense, spans, places, 2.0 * _JOIN * size)
    knuckles = [int(old[k]) for k in knuckles]
    chosen = choosing_points.chosen(points, list(numbers.values()), knuckles, _CHOOSE * size, _TURN)
    chosen = _spaced(points, chosen, {*numbers.values(), *knuckles, 0, len(points) - 1}, size)
    kind, role = _kind_and_role(curve, plane, points)
    own = tuple(int(np.searchsorted(chosen, k)) for k in knuckles)
    return _Line(_name(curve, kind, role), kind, role, plane, points[chosen], own)


def _spaced(points, chosen, needed, size):
    """Without those that are hardly apart from the one before, where neither is needed."""
    kept = [chosen[0]]
    for number in chosen[1:]:
        step = np.linalg.norm(points[number] - points[kept[-1]])
        if step > 10.0 * _JOIN * size or number in needed:
            if step <= 10.0 * _JOIN * size and kept[-1] not in needed:
                kept.pop()
            kept.append(number)
    return np.array(kept)


def _name(curve, kind, role):
    """Blender numbers what has the same name."""
    if role == "KNUCKLE":
        return "Knuckle"
    own = {"PROFILE": "Profile", "DECK_EDGE": "Deck edge", "FREE": "Border"}
    return own.get(kind) or curve.name.capitalize()


def _kind_and_role(curve, plane, points):
    if curve.kind in ("station", "waterline", "buttock"):
        return curve.kind.upper(), "FOUND"
    if plane[0] == "Y":
        return "PROFILE", "FOUND"
    if curve.kind == "knuckle":
        return "FREE", "KNUCKLE"
    along, across = np.ptp(points[:, 0]), np.ptp(points[:, 1:], axis=0).max()
    return ("DECK_EDGE" if along > across else "FREE"), "FOUND"
