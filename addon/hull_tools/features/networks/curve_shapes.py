# SPDX-License-Identifier: GPL-3.0-or-later
"""The pieces of a hull_native.CurveNetwork's curve: evaluated, and as Bézier handles between its
points.

A piece is a tuple (degree, knots (k,), control points (p, 3), weights (p,)).
"""

import numpy as np

# Samples of a piece among which the parameter nearest to a point is looked for.
_SAMPLES = 257
_REFINEMENTS = 40
_LEAST_PARTS = 40


def evaluate(piece, parameters, order=0):
    """A list of (n, 3): points of a piece at parameters (n,), and derivatives up to an order of at
    most 2."""
    degree, knots, points, weights = (np.asarray(part) for part in piece)
    degree, t = int(degree), np.asarray(parameters, dtype=np.float64)
    spline = np.column_stack([points * weights[:, None], weights])
    jets = []
    for _ in range(order + 1):
        jets.append(_spline_at(degree, knots, spline, t))
        if degree == 0:
            jets += [np.zeros_like(jets[0])] * (order + 1 - len(jets))
            break
        spans = knots[degree + 1 : -1] - knots[1 : -degree - 1]
        steps = degree * np.diff(spline, axis=0)
        spline = np.divide(
            steps, spans[:, None], out=np.zeros_like(steps), where=spans[:, None] > 0
        )
        degree, knots = degree - 1, knots[1:-1]
    return _without_weights(jets[: order + 1])


def _without_weights(jets):
    """The quotient rule (Piegl & Tiller 1997, 4.3)."""
    w = [jet[:, 3:] for jet in jets]
    found = [jets[0][:, :3] / w[0]]
    if len(jets) > 1:
        found.append((jets[1][:, :3] - w[1] * found[0]) / w[0])
    if len(jets) > 2:
        found.append((jets[2][:, :3] - 2.0 * w[1] * found[1] - w[2] * found[0]) / w[0])
    return found


def _spline_at(degree, knots, coefficients, t):
    """De Boor's algorithm, for all parameters at once."""
    last = len(coefficients) - 1
    span = np.clip(np.searchsorted(knots, t, side="right") - 1, degree, last)
    d = [coefficients[span - degree + j] for j in range(degree + 1)]
    for r in range(1, degree + 1):
        for j in range(degree, r - 1, -1):
            low, high = knots[span - degree + j], knots[span + 1 + j - r]
            width = high - low
            share = np.divide(t - low, width, out=np.zeros_like(t), where=width > 0.0)[:, None]
            d[j] = (1.0 - share) * d[j - 1] + share * d[j]
    return d[degree]


def samples(pieces, parts):
    """(n, 3): points along all pieces of a curve, `parts` in each span between knots or more."""
    found = [evaluate(piece, seen_parameters(piece, parts))[0] for piece in pieces]
    return np.concatenate([found[0], *(points[1:] for points in found[1:])])


def seen_parameters(piece, parts):
    """(n,): `parts` of each span between knots, or as many more as it takes a curve of few spans to
    look round."""
    return parameters_of(piece, max(parts, -(-_LEAST_PARTS // (len(np.unique(piece[1])) - 1))))


def parameters_of(piece, parts):
    knots = np.unique(piece[1])
    shares = np.arange(parts) / parts
    inner = (knots[:-1, None] + shares * np.diff(knots)[:, None]).ravel()
    return np.append(inner, knots[-1])


def curvature(piece, parameters):
    """(points (n, 3), curvature vectors (n, 3), 1/m) at parameters (n,); zero where the curve comes
    to a halt."""
    points, first, second = evaluate(piece, parameters, 2)
    squares = (first**2).sum(axis=1, keepdims=True)
    along = (second * first).sum(axis=1, keepdims=True)
    bend = second * squares - first * along
    return points, np.divide(bend, squares**2, out=np.zeros_like(bend), where=squares > 0.0)


def parameters_at(piece, points):
    """(n,) rising: where a piece that begins and ends at the first and the last one of points
    (n, 3) passes them."""
    low, high = float(piece[1][0]), float(piece[1][-1])
    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    along = np.concatenate([[0.0], np.cumsum(chords)])
    t = low + (high - low) * along / along[-1]
    t[-1] = high
    size = np.ptp(points, axis=0).max()
    if np.abs(evaluate(piece, t)[0] - points).max() <= 1e-6 * size:
        return t  # chords are the parameters of free curves
    for i in range(1, len(points) - 1):
        t[i] = _nearest(piece, points[i], low, high)
    return np.maximum.accumulate(t)


def _nearest(piece, point, low, high):
    tried = np.linspace(low, high, _SAMPLES)
    step = tried[1] - tried[0]
    best = tried[_distances(piece, tried, point).argmin()]
    for _ in range(_REFINEMENTS):
        step *= 0.5
        around = np.clip([best - step, best, best + step], low, high)
        best = around[_distances(piece, around, point).argmin()]
    return best


def _distances(piece, parameters, point):
    return np.linalg.norm(evaluate(piece, parameters)[0] - point, axis=1)


def handles(pieces, points, knuckles):
    """(n, 2, 3): left and right Bézier handles of points (n, 3) of a curve that is made of these
    pieces, from knuckle to knuckle. Cubics are met exactly; other curves by the cubics that have
    their ends and tangents, and their middle."""
    found = np.stack([points, points], axis=1)
    ends = [0, *knuckles, len(points) - 1]
    if len(ends) - 1 != len(pieces):  # an arc of several quarters is one run of points
        return _polygon_handles(points)
    for piece, first, last in zip(pieces, ends, ends[1:]):
        run = slice(first, last + 1)
        t = parameters_at(piece, points[run])
        right, left = _spans(piece, t)
        found[first:last, 1] = right
        found[first + 1 : last + 1, 0] = left
    found[0, 0] = 2.0 * points[0] - found[0, 1]
    found[-1, 1] = 2.0 * points[-1] - found[-1, 0]
    return found


def _spans(piece, t):
    """(handles after the first point (k, 3) of each span, before the last one)."""
    (at, slope), width = evaluate(piece, t, 1), np.diff(t)[:, None]
    # Of a span's own polynomial: at inner knots of low degree the slope jumps to rounding only.
    right, left = at[:-1] + slope[:-1] * width / 3.0, at[1:] - slope[1:] * width / 3.0
    middle = evaluate(piece, 0.5 * (t[1:] + t[:-1]))[0]
    if int(piece[0]) <= 3 and np.ptp(piece[3]) == 0.0:
        return right, left
    off = middle - (at[:-1] + 3.0 * right + 3.0 * left + at[1:]) / 8.0
    reach = 3.0 * ((right - at[:-1]) + (left - at[1:])) / 8.0
    squares = (reach**2).sum(axis=1)
    share = np.divide((off * reach).sum(axis=1), squares, out=np.zeros(len(off)), where=squares > 0)
    factor = np.clip(1.0 + share, 0.2, 5.0)[:, None]
    return at[:-1] + factor * (right - at[:-1]), at[1:] + factor * (left - at[1:])


def _polygon_handles(points):
    found = np.stack([points, points], axis=1)
    chords = np.diff(points, axis=0) / 3.0
    found[1:, 0] -= chords
    found[:-1, 1] += chords
    return found
