# SPDX-License-Identifier: GPL-3.0-or-later
"""Networks of curves as arrays for the graphics card, kept until the network changes."""

import weakref
from dataclasses import dataclass, field

import numpy as np

from ..features.networks import combs, curve_shapes
from . import line_arrays

# Kinds of curves by the kinds of lines whose colours they have.
_INKS = {
    "STATION": "station",
    "WATERLINE": "waterline",
    "BUTTOCK": "buttock",
    "DIAGONAL": "diagonal",
    "FREE": "plane",
    "PROFILE": "feature",
    "DECK_EDGE": "feature",
}
_PARTS = 8  # of a span between knots


@dataclass(eq=False)
class NetworkArrays:
    """lines, teeth, outlines: line_arrays.Strokes by the ink's name; nodes (n, 3); problems (k, 3);
    in the world, Blender's units. centre (3,), size: of all of it. comb_scale: m², it stays while
    the same curves have combs. batches: of the graphics card, by what they are of."""

    key: tuple
    lines: dict
    teeth: dict
    outlines: dict
    nodes: np.ndarray
    problems: np.ndarray
    centre: np.ndarray
    size: float
    comb_scale: float = 0.0
    batches: dict = field(default_factory=dict)


_known = weakref.WeakKeyDictionary()  # by NetworkState


def of_network(network, state):
    """The NetworkArrays of a network; those of before while nothing has changed."""
    settings = network.hull_network
    inks = {name: _ink(network.objects.get(name)) for name in state.curves}
    with_comb = tuple(name for name in state.curves if _has_comb(network.objects.get(name)))
    # Of a curve in edit mode Blender shows points and handles, which nothing is to hide.
    edited = tuple(one.name for one in network.objects if one.mode == "EDIT")
    key = (state.revision, tuple(inks.items()), with_comb, edited, settings.comb_factor)
    known = _known.get(state)
    if known is None or known.key != key:
        scale = known.comb_scale if known is not None and known.key[2] == with_comb else 0.0
        known = _made(state, inks, with_comb, edited, settings.comb_factor, scale)
        known.key = key
        _known[state] = known
    return known


def forget_all():
    _known.clear()


def _ink(obj):
    if obj is None or obj.hull.curve.role == "KNUCKLE":
        return "feature"
    return _INKS[obj.hull.curve.kind]


def _has_comb(obj):
    return obj is not None and obj.hull.curve.show_comb


def _made(state, inks, with_comb, edited, factor, comb_scale):
    lines, every = {}, [np.zeros((1, 3))] if not state.curves else []
    for name, known in state.curves.items():
        line = known.points
        if known.pieces:
            line = curve_shapes.samples(known.pieces, _PARTS) / state.scale
        if name not in edited:
            lines.setdefault(inks[name], []).append(line)
        every.append(line)
    every = np.concatenate(every)
    size = max(float(np.ptp(every, axis=0).max()), 1e-6)
    found = NetworkArrays(
        (),
        {ink: line_arrays.strokes_of(own) for ink, own in lines.items()},
        {},
        {},
        _nodes(state, edited),
        _problems(state),
        every.mean(axis=0),
        size,
    )
    curves = [state.curves[name].pieces for name in with_comb]
    found.comb_scale = comb_scale or combs.handy_scale(curves, size * state.scale)
    _add_combs(found, state, inks, with_comb, found.comb_scale * factor)
    return found


def _add_combs(found, state, inks, with_comb, scale):
    by_ink = {}
    for name in with_comb:
        by_ink.setdefault(inks[name], []).append(combs.comb(state.curves[name].pieces, scale))
    for ink, own in by_ink.items():
        firsts = np.cumsum([0, *(len(points) for points, _, _ in own[:-1])])
        points, tips = (np.concatenate([one[i] for one in own]) / state.scale for i in (0, 1))
        pairs = np.concatenate([one[2] + first for one, first in zip(own, firsts)])
        found.teeth[ink], found.outlines[ink] = line_arrays.comb_strokes(points, tips, pairs)


def _nodes(state, edited):
    if state.network is None or not state.is_joined:
        return np.empty((0, 3))
    nodes = np.asarray(state.network.nodes).reshape(-1, 3) / state.scale
    reach = state.tolerance / state.scale
    for points in (state.curves[name].points for name in edited if name in state.curves):
        apart = np.linalg.norm(nodes[:, None] - points, axis=2).min(axis=1)
        nodes = nodes[apart > reach]
    return nodes


def _problems(state):
    places = [np.empty((0, 3))]
    places += [one.places for one in state.problems if not one.is_note and len(one.places)]
    return np.concatenate(places)
