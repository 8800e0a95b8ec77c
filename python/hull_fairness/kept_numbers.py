# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of the form that are kept while control points move, such as displacement and LCB.

Their exact derivatives by the control points (hull_native.FormNumbers) are linear conditions of the
moves; what these leave, of second order, is taken off again by further solutions.
"""

from dataclasses import dataclass

import numpy as np

from .native import hull_native as hn

VOLUME, LCB = "displaced_volume", "lcb"
_MOST_STEPS = 6
# Of the volume, and of the length for the LCB: small enough to end.
_ENOUGH = 1e-12


@dataclass(frozen=True, eq=False)
class KeptNumbers:
    """names: of VOLUME and LCB; new_body: control points (n, 3), m → hull_native.HullBody of its
    own; points: those of the hull that has the numbers; position: arguments of
    hull_native.FormNumbers; values, gradients: of each name; sizes: what is large in each."""

    names: tuple
    new_body: object
    points: np.ndarray
    position: dict
    values: np.ndarray
    gradients: tuple
    sizes: np.ndarray

    @property
    def key(self):
        """Equal where the conditions of one and the same hull are."""
        return self.names, tuple(self.position.items())

    def conditions(self):
        """As hull_native.FairRegion takes them, each in its size."""
        found = []
        for gradient, size in zip(self.gradients, self.sizes):
            points = np.flatnonzero(gradient.any(axis=1))
            found.append((points, gradient[points] / size))
        return found

    def misses(self, moves):
        """By how much moves (n, 3), m, change each number, of its size."""
        numbers = _numbers(self.new_body(self.points + moves), self.position)
        return (np.array([numbers.value(name) for name in self.names]) - self.values) / self.sizes

    def solve(self, solution):
        """(the hull_native.Faired with which the numbers stay, what it misses as misses() has it).
        solution(values): that with values of the conditions."""
        values = np.zeros(len(self.names))
        for _ in range(_MOST_STEPS):
            faired = solution(values)
            missed = self.misses(faired.moves)
            if np.abs(missed).max(initial=0.0) <= _ENOUGH:
                break
            values = values - missed
        return faired, missed


def kept_numbers(new_body, points, names, **position):
    """The KeptNumbers of a hull upright; see there. ValueError where nothing is under water."""
    points = np.array(points, dtype=float)
    numbers = _numbers(new_body(points), position)
    values = np.array([numbers.value(name) for name in names])
    volume = numbers.value(VOLUME)
    if not volume > 0.0:
        raise ValueError("Nothing is under water: give a draft, or keep neither")
    length = float(np.ptp(points[:, 0]))
    sizes = np.array([volume if name == VOLUME else length for name in names])
    gradients = tuple(map(numbers.gradient, names))
    return KeptNumbers(tuple(names), new_body, points, position, values, gradients, sizes)


def _numbers(body, position):
    return hn.FormNumbers(hn.BodyDerivatives(body), **position)
