# SPDX-License-Identifier: GPL-3.0-or-later
"""Inflections and extrema of curvature of the lines through a part of a surface, counted."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...bridge import native

# Planes through the part along each axis; samples of the lines, of the hull's size.
_PLANES = 12
_STEP = 1.0 / 1000.0
# The part, on each side wider than it is: what is moved changes its neighbours' bend.
_WIDER = 0.05


@dataclass(frozen=True)
class Marks:
    """How many there are on stations, waterlines and buttocks."""

    inflections: int
    extrema: int

    def is_more_than(self, other):
        return self.inflections > other.inflections or self.extrema > other.extrema


class Around:
    """Marks of a hull_native.LimitSurface around points (k, 3); size: the hull's, m. Those of now
    are counted once, however many moves are tried."""

    def __init__(self, surface, points, size):
        self._surface, self._box, self._size = surface, _box_around(points), size

    @cached_property
    def now(self):
        return self.of(self._surface)

    def moved(self, moves):
        """The Marks with moves (n, 3), m, of the control points."""
        if not moves.any():
            return self.now
        mesh = self._surface.mesh
        moved = native.require().LimitSurface(
            mesh.with_points(mesh.points + moves), self._surface.scheme
        )
        return self.of(moved)

    def of(self, surface):
        """The Marks of a changed surface within the same box."""
        return _count(surface, self._box, self._size)


def _box_around(points):
    """(low (3,), high (3,)): the box around points (k, 3), a little wider."""
    low, high = points.min(axis=0), points.max(axis=0)
    margin = _WIDER * float((high - low).max())
    return low - margin, high + margin


def _count(surface, box, size):
    """The Marks within a box (low (3,), high (3,)) of a hull_native.LimitSurface; size: its, m."""
    hull_native = native.require()
    low, high = box
    inflections = extrema = 0
    for axis, name in enumerate("xyz"):
        shares = (np.arange(_PLANES) + 0.5) / _PLANES
        planes = [
            hull_native.plane_across(name, at)
            for at in low[axis] + shares * (high[axis] - low[axis])
        ]
        for curves in hull_native.section_fairness(surface, planes, step=_STEP * size):
            for curve in curves:
                marks = curve.marks
                if not len(marks):
                    continue
                inside = ((marks.points >= low) & (marks.points <= high)).all(axis=1)
                is_inflection = np.array(marks.kinds) == "inflection"
                inflections += int(np.count_nonzero(inside & is_inflection))
                extrema += int(np.count_nonzero(inside & ~is_inflection))
    return Marks(inflections, extrema)
