# SPDX-License-Identifier: GPL-3.0-or-later
"""B-spline curves, rational ones included, as files have them."""

from dataclasses import dataclass

import numpy as np

MOST_DEGREE = 25
_MOST_PARTS = 64  # of a span


@dataclass(frozen=True)
class Spline:
    """degree p, knots (n + p + 1,) not falling, points (n, 3), weights (n,) above 0.

    ValueError with what is wrong, for files that are damaged.
    """

    degree: int
    knots: np.ndarray
    points: np.ndarray
    weights: np.ndarray

    def __post_init__(self):
        count = len(self.points)
        if not 1 <= self.degree <= MOST_DEGREE:
            raise ValueError(f"its degree is {self.degree}, not from 1 to {MOST_DEGREE}")
        if count < self.degree + 1 or len(self.knots) != count + self.degree + 1:
            raise ValueError(
                f"it has {len(self.knots)} knots for {count} points of degree {self.degree}"
            )
        if not all(np.isfinite(part).all() for part in (self.knots, self.points, self.weights)):
            raise ValueError("a number of it is not finite")
        if len(self.weights) != count or not (self.weights > 0.0).all():
            raise ValueError("it has not a weight above 0 for each point")
        if not (np.diff(self.knots) >= 0.0).all() or not self.start < self.end:
            raise ValueError("its knots do not rise")

    @property
    def start(self):
        return self.knots[self.degree]

    @property
    def end(self):
        return self.knots[-self.degree - 1]

    def evaluate(self, parameters):
        """(k, 3) places at parameters (k,) from start to end, by de Boor's algorithm."""
        p, knots = self.degree, self.knots
        t = np.asarray(parameters, dtype=float)
        last = np.searchsorted(knots, self.end, side="left") - 1
        span = np.clip(np.searchsorted(knots, t, side="right") - 1, p, last)
        homogeneous = np.column_stack([self.points * self.weights[:, None], self.weights])
        rows = homogeneous[span[:, None] - p + np.arange(p + 1)]
        for level in range(1, p + 1):
            for j in range(p, level - 1, -1):
                low = knots[span - p + j]
                share = (t - low) / (knots[span + 1 + j - level] - low)
                rows[:, j] = (1.0 - share)[:, None] * rows[:, j - 1] + share[:, None] * rows[:, j]
        return rows[:, p, :3] / rows[:, p, 3:]

    def sampled(self, chord_share):
        """(points (m, 3), knuckles (m,) bool): with the ends of all spans; knuckles where the knots
        allow one and the direction changes."""
        inner = self.knots[(self.knots >= self.start) & (self.knots <= self.end)]
        values, counts = np.unique(inner, return_counts=True)
        parts = self._parts(values, chord_share)
        steps = [np.linspace(a, b, n, endpoint=False) for a, b, n in zip(values, values[1:], parts)]
        parameters = np.concatenate([*steps, values[-1:]])
        points = self.evaluate(parameters)
        ends = np.concatenate([[0], np.cumsum(parts)])
        knuckles = np.zeros(len(points), dtype=bool)
        may_turn = np.flatnonzero(counts[1:-1] >= self.degree) + 1
        knuckles[ends[may_turn]] = self._turns(values[may_turn])
        return points, knuckles

    def _parts(self, values, chord_share):
        """Into how many parts each span is divided: what chords of a quarter miss tells."""
        if self.degree == 1:
            return np.ones(len(values) - 1, dtype=int)
        quarters = values[:-1, None] + np.outer(np.diff(values), np.linspace(0.0, 1.0, 9))
        places = self.evaluate(np.minimum(quarters, values[1:, None]).ravel()).reshape(-1, 9, 3)
        missed = places[:, 1:-1:2] - 0.5 * (places[:, :-2:2] + places[:, 2::2])
        missed = np.linalg.norm(missed, axis=2).max(axis=1)
        size = np.linalg.norm(np.ptp(self.points, axis=0))
        wanted = 4.0 * np.sqrt(missed / max(chord_share * size, np.finfo(float).tiny))
        return np.clip(np.ceil(wanted), 4, _MOST_PARTS).astype(int)

    def _turns(self, knots):
        """Whether the direction changes at inner knots (k,)."""
        step = 1e-6 * (self.end - self.start)
        before, at, after = (self.evaluate(knots + side * step) for side in (-1, 0, 1))
        before, after = at - before, after - at
        lengths = np.linalg.norm(before, axis=1) * np.linalg.norm(after, axis=1)
        # By a degree: less is no knuckle that anybody meant.
        return (before * after).sum(axis=1) < np.cos(np.radians(1.0)) * lengths


def arc_spline(centre, first, second, start, end):
    """The exact Spline of an arc: centre + first cos t + second sin t, (3,) each, for t from start
    to end, radians, start < end <= start + 2 pi; rational quadratics of at most 90 degrees
    (Piegl and Tiller 1997, 7.3)."""
    count = max(1, int(np.ceil((end - start) / (0.5 * np.pi) - 1e-9)))
    step = (end - start) / count
    t = start + 0.5 * step * np.arange(2 * count + 1)
    weights = np.where(np.arange(len(t)) % 2 == 0, 1.0, np.cos(0.5 * step))
    reach = (1.0 / weights)[:, None]
    points = centre + reach * (np.outer(np.cos(t), first) + np.outer(np.sin(t), second))
    knots = np.repeat(np.arange(count + 1.0), 2)
    return Spline(2, np.concatenate([[0.0], knots, [float(count)]]), points, weights)
