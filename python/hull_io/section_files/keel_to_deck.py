# SPDX-License-Identifier: GPL-3.0-or-later
"""Stations as one line each: the port half, from the keel to the deck edge."""

from dataclasses import dataclass, field

import numpy as np

from ..errors import HullFileError
from ..limits import SEA_WATER_DENSITY
from ..mirror import NEAR_CENTRE_PLANE

# Of the hull's size: ends of branches that are nearer meet.
_MEETS = 1e-6


@dataclass(frozen=True)
class StationLine:
    """x: of the station, m. points: (n, 2) half-breadth and height, m, n >= 2, upwards from the
    centre plane. knuckles: (n,) bool."""

    x: float
    points: np.ndarray
    knuckles: np.ndarray

    @property
    def closed(self):
        """(points, knuckles) and the straight line from the end to the centre plane, as by a deck
        without camber, where the end is not there."""
        y, z = self.points[-1]
        if y == 0.0:
            return self.points, self.knuckles
        knuckles = np.append(self.knuckles, True)
        knuckles[-2] = True
        return np.vstack([self.points, [0.0, z]]), knuckles


@dataclass(frozen=True)
class Stations:
    """A ship by her sections. lines: StationLine, x rising. length_pp, beam, draft in m and
    water_density in t/m³, 0 where not given."""

    name: str
    lines: tuple = field(default_factory=tuple)
    length_pp: float = 0.0
    beam: float = 0.0
    draft: float = 0.0
    water_density: float = SEA_WATER_DENSITY


def station_lines(positions, sections, size):
    """A list of StationLine of cuts of a hull, or of her port half.

    positions: (n,) x in m. sections: n lists of branches with `points` (k, 3) and `knuckles`,
    indices, as hull_native.sections gives; size: of the hull, m. What is to starboard is left out.
    Branches above one another, as of a bulb, become one line by way of the centre plane. A station
    that has none is left out. HullFileError with its x for one that is no line from the centre
    plane, as of a catamaran.
    """
    found = []
    for x, branches in zip(positions, sections):
        parts = [part for branch in branches for part in _port_parts(branch, size)]
        if parts:
            found.append(_joined(float(x), _chains(parts, _MEETS * size), NEAR_CENTRE_PLANE * size))
    if not found:
        raise HullFileError("No station cuts the hull: give Lpp and the number of stations.")
    return found


def _port_parts(branch, size):
    """[(points (n, 2), knuckles (n,))] of a branch where y >= 0, cut at the centre plane and parted
    where it runs along that, as the border of a flat across the ship does."""
    points = np.array(branch.points)[:, 1:]
    knuckles = np.zeros(len(points), dtype=bool)
    knuckles[np.asarray(branch.knuckles, dtype=int)] = True
    points[np.abs(points[:, 0]) <= _MEETS * size, 0] = 0.0
    points, knuckles = _with_crossings(*_from_centre_plane(points, knuckles))
    is_port = np.maximum(points[:-1, 0], points[1:, 0]) > 0.0
    is_port &= np.minimum(points[:-1, 0], points[1:, 0]) >= 0.0
    ends = np.flatnonzero(np.diff(is_port.astype(int)) != 0) + 1
    for run in np.split(np.arange(len(is_port)), ends):
        if is_port[run[0]]:
            part = slice(run[0], run[-1] + 2)
            yield points[part], knuckles[part]


def _from_centre_plane(points, knuckles):
    """A line; a closed one begins at a point in the centre plane, if it has one."""
    at_zero = np.flatnonzero(points[:-1, 0] == 0.0)
    if len(points) < 3 or (points[0] != points[-1]).any() or not len(at_zero):
        return points, knuckles
    first = at_zero[0]
    knuckles = knuckles.copy()
    knuckles[0] |= knuckles[-1]
    order = np.append(np.arange(first, len(points) - 1), np.arange(first + 1))
    return points[order], knuckles[order]


def _with_crossings(points, knuckles):
    """The line with a point where a chord crosses the centre plane."""
    crossing = np.flatnonzero(points[:-1, 0] * points[1:, 0] < 0.0)
    share = points[crossing, 0] / (points[crossing, 0] - points[crossing + 1, 0])
    heights = points[crossing, 1] + share * (points[crossing + 1, 1] - points[crossing, 1])
    at_zero = np.column_stack([np.zeros(len(crossing)), heights])
    points = np.insert(points, crossing + 1, at_zero, axis=0)
    return points, np.insert(knuckles, crossing + 1, False)


