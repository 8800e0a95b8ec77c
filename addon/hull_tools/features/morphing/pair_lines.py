# SPDX-License-Identifier: GPL-3.0-or-later
"""The paired lines of a family on the hulls that they are of: of the layout and of the parent that
is chosen in the list, pair by pair in one colour, and the lines that are chosen to be paired.
Drawing computes nothing."""

from dataclasses import dataclass, field

import numpy as np

from ...bridge import native
from ..hull import hull_state
from . import parents

_SPACES = 60  # of a line
_CHOSEN = (1.0, 1.0, 1.0)


@dataclass(frozen=True, eq=False)
class PairLine:
    """A line of a pair on one hull, by the object's address, while its surface has this key:
    polylines of points (k, 3) in m; a half hull's are shown on both sides."""

    address: int
    geometry_key: tuple
    polylines: list
    is_mirrored: bool
    colour: tuple


@dataclass
class PairLines:
    """Of one hull of a family. lines: PairLine, two for each pair, then those that are chosen."""

    lines: list = field(default_factory=list)
    key: tuple = None
    graphs: dict = field(default_factory=dict)  # polylines of features by the key of a surface


def follow(obj, scene):
    """Brings what is shown of a hull's pairs up to date with its lists and the hulls paired."""
    state = hull_state.state_of(obj)
    if state is None:
        return
    shown = state.of(PairLines)
    entry = _entry(obj)
    if entry is None:
        shown.lines, shown.key, shown.graphs = [], None, {}
        return
    hulls = [obj.hull.morph.layout_source, entry.source]
    states = [hull_state.state_of(hull) or hull_state.refresh(hull, scene) for hull in hulls]
    pairs = tuple((pair.first, pair.second, tuple(pair.colour)) for pair in entry.pairs)
    chosen = tuple(_chosen_numbers(obj.hull.morph, entry))
    geometry = [one.ship.geometry_key for one in states]
    key = (*(hull.as_pointer() for hull in hulls), *geometry, pairs, chosen)
    if shown.key == key or None in geometry:
        return
    known = {one.ship.geometry_key: _curves(shown, one) for one in states}
    shown.graphs, shown.key = known, key
    shown.lines = [
        PairLine(hull.as_pointer(), own, known[own][number], hull.hull.half, colour)
        for first, second, colour in (*pairs, (*chosen, _CHOSEN))
        for hull, own, number in zip(hulls, geometry, (first, second))
        if number is not None and number < len(known[own])
    ]


def _chosen_numbers(morph, entry):
    """Of the lines of the layout and of a parent that are chosen to be paired; None where none
    is."""
    for features, name in ((morph.features, morph.feature), (entry.features, entry.feature)):
        found = features.get(name) if name else None
        yield None if found is None else found.number


def _entry(obj):
    """The chosen parent, whose pairs are shown; None where none are."""
    morph = obj.hull.morph
    if not morph.show_pairs or not 0 <= morph.active_parent < len(morph.parents):
        return None
    entry = morph.parents[morph.active_parent]
    is_there = parents.is_there(entry.source) and parents.is_there(morph.layout_source)
    return entry if is_there and len(entry.features) else None


def _curves(shown, state):
    """[polylines] of all features of a hull's surface, by their numbers."""
    known = shown.graphs.get(state.ship.geometry_key)
    if known is not None:
        return known
    graph = native.require().feature_graph(state.ship.surface)
    share = np.linspace(0.0, 1.0, _SPACES + 1)
    return [[one.curve.points_at(share * one.curve.length)] for one in graph.features]
