# SPDX-License-Identifier: GPL-3.0-or-later
"""What is known of each network, and how it follows its curves.

States are found by the collection's name; they hold nothing of Blender's and know what they were
computed from, so that undo cannot harm them. What an undo brings back counts as moved: where undo
restores the curve in edit mode alone, what is tied to it goes back with it.
"""

from dataclasses import dataclass, field

import bpy
import numpy as np

from ...bridge.blender import units
from ...bridge.objects import bezier_curves, networks
from . import joining, planes, ties
from .live_surface import LiveSurface
from .problems import Problem

# Of a curve's size: what is less than this out of its plane is there.
_SHIFTED = 1e-6

_states = {}


@dataclass(eq=False)
class KnownCurve:
    """points (n, 3) and handles (n, 2, 3) in the world, Blender's units, as Blender has them;
    matrix: the object's; address: by which it is known when it was renamed; key, native: see
    definitions; pieces: its shape in m. Arrays that stay are the very same objects from one state
    to the next."""

    points: np.ndarray
    weights: np.ndarray
    knuckles: tuple
    matrix: np.ndarray
    address: int
    key: tuple = ()
    native: object = None
    pieces: list = field(default_factory=list)
    handles: np.ndarray = None


@dataclass(eq=False)
class NetworkState:
    """curves: KnownCurve by name, all that are not refused; joined: the names of those that are
    numbered in `network`, a hull_native.CurveNetwork, None without curves; roles: of these, as
    CurveNetwork.roles has them. found: Problems of the network itself, which are among `problems`.
    read: BezierPoints by name, of objects that were not written since. revision: counts what is
    drawn."""

    curves: dict = field(default_factory=dict)
    joined: tuple = ()
    network: object = None
    problems: list = field(default_factory=list)
    found: list = field(default_factory=list)
    roles: list = field(default_factory=list)
    read: dict = field(default_factory=dict)
    tolerance: float = 0.0
    scale: float = 0.0
    surface: LiveSurface = field(default_factory=LiveSurface)
    revision: int = 0
    measured: object = None  # surface_tasks.Measured of the surface that was measured last

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


def follow(network, scene, changed=None):
    """Brings what is known of a network up to date; what is tied to moved points moves along.
    changed: names of the objects of which Blender told; None: all may have changed."""
    state = _states.setdefault(network.name_full, NetworkState())
    scale = units.metres_per_unit(scene)
    if scale != state.scale:
        state.scale, state.curves, changed = scale, {}, None
    refusals, objects, fresh = _read(network, state, changed)
    _take_renamed(state, objects)
    is_locked = bool(networks.locked(network)) if fresh else True
    if not is_locked:
        _carry_planes(state, objects, fresh)
    known = _known(
        state, objects, fresh, {} if is_locked else _moved(network, state, objects, fresh)
    )
    faults = joining.join(network, state, objects, known)
    state.problems = [*refusals, *faults, *state.found]
    if not is_locked:
        _write(state, objects, known)
    if len(state.curves) != len(known) or any(
        name not in state.curves or one.pieces is not state.curves[name].pieces
        for name, one in known.items()
    ):
        state.revision += 1
    state.curves = known
    state.surface.follow(network, state)
    return state


def _read(network, state, changed):
    """(Problems of objects that are refused, curve objects by name, names of those that were read
    anew)."""
    refusals, objects, fresh = [], {}, set()
    try:
        found = networks.curves_of(network)
    except ValueError as error:
        state.read = {}
        return [Problem(str(error), is_fatal=True)], {}, set()
    read, owners = {}, {}
    for obj in found:
        name, owner = obj.name, owners.setdefault(obj.data, obj)
        is_told = changed is None or name in changed or obj != owner
        if not is_told and name in state.curves:
            if name in state.read:
                objects[name], read[name] = obj, state.read[name]
                continue
        try:
            reason = bezier_curves.refusal(obj) or _shared(obj, owner)
            if reason:
                raise ValueError(reason)
            objects[name], read[name] = obj, bezier_curves.read(obj)
            fresh.add(name)
        except ValueError as error:
            refusals.append(Problem(str(error), (name,)))
    state.read = read
    return refusals, objects, fresh


