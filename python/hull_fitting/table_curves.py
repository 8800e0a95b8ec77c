# SPDX-License-Identifier: GPL-3.0-or-later
"""The curves of a table of offsets as those of a ship: stations, the whole profile, the deck edge,
flat ends, knuckles. What stations do not tell of the ends is taken from lines beside the table, or
waterlines are drawn on to the centre plane."""

from dataclasses import dataclass, field

import numpy as np

from .beside import end_to_end, foot_on
from .beside import hull_native as hn
from .beside import lengths_along, points_at

# Stations at least; points of a line that is drawn and no table's.
_LEAST, _DENSE = 5, 60
# Of the length: how far points of a station may be from its plane, ends of its pieces from one
# another.
_IN_PLANE, _JOINED = 1e-6, 1e-3
# Of the half-breadth: a station that ends broader is an end of the hull, if waterlines do not close
# within so many spacings of stations.
_BROAD, _CLOSES = 0.05, 1.5
# Of the length: a line across at an end is a transom's rim.
_RIM = 0.03


@dataclass
class Station:
    """x; points (n, 3) from the keel to the deck; sharp (n,): which are on a knuckle."""

    x: float
    points: np.ndarray
    sharp: np.ndarray

    @property
    def is_dense(self):
        """Whether it is a drawn curve rather than the few points of a table."""
        return len(self.points) > _DENSE

    def at_height(self, z, tolerance):
        """y of its points at a height; of several the largest. None without."""
        near = np.abs(self.points[:, 2] - z) < tolerance
        return float(self.points[near, 1].max()) if near.any() else None


@dataclass
class TableCurves:
    """near_centre: m, what is so near the centre plane is in it; profile (n, 3): from the deck aft
    along the contour to the deck forward; deck (n, 3): from aft; aft, forward: rims of flat ends,
    upwards, or None; knuckles: lines; levels: z of the waterlines of tables; drawn: waterlines
    (n, 3) that are curves themselves; is_told: whether the profile's ends were."""

    length: float
    near_centre: float
    stations: list
    profile: np.ndarray = None
    deck: np.ndarray = None
    aft: object = None
    forward: object = None
    knuckles: list = field(default_factory=list)
    levels: list = field(default_factory=list)
    drawn: list = field(default_factory=list)
    is_told: bool = True


def table_curves(geometry):
    """The TableCurves of an oriented Geometry of a half hull. ValueError where there are fewer than
    five stations from the keel to the deck."""
    extents = np.ptp(geometry.all_points(), axis=0)
    length = float(extents[0])
    near_centre = hn.tolerances.ON_CENTRE_PLANE * float(np.linalg.norm(extents))
    stations = _stations(geometry, length)
    found = TableCurves(length, near_centre, stations)
    waterlines = [curve.points for curve in _of(geometry, "waterline")]
    found.drawn = [points for points in waterlines if len(points) > _DENSE]
    found.levels = sorted({float(p[0, 2]) for p in waterlines if len(p) <= _DENSE})
    whole = [station for station in stations if len(station.points) > 2]
    if len(whole) < _LEAST:
        raise ValueError(
            f"{geometry.name}: it has no surface and {len(whole)} stations from the keel to the "
            f"deck; give a surface, or {_LEAST} stations at least."
        )
    if np.median([station.points[0, 1] for station in whole]) > _JOINED * length:
        raise ValueError(
            f"{geometry.name}: its stations do not begin at the centre plane; give the heights of "
            "the keel, as a line Profile or Buttock 0."
        )
    found.knuckles = [c.points for c in _of(geometry, "knuckle")]
    _find_profile(found, geometry)
    _find_deck(found, geometry)
    _find_ends(found, geometry)
    return found


def _of(geometry, *kinds):
    return [curve for curve in geometry.curves if curve.kind in kinds]


def _stations(geometry, length):
    at_x = {}
    for curve in _of(geometry, "station"):
        if np.ptp(curve.points[:, 0]) < _IN_PLANE * length:
            key = round(float(curve.points[0, 0]) / (_JOINED * length))
            at_x.setdefault(key, []).append(curve)
    found = []
    for key in sorted(at_x):
        curves = at_x[key]
        lines = end_to_end([curve.points for curve in curves], _JOINED * length, -2.0)
        sharp = np.concatenate([curve.points[curve.knuckles] for curve in curves])
        longest = max(lines, key=lambda one: lengths_along(one)[-1])
        for line in lines:
            if line is not longest and len(line) <= _DENSE:
                continue
            if line[0, 1] > line[-1, 1] or line[0, 1] == line[-1, 1] and line[0, 2] > line[-1, 2]:
                line = line[::-1]
            is_sharp = (line[:, None] == sharp[None]).all(axis=2).any(axis=1)
            found.append(Station(float(line[0, 0]), line, is_sharp))
    return [station for station in found if len(station.points) > 1]


