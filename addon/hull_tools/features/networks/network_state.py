# SPDX-License-Identifier: GPL-3.0-or-later
"""What is known of each network, and how it follows its curves.

States are found by the collection's name; they hold nothing of Blender's and know what they were
computed from, so that undo cannot harm them. What an undo brings back counts as moved: where undo
restores the curve in edit mode alone, what is tied to it goes back with it.
"""

from dataclasses import dataclass, field

import bpy
import numpy as np

from ...bridge import native
from ...bridge.blender import units
from ...bridge.objects import bezier_curves, networks
from . import curve_shapes, definitions, planes, ties
from .live_surface import LiveSurface
from .problems import Problem

_states = {}
# What keeps curves from being joined at all: the surface of before stays until it is mended.
_FATAL = ("shape", "off_plane")


@dataclass(eq=False)
class KnownCurve:
    """points (n, 3) and handles (n, 2, 3) in the world, Blender's units, as Blender has them;
    matrix: the object's; key, native: see definitions; pieces: its shape in m."""

    points: np.ndarray
    knuckles: tuple
    matrix: np.ndarray
    selected: np.ndarray
    key: tuple = ()
    native: object = None
    pieces: list = field(default_factory=list)
    handles: np.ndarray = None


@dataclass(eq=False)
class NetworkState:
    """curves: KnownCurve by name, all that are not refused; joined: the names of those that are
    numbered in `network`, a hull_native.CurveNetwork, None without curves; roles: of these, as
    CurveNetwork.roles has them. found: Problems of the network itself, which are among `problems`.
    revision: counts what is drawn."""

    curves: dict = field(default_factory=dict)
    joined: tuple = ()
    network: object = None
    problems: list = field(default_factory=list)
    tolerance: float = 0.0
    scale: float = 1.0
    surface: LiveSurface = field(default_factory=LiveSurface)
    revision: int = 0
    roles: list = field(default_factory=list)
    found: list = field(default_factory=list)

    @property
    def is_joined(self):
        """Whether the network is of the curves as they are."""
        return self.network is not None and not any(one.is_fatal for one in self.problems)


def state_of(network):
    """The NetworkState of a network; None when nothing was computed yet."""
    return None if network is None else _states.get(network.name_full)


def known_networks():
    """Pairs (network, NetworkState)."""
    for network in networks.all_networks():
        if network.name_full in _states:
            yield network, _states[network.name_full]


def up_to_date(network, scene):
    """The NetworkState of a network as it is now; ValueError where its curves are not joined."""
    state = follow(network, scene)
    if not state.is_joined:
        faults = [one.text for one in state.problems if one.is_fatal]
        raise ValueError(faults[0] if faults else f'"{network.name}" has no curves: add some')
    return state


def forget_all():
    _states.clear()


def forget_deleted():
    for name in _states.keys() - {one.name_full for one in networks.all_networks()}:
        del _states[name]


def follow(network, scene):
    """Brings what is known of a network up to date; what is tied to moved points moves along."""
    state = _states.setdefault(network.name_full, NetworkState())
    state.scale = units.metres_per_unit(scene)
    refusals, objects, read = _read(network)
    _carry_planes(state, objects, read)
    points = _with_ties(network, state, objects, read)
    known = {
        name: KnownCurve(
            points[name], read[name].knuckles, _matrix(objects[name]), read[name].selected
        )
        for name in objects
    }
    _join(network, state, objects, read, known, refusals)
    _write(network, state, objects, read, known)
    if state.curves.keys() != known.keys() or any(
        one.pieces is not state.curves[name].pieces for name, one in known.items()
    ):
        state.revision += 1
    state.curves = known
    state.surface.follow(network, state)
    return state


def _read(network):
    """(Problems of objects that are refused, curve objects by name, their BezierPoints by name)."""
    refusals, objects, read = [], {}, {}
    try:
        found = networks.curves_of(network)
    except ValueError as error:
        return [Problem(str(error), is_fatal=True)], {}, {}
    for obj in found:
        try:
            reason = bezier_curves.refusal(obj)
            if reason:
                raise ValueError(reason)
            read[obj.name] = bezier_curves.read(obj)
            objects[obj.name] = obj
        except ValueError as error:
            refusals.append(Problem(str(error), (obj.name,)))
    return refusals, objects, read


def _matrix(obj):
    return np.array(obj.matrix_world, dtype=np.float64)


def _carry_planes(state, objects, read):
    """An object that was moved as a whole, out of its plane, takes the plane along."""
    for name, obj in objects.items():
        before, plane = state.curves.get(name), planes.plane_of(obj.hull.curve)
        if before is None or plane is None or networks.locked(networks.network_of(obj)):
            continue
        now = read[name].points
        if len(now) != len(before.points) or np.array_equal(_matrix(obj), before.matrix):
            continue
        heights = now @ plane[0]
        shift = float(np.mean(heights) - plane[1])
        size = max(np.ptp(now, axis=0).max(), 1e-6)
        if np.ptp(heights) <= 1e-5 * size and abs(shift) > 1e-6 * size:
            obj.hull.curve.position += shift


