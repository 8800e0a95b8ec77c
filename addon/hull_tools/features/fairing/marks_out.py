# SPDX-License-Identifier: GPL-3.0-or-later
"""The deviation by which marks go that an eye sees: discrepancy told by the marks themselves.

An energy does not know what the design has on purpose, and how deep a dent is is not known either.
But a dent is seen while the surface is too far from what was meant, to either side. So deviations
are tried, the marks around the points are counted for each, and of the interval with the fewest the
middle is taken, which is as far from being too little as from too much.
"""

from dataclasses import dataclass

import numpy as np

from ....hull_fairness import lines as judging
from ...bridge import native

# The smallest deviation is so many times √2 below the largest.
_STEPS = 8
# Halvings of either end of the interval: to a tenth of it.
_HALVINGS = 2
# Times the marks of the start: more moves are not tried then.
_TOO_MANY = 2.0
_RINGS = 2
# Of the beam: how much wider the box is than the points around.
_WIDER = 0.01
_MOST_COUNTS = _STEPS + 2 + 2 * _HALVINGS


@dataclass(frozen=True, eq=False)
class Seen:
    """Counts marks of a surface within a box. wanted: as hull_fairness.lines has it."""

    surface: object
    beam: float
    wanted: tuple
    box: tuple

    def count(self, moves):
        """How many unwanted marks there are when control points have moved by (n, 3), m."""
        mesh = self.surface.mesh
        moved = native.require().LimitSurface(
            mesh.with_points(mesh.points + moves), self.surface.scheme
        )
        found = judging.judged(moved, self.beam, self.wanted, within=self.box)
        return sum(len(line.unwanted) for line in found)


def around(control, points, beam):
    """(low (3,), high (3,)) of a box around all that moves with control points (k,) of a
    mesh_arrays.ControlArrays, and what is beside it."""
    faces = np.split(control.face_vertices, np.cumsum(control.face_sizes)[:-1])
    own = np.asarray(points)
    for _ in range(_RINGS + 1):
        own = np.unique(np.concatenate([own, *(f for f in faces if np.isin(f, own).any())]))
    places = control.points[own]
    return places.min(axis=0) - _WIDER * beam, places.max(axis=0) + _WIDER * beam


def best(solution, count, most, tell):
    """What solution(deviation) gives for the middle of the deviations, m, not above `most`, with
    the fewest marks: a hull_native.Faired. count(moves) counts them; tell(share) is told how much
    is done. Ends of the interval are met to a few per cent.

    ValueError where there are no fewer than now.
    """
    search = _Search(solution, count, tell)
    tried = [(0.0, search.start)]
    for deviation in most * np.sqrt(2.0) ** np.arange(-_STEPS, 1):
        number, rms, is_bound = search.count(deviation)
        tried.append((rms, number))
        fewest = min(number for _, number in tried)
        if number > _TOO_MANY * search.start or not is_bound:
            break
    if fewest == search.start:
        raise ValueError(
            f"Of {search.start} marks seen around the points none goes within that deviation: give "
            "a larger one, or choose the points of the dent alone"
        )
    first = next(i for i, (_, number) in enumerate(tried) if number == fewest)
    last = first
    while last + 1 < len(tried) and tried[last + 1][1] == fewest:
        last += 1
    low = search.border(tried[first][0], tried[first - 1][0], fewest)
    high = tried[last][0]
    if last + 1 < len(tried):
        high = search.border(high, tried[last + 1][0], fewest)
    return solution(0.5 * (low + high))


class _Search:
    def __init__(self, solution, count, tell):
        self._solution, self._count, self._tell = solution, count, tell
        self._done = 0
        self.start = self._told(solution(0.0).moves)
        if not self.start:
            raise ValueError("No mark is seen around the points that was not accepted")

    def count(self, deviation):
        """(how many marks, the deviation that was needed, whether it bound the moves)."""
        faired = self._solution(deviation)
        return self._told(faired.moves), faired.rms, faired.bound == "deviation"

    def border(self, inside, outside, fewest):
        """Between a deviation with the fewest marks and one with more: the last with these."""
        for _ in range(_HALVINGS):
            middle = 0.5 * (inside + outside)
            if self.count(middle)[0] <= fewest:
                inside = middle
            else:
                outside = middle
        return inside

    def _told(self, moves):
        self._done += 1
        self._tell(min(1.0, self._done / _MOST_COUNTS))
        return self._count(moves)
