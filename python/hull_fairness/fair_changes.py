# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks that a change of a hull's form made, taken out again.

The form before was fair, or its marks were meant. So the changed surface is shaped anew, round
after round, while what was wanted of the change is kept, in one way after the other (fair_ways)
until no mark is new: by levers, that is by what makes these very marks less deep, while creases and
borders stay; so that it bends as it did before; by levers with creases and borders, too; and so
that points move along the ship as well, for a mesh that has too few rows to follow otherwise. Of
all rounds the one with the fewest new marks is taken, and then the smallest deviation with as few.
"""

from dataclasses import dataclass

import numpy as np

from .fair_ways import AsBefore, ByLevers, Ground
from .lines import judged
from .native import hull_native as hn

_ROUNDS = 8
# Of what is seen, and of changes.REACH: so much counts where less deviation is tried, so that no
# mark comes back when points are rounded to single precision.
_EYE = 0.95
# Times the new marks at the start, and besides: with more a way leads astray.
_ASTRAY = 3, 10
_HALVINGS = 4
_MOST_COUNTS = 1 + 4 * _ROUNDS + _HALVINGS
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
    heights, the ends, the greatest breadth, and all within `parallel` (aft, forward), m; knuckles
    across the ship in their stations."""
    points, size = surface.mesh.points, surface.mesh.size
    x, out = points[:, 0], np.abs(points[:, 1])
    at_centre = out <= hn.tolerances.ON_CENTRE_PLANE * size
    margin = _ENDS * np.ptp(x)
    stays = (x <= x.min() + margin) | (x >= x.max() - margin)
    if len(parallel) and parallel[1] > parallel[0]:
        stays |= (x >= parallel[0]) & (x <= parallel[1])
    holds = (
        (stays | _of_knuckles_across(surface.mesh), 0),
        (stays | at_centre | (out >= (1.0 - _AS_FAR_OUT) * out.max()), 1),
        (stays | at_centre, 2),
    )
    held = [np.flatnonzero(are_held) for are_held, _ in holds]
    normals = [np.tile(np.eye(3)[axis], (len(own), 1)) for own, (_, axis) in zip(held, holds)]
    return np.concatenate(held), np.concatenate(normals)


def _of_knuckles_across(mesh):
    """(n,) which control points are of creases and borders across the ship."""
    found = np.zeros(len(mesh.points), dtype=bool)
    for edges in (mesh.creases[:, :2], mesh.border_edges):
        edges = np.asarray(edges, dtype=int).reshape(-1, 2)
        along = np.abs(np.diff(mesh.points[edges, 0], axis=1)[:, 0])
        found[edges[along <= hn.tolerances.IN_PLANE * mesh.size]] = True
    return found


def fair_new_marks(known, surface, most, keeping, wanted=(), progress=None, **limits):
    """The FairChange of a changed LimitSurface, whose marks are compared with a changes.Known:
    control points move across the ship, and along it only where that leaves marks.

    most: m, the root mean square shift that is not exceeded. keeping:
    kept_numbers.KeptNumbers of the changed hull. wanted: as Known.compared has it. limits: what
    control points may do, as of hull_native.FairRegion. progress: called with the share done. Where
    nothing gets better nothing moves. ValueError where no point may move.
    """
    search = _Search(known, surface, keeping, wanted, progress or (lambda share: None))
    best, best_region = search.start, None
    if best.new:
        ground = Ground(known, surface, keeping.conditions(), limits)
        for way in _ways(ground):
            best, best_region = search.rounds(way, most, best, best_region)
            if not best.new:
                break
    return best if best_region is None else search.least(best_region, best)


def _ways(ground):
    yield ByLevers(ground, keep_creases=True)
    yield AsBefore(ground)
    yield ByLevers(ground, keep_creases=False)
    yield ByLevers(ground, keep_creases=False, keep_stations=False)


class _Search:
    def __init__(self, known, surface, keeping, wanted, tell):
        self._known, self._surface, self._keeping = known, surface, keeping
        self._wanted, self._tell = wanted, tell
        self._counts = 0
        none = np.zeros_like(surface.mesh.points)
        new = self._new(surface)
        self.start = FairChange(none, 0.0, 0.0, new, len(new))

    def rounds(self, way, most, best, best_region):
        """(the best FairChange, its hull_native.FairRegion) after the rounds of a way."""
        found = self.start
        for _ in range(_ROUNDS):
            region = way.region(found.new, self._moved(found.moves), found.moves)
            found = self.unfolded(region, most)
            if found is None or len(found.new) > _ASTRAY[0] * self.start.start + _ASTRAY[1]:
                break
            if len(found.new) < len(best.new):
                best, best_region = found, region
            if not best.new:
                break
        return best, best_region

    def _moved(self, moves):
        mesh = self._surface.mesh
        return hn.LimitSurface(mesh.with_points(mesh.points + moves), self._surface.scheme)

    def unfolded(self, region, most):
        """The FairChange of the largest deviation, of some, by which the surface does not fold;
        None where there is none."""
        for part in _PARTS:
            found = self.judged(region, part * most)
            if found is not None:
                return found
        return None

    def judged(self, region, deviation, eye=1.0):
        """The FairChange with that deviation, m; None where the surface would fold."""
        faired, _ = self._keeping.solve(lambda values: region.solve(deviation, values=values))
        if faired.folded_place is not None:
            return None
        new = self._new(self._moved(faired.moves), eye)
        return FairChange(faired.moves, faired.rms, faired.largest, new, self.start.start)

    def least(self, region, best):
        """The FairChange of the smallest deviation with as few new marks."""
        low, high = 0.0, best.rms
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            found = self.judged(region, middle, _EYE)
            if found is not None and len(found.new) <= len(best.new):
                best, high = found, middle
            else:
                low = middle
        self._tell(1.0)
        return best

    def _new(self, surface, eye=1.0):
        lines = judged(surface, self._known.beam, eye=eye)
        self._counts += 1
        self._tell(min(1.0, self._counts / _MOST_COUNTS))
        return self._known.compared(lines, surface, self._wanted, eye).new
