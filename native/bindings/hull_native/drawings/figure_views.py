# SPDX-License-Identifier: GPL-3.0-or-later
"""From where a hull's figures look at it, and which lights it mirrors then."""

from math import radians

import numpy as np

from .hidden_lines import Eye, view_axes

# Pairs of a light and a dark band all around the ship, along its length.
LIGHT_BANDS = 32
# Degrees: where the eye is, from the bow to port, and above the hull.
LIGHT_VIEWS = {"bow": (-42.0, -14.0), "stern": (-138.0, -14.0)}
# From the hull's middle to the eye, over the hull's length.
_DISTANCE = 2.2
# mm: of the page, and around the hull.
WIDTH, MARGIN = 270.0, 8.0
# mm: stubby hulls are no higher.
_HIGHEST = 120.0


class FigureView:
    """Points (n, 3) in perspective from one of LIGHT_VIEWS, as wide as the page; `height` in mm."""

    def __init__(self, points, name):
        self.axes = view_axes(*map(radians, LIGHT_VIEWS[name]))
        low, high = points.min(axis=0), points.max(axis=0)
        self.distance = _DISTANCE * float((high - low).max())
        self.eye = Eye(self.axes, points, self.distance)
        self.eye_position = 0.5 * (low + high) + self.distance * self.axes[2]
        seen = self.eye.seen(points)[:, :2]
        width, height = np.ptp(seen, axis=0)
        self.scale = min((WIDTH - 2 * MARGIN) / width, (_HIGHEST - 2 * MARGIN) / height)
        self.height = height * self.scale + 2 * MARGIN
        self._middle = 0.5 * (seen.min(axis=0) + seen.max(axis=0))

    def page(self, points):
        """Places (n, 2) of points (n, 3), mm, y downwards."""
        return self.flat(self.eye.seen(points))

    def flat(self, seen):
        """The same of what the eye has seen, (n, 2 or 3)."""
        away = np.asarray(seen)[:, :2] - self._middle
        return (0.5 * WIDTH, 0.5 * self.height) + away * (self.scale, -self.scale)

    def dots(self, points, dots_per_mm):
        """(n, 3): the same in dots, with the depth towards the eye."""
        seen = self.eye.seen(points)
        return np.column_stack([self.flat(seen) * dots_per_mm, seen[:, 2]])
