# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of points (n, 3) by their lengths, m; shares of them that are closer where they bend."""

import numpy as np

# A line's bend is seen over so many parts of it, …
_PARTS = 160
# … as the turn between chords of so many.
_CHORD = 4
# How much of the shares the bend decides where a line turns much, and the turn, rad, for half of
# that.
_MOST_OF_BEND, _HALF_TURN = 0.6, 0.5


def lengths_along(line):
    """(n,) m: from the first point of (n, d) to each."""
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])


def length_of(line):
    """Of a line (n, d), m."""
    return float(lengths_along(line)[-1])


def points_at(line, parameters, at):
    """(k, 3) of a line whose points have rising parameters (n,), or (3,) for one number."""
    return np.stack([np.interp(at, parameters, line[:, axis]) for axis in range(3)], axis=-1)


def middle_of(line):
    """(3,) halfway along a line."""
    lengths = lengths_along(line)
    return points_at(line, lengths, 0.5 * lengths[-1])


def foot_on(line, parameters, place):
    """The parameter of a line's nearest point to a place, and its distance."""
    start, way = line[:-1], np.diff(line, axis=0)
    squares = np.maximum(np.einsum("ij,ij->i", way, way), 1e-300)
    share = np.clip(np.einsum("ij,ij->i", place - start, way) / squares, 0.0, 1.0)
    off = np.linalg.norm(start + share[:, None] * way - place, axis=1)
    i = int(np.argmin(off))
    return float(parameters[i] + share[i] * (parameters[i + 1] - parameters[i])), float(off[i])


def where_x_is(line, x):
    """Lengths at which a line comes through the plane across at x, rising."""
    lengths, off = lengths_along(line), line[:, 0] - x
    found = np.flatnonzero((off[:-1] <= 0.0) != (off[1:] <= 0.0))
    share = off[found] / (off[found] - off[found + 1])
    return (lengths[found] + share * (lengths[found + 1] - lengths[found])).tolist()


def bend_shares(line):
    """(n,) of a line's points, from 0 to 1: rising with its length, and faster where it bends."""
    lengths = lengths_along(line)
    even = np.linspace(0.0, lengths[-1], _PARTS + 1)
    points = points_at(line, lengths, even)
    before = points[_CHORD:-_CHORD] - points[: -2 * _CHORD]
    after = points[2 * _CHORD :] - points[_CHORD:-_CHORD]
    spans = np.linalg.norm(before, axis=1) * np.linalg.norm(after, axis=1)
    cosines = np.einsum("ij,ij->i", before, after) / np.maximum(spans, 1e-300)
    turns = np.pad(np.arccos(np.clip(cosines, -1.0, 1.0)), 2 * _CHORD, "edge")
    turns = np.convolve(turns, np.full(2 * _CHORD + 1, 1.0 / (2 * _CHORD + 1)), "valid")
    whole = turns.sum()
    of_bend = _MOST_OF_BEND * (whole / _CHORD) / (whole / _CHORD + _HALF_TURN)
    density = (1.0 - of_bend) / (_PARTS + 1) + of_bend * turns / max(whole, 1e-12)
    shares = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]))])
    return np.interp(lengths, even, shares / shares[-1])


def end_to_end(lines, tolerance, direction=0.0):
    """Lines joined at ends that are within tolerance, m, of one another, while they go on there
    with the cosine of their directions above `direction`; each may be turned round."""
    lines = list(lines)
    while True:
        pair = _first_pair(lines, tolerance, direction)
        if pair is None:
            return lines
        first, second, joined = pair
        lines = [line for i, line in enumerate(lines) if i not in (first, second)] + [joined]


def _first_pair(lines, tolerance, direction):
    for i, first in enumerate(lines):
        for k in range(i + 1, len(lines)):
            for a in (first, first[::-1]):
                for b in (lines[k], lines[k][::-1]):
                    if np.linalg.norm(a[-1] - b[0]) > tolerance:
                        continue
                    if _cosine(a[-1] - a[-2], b[1] - b[0]) > direction:
                        return i, k, np.concatenate([a, b[1:]])
    return None


def _cosine(a, b):
    return float(a @ b) / max(float(np.linalg.norm(a) * np.linalg.norm(b)), 1e-300)
