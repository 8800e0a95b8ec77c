# SPDX-License-Identifier: GPL-3.0-or-later
"""Where rows of one x are best: control points in them carry uniform cubic splines along the ship,
which miss the hull's lines least.

A Catmull-Clark surface whose rows have the control abscissas x_i is along each column

    Σ P_i N_i(t), at x(t) = Σ x_i N_i(t), N_i the uniform cubic B-splines

(Catmull and Clark 1978), and goes on beyond its ends as if it were reflected there. So the places
x_i settle which lines y(x), z(x) a hull can have; the P_i that do best follow by least squares.
"""

import numpy as np

from ..polylines import lengths_along, points_at

# Lines along the ship by shares of girth, sections that they are drawn through, places in a span.
_LINES, _SECTIONS, _IN_SPAN = 24, 120, 8
# Of the range: rows are no closer than this, or than they begin where these are closer; the first
# step of the search, and how often it is halved.
_LEAST_GAP, _FIRST_STEP, _HALVINGS = 3e-2, 2e-2, 6
_MOST_PASSES = 12
# Of the largest singular value: control points of which no place tells.
_NOTHING = 1e-9


def best_rows(girths, start, before, after):
    """(n,) x of rows, m, rising, with which the sections of GirthLines are missed least; start
    (n,): rows to begin with, of which the first and the last stay. before, after: x where columns
    begin and end, m."""
    lines, rows = _Lines(girths, start[0], start[-1]), np.array(start, dtype=float)
    if len(rows) < 3:
        return rows
    size = rows[-1] - rows[0]
    gap, step = min(_LEAST_GAP * size, np.diff(rows).min()), _FIRST_STEP * size

    def missed(tried):
        return lines.missed(np.concatenate([[before], tried, [after]]))

    best = missed(rows)
    for _ in range(_HALVINGS):
        for _ in range(_MOST_PASSES):
            rows, found = _moved_once(rows, best, step, gap, missed)
            if not found < best:
                break
            best = found
        step *= 0.5
    return rows


def _moved_once(rows, best, step, gap, missed):
    """Rows, each moved by a step to either side where less is missed then, and what is missed."""
    for i in range(1, len(rows) - 1):
        for move in (step, -step):
            tried = rows.copy()
            tried[i] += move
            if np.diff(tried).min() < gap:
                continue
            now = missed(tried)
            if now < best:
                rows, best = tried, now
    return rows, best


class _Lines:
    """Lines along the ship: at places x (k,) the coordinates across it, (k, 2 lines)."""

    def __init__(self, girths, low, high):
        self.x = np.linspace(low, high, _SECTIONS)
        shares = np.linspace(0.0, 1.0, _LINES + 1)
        across = []
        for x in self.x:
            line = girths.at(x)
            lengths = lengths_along(line)
            across.append(points_at(line, lengths, shares * lengths[-1])[:, 1:].ravel())
        self.across = np.array(across)

    def missed(self, control):
        """Sum over lines of the mean squared distance, m², of the best splines from them; control:
        x of all rows, m."""
        basis = _basis(len(control))
        x = basis @ control
        speeds = np.gradient(x)
        inside = (x >= self.x[0]) & (x <= self.x[-1]) & (speeds > 0.0)
        roots = np.sqrt(speeds[inside])[:, None]
        ways, sizes, _ = np.linalg.svd(roots * basis[inside], full_matrices=False)
        ways = ways[:, sizes > _NOTHING * sizes[0]]
        wanted = roots * _between(self.x, self.across, x[inside])
        return float(np.sum((wanted - ways @ (ways.T @ wanted)) ** 2) / np.sum(roots**2))


def _basis(count):
    """(k, count): what control points count for at even parameters from end to end."""
    t = np.linspace(0.0, count - 1.0, _IN_SPAN * (count - 1) + 1)
    extended = np.zeros((count + 2, count))
    extended[1:-1] = np.eye(count)
    extended[0, :2] = extended[-1, :-3:-1] = 2.0, -1.0
    span = np.minimum(t.astype(int), count - 2)
    s = t - span
    parts = (
        (1 - s) ** 3,
        3 * s**3 - 6 * s**2 + 4,
        -3 * s**3 + 3 * s**2 + 3 * s + 1,
        s**3,
    )
    return sum(part[:, None] / 6.0 * extended[span + k] for k, part in enumerate(parts))


def _between(places, values, at):
    """Values (k, m) between those (n, m) at even places, by cubics through the nearest four."""
    share = (at - places[0]) / (places[1] - places[0])
    first = np.clip(share.astype(int) - 1, 0, len(places) - 4)
    s = (share - first)[:, None]
    a, b, c, d = (values[first + k] for k in range(4))
    return (
        -(s - 1) * (s - 2) * (s - 3) / 6 * a
        + s * (s - 2) * (s - 3) / 2 * b
        - s * (s - 1) * (s - 3) / 2 * c
        + s * (s - 1) * (s - 2) / 6 * d
    )
