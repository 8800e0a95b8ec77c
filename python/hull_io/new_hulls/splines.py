# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders and creases of a control mesh as the cubic B-splines that its surface has there."""

import numpy as np


def spans(control):
    """Bézier points (n - 1, 4, d) of the curve of a chain of n >= 2 control points (n, d) from
    corner to corner: uniform knots, one more point beyond each end, reflected."""
    control = np.asarray(control, dtype=float)
    before = 2.0 * control[0] - control[1]
    after = 2.0 * control[-1] - control[-2]
    p = np.vstack([before, control, after])
    a, b, c, d = p[:-3], p[1:-2], p[2:-1], p[3:]
    return np.stack(
        [(a + 4 * b + c) / 6, (2 * b + c) / 3, (b + 2 * c) / 3, (b + 4 * c + d) / 6], axis=1
    )


def minimum(control, axis):
    """The least coordinate of the curve along an axis."""
    values = spans(control)[:, :, axis]
    least = min(values[:, 0].min(), values[:, 3].min())
    for b in values:
        for t in _roots(np.polyder(_power_form(b))):
            least = min(least, np.polyval(_power_form(b), t))
    return float(least)


def maximum(control, axis):
    return -minimum(-np.asarray(control, dtype=float), axis)


def crossings(control, axis, value):
    """Points (k, d), along the curve, where a coordinate has a value."""
    found = []
    for b in spans(control):
        form = _power_form(b[:, axis])
        form[-1] -= value
        for t in _roots(form):
            found.append([np.polyval(_power_form(b[:, k]), t) for k in range(b.shape[1])])
    return np.array(found).reshape(-1, np.shape(control)[1])


def _power_form(b):
    """Coefficients, the highest power first, of a cubic with Bézier values (4,)."""
    return np.array(
        [b[3] - 3 * b[2] + 3 * b[1] - b[0], 3 * (b[2] - 2 * b[1] + b[0]), 3 * (b[1] - b[0]), b[0]]
    )


# How far outside [0, 1] a root may be found and yet be meant.
_ROUNDING = 1e-12


def _roots(polynomial):
    """Real roots in [0, 1], in order."""
    size = np.abs(polynomial).max()
    if size == 0.0:
        return []
    polynomial = np.where(np.abs(polynomial) < 1e-15 * size, 0.0, polynomial)
    roots = np.roots(polynomial)
    real = roots[np.abs(roots.imag) < 1e-9].real
    inside = real[(real > -_ROUNDING) & (real < 1.0 + _ROUNDING)]
    return sorted(np.clip(inside, 0.0, 1.0))