def _find_profile(found, geometry):
    xs = np.array([station.x for station in found.stations])
    length, in_space = found.length, []
    for curve in _of(geometry, "profile"):
        off = np.abs(curve.points[:, :1] - xs).min(axis=1)
        if off.max() > 1e-6 * length or len(curve.points) > len(xs):
            in_space.append(curve.points)
    keel = np.array([s.points[0] for s in found.stations if s.points[0, 1] < found.near_centre])
    middle = 0.5 * (xs[0] + xs[-1])
    ends = {"aft": None, "forward": None}
    in_space = end_to_end(in_space, _JOINED * 1e-2 * length, -2.0)
    for line in in_space:
        line = line if line[0, 0] < line[-1, 0] else line[::-1]
        if line[0, 0] < middle < line[-1, 0]:
            found.profile = line
            return
        ends["aft" if line[:, 0].mean() < middle else "forward"] = line
    found.is_told = ends["aft"] is not None and ends["forward"] is not None
    parts = [keel.reshape(-1, 3)]
    if ends["aft"] is not None:
        parts[0] = parts[0][parts[0][:, 0] > ends["aft"][:, 0].max()]
        parts.insert(0, ends["aft"])
    if ends["forward"] is not None:
        begin = ends["forward"][:, 0].min()
        parts = [
            part if i < len(parts) - 1 else part[part[:, 0] < begin] for i, part in enumerate(parts)
        ]
        parts.append(ends["forward"])
    found.profile = np.concatenate(parts)
    if ends["aft"] is None:
        found.profile = _drawn_on(found, found.profile, True)
    if ends["forward"] is None:
        found.profile = _drawn_on(found, found.profile[::-1], False)[::-1]


