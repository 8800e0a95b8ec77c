# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of a hull before and after a change, in frames of a page."""

import hull_native as hn
import numpy as np

from . import paper

BEFORE, AFTER = (0.52, 0.56, 0.62), (0.07, 0.20, 0.50)
TITLE = 3.6  # mm
_STEP, _ON_EDGE = 0.1, 1e-6  # m


class Frame:
    """A part of the page, left and top in mm, where points from low (2,) to high (2,), m, are drawn
    in `scale` millimetres a metre; upwards in `stretch` times as many."""

    def __init__(self, left, top, scale, low, high, stretch=1.0):
        self.left, self.top, self.low, self.high = left, top, np.array(low), np.array(high)
        self.scale, self.upwards = scale, stretch * scale
        self.bottom = top + (self.high - self.low)[1] * self.upwards

    def at(self, points):
        """(n, 2) on the page of points (n, 2) in m."""
        right = self.left + (points[:, 0] - self.low[0]) * self.scale
        return np.stack([right, self.top + (self.high[1] - points[:, 1]) * self.upwards], axis=-1)

    def line(self, context, points, width, colour, dashes=()):
        """What is within the frame of a line through points (n, 2)."""
        inside = ((self.low - _ON_EDGE <= points) & (points <= self.high)).all(axis=1)
        borders = np.flatnonzero(np.diff(np.concatenate([[0], inside, [0]])))
        for first, last in zip(borders[::2], borders[1::2]):
            if last - first > 1:
                paper.line(context, self.at(points[first:last]), width, colour, dashes)

    def title(self, context, words):
        place = self.left, self.top - 2.0
        paper.text(context, place, words, TITLE, align=0.0, bold=True)


def cuts(surface, axis, places):
    """Points (n, 3) of each section across an axis, "x", "y" or "z"."""
    planes = np.zeros((len(places), 4))
    planes[:, "xyz".index(axis)], planes[:, 3] = 1.0, places
    found = hn.section_fairness(surface, planes, step=_STEP, marks=False)
    return [curve.points for curves in found for curve in curves]


def paint_both(context, frame, axes, before, after):
    """Curves (n, 3) of both, seen along the axis that is not in `axes`."""
    for curves, width, colour in ((before, 0.25, BEFORE), (after, 0.22, AFTER)):
        for points in curves:
            frame.line(context, points[:, axes], width, colour)
