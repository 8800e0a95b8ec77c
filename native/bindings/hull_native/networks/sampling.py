# SPDX-License-Identifier: GPL-3.0-or-later
"""Points on a curve that are as close as it takes for a network's curve through them to be the same
within a tolerance."""

import numpy as np

from .._network import CurveNetwork, NetworkCurve
from ..polylines import lengths_along

# Halvings of a span between two points at most, and points of a curve that are halved between.
_HALVINGS, _MOST_POINTS = 8, 4000
# Parts of a span, at which the two curves are compared.
_PARTS = 4
_STEPS = 3
# Of a span: the difference quotient of the curve.
_QUOTIENT = 1e-4


def parameters_within(evaluate, at, tolerance):
    """Parameters: those given (n,), rising, and as many between them as it takes for the spline
    through the curve's places there to be within tolerance, m, of the curve. evaluate: of
    parameters (k,) the places (k, 3), m. After eight halvings it is left as it is."""
    at = np.asarray(at, dtype=float)
    for _ in range(_HALVINGS):
        points = np.asarray(evaluate(at))
        if len(at) < 3 or len(at) > _MOST_POINTS:
            return at
        off, where = _deviations(evaluate, at, points)
        spans = np.clip(np.searchsorted(at, where[off > tolerance], "right") - 1, 0, len(at) - 2)
        if not len(spans):
            return at
        spans = np.unique(spans)
        at = np.sort(np.append(at, 0.5 * (at[spans] + at[spans + 1])))
    return at


def _deviations(evaluate, at, points):
    """m, of places on the network's curve through points from the curve, and the parameters of
    their feet there."""
    found = []
    for degree, knots, control, weights in CurveNetwork([NetworkCurve("", points)], 1.0).pieces(0):
        spans = np.unique(knots)
        shares = (np.arange(2 * _PARTS) + 0.5) / (2 * _PARTS)
        inner = (spans[:-1, None] + shares * np.diff(spans)[:, None]).ravel()
        found.append(on_spline(degree, np.asarray(knots), control, weights, inner))
    places = np.concatenate(found)
    shares = np.arange(_PARTS) / _PARTS
    near = np.append((at[:-1, None] + shares * np.diff(at)[:, None]).ravel(), at[-1])
    t = np.interp(
        _shares(np.vstack([points[:1], places, points[-1:]]))[1:-1],
        _shares(np.asarray(evaluate(near))),
        near,
    )
    step = _QUOTIENT * np.diff(at).min()
    for _ in range(_STEPS):
        low, high = np.clip(t - step, at[0], at[-1]), np.clip(t + step, at[0], at[-1])
        way = (np.asarray(evaluate(high)) - evaluate(low)) / (high - low)[:, None]
        off = places - evaluate(t)
        squares = np.maximum(np.einsum("ij,ij->i", way, way), 1e-300)
        t = np.clip(t + np.einsum("ij,ij->i", way, off) / squares, at[0], at[-1])
    return np.linalg.norm(places - evaluate(t), axis=1), t


def _shares(line):
    """(n,) of a line's points, of its length."""
    lengths = lengths_along(line)
    return lengths / max(lengths[-1], 1e-300)


def on_spline(degree, knots, points, weights, at):
    """Places (k, 3) on a rational B-spline curve (Piegl and Tiller 1987), by de Boor's way."""
    at_places = _de_boor(degree, knots, _homogeneous(points, weights), at)
    return at_places[:, :3] / at_places[:, 3:]


def spline_slopes(degree, knots, points, weights, at):
    """First and second derivatives (k, 3) of a rational B-spline curve by its parameter (Piegl and
    Tiller 1987): of numerator and denominator those of splines of lower degrees."""
    control, lower = _homogeneous(points, weights), np.asarray(knots)
    parts = [_de_boor(degree, lower, control, at)]
    for order in (1, 2):
        if order > degree:
            parts.append(np.zeros_like(parts[0]))
            continue
        p = degree - order + 1
        spans = lower[p + 1 : -1] - lower[1 : -p - 1]
        steps = np.diff(control, axis=0)
        control = p * steps / np.where(spans > 0.0, spans, np.inf)[:, None]
        lower = lower[1:-1]
        parts.append(_de_boor(p - 1, lower, control, at))
    (a, w), (da, dw), (dda, ddw) = ((part[:, :3], part[:, 3:]) for part in parts)
    first = (da - dw * a / w) / w
    return first, (dda - 2.0 * dw * first - ddw * a / w) / w


def _homogeneous(points, weights):
    weights = np.asarray(weights)
    return np.column_stack([np.asarray(points) * weights[:, None], weights])


def _de_boor(degree, knots, control, at):
    spans = np.clip(np.searchsorted(knots, at, "right") - 1, degree, len(control) - 1)
    near = control[spans[:, None] + np.arange(-degree, 1)]
    for level in range(1, degree + 1):
        for k in range(degree, level - 1, -1):
            low = knots[spans - degree + k]
            high = knots[spans + 1 + k - level]
            share = ((at - low) / (high - low))[:, None]
            near[:, k] = (1.0 - share) * near[:, k - 1] + share * near[:, k]
    return near[:, degree]