def _chains(parts, nearness):
    """The parts, joined where their ends meet."""
    chains = list(parts)
    k = 0
    while k < len(chains):
        for other in range(k + 1, len(chains)):
            joined = _met(chains[k], chains[other], nearness)
            if joined is not None:
                chains[k] = joined
                del chains[other]
                break
        else:
            k += 1
    return chains


def _met(one, other, nearness):
    """Two chains as one, None where no ends off the centre plane meet."""
    for first in (one, _turned(one)):
        for second in (other, _turned(other)):
            end, start = first[0][-1], second[0][0]
            if end[0] > nearness and np.abs(end - start).max() <= nearness:
                knuckles = np.append(first[1], second[1][1:])
                return np.vstack([first[0], second[0][1:]]), knuckles
    return None


def _turned(chain):
    return chain[0][::-1], chain[1][::-1]


def _joined(x, chains, nearness):
    """The StationLine of chains, the lowest first; between them is the centre plane."""
    chains = sorted((_upwards(chain, nearness) for chain in chains), key=lambda c: c[0][:, 1].min())
    chains[0] = _from_the_centre(*chains[0], nearness)
    if any(line[0, 0] > 0.0 for line, _ in chains):
        raise _beside_one_another(x)
    points, knuckles = chains[0]
    for line, marks in chains[1:]:
        if points[-1, 0] == 0.0:
            marks = np.append(True, marks[1:])
            knuckles = np.append(np.append(knuckles[:-1], True), marks)
            points = np.vstack([points, line])
            continue
        # An appendage that goes into the hull: up to where it does, and on along the hull.
        met = _first_crossing(points, line)
        if met is None:
            raise _beside_one_another(x)
        i, k, place = met
        points = np.vstack([points[: i + 1], place, line[k + 1 :]])
        knuckles = np.concatenate([knuckles[: i + 1], [True], marks[k + 1 :]])
    knuckles[0] = knuckles[-1] = False
    keep = np.append(True, (np.diff(points, axis=0) != 0.0).any(axis=1))
    return StationLine(x, points[keep], knuckles[keep])


def _from_the_centre(line, marks, nearness):
    """The lowest chain with the level line to it from the centre plane where it begins lowest but
    beside that: a bar keel's side, or a bottom."""
    if line[0, 0] > 0.0 and line[0, 1] <= line[:, 1].min() + nearness:
        line, marks = np.vstack([[0.0, line[0, 1]], line]), np.append(False, marks)
        marks[1] = True
    return line, marks


def _beside_one_another(x):
    return HullFileError(
        f"The station at x = {x:.4g} m has parts beside one another, as of two hulls; this file "
        "knows one line from keel to deck: leave such stations out, or make one hull of them."
    )


def _first_crossing(low, high):
    """(i, k, place (2,)) where the chord i of a line first crosses the chord k of another; None
    where none does."""
    start, way = low[:-1, None], np.diff(low, axis=0)[:, None]
    other, other_way = high[None, :-1], np.diff(high, axis=0)[None]
    area = _cross(way, other_way)
    safe = np.where(area == 0.0, 1.0, area)
    share = _cross(other - start, other_way) / safe
    other_share = _cross(other - start, way) / safe
    crosses = (area != 0.0) & (share >= 0) & (share <= 1) & (other_share >= 0) & (other_share <= 1)
    found = np.argwhere(crosses)
    if not len(found):
        return None
    i, k = found[0]
    return i, k, low[i] + share[i, k] * (low[i + 1] - low[i])


def _cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _upwards(chain, nearness):
    """A chain that begins at its end in the centre plane, of two at the lower one."""
    (start, end) = chain[0][0], chain[0][-1]
    on_start, on_end = start[0] <= nearness, end[0] <= nearness
    if on_start == on_end:
        is_upwards = start[1] <= end[1]
    else:
        is_upwards = on_start
    line, marks = chain if is_upwards else _turned(chain)
    line = line.copy()
    if line[0, 0] <= nearness:
        line[0, 0] = 0.0
    if line[-1, 0] <= nearness:
        line[-1, 0] = 0.0
    return line, marks
