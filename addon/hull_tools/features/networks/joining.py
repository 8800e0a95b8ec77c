# SPDX-License-Identifier: GPL-3.0-or-later
"""The curves of a NetworkState joined to a hull_native.CurveNetwork, and the shapes that they have
in it."""

import numpy as np

from ...bridge import native
from . import curve_shapes, definitions
from .problems import Problem

# What keeps curves from being joined at all: the surface of before stays until it is mended.
_FATAL = ("shape", "off_plane")
_SLAVES = ("SLAVE_TANGENT", "SLAVE_CURVATURE")


def join(network, state, objects, known):
    """Gives KnownCurves by name their definitions and shapes, and the state its network; returns
    Problems of curves that have no definition."""
    joined = [name for name, obj in objects.items() if obj.hull.curve.role != "REFERENCE"]
    joined, faults = _define(state, objects, known, joined)
    tolerance = network.hull_network.tolerance * state.scale
    curves = [known[name].native for name in joined]
    is_same = state.joined == tuple(joined) and state.tolerance == tolerance
    is_new = not is_same or any(
        name not in state.curves or known[name].native is not state.curves[name].native
        for name in joined
    )
    if is_new:
        state.network, found = _joined(curves, tolerance, state.network if is_same else None)
        state.joined, state.tolerance = tuple(joined), tolerance
        state.found = [_problem(state, one, joined) for one in found]
        state.roles = [] if state.network is None else state.network.roles
        state.revision += 1
    _shape(state, known, joined, is_new)
    return faults


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
    places = np.asarray(found.places).reshape(-1, 3) / state.scale
    return Problem(found.what, names, places, found.is_note, found.kind in _FATAL)


def _define(state, objects, known, joined):
    """(names of curves that have a definition and are joined, Problems of the others)."""
    faults, names = {}, list(joined)
    while True:
        order = {name: number for number, name in enumerate(names)}
        for name, obj in objects.items():
            if name in faults:
                continue
            one, before = known[name], state.curves.get(name)
            key = definitions.key_of(obj, one, state.scale, order)
            if before is not None and before.native is not None and before.key == key:
                one.key, one.native = key, before.native
                continue
            try:
                one.key = key
                one.native = definitions.network_curve(obj, one, state.scale, order)
            except ValueError as error:
                faults[name] = Problem(str(error), (name,))
        left = [name for name in names if name not in faults]
        if left == names:
            return left, list(faults.values())
        names = left


def _shape(state, known, joined, is_new):
    """Gives known curves their pieces: those that are as they were keep the very same list."""
    numbers = {name: number for number, name in enumerate(joined)}
    for name, one in known.items():
        before = state.curves.get(name)
        is_kept = before is not None and before.native is one.native
        if is_kept and not (is_new and name in numbers and _is_slave(one)):
            one.pieces, one.handles = before.pieces, before.handles
            continue
        pieces = _pieces(state.network, numbers.get(name), one.native)
        if is_kept and _are_same(pieces, before.pieces):
            one.pieces, one.handles = before.pieces, before.handles
            continue
        one.pieces = pieces
        if pieces:
            metres = one.points * state.scale
            one.handles = curve_shapes.handles(pieces, metres, one.knuckles) / state.scale


def _is_slave(one):
    return any(kind in _SLAVES for kind, *_ in one.key[-2:])


def _pieces(network, number, curve):
    """A curve's pieces in a network, or else by itself; none where it has no shape."""
    if curve is None:
        return []
    if network is not None and number is not None:
        try:
            return network.pieces(number)
        except ValueError:  # some other curve keeps all from being made
            pass
    try:
        return native.require().CurveNetwork([curve], 1.0).pieces(0)
    except ValueError:
        return []


def _are_same(pieces, others):
    return len(pieces) == len(others) and all(
        all(np.array_equal(a, b) for a, b in zip(one, other)) for one, other in zip(pieces, others)
    )
