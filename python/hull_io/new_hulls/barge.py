# SPDX-License-Identifier: GPL-3.0-or-later
"""A barge: box-shaped, flat bottom and sides, small round bilges, raked ends with headlogs."""

import numpy as np

from . import bilge
from .grid import HullGrid, fitted, hull_of

SOURCE = "new hull: barge"

_RAKE = 0.10  # length of a rake, in parts of the length


def barge(dimensions, sections, points):
    depth, draft = dimensions.depth, dimensions.draft
    half_beam = 0.5 * dimensions.beam
    radius = min(0.2 * half_beam, 0.35 * draft)
    y, z = bilge.section(half_beam, depth, radius, points).T
    # The headlogs begin above the water.
    headlog = draft + 0.3 * (depth - draft)
    x, bottom = _along(sections, dimensions.length, headlog)
    grid = np.empty((sections, points, 3))
    grid[:, :, 0], grid[:, :, 1] = x[:, None], y
    grid[:, :, 2] = bottom[:, None] + z * (1.0 - bottom[:, None] / depth)
    grid = HullGrid(grid, has_stem=False)
    return hull_of(fitted(grid, dimensions, points - 1), dimensions, "Barge", SOURCE)


def _along(sections, length, headlog):
    """x and height of the bottom: straight rakes, rounded into the flat bottom."""
    half_rake = 0.5 * _RAKE * length
    end = half_rake * np.arange(3.0)
    middle = np.linspace(3.0 * half_rake, length - 3.0 * half_rake, sections - 6)
    x = np.concatenate([end, middle, length - end[::-1]])
    rise = headlog * np.array([1.0, 0.5, 0.0])
    return x, np.concatenate([rise, np.zeros(sections - 6), rise[::-1]])
