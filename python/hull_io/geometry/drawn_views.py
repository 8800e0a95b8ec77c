# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the three views of a lines plan are on its sheet, by its layers BASE_LINE and
CENTRE_LINE."""

from dataclasses import dataclass

import numpy as np

# Of a lines plan that can be put together.
LAYERS = ("BASE_LINE", "CENTRE_LINE", "GRID", "STATIONS", "WATERLINES", "OUTLINE")
# Places on a spline between two of its knots.
PER_SPAN = 24
# Of the distance of two views: curves reach so far below their lines.
_BELOW = 0.1


def sampled(curve):
    """(n, 3), of a spline by its knots: two views of one curve have the same places."""
    spline = curve.spline
    if spline is None:
        return curve.points
    knots = np.unique(np.clip(spline.knots, spline.start, spline.end))
    steps = np.arange(PER_SPAN * (len(knots) - 1) + 1) / PER_SPAN
    return spline.evaluate(np.interp(steps, np.arange(len(knots)), knots))


@dataclass(frozen=True)
class Views:
    """base: y of the profile's base line; centre: y of the half-breadth plan's centre line; body:
    (x of the body plan's centre line, y of its base line); body_box: (low (2,), high (2,))."""

    base: float
    centre: float
    body: tuple
    body_box: tuple

    def view_of(self, points):
        low, high = self.body_box
        if (points >= low).all() and (points <= high).all():
            return "body"
        # Both are drawn upwards from their lines; a keel may be a little below.
        lower, upper = sorted((self.base, self.centre))
        is_upper = points[:, 1].mean() > upper - _BELOW * (upper - lower)
        return "profile" if is_upper == (self.base > self.centre) else "plan"

    def in_ship(self, points, view):
        """(n, 2): (x, z) in the profile, (x, y) in the plan, (y, z) in the body plan."""
        if view == "profile":
            return points - [0.0, self.base]
        if view == "plan":
            return points - [0.0, self.centre]
        placed = points - list(self.body)
        placed[:, 0] = np.abs(placed[:, 0])
        return placed


def views_of(layers):
    lines = {name: np.array([c[[0, -1]] for c in layers[name]]) for name in LAYERS[:2]}
    level = {
        name: one[np.abs(one[:, 0, 1] - one[:, 1, 1]) < 1e-9 * np.ptp(one)]
        for name, one in lines.items()
    }
    upright = [one for one in lines["CENTRE_LINE"] if one[0, 0] == one[1, 0]]
    if len(level["BASE_LINE"]) < 2 or not len(level["CENTRE_LINE"]) or len(upright) != 1:
        return None
    bases = sorted(level["BASE_LINE"], key=lambda one: np.ptp(one[:, 0]))
    body, profile = bases[0], bases[-1]
    middle = upright[0]
    low = np.array([body[:, 0].min(), middle[:, 1].min()])
    high = np.array([body[:, 0].max(), middle[:, 1].max()])
    return Views(
        float(profile[0, 1]), float(level["CENTRE_LINE"][0, 0, 1]),
        (float(middle[0, 0]), float(body[0, 1])), (low, high),
    )  # fmt: skip
