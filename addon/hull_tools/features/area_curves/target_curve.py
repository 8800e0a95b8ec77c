# SPDX-License-Identifier: GPL-3.0-or-later
"""A sectional area curve that is wanted, as numbers."""

from dataclasses import dataclass

import numpy as np

from ...bridge import native

# Of the curve's length: places this far beyond an end are the end, so that rounding of what Blender
# stores does not cut a transom's area off.
_AT_END = 1e-5
_PLACES = 801  # at which the curve's volume is summed


@dataclass(frozen=True, eq=False)
class TargetCurve:
    """base_x, base_areas (b,): the curve it was at first, at its own stations; b = 0 for none. x,
    areas (h,): the handles, through which it goes. Metres from the after perpendicular, rising, and
    m².

    Between handles it is the base and, beside that, the smooth curve of what the handles have been
    moved by, which rises and falls only where they do. So handles that stay leave the base with all
    its details. Beyond the first and the last handle it is zero.

    ValueError where places do not rise, or no area is above zero.
    """

    base_x: np.ndarray
    base_areas: np.ndarray
    x: np.ndarray
    areas: np.ndarray

    def __post_init__(self):
        native.require().target_area_curve(self.x, self.areas, [])
        if len(self.base_x):
            native.require().target_area_curve(self.base_x, self.base_areas, [])

    @property
    def ends(self):
        """(aft, forward), m."""
        return float(self.x[0]), float(self.x[-1])

    def at(self, places):
        """Areas (k,) at places (k,), m²."""
        places = np.asarray(places, dtype=np.float64)
        aft, forward = self.ends
        margin = _AT_END * (forward - aft)
        inside = (places >= aft - margin) & (places <= forward + margin)
        clamped = np.clip(places, aft, forward)
        moved = self.areas - self._base(self.x)
        # hull_native's curve takes areas, which are above zero: it goes along with what is added.
        lift = 1.0 + np.abs(moved).max()
        change = native.require().target_area_curve(self.x, moved + lift, clamped) - lift
        return np.where(inside, np.maximum(self._base(clamped) + change, 0.0), 0.0)

    def _base(self, places):
        if not len(self.base_x):
            return np.zeros(len(places))
        within = np.clip(places, self.base_x[0], self.base_x[-1])
        return native.require().target_area_curve(self.base_x, self.base_areas, within)

    def drawn(self):
        """(x (n,), areas (n,)) by which it is drawn."""
        aft, forward = self.ends
        own = self.base_x[(self.base_x > aft) & (self.base_x < forward)]
        x = np.unique(np.concatenate([np.linspace(aft, forward, 161), own, self.x]))
        return x, self.at(x)

    def volume(self):
        """(m³, x of its centre in m)."""
        x, step = np.linspace(*self.ends, _PLACES, retstep=True)
        parts = step * self.at(x)
        parts[[0, -1]] *= 0.5
        return float(parts.sum()), float(parts @ x / parts.sum())

    def scaled(self, factor):
        """The same with all areas times a factor."""
        return TargetCurve(self.base_x, factor * self.base_areas, self.x, factor * self.areas)


@dataclass(frozen=True, eq=False)
class PartWay:
    """So far on the way from the areas (n,) that a hull has at positions (n,) to a TargetCurve: way
    0 to 1. As that it has ends, areas at() places, and drawn()."""

    positions: np.ndarray
    areas: np.ndarray
    target: TargetCurve
    way: float

    @property
    def ends(self):
        return self.target.ends

    def at(self, places):
        wanted = self.target.at(places)
        if self.way == 1.0:
            return wanted
        present = np.interp(places, self.positions, self.areas, left=0.0, right=0.0)
        return present + self.way * (wanted - present)

    def drawn(self):
        x, _ = self.target.drawn()
        return x, self.at(x)


def through(x, areas, handles):
    """The TargetCurve whose base are areas (n,) at x (n,), with so many handles on it, as far from
    one another. ValueError where none of them comes to lie where there is an area."""
    x, areas = np.asarray(x, dtype=np.float64), np.asarray(areas, dtype=np.float64)
    places = np.linspace(x[0], x[-1], handles)
    found = native.require().target_area_curve(x, areas, places)
    if not np.any(found > 0.0):
        raise ValueError(f"The curve has no area at any of {handles} handles: take more of them")
    return TargetCurve(x, areas, places, found)


@dataclass(frozen=True)
class Difference:
    """Of a hull's sectional areas from those wanted, in parts of the largest area wanted: largest,
    with sign, and its x in m; rms: root of the mean square over the stations."""

    largest: float
    at: float
    rms: float


def difference(x, areas, target):
    """The Difference of areas (n,) of a hull at its stations x (n,) from a TargetCurve, or from a
    PartWay to one. Where only one of both is, all of it counts, but for rounding at the ends."""
    aft, forward = target.ends
    beyond = np.linspace(aft, forward, 201)
    margin = 1e-3 * (forward - aft)
    beyond = beyond[(beyond < x[0] - margin) | (beyond > x[-1] + margin)]
    near = (np.abs(x - aft) > margin) & (np.abs(x - forward) > margin)
    counted = near | ((x >= aft) & (x <= forward))
    lacks = np.concatenate([areas[counted] - target.at(x[counted]), -target.at(beyond)])
    if not len(lacks):
        return Difference(0.0, aft, 0.0)
    places = np.concatenate([x[counted], beyond])
    worst = int(np.abs(lacks).argmax())
    parts = lacks / _largest(target)
    return Difference(
        float(parts[worst]), float(places[worst]), float(np.sqrt(np.mean(parts**2)))
    )


def _largest(target):
    return float(max(target.drawn()[1].max(), 1e-9))
