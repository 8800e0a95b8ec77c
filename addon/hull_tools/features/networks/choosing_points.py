# SPDX-License-Identifier: GPL-3.0-or-later
"""Few points for a curve that is known by many, and places put in among points."""

import numpy as np

from ...bridge import native

_PARTS = 12  # of a span of a spline, between which it is straight enough
_ROUNDS = 12


def chosen(points, kept, knuckles, tolerance, turn=None):
    """Numbers, rising, of those of points (n, 3) through which the smooth curve from knuckle to
    knuckle is within a tolerance of all, and, where that is given, within an angle `turn`, rad, of
    the direction in which they follow one another; the ends, those of `kept` and knuckles are among
    them."""
    ends = [0, *knuckles, len(points) - 1]
    kept = np.unique([*kept, *ends])
    found = []
    for first, last in zip(ends, ends[1:]):
        own = kept[(kept >= first) & (kept <= last)]
        run = points[first : last + 1]
        found.append(_chosen_in_run(run, own - first, tolerance, turn) + first)
    return np.unique(np.concatenate(found))


def _chosen_in_run(points, numbers, tolerance, turn):
    for _ in range(_ROUNDS):
        spline, t = _through(points[numbers])
        more = _missed(points, numbers, spline, t, tolerance)
        if turn is not None:
            more = np.union1d(more, _turned(points, numbers, spline, t, turn))
        if not len(more):
            break
        numbers = np.union1d(numbers, more)
    return numbers


def _missed(points, numbers, spline, t, tolerance):
    """Of each span that misses points by more than the tolerance, or goes astray from them, the one
    where it does most."""
    shares = np.arange(_PARTS + 1) / _PARTS
    more = []
    for i, (first, last) in enumerate(zip(numbers, numbers[1:])):
        if last - first < 2:
            continue
        line = spline.evaluate(t[i] + shares * (t[i + 1] - t[i]))
        inner = points[first + 1 : last]
        off, beyond = distances_to(inner, line), distances_to(line, points[first : last + 1])
        if off.max() > tolerance and off.max() >= beyond.max():
            more.append(first + 1 + int(off.argmax()))
        elif beyond.max() > tolerance:
            worst = line[beyond.argmax()]
            more.append(first + 1 + int(np.linalg.norm(inner - worst, axis=1).argmin()))
    return np.array(more, dtype=np.int64)


def _turned(points, numbers, spline, t, turn):
    """The middles of spans beside a chosen point where the curve leaves it by another direction."""
    way = np.gradient(points, axis=0)[numbers]
    own = spline.evaluate(t, 1)
    across, along = np.linalg.norm(np.cross(way, own), axis=1), (way * own).sum(axis=1)
    more = []
    for i in np.flatnonzero(np.arctan2(across, along) > turn):
        for k in (i - 1, i):
            if 0 <= k < len(numbers) - 1 and numbers[k + 1] - numbers[k] > 1:
                more.append(_middle(points, numbers[k], numbers[k + 1]))
    return np.array(more, dtype=np.int64)


def _middle(points, first, last):
    """The number of the point between two others that is the middle by length."""
    steps = np.linalg.norm(np.diff(points[first : last + 1], axis=0), axis=1)
    along = np.cumsum(steps)[:-1]
    return first + 1 + int(np.abs(along - 0.5 * steps.sum()).argmin())


def _through(points):
    """(hull_native.SmoothCurve through points (n, 3), parameters of these)."""
    t = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    degree = min(3, len(points) - 1)
    curve = native.require().smooth_curve(points, 0.0, parameters=t, degree=degree)
    return curve, t


def distances_to(points, line):
    """(n,) of points (n, 3) from a polyline (k, 3)."""
    starts, ways = line[:-1], np.diff(line, axis=0)
    squares = np.maximum((ways**2).sum(axis=1), 1e-300)
    shares = np.einsum("nkc,kc->nk", points[:, None] - starts, ways) / squares
    feet = starts + np.clip(shares, 0.0, 1.0)[..., None] * ways
    return np.linalg.norm(points[:, None] - feet, axis=2).min(axis=1)


def with_places(points, lines, places, near):
    """(points, numbers of the places among them, where each of the old points is): places (k, 3)
    put in among points (n, 3) in the order of the curve, or in place of a point that is within
    `near`. lines: polylines (k, 3) of the n - 1 spans between the points."""
    spans = _Spans(lines)
    slots = [_slot(points, spans, place, near) for place in places]
    merged = [(float(i), point, -1) for i, point in enumerate(points)]
    for number, (slot, place) in enumerate(zip(slots, places)):
        if slot == int(slot):
            merged[int(slot)] = (slot, place, number)
        else:
            merged.append((slot, place, number))
    merged.sort(key=lambda one: one[0])
    numbers = {one[2]: i for i, one in enumerate(merged) if one[2] >= 0}
    old = [i for i, one in enumerate(merged) if one[0] == int(one[0])]
    return np.array([one[1] for one in merged]), numbers, np.array(old)


def _slot(points, spans, place, near):
    """The number of the point that is near, or one between two numbers."""
    distances = np.linalg.norm(points - place, axis=1)
    nearest = int(distances.argmin())
    return float(nearest) if distances[nearest] <= near else spans.number_at(place)


class _Spans:
    """The spans between points, each a polyline (k, 3), as one array of straight pieces."""

    def __init__(self, lines):
        self._ways = np.concatenate([np.diff(line, axis=0) for line in lines])
        self._starts = np.concatenate([line[:-1] for line in lines])
        self._squares = np.maximum((self._ways**2).sum(axis=1), 1e-300)
        counts = [len(line) - 1 for line in lines]
        self._first = np.concatenate([[0], np.cumsum(counts)])
        self._span_of = np.repeat(np.arange(len(lines)), counts)
        self._along = np.concatenate([[0.0], np.cumsum(np.sqrt(self._squares))])

    def number_at(self, place):
        """i + how far along span i, above 0 and below 1, the place (3,) is; i the nearest span."""
        aside = place - self._starts
        shares = np.clip((aside * self._ways).sum(axis=1) / self._squares, 0.0, 1.0)
        off = ((aside - shares[:, None] * self._ways) ** 2).sum(axis=1)
        piece = int(off.argmin())
        span = self._span_of[piece]
        begin, end = self._along[self._first[span]], self._along[self._first[span + 1]]
        length = shares[piece] * np.sqrt(self._squares[piece])
        share = (self._along[piece] - begin + length) / max(end - begin, 1e-300)
        return float(span + np.clip(share, 1e-6, 1.0 - 1e-6))
