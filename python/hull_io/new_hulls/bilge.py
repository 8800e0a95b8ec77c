# SPDX-License-Identifier: GPL-3.0-or-later
"""Control points of a midship section: flat bottom, round bilge, flat side."""

import numpy as np

# Points of a section in the bottom and in the side, at least: three in a line make the surface
# straight from the first on.
BOTTOM_POINTS = 3
SIDE_POINTS = 3
LEAST_POINTS = BOTTOM_POINTS + SIDE_POINTS


# By the number of points between bottom and side, for a bilge of radius 1: how far the outermost
# point of bottom and side is from the corner between them, how far the next is, distance of the
# points between from the circle's centre, and the angle of the first of two.
_BILGES = (
    (0.564, 1.169, None, None),
    (0.727, 1.200, 1.051, 0.25 * np.pi),
    (0.811, 1.180, 1.030, 0.571),
)


def section(half_beam, depth, radius, points):
    """Control points (points, 2) of y and z: from (0, 0) along z = 0, then y = half_beam up to
    depth, with a bilge near to a circle of `radius` between; points >= 6.

    The surface is flat in the bottom up to the bilge and in the side from the bilge on.
    """
    inner = min((points - LEAST_POINTS + 1) // 2, len(_BILGES) - 1)
    first, second, ring, angle = _BILGES[inner]
    first, second = first * radius, second * radius
    bottom_points = BOTTOM_POINTS + (points - LEAST_POINTS - inner) // 2
    low = np.linspace(0.0, half_beam - second, bottom_points - 1)
    bottom = [(y, 0.0) for y in low] + [(half_beam - first, 0.0)]
    angles = [angle, 0.5 * np.pi - angle][:inner] if inner else []
    arc = [
        (
            half_beam + radius * (ring * np.sin(a) - 1.0),
            radius * (1.0 - ring * np.cos(a)),
        )
        for a in angles
    ]
    side_points = points - len(bottom) - inner
    high = np.linspace(second, depth, side_points - 1)
    side = [(half_beam, first)] + [(half_beam, z) for z in high]
    return np.array(bottom + arc + side)
