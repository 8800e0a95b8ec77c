# SPDX-License-Identifier: GPL-3.0-or-later
"""What a guess takes of a hull: points spread over it, symmetry, breadths, where it ends."""

from dataclasses import dataclass

import numpy as np

from ..triangles import spread_points

# Points of a cloud; slabs along the hull and bins across it in which it is looked at.
_MOST, _SLABS, _BINS = 12_000, 40, 12
# Of the extent: what lies in a plane, and what is symmetric.
_TOUCHING, _SYMMETRIC = 0.01, 0.02
# Of the size: a coordinate that is meant to be 0, and a plane that is exact.
_MEANT, _EXACT = 2e-5, 1e-6
# Of the size: sides of triangles that are longer have places between their ends.
_LONG_SIDE = 0.01


def cloud_points(geometry):
    """(n, 3): places spread over meshes by area, where there are some, and their own points; else
    along curves by length; else the points."""
    if geometry.meshes:
        firsts = np.cumsum([0, *(len(mesh.points) for mesh in geometry.meshes)])
        points = np.concatenate([mesh.points for mesh in geometry.meshes])
        triangles = np.concatenate(
            [mesh.triangles + first for mesh, first in zip(geometry.meshes, firsts)]
        )
        spread, _ = spread_points(points, triangles, _MOST)
        return np.concatenate([spread, _thinned(points), _on_long_sides(points, triangles)])
    if geometry.curves:
        return np.concatenate([_along(geometry.curves), geometry.points])
    return _thinned(geometry.points)


def _thinned(points):
    """Some of many points, with the outermost along each axis: dimensions are of all of them."""
    step = max(1, len(points) // _MOST)
    if step == 1:
        return points
    outermost = np.concatenate([points.argmin(axis=0), points.argmax(axis=0)])
    return np.concatenate([points[::step], points[outermost]])


def _on_long_sides(points, triangles):
    """Places on sides of triangles that are few and large, as along the keel; none of many."""
    sides = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    starts, ends = points[sides].transpose(1, 0, 2)
    is_long = np.linalg.norm(ends - starts, axis=1) > _LONG_SIDE * np.ptp(points, axis=0).max()
    if not 0 < is_long.sum() < _MOST // 4:
        return np.empty((0, 3))
    return _between(starts[is_long], ends[is_long])


def _along(curves):
    """Corners of curves, and places between them."""
    starts = np.concatenate([curve.points[:-1] for curve in curves])
    ends = np.concatenate([curve.points[1:] for curve in curves])
    lasts = np.array([curve.points[-1] for curve in curves])
    return np.concatenate([_between(starts, ends), lasts])


def _between(starts, ends):
    """Places from each start (k, 3) on towards its end, as many in all as a cloud has."""
    lengths = np.linalg.norm(ends - starts, axis=1)
    spacing = max(lengths.sum() / _MOST, np.finfo(float).tiny)
    counts = np.clip(np.ceil(lengths / spacing), 1, _MOST).astype(int)
    piece = np.repeat(np.arange(len(counts)), counts)
    share = (np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)) / counts[
        piece
    ]
    return starts[piece] + share[:, None] * (ends - starts)[piece]