def _shared(obj, owner):
    """Why an object that has the data of another one of the network, which would move along with
    each write to it, is refused; "" for any other."""
    if obj == owner:
        return ""
    return (
        f'"{obj.name}" has the same curve data as "{owner.name}": make it single-user (Object ▸ '
        "Relations), or delete it"
    )


def _take_renamed(state, objects):
    """What was tied to a curve is tied to it by its new name, too."""
    names = {one.address: name for name, one in state.curves.items() if name not in objects}
    for name in objects.keys() - state.curves.keys():
        before = names.get(objects[name].as_pointer())
        if before is not None:
            state.curves[name] = state.curves.pop(before)


def _matrix(obj):
    return np.array(obj.matrix_world, dtype=np.float64)


def _carry_planes(state, objects, fresh):
    """An object that was moved as a whole, out of its plane, takes the plane along."""
    for name in fresh:
        obj, before = objects[name], state.curves.get(name)
        plane = planes.plane_of(obj.hull.curve)
        if before is None or plane is None:
            continue
        now = state.read[name].points
        if len(now) != len(before.points) or np.array_equal(_matrix(obj), before.matrix):
            continue
        heights = now @ plane[0]
        shift = float(np.mean(heights) - plane[1])
        size = max(np.ptp(now, axis=0).max(), 1e-6)
        if np.ptp(heights) <= planes.FLAT * size and abs(shift) > _SHIFTED * size:
            obj.hull.curve.position += shift


def _moved(network, state, objects, fresh):
    """Points by name, of those that are to be others than Blender has, as it can keep them."""
    now = {name: state.read[name].points for name in objects}
    before = {name: one.points for name, one in state.curves.items() if name in now}
    for name in before.keys() - fresh:
        now[name] = before[name]
    own_planes = {name: planes.plane_of(obj.hull.curve) for name, obj in objects.items()}
    active = bpy.context.view_layer.objects.active if bpy.context.view_layer else None
    first = [name for name in sorted(fresh) if objects[name].mode == "EDIT"]
    first += [name for name in sorted(fresh) if objects[name] == active]
    first += sorted(fresh)
    settings = network.hull_network
    tied = ties.Tied(before if settings.tie else {}, now, own_planes, first, settings.tolerance)
    found = {}
    for name, points in tied.moved().items():
        is_off = np.abs(points - now[name]).max(axis=1) > bezier_curves.rounding(
            objects[name], points
        )
        if is_off.any():
            kept = np.where(is_off[:, None], points, now[name])
            found[name] = bezier_curves.rounded(objects[name], kept)
    return found


def _known(state, objects, fresh, moved):
    """KnownCurve by name, still without shapes; the same as before where nothing has changed."""
    known = {}
    for name, obj in objects.items():
        before, read = state.curves.get(name), state.read[name]
        if name not in fresh and name not in moved:
            known[name] = KnownCurve(
                before.points, before.weights, before.knuckles, before.matrix, before.address
            )
            continue
        points = moved.get(name, read.points)
        if before is not None and np.array_equal(before.points, points):
            points = before.points
        known[name] = KnownCurve(
            points, read.weights, read.knuckles, _matrix(obj), obj.as_pointer()
        )
    return known


def _write(state, objects, known):
    """Writes points and handles to the objects where they are others than Blender has."""
    for name, one in known.items():
        read = state.read[name]
        if one.handles is None or len(one.handles) != len(one.points):
            one.handles = read.handles
        is_moved = one.points is not read.points and not np.array_equal(one.points, read.points)
        if is_moved or np.abs(one.handles - read.handles).max() > 4.0 * bezier_curves.rounding(
            objects[name], one.points
        ):
            bezier_curves.write(objects[name], one.points, one.handles, one.knuckles)
            del state.read[name]
