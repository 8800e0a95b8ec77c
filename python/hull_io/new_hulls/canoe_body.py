# SPDX-License-Identifier: GPL-3.0-or-later
"""The canoe body of a sailing yacht: round sections, rockered keel line, overhangs at both ends."""

import numpy as np

from .grid import HullGrid, fitted, hull_of, move_foot

SOURCE = "new hull: sailing-yacht canoe body"

# In parts of the waterline's length from its after end.
_TRANSOM, _DEEPEST, _WIDEST = -0.09, 0.52, 0.44
# x over z: the stem leans forward, and so does the transom.
_STEM_LEAN, _TRANSOM_RAKE = 0.5, 0.4


def canoe_body(dimensions, sections, points):
    grid = HullGrid(_points(dimensions, sections, points), rake=_TRANSOM_RAKE)
    return hull_of(fitted(grid, dimensions, points - 1), dimensions, "Canoe Body", SOURCE)


def _points(dimensions, sections, points):
    half_beam, draft, depth = 0.5 * dimensions.beam, dimensions.draft, dimensions.depth
    freeboard = depth - draft
    t = np.linspace(0.0, 1.0, sections)
    t = t - 0.25 * np.sin(2.0 * np.pi * t) / (2.0 * np.pi)
    x = (_TRANSOM + (1.0 - _TRANSOM) * t)[:, None]
    rocker = np.where(x < _DEEPEST, (_DEEPEST - x) / _DEEPEST, (x - _DEEPEST) / (1.0 - _DEEPEST))
    fore = np.clip((x - _WIDEST) / (1.0 - _WIDEST), 0.0, 1.0)
    aft = np.clip((_WIDEST - x) / (_WIDEST - _TRANSOM), 0.0, 1.0)

    keel = draft * np.where(x < _DEEPEST, rocker**2, 0.95 * rocker**2.15)
    sheer_y = half_beam * (1.0 - 0.26 * aft**2) * (1.0 - fore**2.35)
    sheer_z = depth + 0.25 * freeboard * fore**2 + 0.04 * freeboard * aft**2

    row = np.linspace(0.0, 1.0, points)[None, :]
    round_y = np.sin(0.46 * np.pi * row) / np.sin(0.46 * np.pi)
    # Level at the keel: the first two points are at one height.
    lift = np.clip((points - 1) * row - 1.0, 0.0, None) / (points - 2)
    round_z = (1.0 - np.cos(0.46 * np.pi * lift)) / (1.0 - np.cos(0.46 * np.pi))
    sharp = 0.7 * fore**1.8
    y = sheer_y * (round_y + (row - round_y) * sharp)
    z = keel + (sheer_z - keel) * (round_z + (row - round_z) * sharp)
    x = dimensions.length * x + (z - draft) * (_STEM_LEAN * fore**1.8 + _TRANSOM_RAKE * aft**2)
    grid = np.stack([x, y, z], axis=-1)
    move_foot(grid, along=0.3, up=0.1)
    return grid
