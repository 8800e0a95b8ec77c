# SPDX-License-Identifier: GPL-3.0-or-later
"""Stations and waterlines of a table as smooth lines that a surface is fitted to: stations from the
keel to the deck, waterlines to where the profile or a flat end has their height."""

import numpy as np

from .beside import lengths_along
from .smooth_lines import line_through, runs

# Of the length: what tables round away where a line is straight; points are the same.
_FLAT, _SAME = 1e-5, 1e-6
# Places of a line between two of its points.
_FINE = 12
# How much of the last breadth a chord drawn on from the last two points has left in the centre
# plane, where a line ends square to that: it is round there, as a bulb is; with less it is sharp.
_ROUND = 0.55


def station_line(station, length):
    """(n, 3) along a smooth curve through a station's points, but for its knuckles; flat bottom and
    flat side are straight."""
    points, tolerance = station.points, _FLAT * length
    if station.is_dense:
        return points.copy()
    flats = runs(np.abs(np.diff(points[:, 2])) < tolerance)[:1]
    flats = [flat for flat in flats if flat[0] == 0]
    has_bottom = bool(flats)
    outermost = np.abs(points[:, 1] - points[:, 1].max()) < tolerance
    flats += runs(outermost[1:] & outermost[:-1])
    start = None
    if not has_bottom and len(points) > 2 and points[0, 1] < _SAME * length:
        start = np.array([0.0, 1.0, 0.0]) if _is_round(points[:3, 1:], False) else None
    fine = line_through(points, _centripetal(points), _FINE, station.sharp, flats, start=start)
    fine[:, 0] = station.x
    fine[:, 1] = np.maximum(fine[:, 1], 0.0)
    return fine


def waterline_lines(curves):
    """Lists of (n, 3): the pieces of each waterline of TableCurves, from aft."""
    found = [line if line[0, 0] < line[-1, 0] else line[::-1] for line in curves.drawn]
    for z in curves.levels:
        for piece in _pieces(curves, z):
            line = _waterline(curves, *piece)
            if line is not None:
                found.append(line)
    return found


def _pieces(curves, z):
    """(points (n, 3), whether its ends are in the centre plane) of runs of stations at a height."""
    tolerance = _SAME * curves.length
    values = [station.at_height(z, tolerance) for station in curves.stations]
    run, runs_of = [], []
    for i, y in enumerate([*values, None]):
        if y is not None:
            run.append(i)
        elif run:
            runs_of.append(run)
            run = []
    for run in runs_of:
        points = [(curves.stations[i].x, values[i], z) for i in run]
        ends = []
        for is_aft in (True, False):
            first = points[0 if is_aft else -1]
            if first[1] <= tolerance:
                ends.append(True)
                continue
            beyond = run[0] - 1 if is_aft else run[-1] + 1
            limit = curves.stations[beyond].x if 0 <= beyond < len(curves.stations) else None
            end = _end_at(curves, z, first, limit, is_aft)
            if end is None:
                ends.append(False)
                continue
            ends.append(end[1] == 0.0)
            points = [end, *points] if is_aft else [*points, end]
        yield np.array(points), ends


def _end_at(curves, z, first, limit, is_aft):
    """Where the rim of a flat end, or the profile, has the height, next beyond the first point of a
    waterline and not beyond the limit. None without."""
    rim = curves.aft if is_aft else curves.forward
    if rim is not None and limit is None and rim[:, 2].min() < z < rim[:, 2].max():
        i = int(np.argmax((rim[:-1, 2] <= z) & (rim[1:, 2] > z)))
        share = (z - rim[i, 2]) / (rim[i + 1, 2] - rim[i, 2])
        place = rim[i] + share * (rim[i + 1] - rim[i])
        far = abs(place[0] - first[0]) > 1e-4 * curves.length
        return tuple(place) if far else None
    line, side = curves.profile, -1.0 if is_aft else 1.0
    off = line[:, 2] - z
    at = np.flatnonzero((off[:-1] <= 0.0) != (off[1:] <= 0.0))
    share = off[at] / (off[at] - off[at + 1])
    xs = line[at, 0] + share * (line[at + 1, 0] - line[at, 0])
    ahead = side * (xs - first[0])
    near = ahead > -1e-4 * curves.length
    if limit is not None:
        near &= ahead < abs(limit - first[0]) + 1e-3 * curves.length
    if not near.any():
        return None
    x = xs[near][np.argmin(ahead[near])]
    return (float(x), 0.0, z) if side * (x - first[0]) > 1e-4 * curves.length else None


def _waterline(curves, points, is_central):
    if len(points) < 2 or np.ptp(points[:, 0]) < 1e-3 * curves.length:
        return None
    is_same = np.abs(np.diff(points[:, 1])) < _FLAT * curves.length
    square = np.array([0.0, 1.0, 0.0])
    start = square if is_central[0] and _is_round(points[:3, :2], True) else None
    end = square if is_central[1] and _is_round(points[:-4:-1, :2], True) else None
    line = line_through(
        points, lengths_along(points), _FINE, flats=runs(is_same), start=start, end=end
    )
    line[:, 1] = np.maximum(line[:, 1], 0.0)
    line[:, 2] = points[0, 2]
    return line


def _is_round(points, is_across):
    """Whether a line that ends in the centre plane with the first of three points (along it, across
    it) is square to that there. is_across: the second coordinate is the one from the plane."""
    if len(points) < 3:
        return False
    along, off = (points[:, 0], points[:, 1]) if is_across else (points[:, 1], points[:, 0])
    if abs(along[1] - along[2]) < 1e-12 or off[1] <= 0.0:
        return abs(along[1] - along[2]) < 1e-12
    slope = (off[1] - off[2]) / (along[1] - along[2])
    return off[1] + slope * (along[0] - along[1]) > _ROUND * off[1]


def _centripetal(line):
    """Parameters (n,) of points that may be far apart beside such as are close: splines by their
    distances would bulge there."""
    return np.concatenate([[0.0], np.cumsum(np.sqrt(np.diff(lengths_along(line))))])
