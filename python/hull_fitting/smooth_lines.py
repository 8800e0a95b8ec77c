# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth lines through the few points of a table, straight where the table is flat."""

import numpy as np

from .beside import points_at, smooth_curve
from .conic_pieces import bend_of, between, tangents_at

# Points that a spline is laid through at least.
_LEAST = 4
# Degrees: what is said to be a knuckle and turns by no more is none.
_RIM = 12.0
# Cosine of the turn from chord to chord at a point beside which conics are better than a spline.
_TURNS = np.cos(np.radians(22.0))


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
    sharp = {number for number in sharp if not _is_smooth(points, number)}
    cuts = {0, len(points) - 1, *sharp, *(border for flat in flats for border in flat)}
    cuts = sorted(cut for cut in cuts if 0 <= cut < len(points))
    straight = {i for first, last in flats for i in range(first, last)}
    tangents = {
        border: points[last] - points[first]
        for first, last in flats
        for border in (first, last)
        if border not in sharp
    }
    tangents.update(
        {at: way for at, way in ((0, start), (len(points) - 1, end)) if way is not None}
    )
    for low, high in zip(cuts, cuts[1:]):
        if low in straight:
            continue
        inner = slice(parts * low, parts * high + 1)
        fine[inner] = _piece(
            points[low : high + 1], parameters[low : high + 1], at[inner],
            tangents.get(low), tangents.get(high),
        )  # fmt: skip
    return fine


def _is_smooth(points, at):
    """Whether a line (in a plane across) turns at one of its points by no more than arcs would that
    turn on beside it: the rim of a flat is no knuckle, though it may be tagged as one."""
    if not 0 < at < len(points) - 1:
        return True
    before = tangents_at(points[max(0, at - 2) : at + 1])
    after = tangents_at(points[at : at + 3])
    ways = np.diff(points[at - 1 : at + 2], axis=0)
    turn = _turn(ways[0], ways[1])
    beside = np.array([_turn(before[-2], ways[0]), _turn(ways[1], after[1])])
    return abs(turn) - np.abs(beside[beside * turn > 0.0]).sum() < _RIM


def _turn(a, b):
    """Degrees from one direction to another, seen along the ship."""
    return np.degrees(np.arctan2(a[1] * b[2] - a[2] * b[1], a[1] * b[1] + a[2] * b[2]))


def _piece(points, parameters, at, at_start, at_end):
    """Places of a smooth curve; where it ends along a direction (3,) it goes on as its mirror image
    there, so that it ends along that."""
    found = _spline(points, parameters, at, at_start, at_end)
    tangents = tangents_at(points, at_start, at_end)
    ways = np.diff(points, axis=0)
    ways /= np.maximum(np.linalg.norm(ways, axis=1), 1e-300)[:, None]
    turns = np.append((ways[1:] * ways[:-1]).sum(axis=1) < _TURNS, False)
    turns = np.insert(turns, 0, False)
    turns[0] = tangents[0] @ ways[0] < _TURNS
    turns[-1] = tangents[-1] @ ways[-1] < _TURNS
    for i in np.flatnonzero(turns[:-1] | turns[1:]):
        inside = (at >= parameters[i]) & (at <= parameters[i + 1])
        shares = (at[inside] - parameters[i]) / (parameters[i + 1] - parameters[i])
        bends = bend_of(points[max(0, i - 2) : i + 1]), bend_of(points[i + 1 : i + 4])
        found[inside] = between(
            points[i], points[i + 1], tangents[i], tangents[i + 1], shares, bends
        )
    return found


def _spline(points, parameters, at, at_start, at_end):
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
