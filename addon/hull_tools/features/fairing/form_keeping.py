# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of the form that are kept while the surface is faired: displacement and LCB.

Their exact derivatives by the control points (hull_native.FormNumbers) are linear conditions of the
moves; what these leave, of second order, is taken off again by further solutions.
"""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ..flotation import afloat

VOLUME, LCB = "displaced_volume", "lcb"
_MOST_STEPS = 4
# Of the volume, and of the length for the LCB: small enough to end.
_ENOUGH = 1e-12


@dataclass(frozen=True, eq=False)
class Keeping:
    """names: of VOLUME and LCB; source: flotation.ship.ShipSource; position: arguments of
    hull_native.FormNumbers; values, gradients: of each name; sizes: what is large in each."""

    names: tuple
    source: object
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
        surface = self.source.new_surface()
        surface.set_points(self.source.control.points + moves)
        numbers = _numbers(self.source.new_body(surface), self.position)
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


def keeping(obj, scale, source, names):
    """The Keeping of a hull whose ShipSource is given; None without names."""
    if not names:
        return None
    where = afloat.afloat(obj.hull, scale)
    if where.heel != 0.0:
        raise ValueError("Displacement and LCB are kept upright: set the heel to zero first")
    position = where.position()
    position.pop("heel")
    position["length_pp"] = where.length_pp or None
    position["water_density"] = where.water_density
    numbers = _numbers(source.new_body(source.new_surface()), position)
    values = np.array([numbers.value(name) for name in names])
    volume = numbers.value(VOLUME)
    if not volume > 0.0:
        raise ValueError("Nothing is under water: give a draft, or keep neither")
    length = float(np.ptp(source.control.points[:, 0]))
    sizes = np.array([volume if name == VOLUME else length for name in names])
    return Keeping(
        tuple(names), source, position, values, tuple(map(numbers.gradient, names)), sizes
    )


def _numbers(body, position):
    hull_native = native.require()
    return hull_native.FormNumbers(hull_native.BodyDerivatives(body), **position)
