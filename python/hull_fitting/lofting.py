# SPDX-License-Identifier: GPL-3.0-or-later
"""Stations of a table of offsets as a surface of triangles between them."""

from dataclasses import replace

import numpy as np

from .beside import GeometryMesh, bend_shares, end_to_end, foot_on, lengths_along, points_at
from .smooth_lines import line_through, runs

# Stations at least; of the length: how far points of one may be from its plane, and ends of its
# pieces from one another; how far the profile reaches beyond the last one where that is no end.
_LEAST, _IN_PLANE, _JOINED, _BEYOND = 5, 1e-6, 1e-3, 2e-3
# Of the length: what tables round away where a line is straight.
_FLAT = 1e-5
# Places of a station's curve between two of its points, across the surface, and along it between
# two stations.
_FINE, _ACROSS, _ALONG = 16, 96, 8


def lofted(geometry):
    """An oriented Geometry of a half hull with a mesh through its stations, from keel to deck, and
    to stem and stern where the profile goes on to there. ValueError where there are fewer than five
    stations."""
    length = float(np.ptp(geometry.all_points()[:, 0]))
    stations = _stations(geometry, length)
    if len(stations) < _LEAST:
        raise ValueError(
            f"{geometry.name}: it has no surface and {len(stations)} stations from the keel to the "
            f"deck; give a surface, or {_LEAST} stations at least."
        )
    if np.median([line[0, 1] for line, _ in stations]) > _JOINED * length:
        raise ValueError(
            f"{geometry.name}: its stations do not begin at the centre plane; give the heights of "
            "the keel, as a line Profile or Buttock 0."
        )
    rows = [_places(line, knuckles, _FLAT * length) for line, knuckles in stations]
    profile = _profile(geometry)
    if profile is not None:
        for number, is_aft in ((0, True), (-1, False)):
            end = _end_row(profile, rows[number], is_aft, length)
            if end is not None:
                rows.insert(0 if is_aft else len(rows), end)
    mesh = GeometryMesh(*_surface(np.array(rows), _FLAT * length), name="lofted", is_exact=False)
    return replace(geometry, meshes=(mesh,))


def _stations(geometry, length):
    """(line (n, 3) from the keel upwards, points (n,) that are knuckles) of stations, from aft."""
    at_x = {}
    for curve in geometry.curves:
        if curve.kind == "station" and np.ptp(curve.points[:, 0]) < _IN_PLANE * length:
            key = round(float(curve.points[0, 0]) / (_JOINED * length))
            at_x.setdefault(key, []).append(curve)
    found = []
    for key in sorted(at_x):
        curves = at_x[key]
        lines = end_to_end([curve.points for curve in curves], _JOINED * length, -2.0)
        line = max(lines, key=lambda one: lengths_along(one)[-1])
        if line[0, 1] > line[-1, 1]:
            line = line[::-1]
        sharp = np.concatenate([curve.points[curve.knuckles] for curve in curves])
        is_sharp = (line[:, None] == sharp[None]).all(axis=2).any(axis=1)
        if len(line) > 2:
            found.append((line, is_sharp))
    return found


def _places(line, is_sharp, tolerance):
    """(_ACROSS + 1, 3) along a smooth curve through a station's points, but for its knuckles; its
    flat bottom and flat side are straight."""
    flats = runs(np.abs(np.diff(line[:, 2])) < tolerance)[:1]
    flats = [flat for flat in flats if flat[0] == 0]
    outermost = np.abs(line[:, 1] - line[:, 1].max()) < tolerance
    flats += runs(outermost[1:] & outermost[:-1])
    fine = line_through(line, _centripetal(line), _FINE, is_sharp, flats)
    fine[:, 0] = line[0, 0]
    return points_at(fine, bend_shares(fine), np.linspace(0.0, 1.0, _ACROSS + 1))


def _centripetal(line):
    """Parameters (n,) of points that may be far apart beside such as are close: splines by their
    distances would bulge there."""
    return np.concatenate([[0.0], np.cumsum(np.sqrt(np.diff(lengths_along(line))))])


def _profile(geometry):
    lines = [curve.points for curve in geometry.curves if curve.kind == "profile"]
    if not lines:
        return None
    line = max(lines, key=lambda one: lengths_along(one)[-1])
    return line if line[0, 0] < line[-1, 0] else line[::-1]


def _end_row(profile, row, is_aft, length):
    """The part of the profile beyond the last station's keel, upwards; None where it ends there."""
    lengths = lengths_along(profile)
    foot, _ = foot_on(profile, lengths, row[0])
    end = profile[0 if is_aft else -1]
    if abs(end[0] - row[0, 0]) < _BEYOND * length or end[2] < row[0, 2]:
        return None
    beyond = lengths < foot if is_aft else lengths > foot
    line = np.vstack([points_at(profile, lengths, foot), profile[beyond][:: -1 if is_aft else 1]])
    return points_at(line, lengths_along(line), np.linspace(0.0, lengths_along(line)[-1], len(row)))


def _surface(rows, tolerance):
    """(points, triangles) through rows (n, m, 3)."""
    at = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(rows[:, :, 0], axis=0)).mean(axis=1))])
    lines = []
    for line in rows.transpose(1, 0, 2):
        is_same = (np.abs(np.diff(line[:, 1:], axis=0)) < tolerance).all(axis=1)
        lines.append(line_through(line, at, _ALONG, flats=runs(is_same)))
    points = np.stack(lines, axis=1)
    points[:, :, 1] = np.maximum(points[:, :, 1], 0.0)
    points[:, 0, 1] *= rows[:, 0, 1].any()
    numbers = np.arange(points.shape[0] * points.shape[1]).reshape(points.shape[:2])
    a, b = numbers[:-1, :-1].ravel(), numbers[1:, :-1].ravel()
    c, d = numbers[1:, 1:].ravel(), numbers[:-1, 1:].ravel()
    triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return points.reshape(-1, 3), triangles
