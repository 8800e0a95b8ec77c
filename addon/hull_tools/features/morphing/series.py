# SPDX-License-Identifier: GPL-3.0-or-later
"""Series of members of a family, from one set of weights to another in equal steps."""

from dataclasses import dataclass, replace

import numpy as np

from ...bridge import limits
from ...bridge.blender import units
from ..flotation import afloat, ship
from ..hull import hull_state
from . import local_parents, members, parents, weights


@dataclass(frozen=True, eq=False)
class Step:
    """A member of a series at t, 0 to 1. where: how it lies, afloat.Afloat; particulars: its
    parents.PARTICULARS by name, in m."""

    t: float
    weights: list
    where: afloat.Afloat
    particulars: dict


@dataclass(frozen=True, eq=False)
class Series:
    """steps: Steps. family: hull_native.HullFamily; factors (3,) of length, beam and draft; local:
    as local_parents has them; source: the ship.ShipSource of the hull, whose faces all members
    have. For any thread."""

    name: str
    parents: list
    steps: list
    family: object
    factors: np.ndarray
    local: list
    source: ship.ShipSource

    def points(self, step):
        """(n, 3), m. ValueError, with t, where the member is folded."""
        points = self.family.points(step.weights, local=self.local, mirrored=self.source.half)
        place = self.family.first_fold(points)
        if place is not None:
            x, y, z = place
            raise ValueError(f"At t = {step.t:g} the surface folds, at x {x:.3f}, y {y:.3f}, "
                             f"z {z:.3f} m: leave that member out")  # fmt: skip
        return points * self.factors

    def member(self, step):
        """The ship.ShipSource of a member."""
        own = self.source.control  # without layers that are no part of the shell
        control = replace(own, points=self.points(step)[own.vertex_ids])
        return replace(self.source, control=control)


def of_hull(obj, scene, first=None, last=None, steps=None):
    """The Series of a hull of a family. first, last: weights, one a parent; None for the parents
    that Object.hull.morph names; steps likewise. ValueError where there is none."""
    state, morph = hull_state.up_to_date(obj, scene), obj.hull.morph
    if not members.is_of_family(obj):
        raise ValueError(members.NOT_OF_FAMILY)
    count = len(morph.parents)
    first = weights.checked(first or _one(morph.series_from, count), count)
    last = weights.checked(last or _one(morph.series_to, count), count)
    if np.array_equal(first, last):
        raise ValueError("The series begins and ends with the same hull: choose another parent")
    number = limits.within(steps or morph.steps, "Steps", 1, limits.MOST_SERIES_STEPS)
    scale, factors = units.metres_per_unit(scene), members.factors_of(morph)
    family = parents.family_of(obj, scale)
    local = local_parents.of_hull(obj, family, scale)
    own = afloat.afloat(obj.hull, scale)
    found = [_step(obj, k / number, first, last, own, scale) for k in range(number + 1)]
    names = [entry.name for entry in morph.parents]
    return Series(obj.name, names, found, family.native, factors, local, state.ship.source)


def _one(number, count):
    """The weights of a parent by its number, from 1 on, alone."""
    limits.within(number, "The number of a parent", 1, count)
    return [float(k == number - 1) for k in range(count)]


def _step(obj, t, first, last, own, scale):
    morph = obj.hull.morph
    mixed = [(1.0 - t) * a + t * b for a, b in zip(first, last)]
    particulars = _particulars(obj, mixed)
    metres = {name: value * scale for name, value in particulars.items()}
    where = own
    if morph.follows_particulars:
        where = replace(own, draft=metres["draft"], trim_m=metres["trim_m"],
                        length_pp=metres["length_pp"], beam=metres["beam"])  # fmt: skip
    return Step(t, mixed, where, metres)


def _particulars(obj, mixed):
    """Those of the parents by weights where they follow, else the hull's own; in Blender's units,
    as they would be stored."""
    if obj.hull.morph.follows_particulars:
        found = parents.blended(obj.hull.morph, mixed, members.factors_of(obj.hull.morph))
        return {name: units.as_stored(value) for name, value in found.items()}
    return dict(zip(parents.PARTICULARS, parents.particulars_of(obj)))
