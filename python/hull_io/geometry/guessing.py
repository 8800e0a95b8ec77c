# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a ship's axes, ends, centre plane and base line are in what was read, and its unit.

A pure function of the geometry: the same for the same file, whatever way it is turned. Each answer
has a reason in a sentence; those that another answer is nearly as good for are named as doubts.
What the user knows is given, and the rest is guessed around it.
"""

from dataclasses import dataclass

import numpy as np

from .hull_cloud import HullCloud, cloud_points
from .values import METRES_PER_UNIT

AXES = ("+x", "-x", "+y", "-y", "+z", "-z")
# Lengths of ships and boats, models included, that a number without unit may mean, m.
_LONGEST_SHIP = 500.0
_SHORTEST_IN_MM = 2000.0
# Of the depth: how near to the lowest point an origin is taken for the base line.
_NEAR_BASE = 0.02
# Of the slabs along the hull: how many have their lowest point at 0 where that is the base line.
_KEEL_AT_ZERO = 0.15
# Of the length: how near to the after end an origin is taken for the after perpendicular.
_NEAR_END = 0.12
# Of the depth, where the stem is taken for the forward perpendicular: about the design waterline.
_WATERLINE = 0.6


@dataclass(frozen=True)
class Guess:
    """forward, port, up: AXES of the file. unit: a key of METRES_PER_UNIT. is_half: one side alone,
    which becomes the port one. origin: (3,) in the file's numbers, what is to be at x = y = z = 0:
    after perpendicular, centre plane, base line. length_pp, length, beam (of the whole), depth: m.
    reasons: a sentence for each of "axes", "forward", "up", "half", "unit", "base line",
    "perpendiculars". doubts: those of them that are to be looked at."""

    forward: str
    port: str
    up: str
    unit: str
    is_half: bool
    origin: tuple
    length_pp: float
    length: float
    beam: float
    depth: float
    reasons: dict
    doubts: tuple

    @property
    def metres_per_unit(self):
        return METRES_PER_UNIT[self.unit]

    def matrix(self):
        """(3, 3) from the file's axes to forward, port and up; a reflection where the file's axes
        or its side are the other way round."""
        return np.array([_direction(name) for name in (self.forward, self.port, self.up)])


def _direction(name):
    return np.eye(3)["xyz".index(name[1])] * (1.0 if name[0] == "+" else -1.0)


def guess_hull(geometry, *, forward=None, up=None, unit=None, is_half=None):
    """The Guess for a Geometry. forward, up (of AXES), unit and is_half: what is known.

    ValueError for what is no hull in space, and for values that can't be.
    """
    for name, value in (("forward", forward), ("up", up)):
        if value not in (None, *AXES):
            raise ValueError(f"{name} is one of {', '.join(AXES)}, not '{value}'.")
    if forward and up and forward[1] == up[1]:
        raise ValueError(f"forward is {forward} and up is {up}: give two different axes.")
    if unit not in (None, *METRES_PER_UNIT):
        raise ValueError(f"unit is one of {', '.join(METRES_PER_UNIT)}, not '{unit}'.")
    points = cloud_points(geometry)
    extents = np.ptp(points, axis=0)
    if not extents.min() > 1e-4 * extents.max():
        raise ValueError(
            f"{geometry.name}: all of it lies in one plane; a drawing's views have to be placed "
            "in space first."
        )
    return _Guesser(geometry, points, forward, up, unit, is_half).guess()


class _Guesser:
    def __init__(self, geometry, points, forward, up, unit, is_half):
        self.geometry, self.points = geometry, points
        self.wanted = {"forward": forward, "up": up, "unit": unit, "half": is_half}
        self.reasons, self.doubts = {}, []

    def guess(self):
        long_axis = self._long_axis()
        cloud = self._side_axis(long_axis)
        up = self._up(cloud)
        forward = self._forward(cloud, up)
        port = self._port(cloud, forward, up)
        unit = self._unit(cloud)
        origin, length_pp = self._origin(cloud, forward, up)
        scale = METRES_PER_UNIT[unit]
        beam = cloud.extent(cloud.side)
        if cloud.is_half:
            beam = 2.0 * np.abs(cloud.points[:, cloud.side] - cloud.centre).max()
        return Guess(
            forward,
            port,
            up,
            unit,
            cloud.is_half,
            tuple(origin),
            scale * length_pp,
            scale * cloud.extent(cloud.long),
            scale * beam,
            scale * cloud.extent(cloud.vertical),
            self.reasons,
            tuple(self.doubts),
        )

    def _tell(self, about, reason, is_doubtful=False):
        self.reasons[about] = reason
        if is_doubtful:
            self.doubts.append(about)

    def _long_axis(self):
        if self.wanted["forward"]:
            return "xyz".index(self.wanted["forward"][1])
        if self.geometry.on_ship_axes:
            return 0
        return int(np.argmax(np.ptp(self.points, axis=0)))

    def _side_axis(self, long_axis):
        """The HullCloud with the athwartships axis and the centre plane of the best account."""
        others = [axis for axis in range(3) if axis != long_axis]
        if self.wanted["up"]:
            others.remove("xyz".index(self.wanted["up"][1]))
        elif self.geometry.on_ship_axes:
            others = [1]
        is_half = self.wanted["half"]
        if is_half is None:
            is_half = self.geometry.is_half
        plane = 0.0 if self.geometry.on_ship_axes else None
        choices = [
            choice
            for side in others
            for choice in HullCloud.accounts(self.points, long_axis, side, is_half, plane)
        ]
        choices.sort(key=lambda choice: choice.doubt)
        best = choices[0]
        letters = "xyz"
        near = any(other.side != best.side and other.doubt < best.doubt + 0.05 for other in choices)
        self._tell(
            "axes",
            f"The hull is longest along {letters[long_axis]}, and {letters[best.side]} is athwart.",
            near or best.doubt > 0.2,
        )
        self._tell("half", best.reason, best.doubt > 0.1)
        return best

    def _up(self, cloud):
        if self.wanted["up"]:
            self._tell("up", f"Up is {self.wanted['up']}, as told.")
            return self.wanted["up"]
        if self.geometry.on_ship_axes:
            self._tell("up", "Up is z, as tables and FREE!ship have it.")
            return "+z"
        fullness = cloud.fullness_above()
        name = ("+" if fullness >= 0.0 else "-") + "xyz"[cloud.vertical]
        reason = f"Up is {name}: the hull is broader there, or open."
        self._tell("up", reason, abs(fullness) < 0.03)
        return name

    def _forward(self, cloud, up):
        if self.wanted["forward"]:
            self._tell("forward", f"Forward is {self.wanted['forward']}, as told.")
            return self.wanted["forward"]
        first, last = cloud.breadths_at_ends(up[0] == "+")
        sign = "+" if last <= first else "-"
        name = sign + "xyz"[cloud.long]
        self._tell(
            "forward",
            f"Forward is {name}: the hull is finer at that end, above.",
            min(first, last) > 0.85 * max(first, last),
        )
        return name

    def _port(self, cloud, forward, up):
        """Of a half the side on which it is; else to the left of forward, seen from above."""
        letter = "xyz"[cloud.side]
        if cloud.is_half:
            middle = np.mean(cloud.points[:, cloud.side])
            return ("+" if middle >= cloud.centre else "-") + letter
        across = np.cross(_direction(up), _direction(forward))
        return ("+" if across[cloud.side] > 0.0 else "-") + letter

    def _unit(self, cloud):
        length = cloud.extent(cloud.long)
        told = self.wanted["unit"] or self.geometry.unit
        if told:
            who = "as told" if self.wanted["unit"] else "as the file tells"
            metres = length * METRES_PER_UNIT[told]
            is_odd = not 1.0 <= metres <= _LONGEST_SHIP
            self._tell("unit", f"Lengths are in {told}, {who}: the hull is {metres:.3g} m.", is_odd)
            return told
        unit = "m" if length <= _LONGEST_SHIP else "mm" if length >= _SHORTEST_IN_MM else "ft"
        metres = length * METRES_PER_UNIT[unit]
        self._tell(
            "unit",
            f"The file tells no unit; as {unit} the hull is {metres:.4g} m long.",
            unit != "mm",
        )
        return unit

    def _origin(self, cloud, forward, up):
        """((3,), Lpp) in the file's numbers."""
        origin = np.zeros(3)
        origin[cloud.side] = cloud.centre
        origin[cloud.vertical] = self._base(cloud, up)
        after, fore = self._perpendiculars(cloud, forward, up)
        origin[cloud.long] = after
        return origin, abs(fore - after)

    def _base(self, cloud, up):
        lowest = cloud.end(cloud.vertical, up[0] == "-")
        if abs(lowest) <= _NEAR_BASE * cloud.extent(cloud.vertical):
            self._tell("base line", f"The file's own 0 along {up[1]} is at the lowest point.")
            return 0.0
        if cloud.share_ending_at_zero(up[0] == "+") >= _KEEL_AT_ZERO:
            self._tell(
                "base line",
                f"The file's own 0 along {up[1]} is along the keel; parts lie below it.",
                True,
            )
            return 0.0
        self._tell(
            "base line",
            f"It is laid through the lowest point, {lowest:.6g} along {up[1]}.",
            cloud.low(cloud.vertical) < 0.0 < cloud.high(cloud.vertical),
        )
        return lowest

    def _perpendiculars(self, cloud, forward, up):
        is_positive = forward[0] == "+"
        after_end = cloud.end(cloud.long, not is_positive)
        length = cloud.extent(cloud.long)
        after = 0.0 if abs(after_end) <= _NEAR_END * length else after_end
        height = cloud.end(cloud.vertical, up[0] == "-")
        height += (1.0 if up[0] == "+" else -1.0) * _WATERLINE * cloud.extent(cloud.vertical)
        fore = cloud.end_at_height(height, is_positive)
        at = "the file's own 0" if after == 0.0 else "the after end"
        self._tell(
            "perpendiculars",
            f"The after one is at {at}, the forward one where the stem is at {_WATERLINE:.0%} of "
            "the depth.",
            True,
        )
        return after, fore
