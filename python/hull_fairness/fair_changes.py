# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks that a change of a hull's form made, taken out again.

The form before was fair, or its marks were meant. So the changed surface is shaped so that it bends
as it did before, in proportion to how much it did (native/modelling/fairing/bend_change.h), while
what was wanted of the change is kept. Where a mark is new bends are held the more, round after
round; of the rounds the one with the fewest new marks is taken, and then the smallest deviation
with as few.
"""

from dataclasses import dataclass

import numpy as np

from .lines import judged
from .native import hull_native as hn

# Over the beam, 1/m: bends below are about straight.
_LEAST_BEND = 0.05
_ROUNDS = 8
# How much more it costs from round to round where a mark is new, and at most.
_MORE, _MOST = 10.0, 1e8
_HALVINGS = 4
# Of the deviation, where the surface would fold with more.
_PARTS = (1.0, 0.5, 0.25, 0.125)
# Of the length from either end: what is at the ends. Of the beam: points as far out as any.
_ENDS, _AS_FAR_OUT = 0.02, 1e-3


@dataclass(frozen=True, eq=False)
class FairChange:
    """moves: (n, 3), m, of control points from the changed surface; rms, largest: m, how far the
    surface shifts; new: [changes.Placed] that are still new; start: how many were."""

    moves: np.ndarray
    rms: float
    largest: float
    new: list
    start: int


def held_form(surface, parallel=()):
    """(control points (h,), normals (h, 3)) that hold of a LimitSurface: the keel's and stem's
    heights, the ends, the greatest breadth, and all within `parallel` (aft, forward), m."""
    points, size = surface.mesh.points, surface.mesh.size
    x, out = points[:, 0], np.abs(points[:, 1])
    at_centre = out <= hn.tolerances.ON_CENTRE_PLANE * size
    margin = _ENDS * np.ptp(x)
    stays = (x <= x.min() + margin) | (x >= x.max() - margin)
    if len(parallel) and parallel[1] > parallel[0]:
        stays |= (x >= parallel[0]) & (x <= parallel[1])
    holds = (
        (stays | at_centre | (out >= (1.0 - _AS_FAR_OUT) * out.max()), 1),
        (stays | at_centre, 2),
    )
    held = [np.flatnonzero(are_held) for are_held, _ in holds]
    normals = [np.tile(np.eye(3)[axis], (len(own), 1)) for own, (_, axis) in zip(held, holds)]
    return np.concatenate(held), np.concatenate(normals)


def fair_new_marks(known, surface, most, keeping, wanted=(), progress=None, **limits):
    """The FairChange of a changed LimitSurface, whose marks are compared with a changes.Known:
    control points move across the ship alone.

    most: m, the root mean square shift that is not exceeded. keeping:
    kept_numbers.KeptNumbers of the changed hull. wanted: as Known.compared has it. limits: what
    control points may do, as of hull_native.FairRegion. progress: called with the share done. Where
    nothing gets better nothing moves. ValueError where no point may move.
    """
    search = _Search(known, surface, keeping, wanted, limits, progress or (lambda share: None))
    best = search.start
    attention = _Attention(known)
    found = best
    for _ in range(_ROUNDS):
        if not best.new:
            break
        attention.add(found.new)
        region = search.region(attention)
        found = search.unfolded(region, most)
        if found is None:
            break
        if len(found.new) < len(best.new):
            best, best_region = found, region
    if best is search.start:
        return best
    return search.least(best_region, best)


class _Attention:
    """Places on the hull before, and how much more bends count there."""

    def __init__(self, known):
        self.reach = known.reach
        self.places, self.factors = np.empty((0, 3)), np.empty(0)

    def add(self, new):
        """More where marks [changes.Placed] are new."""
        places = np.concatenate([one.extent for one in new])
        factors = np.array([min(_MORE * self._at(place), _MOST) for place in places])
        self.places = np.concatenate([self.places, places])
        self.factors = np.concatenate([self.factors, factors])

    def _at(self, place):
        near = np.linalg.norm(self.places - place, axis=1) <= self.reach
        return self.factors[near].max(initial=1.0)


class _Search:
    def __init__(self, known, surface, keeping, wanted, limits, tell):
        self._known, self._surface, self._keeping = known, surface, keeping
        self._wanted, self._limits, self._tell = wanted, limits, tell
        self._counts = 0
        none = np.zeros_like(surface.mesh.points)
        new = self._new(surface)
        self.start = FairChange(none, 0.0, 0.0, new, len(new))

    def region(self, attention):
        """hull_native.FairRegion of all control points with bends held as `attention` tells."""
        return hn.FairRegion(
            self._surface,
            np.arange(len(self._surface.mesh.points)),
            before=self._known.surface.mesh.points,
            least_bend=_LEAST_BEND / self._known.beam,
            emphasised=attention.places,
            factors=attention.factors,
            reach=attention.reach,
            keep_creases=False,
            along_normals=False,
            conditions=self._keeping.conditions(),
            **self._limits,
        )

    def unfolded(self, region, most):
        """The FairChange of the largest deviation, of some, by which the surface does not fold;
        None where there is none."""
        for part in _PARTS:
            found = self.judged(region, part * most)
            if found is not None:
                return found
        return None

    def judged(self, region, deviation):
        """The FairChange with that deviation, m; None where the surface would fold."""
        faired, _ = self._keeping.solve(lambda values: region.solve(deviation, values=values))
        if faired.folded_place is not None:
            return None
        mesh = self._surface.mesh
        moved = hn.LimitSurface(mesh.with_points(mesh.points + faired.moves), self._surface.scheme)
        new = self._new(moved)
        return FairChange(faired.moves, faired.rms, faired.largest, new, self.start.start)

    def least(self, region, best):
        """The FairChange of the smallest deviation with as few new marks."""
        low, high = 0.0, best.rms
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            found = self.judged(region, middle)
            if found is not None and len(found.new) <= len(best.new):
                best, high = found, middle
            else:
                low = middle
        self._tell(1.0)
        return best

    def _new(self, surface):
        lines = judged(surface, self._known.beam)
        self._counts += 1
        self._tell(min(1.0, self._counts / (1 + _ROUNDS + _HALVINGS)))
        return self._known.compared(lines, surface, self._wanted).new