@dataclass(frozen=True)
class HullCloud:
    """points (n, 3) with axes 0 to 2: long, side (athwartships), vertical; centre: the coordinate
    of the centre plane. doubt: from 0, how badly this account of the hull fits."""

    points: np.ndarray
    long: int
    side: int
    centre: float
    is_half: bool
    doubt: float
    reason: str

    @property
    def vertical(self):
        return 3 - self.long - self.side

    @classmethod
    def accounts(cls, points, long_axis, side, is_half, centre_plane=None):
        """HullClouds of the hull as whole and as either half, or only as is_half says.
        centre_plane: that of halves, where it is told."""
        found = []
        letter = "xyz"[side]
        low, high = points[:, side].min(), points[:, side].max()
        extent = high - low
        if not is_half:
            centre, spread = _symmetry(points, long_axis, side)
            is_beside = low > 0.1 * extent or high < -0.1 * extent
            is_twin = is_half is None and is_beside and spread < _SYMMETRIC
            reason = f"It is whole: symmetric about {letter} = {centre:.6g}."
            if is_twin:
                reason = f"It is one hull of a catamaran, symmetric beside {letter} = 0."
            plane = 0.0 if is_twin else centre
            doubt = max(0.0, spread - _SYMMETRIC) / _SYMMETRIC * 0.2 + 0.12 * is_twin
            found.append(cls(points, long_axis, side, plane, is_twin, doubt, reason))
        if is_half is not False:
            size = np.ptp(points, axis=0).max()
            for plane in (low, high) if centre_plane is None else (centre_plane,):
                is_zero = abs(plane) <= _MEANT * size
                plane = 0.0 if is_zero else plane
                share, exact = _touching(points, long_axis, side, plane)
                doubt = 0.01 + (1.0 - share) + 0.15 * (1.0 - exact) + 0.12 * (not is_zero)
                reason = f"It is one half: it ends in the plane {letter} = {plane:.6g} all along."
                found.append(cls(points, long_axis, side, plane, True, doubt, reason))
        return found

    def low(self, axis):
        return self.points[:, axis].min()

    def high(self, axis):
        return self.points[:, axis].max()

    def end(self, axis, is_high):
        return self.high(axis) if is_high else self.low(axis)

    def extent(self, axis):
        return self.high(axis) - self.low(axis)

    def fullness_above(self):
        """From -1 to 1: how much more of the hull is towards the higher numbers of the vertical
        axis than towards the lower ones. By breadths, from slab to slab; where these are alike, as
        in a barge, by the bottom, for most hulls have no deck."""
        breadths = self._breadths()
        third = _BINS // 3
        lower, upper = breadths[:, :third].mean(), breadths[:, -third:].mean()
        middle = 0.5 * (self.low(self.vertical) + self.high(self.vertical))
        below = middle - self.points[:, self.vertical].mean()
        return (upper - lower) / (upper + lower) + 0.5 * below / self.extent(self.vertical)

    def breadths_at_ends(self, is_up_positive):
        """Mean half-breadths above the middle at the end with the lower and with the higher
        numbers."""
        upper = slice(_BINS // 2, None) if is_up_positive else slice(None, _BINS // 2)
        breadths = self._breadths()[:, upper].max(axis=1)
        window = _SLABS // 10
        return breadths[:window].mean(), breadths[-window:].mean()

    def share_ending_at_zero(self, is_up_positive):
        """Of the slabs along the hull those whose lowest point is at the file's own 0."""
        slabs = _steps(self.points[:, self.long], _SLABS)
        low, high = _ranges(slabs, self.points[:, self.vertical], _SLABS)
        lowest = low if is_up_positive else high
        return np.mean(np.abs(lowest) <= 0.005 * self.extent(self.vertical))

    def end_at_height(self, height, is_high):
        """How far the hull reaches along its length about a height."""
        near = np.abs(self.points[:, self.vertical] - height) <= 0.05 * self.extent(self.vertical)
        at = self.points[near, self.long]
        if not len(at):
            return self.end(self.long, is_high)
        return at.max() if is_high else at.min()

    def _breadths(self):
        """(_SLABS, _BINS) largest distances from the centre plane; 0 where there is nothing. Bins
        divide each slab's own height, for forecastles reach higher than other decks."""
        slabs = _steps(self.points[:, self.long], _SLABS)
        heights = self.points[:, self.vertical]
        low, high = _ranges(slabs, heights, _SLABS)
        shares = (heights - low[slabs]) / np.maximum(high - low, _EXACT * np.ptp(heights))[slabs]
        cells = slabs * _BINS + np.minimum((shares * _BINS).astype(int), _BINS - 1)
        found = np.zeros(_SLABS * _BINS)
        np.maximum.at(found, cells, np.abs(self.points[:, self.side] - self.centre))
        return found.reshape(_SLABS, _BINS)


def _ranges(cells, values, count):
    """(least, largest) value of each cell; NaN where there is none."""
    low, high = np.full(count, np.inf), np.full(count, -np.inf)
    np.minimum.at(low, cells, values)
    np.maximum.at(high, cells, values)
    is_empty = low > high
    return np.where(is_empty, np.nan, low), np.where(is_empty, np.nan, high)


def _steps(values, count):
    low, high = values.min(), values.max()
    return np.minimum(((values - low) / max(high - low, 1e-300) * count).astype(int), count - 1)


def _cells(points, long_axis, other):
    return _steps(points[:, long_axis], _SLABS) * _BINS + _steps(points[:, other], _BINS)


def _symmetry(points, long_axis, side):
    """(centre, mean distance of the cells' middles from it, of the extent)."""
    cells = _cells(points, long_axis, 3 - long_axis - side)
    values = points[:, side]
    low, high = _ranges(cells, values, _SLABS * _BINS)
    counts = np.bincount(cells, minlength=len(low))
    middles = 0.5 * (low + high)[counts >= 6]
    centre = 0.5 * (values.min() + values.max())
    if not len(middles):
        return centre, 1.0
    return centre, np.abs(middles - centre).mean() / max(np.ptp(values), 1e-300)


def _touching(points, long_axis, side, plane):
    """Shares of the slabs along the hull that reach a plane, about and exactly."""
    slabs = _steps(points[:, long_axis], _SLABS)
    away = np.full(_SLABS, np.inf)
    np.minimum.at(away, slabs, np.abs(points[:, side] - plane))
    away = away[np.isfinite(away)]
    extent = max(np.ptp(points[:, side]), 1e-300)
    size = np.ptp(points, axis=0).max()
    return np.mean(away <= _TOUCHING * extent), np.mean(away <= _EXACT * size)
