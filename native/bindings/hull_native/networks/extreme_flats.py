# SPDX-License-Identifier: GPL-3.0-or-later
"""The flat bottom and the flat side, as the curves of a network tell them."""

from dataclasses import dataclass

import numpy as np

# Of the length: places of curves are in a flat's plane; it reaches as far along the ship.
_IN_FLAT, _LEAST_FLAT = 3e-5, 0.05
_LEAST_PLACES = 30


@dataclass(frozen=True)
class ExtremeFlat:
    """The flat bottom (axis 2) or flat side (axis 1), in the plane where the coordinate is `place`:
    between low and high, m, of the other coordinate across the ship, at x (k,), rising."""

    axis: int
    place: float
    x: np.ndarray
    low: np.ndarray
    high: np.ndarray

    def has(self, points, margin):
        """Of points (n, 3), projected into its plane, whether they are in it."""
        across = points[:, 3 - self.axis]
        low, high = (np.interp(points[:, 0], self.x, side) for side in (self.low, self.high))
        along = (points[:, 0] >= self.x[0] - margin) & (points[:, 0] <= self.x[-1] + margin)
        return along & (across >= low - margin) & (across <= high + margin)


def extreme_flats(outline, places):
    """The ExtremeFlats that many places of the curves lie in."""
    found = []
    for axis, place in ((2, places[:, 2].min()), (1, places[:, 1].max())):
        inside = places[np.abs(places[:, axis] - place) < _IN_FLAT * outline.length]
        if len(inside) < _LEAST_PLACES or np.ptp(inside[:, 0]) < _LEAST_FLAT * outline.length:
            continue
        at, which = np.unique((inside[:, 0] / (1e-5 * outline.length)).round(), return_inverse=True)
        across = [inside[which == k][:, 3 - axis] for k in range(len(at))]
        # Of a line along the flat there is one place each: a station has more.
        wide = [k for k, values in enumerate(across) if len(values) > 2]
        if len(wide) < 2:
            continue
        found.append(
            ExtremeFlat(
                axis, float(np.median(inside[:, axis])), at[wide] * 1e-5 * outline.length,
                np.array([across[k].min() for k in wide]),
                np.array([across[k].max() for k in wide]),
            )  # fmt: skip
        )
    return found
