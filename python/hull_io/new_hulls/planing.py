# SPDX-License-Identifier: GPL-3.0-or-later
"""A planing hull: one hard chine, constant deadrise aft, sharp V forward, transom."""

import numpy as np

from .grid import HullGrid, fitted, hull_of

SOURCE = "new hull: hard-chine planing type"

# In parts of the length from the transom: the keel is straight up to here.
_FOREFOOT = 0.50
# x over z: the stem leans forward, the transom aft.
_STEM_LEAN, _TRANSOM_RAKE = 0.9, -0.2


def planing_hull(dimensions, sections, points):
    chine = (points - 1) // 2
    grid = HullGrid(_points(dimensions, sections, points, chine), rake=_TRANSOM_RAKE)
    grid.creases = [((i, chine), (i + 1, chine)) for i in range(sections - 1)]
    return hull_of(fitted(grid, dimensions, points - 1), dimensions, "Planing Hull", SOURCE)


def _points(dimensions, sections, points, chine):
    half_beam, draft, depth = 0.5 * dimensions.beam, dimensions.draft, dimensions.depth
    freeboard = depth - draft
    t = np.linspace(0.0, 1.0, sections)
    x = (t - 0.12 * np.sin(2.0 * np.pi * t) / (2.0 * np.pi))[:, None]
    bow = np.clip((x - _FOREFOOT) / (1.0 - _FOREFOOT), 0.0, 1.0)
    fore = np.clip((x - 0.38) / 0.62, 0.0, 1.0)
    aft = np.clip((0.38 - x) / 0.38, 0.0, 1.0)

    keel = 0.55 * draft * bow**2.4
    chine_y = half_beam * (0.86 - 0.05 * aft**2) * (1.0 - fore**2.5)
    chine_z = 0.72 * draft + (0.28 * draft + 0.42 * freeboard) * bow**1.8
    sheer_y = half_beam * (1.0 - 0.06 * aft**2) * (1.0 - fore**3.0)
    sheer_z = depth + 0.22 * freeboard * bow**2

    up = np.linspace(0.0, 1.0, chine + 1)[None, :]
    side = np.linspace(0.0, 1.0, points - chine)[None, 1:]
    y = np.hstack([chine_y * up, chine_y + (sheer_y - chine_y) * side])
    z = np.hstack([keel + (chine_z - keel) * up, chine_z + (sheer_z - chine_z) * side])
    x = dimensions.length * x + (z - draft) * (_STEM_LEAN * bow**1.5 + _TRANSOM_RAKE * aft**2)
    return np.stack([x, y, z], axis=-1)