def _with_ties(network, state, objects, read):
    """Points by name, as Blender can keep them."""
    now = {name: one.points for name, one in read.items()}
    if networks.locked(network):
        return now
    is_tied = network.hull_network.tie
    before = {name: one.points for name, one in state.curves.items()} if is_tied else {}
    own_planes = {name: planes.plane_of(obj.hull.curve) for name, obj in objects.items()}
    active = bpy.context.view_layer.objects.active if bpy.context.view_layer else None
    first = [name for name, obj in objects.items() if obj.mode == "EDIT"]
    first += [name for name, obj in objects.items() if obj == active]
    tied = ties.Tied(before, now, own_planes, first, network.hull_network.tolerance)
    found = tied.moved()
    for name, points in found.items():
        if points is not now[name]:
            moved = np.abs(points - now[name]).max(axis=1) > _rounding(points)
            kept = np.where(moved[:, None], points, now[name])
            found[name] = bezier_curves.rounded(objects[name], kept)
    return found


def _rounding(points):
    """What Blender's single precision leaves of coordinates, twice over."""
    return 2.0 * float(np.spacing(np.float32(max(np.abs(points).max(), 1e-6))))


def _join(network, state, objects, read, known, refusals):
    joined = [name for name, obj in objects.items() if obj.hull.curve.role != "REFERENCE"]
    joined, faults = _define(state, objects, read, known, joined)
    problems = [*refusals, *faults]
    tolerance = network.hull_network.tolerance * state.scale
    curves = [known[name].native for name in joined]
    is_same = state.joined == tuple(joined) and state.tolerance == tolerance
    before = state.network if is_same else None
    is_new = before is None or any(
        known[name].native is not state.curves[name].native for name in joined
    )
    if is_new:
        state.network, found = _joined(curves, tolerance, before)
        state.joined, state.tolerance = tuple(joined), tolerance
        state.found = [_problem(state, one, joined) for one in found]
        state.roles = [] if state.network is None else state.network.roles
        state.revision += 1
    state.problems = problems + state.found
    _shape(state, known, joined, is_new)


def _joined(curves, tolerance, before):
    """(hull_native.CurveNetwork or None, its problems)."""
    if not curves:
        return None, []
    if before is not None:
        made = before.with_curves(curves)
    else:
        made = native.require().CurveNetwork(curves, tolerance)
    return made, made.problems


def _problem(state, found, joined):
    names = tuple(joined[number] for number in found.curves)
    places = np.asarray(found.places) / state.scale
    return Problem(found.what, names, places, found.is_note, found.kind in _FATAL)


def _define(state, objects, read, known, joined):
    """Gives known curves their definitions; (names of those that have one and are joined, Problems
    of the others)."""
    faults, names = {}, list(joined)
    while True:
        order = {name: number for number, name in enumerate(names)}
        for name, obj in objects.items():
            if name in faults:
                continue
            points = _Moved(known[name].points, read[name])
            key = definitions.key_of(obj, points, state.scale, order)
            before = state.curves.get(name)
            if before is not None and before.key == key:
                known[name].key, known[name].native = key, before.native
                continue
            try:
                made = definitions.network_curve(obj, points, state.scale, order)
                known[name].key, known[name].native = key, made
            except ValueError as error:
                faults[name] = Problem(str(error), (name,))
        left = [name for name in names if name not in faults]
        if left == names:
            return left, list(faults.values())
        names = left


class _Moved:
    """What was read of a curve, with other points."""

    def __init__(self, points, read):
        self.points, self.weights, self.knuckles = points, read.weights, read.knuckles


def _shape(state, known, joined, is_new):
    """Gives known curves their pieces: those that are as they were keep the very same list."""
    numbers = {name: number for number, name in enumerate(joined)}
    for name, one in known.items():
        before = state.curves.get(name)
        is_kept = before is not None and before.native is one.native
        if is_kept and (not is_new or name not in numbers):
            one.pieces, one.handles = before.pieces, before.handles
            continue
        pieces = _pieces(state.network, numbers.get(name), one.native)
        if before is not None and _are_same(pieces, before.pieces):
            one.pieces, one.handles = before.pieces, before.handles
            continue
        one.pieces = pieces
        if pieces:
            metres = one.points * state.scale
            knuckles = one.knuckles
            one.handles = curve_shapes.handles(pieces, metres, knuckles) / state.scale


def _pieces(network, number, curve):
    """A curve's pieces in a network, or else by itself; none where it has no shape."""
    if curve is None:
        return []
    try:
        if network is None or number is None:
            return _alone(curve)
        return network.pieces(number)
    except ValueError:  # some other curve keeps all from being made
        return _alone(curve)


def _alone(curve):
    try:
        return native.require().CurveNetwork([curve], 1.0).pieces(0)
    except ValueError:
        return []


def _are_same(pieces, others):
    return len(pieces) == len(others) and all(
        all(np.array_equal(a, b) for a, b in zip(one, other)) for one, other in zip(pieces, others)
    )


def _write(network, state, objects, read, known):
    """Writes points and handles to the objects where they are others than Blender has."""
    is_locked = bool(networks.locked(network))
    for name, one in known.items():
        if one.handles is None or len(one.handles) != len(one.points):
            one.handles = read[name].handles
        if is_locked:
            continue
        rounding = 8.0 * _rounding(one.points)
        is_moved = np.abs(one.points - read[name].points).max() > 0.0
        if is_moved or np.abs(one.handles - read[name].handles).max() > rounding:
            bezier_curves.write(objects[name], one.points, one.handles, one.knuckles)
