# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth lines through the few points of a table, straight where the table is flat."""

import numpy as np

from .beside import points_at, smooth_curve

# Points that a spline is laid through at least.
_LEAST = 4


def line_through(points, parameters, parts, is_sharp=None, flats=(), start=None, end=None):
    """(parts * (n - 1) + 1, 3) places along a line through points (n, 3) with rising parameters
    (n,), `parts` of them evenly between two points. is_sharp (n,): where it has knuckles. flats:
    pairs (first, last) of points between which it is straight; it is tangent to that at its ends.
    start, end: directions (3,) that it begins and ends along.
    """
    steps = np.arange(parts * (len(points) - 1) + 1) / parts
    at = np.interp(steps, np.arange(len(points)), parameters)
    fine = points_at(points, parameters, at)
    sharp = set() if is_sharp is None else set(np.flatnonzero(is_sharp).tolist())
    cuts = {0, len(points) - 1, *sharp, *(border for flat in flats for border in flat)}
    cuts = sorted(cut for cut in cuts if 0 <= cut < len(points))
    straight = {i for first, last in flats for i in range(first, last)}
    tangents = {
        border: points[last] - points[first]
        for first, last in flats
        for border in (first, last)
        if border not in sharp
    }
    tangents.update({at: way for at, way in ((0, start), (len(points) - 1, end)) if way is not None})
    for low, high in zip(cuts, cuts[1:]):
        if low in straight:
            continue
        inner = slice(parts * low, parts * high + 1)
        fine[inner] = _piece(
            points[low : high + 1], parameters[low : high + 1], at[inner],
            tangents.get(low), tangents.get(high),
        )  # fmt: skip
    return fine


def _piece(points, parameters, at, at_start, at_end):
    """Places of a smooth curve; where it ends along a direction (3,) it goes on as its mirror image
    there, so that it ends along that."""
    line, along = [points], [parameters]
    if at_start is not None:
        line.insert(0, _mirrored(points[:0:-1], points[0], at_start))
        along.insert(0, 2.0 * parameters[0] - parameters[:0:-1])
    if at_end is not None:
        line.append(_mirrored(points[-2::-1], points[-1], at_end))
        along.append(2.0 * parameters[-1] - parameters[-2::-1])
    line, along = np.concatenate(line), np.concatenate(along)
    if len(line) < _LEAST:
        return points_at(line, along, at)
    return np.asarray(smooth_curve(line, 0.0, parameters=along).evaluate(at))


def _mirrored(points, centre, direction):
    unit = direction / np.linalg.norm(direction)
    return points - 2.0 * ((points - centre) @ unit)[:, None] * unit


def runs(is_same):
    """Pairs (first, last) of points between which all steps (n - 1,) are the same."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], is_same, [False]]).astype(int)))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist()))
