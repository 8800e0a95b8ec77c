# SPDX-License-Identifier: GPL-3.0-or-later
"""The deadrise of a planing boat's bottom, from the exact hull."""

import math

import numpy as np

from .. import _core
from .side_by_side import is_side_by_side

_STATIONS = 40


def bottom_deadrise(body, *, draft, trim=0.0, draft_at=0.0):
    """Mean angle in rad by which the bottom of a HullBody rises from keel to chine.

    The bottom is what of the sections in the after half of the waterline lies below the water
    (draft in m at x = draft_at, trim in rad by the stern) and is flatter than 45°: on that half a
    boat planes, and steeper parts are sides. The tangent is what it rises outwards, of its breadth,
    over all these sections: that of a prismatic V to rounding, and that of the chord across rails
    and hollows. Not below 0. ValueError for a hull out of the water, for hulls beside one another,
    whose keels are not amidships, and where nothing is so flat.
    """
    water = _core.hydrostatics(body, draft=draft, trim=trim, draft_at=draft_at)
    if not water.waterline_length > 0.0:
        raise ValueError(f"The hull is out of the water at a draft of {draft:.4g} m: set it.")
    if is_side_by_side(body, water, draft, trim, draft_at):
        raise ValueError(
            "Hulls beside one another have no bottom that rises from one keel: give the deadrise."
        )
    step = 0.5 * water.waterline_length / _STATIONS
    stations = water.waterline_aft + step * (np.arange(_STATIONS) + 0.5)
    planes = np.column_stack([np.tile((1.0, 0.0, 0.0), (_STATIONS, 1)), stations])
    rise = breadth = 0.0
    for x, curves in zip(stations, _core.sections(body.surface, planes)):
        level = draft - (x - draft_at) * math.tan(trim)
        for curve in curves:
            gains = _rise_and_breadth(np.asarray(curve.points)[:, 1:], level)
            rise, breadth = rise + gains[0], breadth + gains[1]
    if not breadth > 0.0:
        raise ValueError(
            "The hull has no bottom flatter than 45° in the after half of the waterline: give the "
            "deadrise."
        )
    return max(math.atan2(rise, breadth), 0.0)


def _rise_and_breadth(points, level):
    """Of a section's points (n, 2), y and z, below the water: what its flat parts rise outwards,
    and their breadth."""
    y, z = points[:, 0], points[:, 1]
    across, up = np.diff(y), np.diff(z)
    outwards = np.sign(across) * np.sign(y[:-1] + y[1:])
    low = np.minimum(z[:-1], z[1:])
    steps = np.where(up == 0.0, 1.0, np.abs(up))
    below = np.where(up == 0.0, low <= level, np.clip((level - low) / steps, 0.0, 1.0))
    below *= np.abs(up) <= np.abs(across)
    return float(np.sum(below * up * outwards)), float(np.sum(below * np.abs(across)))
