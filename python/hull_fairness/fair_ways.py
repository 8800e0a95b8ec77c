# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways in which a changed surface is shaped so that marks go that are new, round after round.

Each is told of the marks that are new on the surface as it is by then, and gives the
hull_native.FairRegion by which it is to be shaped next, from the changed surface on.
"""

import numpy as np

from . import levers
from .native import hull_native as hn

# Over the beam, 1/m: bends below are about straight.
_LEAST_BEND = 0.05
# How much more it costs from round to round where a mark is new, and at most.
_MORE, _MOST = 10.0, 1e8
# Of what is not seen any more: as deep as a mark is to be. What it costs to miss it by as much as
# is not seen, against the integral of changed bends, where a mark is new and where it stays so.
_DEPTH = 0.5
_FIRST_COST, _GREATEST_COST = 1e-4, 1.0
# Of the beam: the distance of places of creases and borders whose bend costs, and how broad the
# surface is beside them that bends as they do.
_STEP, _WIDTH = 1.0 / 20.0, 0.1


class Ground:
    """What all ways begin with. known: a changes.Known; surface: the changed LimitSurface;
    conditions, limits: what control points may do, as of hull_native.FairRegion."""

    def __init__(self, known, surface, conditions, limits):
        self.known, self.surface = known, surface
        self.conditions, self.limits = conditions, limits
        self.sums = hn.BendSums(surface)
        self.least_bend = _LEAST_BEND / known.beam

    def region(self, before, attention, keep_creases=False, keep_stations=True, **wishes):
        """hull_native.FairRegion of all control points; bends are held to those of `before`, more
        where `attention` tells."""
        return hn.FairRegion(
            self.surface,
            np.arange(len(self.surface.mesh.points)),
            before=before.mesh.points,
            least_bend=self.least_bend,
            emphasised=attention.places,
            factors=attention.factors,
            reach=attention.reach,
            keep_creases=keep_creases,
            keep_stations=keep_stations,
            along_normals=False,
            conditions=self.conditions,
            **wishes,
            **self.limits,
        )


class _Attention:
    """Places on the hull before, and how much more bends count there."""

    def __init__(self, known):
        self.reach = known.reach
        self.places, self.factors = np.empty((0, 3)), np.empty(0)

    def add(self, new):
        """More where marks [changes.Placed] are new."""
        places = np.concatenate([np.empty((0, 3)), *[one.extent for one in new]])
        factors = np.array([min(_MORE * self._at(place), _MOST) for place in places])
        self.places = np.concatenate([self.places, places])
        self.factors = np.concatenate([self.factors, factors])

    def _at(self, place):
        near = np.linalg.norm(self.places - place, axis=1) <= self.reach
        return self.factors[near].max(initial=1.0)


class AsBefore:
    """The surface bends as it did before the change, in proportion; the more so where marks are
    new."""

    def __init__(self, ground):
        self._ground, self._attention = ground, _Attention(ground.known)

    def region(self, new, surface, moves):
        """For marks [changes.Placed] that are new on a LimitSurface, which is the changed one with
        moves (n, 3) of its control points."""
        self._attention.add(new)
        return self._ground.region(self._ground.known.surface, self._attention)


class ByLevers:
    """Marks are made as little deep as is not seen, by their levers, while the changed surface
    changes its bends as little as can be, in proportion. keep_creases: creases and borders stay;
    otherwise their own bends count, too. keep_stations: points move across the ship alone. Of
    reflection lines' marks, which have no levers, bends are held."""

    def __init__(self, ground, keep_creases, keep_stations=True):
        self._ground, self._attention = ground, _Attention(ground.known)
        self._keep_creases, self._keep_stations = keep_creases, keep_stations
        self._wishes = []
        self._features = ([], [])
        if not keep_creases:
            beam = ground.known.beam
            self._features = levers.feature_bends(
                ground.sums, ground.surface, _STEP * beam, _WIDTH * beam, ground.least_bend
            )

    def region(self, new, surface, moves):
        """As AsBefore.region."""
        tree = hn.SurfaceTree(surface)
        for mark in new:
            if mark.found.lever is not None:
                self._wish(mark, levers.slopes(self._ground.sums, surface, tree, mark.found.lever),
                           moves)  # fmt: skip
        self._attention.add([mark for mark in new if mark.found.lever is None])
        rows, costs = self._features
        wishes = self._wishes
        return self._ground.region(
            self._ground.surface,
            self._attention,
            self._keep_creases,
            self._keep_stations,
            wished=[one.row for one in wishes] + rows,
            wished_values=[one.value for one in wishes] + [0.0] * len(rows),
            wished_weights=[one.cost / one.mark.found.lever.unseen**2 for one in wishes] + costs,
        )

    def _wish(self, mark, row, moves):
        cost = _FIRST_COST
        for one in [one for one in self._wishes if self._is_same(one.mark, mark)]:
            cost = min(max(cost, _MORE * one.cost), _GREATEST_COST)
            self._wishes.remove(one)
        points, own = row
        lever = mark.found.lever
        value = np.sum(own * moves[points]) + _DEPTH * lever.unseen - lever.depth
        self._wishes.append(_Wish(mark, row, value, cost))

    def _is_same(self, one, other):
        apart = np.linalg.norm(np.subtract(one.place, other.place))
        is_near = apart <= self._ground.known.reach
        return is_near and one.kind == other.kind and one.line.name == other.line.name


class _Wish:
    """row: slopes of a mark's depth by moves of control points; value: what they are to sum up
    to; cost: see above."""

    def __init__(self, mark, row, value, cost):
        self.mark, self.row, self.value, self.cost = mark, row, value, cost