def _drawn_on(found, profile, is_aft):
    """A profile that begins at an end with what waterlines tell of that end: they are drawn on to
    the centre plane. As it is where the hull has a flat end there."""
    stations = found.stations if is_aft else found.stations[::-1]
    closings = _closings(found, stations)
    if closings is None:
        return profile
    # Of the profile what rises from its lowest place to the end goes by its height, as closings do.
    lowest = int(np.argmin(profile[: max(1, len(profile) // 2), 2]))
    rising = np.arange(len(profile)) < lowest
    rising &= profile[:, 2] > min(place[2] for place in closings)
    upper = sorted([*closings, *map(tuple, profile[rising])], key=lambda place: -place[2])
    return np.concatenate([np.array(upper).reshape(-1, 3), profile[~rising]])


def _closings(found, stations):
    """(x, 0, z) where waterlines and the deck edge come to the centre plane beyond the stations, in
    the order of `stations` from that end; None where the hull ends flat."""
    tolerance = 1e-6 * found.length
    breadth = max(station.points[:, 1].max() for station in found.stations)
    pieces_at = _by_x(stations, tolerance)
    step = abs(pieces_at[:2][-1][0].x - pieces_at[0][0].x)
    lines = [[(p[0].x, _breadth(p, z, tolerance), z) for p in pieces_at] for z in found.levels]
    tops = [max(pieces, key=lambda piece: piece.points[-1, 2]) for pieces in pieces_at]
    lines.append([(s.x, float(s.points[-1, 1]), float(s.points[-1, 2])) for s in tops])
    places, reaches = [], []
    for line in lines:
        first = next((i for i, (_, y, _) in enumerate(line) if y is not None and y > 0.0), None)
        if first is None or first + 1 >= len(line):
            continue
        known = []
        for x, y, z in line[first:]:
            if y is None:
                break
            known.append((x, y, z))
        if len(known) < 2:
            continue
        beyond = line[first - 1][0] if first else None
        place, reach = _closing(known, beyond, step)
        if first and line[first - 1][1] == 0.0:
            place = line[first - 1]
        if first == 0 and known[0][1] > _BROAD * breadth:
            reaches.append(reach)
        places.append(place)
    if reaches and np.median(reaches) > _CLOSES * step:
        return None
    return places or None


def _by_x(stations, tolerance):
    """The pieces of each station: at a bulb drawn ones have two at one x."""
    found = []
    for station in stations:
        if found and abs(found[-1][0].x - station.x) <= tolerance:
            found[-1].append(station)
        else:
            found.append([station])
    return found


def _breadth(pieces, z, tolerance):
    found = [piece.at_height(z, tolerance) for piece in pieces]
    return max((y for y in found if y is not None), default=None)


def _closing(known, beyond, step):
    """((x, 0, z), how far from the first of the places (x, y, z) that is, m): the parabola through
    three places, or the line through two; no further than `beyond`."""
    (x, y, z), (x1, y1, z1) = known[:2]
    side = np.sign(x - x1)
    slope = (y1 - y) / abs(x1 - x)
    bend = 0.0
    if len(known) > 2:
        x2, y2, _ = known[2]
        second = (y2 - y1) / abs(x2 - x1)
        bend = (second - slope) / abs(x2 - x)
        slope = slope - bend * abs(x1 - x)
    # y - slope t + bend t² = 0 at t m beyond the first place; without such a place by the chord.
    roots = np.roots([bend, -slope, y]) if abs(bend) > 1e-12 else np.array([y / max(slope, 1e-12)])
    ahead = [float(root.real) for root in roots if abs(root.imag) < 1e-9 and root.real > 0.0]
    chord = (y1 - y) / abs(x1 - x)
    reach = min(ahead) if ahead else y / chord if chord > 0.0 else np.inf
    most = abs(beyond - x) if beyond is not None else step
    t = min(reach, most)
    rise = (z - z1) / abs(x1 - x) * t
    return (x + side * t, 0.0, z + rise), reach


def _find_deck(found, geometry):
    ends = np.array([station.points[-1] for station in found.stations])
    lines = [curve.points for curve in _of(geometry, "deck_edge")]
    lines = end_to_end(lines, 1e-5 * found.length, -2.0)
    line = max(lines, key=lambda one: np.ptp(one[:, 0])) if lines else ends
    found.deck = line if line[0, 0] < line[-1, 0] else line[::-1]


def _find_ends(found, geometry):
    """Rims of flat ends, or the first and the last station where the hull ends broad; the deck edge
    is drawn to the ends, and the profile ends there."""
    breadth = max(station.points[:, 1].max() for station in found.stations)
    across = [
        c.points
        for c in _of(geometry, "border", "edge")
        if np.ptp(c.points[:, 0]) < _RIM * found.length
    ]
    rims = [
        line if line[0, 1] < line[-1, 1] else line[::-1]
        for line in end_to_end(across, 1e-5 * found.length, -2.0)
        if np.ptp(line[:, 1]) > _BROAD * breadth
    ]
    for name, is_aft in (("aft", True), ("forward", False)):
        profile = found.profile if is_aft else found.profile[::-1]
        deck = found.deck if is_aft else found.deck[::-1]
        end = found.stations[0 if is_aft else -1]
        rim = next(
            (r for r in rims if abs(r[:, 0].mean() - profile[0, 0]) < _RIM * found.length), None
        )
        if rim is None and end.points[-1, 1] > _BROAD * breadth:
            if abs(profile[0, 0] - end.x) < _JOINED * found.length:
                rim = end.points
        if rim is not None:
            rim, profile, deck = _with_rim(found, rim, profile, deck, is_aft)
        elif np.linalg.norm(deck[0] - profile[0]) > 1e-6 * found.length:
            deck = np.vstack([profile[:1], deck])
        setattr(found, name, rim)
        found.profile = profile if is_aft else profile[::-1]
        found.deck = deck if is_aft else deck[::-1]


def _with_rim(found, rim, profile, deck, is_aft):
    """The rim from the profile to the deck edge, and these from there on."""
    side, length = 1.0 if is_aft else -1.0, found.length
    if rim[0, 1] > 0.0:
        lengths = lengths_along(profile)
        at, _ = foot_on(profile, lengths, rim[0] * [1.0, 0.0, 1.0])
        foot = points_at(profile, lengths, at)
        rim = np.vstack([foot, rim]) if rim[0, 1] > found.near_centre else rim
    lengths = lengths_along(profile)
    at, _ = foot_on(profile, lengths, rim[0])
    profile = np.vstack([rim[:1] * [1.0, 0.0, 1.0], profile[lengths > at + 1e-6 * length]])
    rim = np.vstack([profile[:1], rim[1:]])
    beyond = side * (deck[:, 0] - rim[:, 0].max() * 1.0) > 1e-6 * length
    if is_aft is False:
        beyond = deck[:, 0] < rim[:, 0].min() - 1e-6 * length
    deck = np.vstack([rim[-1:], deck[beyond]])
    return rim, profile, deck
