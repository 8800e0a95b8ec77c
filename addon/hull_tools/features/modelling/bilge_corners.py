# SPDX-License-Identifier: GPL-3.0-or-later
"""The circle of a bilge between the flats of its section; arrays only. Places in a section are
(y, z)."""

import numpy as np

from .bilge_sections import BilgeError, beyond, in_plane


class Corner:
    """The circle of a radius between two flats, in a section's plane. angle: between the flats'
    directions, radians."""

    def __init__(self, radius, angle, centre, along, outwards):
        self.radius, self.angle, self._centre = radius, angle, centre
        self._frame = np.array([along, -outwards])  # rows: along the bottom, inwards

    def places(self, unit):
        """(k, 2) of (k, 2) that are for the circle of radius 1 around the origin."""
        return self._centre + self.radius * np.asarray(unit) @ self._frame

    def _to_unit(self, places):
        return (places - self._centre) @ self._frame.T / self.radius

    def _flat(self, k):
        """(point where the circle touches flat k, the way out of the bilge in it), for radius 1."""
        if k == 0:
            return np.array([0.0, -1.0]), np.array([-1.0, 0.0])
        c, s = np.cos(self.angle), np.sin(self.angle)
        return np.array([s, -c]), np.array([c, s])

    def outer_distance(self, k, point):
        """How far beyond the circle a point (3,) of flat 0 (bottom) or 1 (side) is, in radii."""
        touch, out = self._flat(k)
        return float((self._to_unit(point[1:]) - touch) @ out)

    def refuse_beyond_flats(self, section, points, arc):
        """BilgeError when points come to lie beyond the next points of the flats."""
        for k, end in enumerate((section.bottom, section.side)):
            last = (arc[0], arc[1]) if k == 0 else (arc[-1], arc[-2])
            last = beyond(*last)[0] if end.is_moved else last[0]
            limit = end.further if end.is_moved else end.outer
            touch, out = self._flat(k)
            if limit is not None and (last - touch) @ out >= self.outer_distance(k, points[limit]):
                raise BilgeError(
                    f"The radius is too large: the flat {('bottom', 'side')[k]} would end beyond "
                    "its next control point"
                )

    def deviation(self, places):
        """The largest distance from the circle of the places (k, 2) on a section between the flats,
        in m; None when none is near it."""
        unit = self._to_unit(places)
        turn = np.arctan2(unit[:, 0], -unit[:, 1])
        off = np.abs(np.hypot(*unit.T) - 1.0)
        near = (turn >= 0.0) & (turn <= self.angle) & (off < 0.5)
        return float(off[near].max() * self.radius) if near.any() else None


def corner_of(section, points, radius):
    """The Corner of a BilgeSection. BilgeError where its flats do not meet, or meet too flatly."""
    low, _, along, up = _flats(section, points)
    angle, turn = _angle(along, up)
    t = _to_meeting(section, points)[0]
    touch = low + along * (t - radius * np.tan(0.5 * angle))
    inwards = np.sign(turn) * np.array([-along[1], along[0]])
    return Corner(radius, angle, touch + radius * inwards, along, -inwards)


def present_radius(section, points):
    """The radius of the largest circle that touches the flats between the borders as they are."""
    _, _, along, up = _flats(section, points)
    return min(_to_meeting(section, points)) / np.tan(0.5 * _angle(along, up)[0])


def _flats(section, points):
    """(border of the bottom, border of the side, direction of the bottom, of the side)."""
    places = in_plane(points)
    low, high = places[section.row[0]], places[section.row[-1]]
    along = _way(places, section.bottom.outer, section.row[0])
    up = _way(places, section.row[-1], section.side.outer)
    if along is None:
        along = np.array([np.sign(high[0] - low[0]) or 1.0, 0.0])
    return low, high, along, np.array([0.0, 1.0]) if up is None else up


def _angle(along, up):
    """(radians that the side is turned from the bottom, positive; the signed sine)."""
    turn = along[0] * up[1] - along[1] * up[0]
    angle = float(np.arctan2(abs(turn), along @ up))
    if not np.radians(10.0) <= angle <= np.radians(170.0):
        raise BilgeError(
            f"The flats beside the bilge are turned by {np.degrees(angle):.1f}° only: there must "
            "be a flat bottom and a flat side, 10° to 170° apart"
        )
    return angle, turn


def _to_meeting(section, points):
    """Distances along the bottom and the side from their borders to where the flats meet."""
    low, high, along, up = _flats(section, points)
    _, turn = _angle(along, up)
    way = high - low
    return (way[0] * up[1] - way[1] * up[0]) / turn, (along[0] * way[1] - along[1] * way[0]) / turn


def _way(places, start, end):
    """The direction from one point to another; None without one of them."""
    if start is None or end is None:
        return None
    way = places[end] - places[start]
    length = np.linalg.norm(way)
    return way / length if length > 0.0 else None
