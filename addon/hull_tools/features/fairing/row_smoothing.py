# SPDX-License-Identifier: GPL-3.0-or-later
"""Points of rows moved so that the curves through them are as smooth as can be, within a mean
deviation.

What is made the least is Dierckx's measure of smoothness (Dierckx 1993, 5.2): the sum of the
squared jumps of the third derivative of the cubic spline through a row's points, by lengths along
it, that has none at the second and the last but one point. What is to stay is kept exactly.
"""

from dataclasses import dataclass

import numpy as np

from ...bridge import native

# Fewer points than this have a spline without a knot.
LEAST_POINTS = 5
# Over the largest: what is none, of singular values and of squared jumps' eigenvalues.
_RANK = 1e-10
_EIGENVALUE = 1e-13
_BISECTIONS = 200
# Points of a closed row that are put before and behind it: a jump fades by four a point.
_BEYOND = 8


@dataclass(frozen=True)
class Smoothed:
    """moves (n, 3) of all points, m; rms: of the points that may move; is_bound: the deviation
    bounds them, otherwise they are as smooth as they can be; before, after: the sum of squares."""

    moves: np.ndarray
    rms: float
    is_bound: bool
    before: float
    after: float


def smooth(points, parts, conditions, deviation):
    """Smoothed of points (n, 3), m. parts: (places (k,) among them, whether closed) of each curve
    without knuckles; conditions (c, 3 n): rows whose sums over the moves are to be zero, of x,
    y and z of one point after another; deviation: root mean square move of the points that are not
    held altogether, m.

    ValueError where no curve has points enough, and none may move.
    """
    jumps = [_jumps(points, part, is_closed) for part, is_closed in parts]
    jumps = [one for one in jumps if one is not None]
    if not jumps:
        raise ValueError(
            f"Select a row with {LEAST_POINTS} points or more between its ends and knuckles"
        )
    jumps = np.concatenate(jumps)
    free = _free(conditions, 3 * len(points))
    moving = np.flatnonzero((np.abs(free.reshape(len(points), -1)) > 0.0).any(axis=1))
    if not len(moving):
        raise ValueError("No point of the row may move: they are locked, or held as ends are")
    sums = np.kron(jumps, np.eye(3))
    start = jumps @ points
    by_freedom = sums @ free
    x, is_bound = _least(by_freedom, start.ravel(), deviation * np.sqrt(len(moving)))
    moves = (free @ x).reshape(-1, 3)
    rms = float(np.sqrt((moves**2).sum() / len(moving)))
    after = start + jumps @ moves
    return Smoothed(moves, rms, is_bound, float((start**2).sum()), float((after**2).sum()))


def _jumps(points, part, is_closed):
    """(j, n) the jumps of the third derivative at the knots of a part, by all points."""
    count = len(part)
    if count < LEAST_POINTS:
        return None
    beyond = _BEYOND if is_closed else 0
    places = part[np.arange(-beyond, count + beyond) % count]
    lengths = np.linalg.norm(np.diff(points[places], axis=0), axis=1)
    if not lengths.min() > 0.0:
        raise ValueError("Two points of the row lie at the same place: merge them first")
    t = np.concatenate([[0.0], np.cumsum(lengths)])
    hull_native = native.require()
    through = hull_native.smooth_curve(np.eye(len(places)), 0.0, parameters=t)
    thirds = through.evaluate(0.5 * (t[1:] + t[:-1]), 3)
    own = np.diff(thirds, axis=0)
    # Of a closed row each point's once; of others those at knots.
    own = own[beyond - 1 : beyond - 1 + count] if is_closed else own[1:-1]
    found = np.zeros((len(own), len(points)))
    np.add.at(found.T, places, own.T)
    # By mean distances, so that noise counts alike in rows with few points and with many.
    return found * (t[-1] / (len(t) - 1)) ** 3


def _free(conditions, count):
    """(count, m) orthonormal moves that fulfil the conditions; coordinates that these hold by
    themselves have none."""
    conditions = np.array(conditions, dtype=np.float64).reshape(-1, count)
    alone = np.count_nonzero(conditions, axis=1) == 1
    held = conditions[alone].any(axis=0)
    rest = np.where(held, 0.0, conditions[~alone])
    together = np.flatnonzero(rest.any(axis=0))
    free = [np.eye(count)[:, ~held & ~rest.any(axis=0)]]
    if len(together):
        _, sizes, axes = np.linalg.svd(rest[:, together])
        rank = int((sizes > _RANK * sizes.max()).sum())
        own = np.zeros((count, len(together) - rank))
        own[together] = np.where(np.abs(axes[rank:].T) > _RANK, axes[rank:].T, 0.0)
        free.append(own)
    return np.concatenate(free, axis=1)


def _least(matrix, start, bound):
    """(x with the least |start + matrix x| of those not longer than a bound, whether that binds).

    With the singular values s of the matrix, x = -s c / (s² + p) along each, and p >= 0 is found by
    bisection of its logarithm: the length falls as p rises (Moré and Sorensen 1983).
    """
    left, sizes, axes = np.linalg.svd(matrix, full_matrices=False)
    squares = sizes**2
    kept = squares > _EIGENVALUE * squares.max(initial=0.0)
    pulls, squares, axes = (sizes * (start @ left))[kept], squares[kept], axes[kept]

    def moved(p):
        return -pulls / (squares + p)

    if not len(squares) or np.linalg.norm(moved(0.0)) <= bound:
        return moved(0.0) @ axes, False
    if not bound > 0.0:
        return np.zeros(matrix.shape[1]), True
    high = np.log(np.linalg.norm(pulls) / bound)
    low = min(np.log(squares.min()) + np.log(_EIGENVALUE), high)
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        is_long = np.linalg.norm(moved(np.exp(middle))) > bound
        low, high = (middle, high) if is_long else (low, middle)
    return moved(np.exp(high)) @ axes, True
