# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers as diagrams take them: checked, made a smooth curve of, rounded."""

import numpy as np

# Between two points of a table a curve is drawn with so many parts.
_FAIR_PARTS = 8


def numbers(values, name):
    array = np.asarray(values, dtype=float)
    if array.ndim != 1:
        raise ValueError(f"{name} must have shape (n,), not {array.shape}.")
    return array


def same_length(x, y, x_name, y_name):
    x, y = numbers(x, x_name), numbers(y, y_name)
    if x.size != y.size:
        raise ValueError(f"{x_name} has {x.size} numbers and {y_name} {y.size}; as many are needed")
    return x, y


def typical_spacing(stations):
    distances = np.diff(np.unique(stations[np.isfinite(stations)]))
    return float(np.median(distances)) if distances.size else 1.0


def round_number(wanted):
    """1, 2 or 5 times a power of ten, the nearest."""
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(min((1.0, 2.0, 5.0, 10.0), key=lambda m: abs(np.log(m * power / wanted))) * power)


def maximum(x, y):
    """(x, y) of the highest point; None when no number is finite."""
    if not np.isfinite(y).any():
        return None
    top = int(np.nanargmax(y))
    return float(x[top]), float(y[top])


def fair(t, values, slopes=None):
    """A smooth curve through values (n,) at rising t (n,): (t, values) of closer points.

    Piecewise cubic; slopes not given are those of the parabola through each point and its
    neighbours.
    What is not rising, not finite or less than three points is left as it is.
    """
    if t.size < 3 or not (np.isfinite(t).all() and np.isfinite(values).all()):
        return t, values
    steps = np.diff(t)
    if not (steps > 0.0).all():
        return t, values
    if slopes is None or not np.isfinite(slopes).all():
        slopes = np.gradient(values, t, edge_order=2)
    share = np.linspace(0.0, 1.0, _FAIR_PARTS, endpoint=False)[None, :]
    h, rise = steps[:, None], np.diff(values)[:, None]
    start, end = slopes[:-1, None] * h, slopes[1:, None] * h
    between = values[:-1, None] + share * (
        start + share * (3.0 * rise - 2.0 * start - end + share * (start + end - 2.0 * rise))
    )
    places = t[:-1, None] + share * h
    return np.append(places, t[-1]), np.append(between, values[-1])
