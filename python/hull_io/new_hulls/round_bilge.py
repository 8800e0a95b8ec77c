# SPDX-License-Identifier: GPL-3.0-or-later
"""A displacement hull: flat bottom, round bilges and flat side amidships, raked stem, transom."""

import numpy as np

from . import bilge
from .grid import HullGrid, fitted, hull_of, move_foot

SOURCE = "new hull: round-bilge displacement type"

# In parts of the length from the aft perpendicular: the transom, and the parallel middle body.
_TRANSOM, _RUN, _SHOULDER = -0.03, 0.38, 0.56
# Forward lean of the stem, x over z.
_STEM_LEAN = 0.35


def round_bilge_hull(dimensions, sections, points):
    grid = HullGrid(_points(dimensions, sections, points))
    return hull_of(fitted(grid, dimensions, points - 1), dimensions, "Round-bilge Hull", SOURCE)


def _points(dimensions, sections, points):
    half_beam, draft, depth = 0.5 * dimensions.beam, dimensions.draft, dimensions.depth
    radius = min(0.5 * half_beam, 0.45 * draft)
    y, z = bilge.section(half_beam, depth, radius, points).T
    x = _along(sections)
    grid = np.empty((sections, points, 3))
    grid[:, :, 0], grid[:, :, 1], grid[:, :, 2] = dimensions.length * x[:, None], y, z
    _draw_in_stern(grid, x, draft, depth)
    _draw_in_bow(grid, x, draft, depth)
    return grid


def _along(sections):
    """Places of the sections: four or more in the parallel middle body, closer at the ends."""
    middle = max(4, sections // 4)
    aft = (sections - middle) // 2
    fore = sections - middle - aft
    parallel = np.linspace(_RUN, _SHOULDER, middle)
    first = parallel[1] - parallel[0]
    before = _RUN - (_RUN - _TRANSOM) * _closing(aft, first / (_RUN - _TRANSOM))[::-1]
    after = _SHOULDER + (1.0 - _SHOULDER) * _closing(fore, first / (1.0 - _SHOULDER))
    return np.concatenate([before, parallel, after])


def _closing(count, first):
    """(count,) places up to 1, whose distances from 0 on go from about `first` to smaller ones."""
    t = np.arange(1, count + 1) / count
    bend = np.clip(first * count - 1.0, 0.15, 0.5)
    return t * (1.0 + bend * (1.0 - t))


def _draw_in_stern(grid, x, draft, depth):
    """The bottom rises to a transom that begins just above the water, and the sides draw in."""
    run = np.clip((_RUN - x) / (_RUN - _TRANSOM), 0.0, 1.0)[:, None]
    y, z = grid[:, :, 1], grid[:, :, 2]
    half = y[0, -1]
    height = z / depth
    keel = 1.03 * draft * run**2.2
    rise = 0.10 * half * run**2.2 * (y * (y - y[0, 1]) / half**2) * (1 - height)
    grid[:, :, 2] = keel + z * (1.0 - keel / depth) + rise + 0.10 * depth * run**2 * height**2
    grid[:, :, 1] = y * (1.0 - (0.24 - 0.12 * height) * run**2.6)


def _draw_in_bow(grid, x, draft, depth):
    """Rows of points draw in to the stem, the lower ones earlier; bottom and bilge become a V."""
    entrance = np.clip((x - _SHOULDER) / (1.0 - _SHOULDER), 0.0, 1.0)[:, None]
    y, z = grid[:, :, 1].copy(), grid[:, :, 2].copy()
    height = z[-1] / depth
    power = 2.1 + 1.7 * height
    flare = y[-1] * power / (y[-1, -1] * power[-1])
    stem = 1.2 * depth * flare**1.6
    grid[:, :, 1] = y * (1.0 - entrance**power)
    grid[:, :, 2] = z + (stem - z) * entrance**2.6
    grid[x > _RUN, 0, 2] = 0.0
    grid[:, :, 0] += _STEM_LEAN * (grid[:, :, 2] - draft) * entrance**3
    move_foot(grid, along=0.3, up=0.0)
