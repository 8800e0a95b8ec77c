# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams and butts of the plates laid out last, as lines on the hull as it is now.

They keep their places in the surface's parameters, so that they follow while points move, at some
microseconds a point; seams by rules are made anew when plates are laid out again. Where faces come
or go nothing is shown of them.
"""

from dataclasses import dataclass, field

import numpy as np

from ...bridge import native
from ..hull import hull_state
from .plate_files import KeptPlates, plain_name


@dataclass(frozen=True, eq=False)
class SeamGroup:
    """polylines: (k, 3) each, m. is_mirrored: whether their mirror images belong to it, too.
    names: of plates; places, normals (n, 3): a point of each on the surface, m, and which way it
    faces. is_current: whether the plates are of the hull as it is."""

    polylines: list
    names: list
    places: np.ndarray
    normals: np.ndarray
    is_current: bool
    is_mirrored: bool = True


@dataclass
class Followed:
    """Of one hull: what the SeamGroup is of, and it or None."""

    key: object = None
    group: SeamGroup = None
    _points: dict = field(default_factory=dict)

    def follow(self, layout, ship):
        """The SeamGroup of a plate_files.Layout on the surface of a LiveShip, None where it has
        other faces."""
        key = id(layout), ship.geometry_key
        if key != self.key:
            self.key, self.group = key, None
            if ship.geometry_key[0] == layout.key[0][0]:
                self.group = self._made(layout, ship)
        return self.group

    def _made(self, layout, ship):
        if id(layout) not in self._points:
            self._points = {id(layout): (layout, _Places(layout))}
        places = self._points[id(layout)][1]
        is_current = ship.geometry_key == layout.key[0]
        return places.on(ship.surface, is_current)


class _Places:
    """Where points of seams and the middles of plates are in the surface's parameters."""

    def __init__(self, layout):
        cells, uv, ends = [], [], []
        for curve in layout.seams:
            own = curve.cells
            cells += [own, own[-1:]]
            uv += [curve.starts, curve.ends[-1:]]
            ends.append(len(own) + 1)
        self._cells, self._uv = np.concatenate(cells), np.concatenate(uv)
        self._cuts = np.cumsum(ends)[:-1]
        self._names = [plain_name(one) for one in layout.listed]
        middles = np.array([one.plate.centre for one in layout.listed])
        found = native.require().SurfaceTree(layout.surface).closest_points(middles)
        self._middles = found.cells, found.uv

    def on(self, surface, is_current):
        (points,) = surface.evaluate(self._cells, self._uv)
        (middles,) = surface.evaluate(*self._middles)
        return SeamGroup(
            np.split(points, self._cuts),
            self._names,
            middles,
            surface.normals(*self._middles),
            is_current,
        )


def shown(obj):
    """The SeamGroup of a hull that is to be shown, None without one."""
    state = hull_state.state_of(obj)
    if not obj.hull.plates.show_seams or state is None or state.ship.surface is None:
        return None
    layout = state.of(KeptPlates).layout
    if layout is None or not layout.seams:
        return None
    return state.of(Followed).follow(layout, state.ship)
