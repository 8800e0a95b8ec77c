# SPDX-License-Identifier: GPL-3.0-or-later
"""How a surface bends along the ship and across it, as sums that a fit keeps small.

At places all over the surface, d the unit tangent along the ship or across it, the covariant second
derivative along d of what the control points carry is a sum of these, w · p, whose value is the
surface's bend h(d, d) n: it has no part along the surface, so that rows and columns of control
points may be as close as they are laid (do Carmo 1976, section 4-4). Where the surface bends by
design, at stems and bilges, more bend costs less:

    (f L)² ∫ h(d, d)² / (1 + (h / h₀)²) dA, L the size of the mesh, h₀ = 10 / L

with h in the quotient as it is on the surface that is given. Along the ship the part of the x axis
in the surface counts; across it is to be fair by a part of f only.

An eye sees changes of bend, as dips of lines and kinks of what they mirror. These, along and across
the ship alike, are kept small by

    (g L²)² ∫ |∇h(d, d)|² / (1 + (h / h₀)²) dA

with the differences of h from place to place in a cell, in which it is nearly linear.
"""

import numpy as np

from .._core import BendSums

# Of a cell's square: where it is looked at.
_AT = np.array([[0.25, 0.25], [0.25, 0.75], [0.75, 0.25], [0.75, 0.75]])
# Of the fairness along the ship: what that across it counts for.
_ACROSS = 0.05
# Over the size: a bend above which more costs less.
_STRONG = 10.0
_NO_LENGTH = 1e-9
# Of a cell's places those beside one another; of the x axis, the part in the surface that tells
# what is along the ship; of the size, a distance below which changes count as over that.
_PAIRS = ((0, 2), (1, 3), (0, 1), (2, 3))
_LEAST_PART, _SHORT = 0.05, 4e-3


def bend_terms(surface, fairness, change_fairness=0.0):
    """Tuples (control points, weights, rest) as fit_surface() takes sums: f = fairness, g =
    change_fairness."""
    found = []
    if not (fairness > 0.0 or change_fairness > 0.0):
        return found
    places = _Places(surface)
    for ways, shares, part in (
        (places.along, places.parts**2, 1.0),
        (np.cross(places.normals, places.along), 1.0 + 0.0 * places.parts, _ACROSS),
    ):
        terms = places.terms(ways)
        if fairness > 0.0:
            found += places.bends(terms, part * fairness * shares)
        if change_fairness > 0.0:
            found += places.changes(terms, change_fairness)
    return found


class _Places:
    """Places all over a surface, four to a cell, with unit normals, unit tangents along the ship,
    what part of the x axis is in the surface, and areas of |x_u × x_v|, m²."""

    def __init__(self, surface):
        self.size, self._sums = surface.mesh.size, BendSums(surface)
        self._control = np.asarray(surface.mesh.points)
        self._cells = np.repeat(np.arange(surface.cell_count), len(_AT))
        self._uv = np.tile(_AT, (surface.cell_count, 1))
        self._points, by_u, by_v = surface.evaluate(self._cells, self._uv, 1)
        normals = np.cross(by_u, by_v)
        self.areas = np.linalg.norm(normals, axis=1)
        self.normals = normals / np.maximum(self.areas, 1e-300)[:, None]
        along = np.array([1.0, 0.0, 0.0]) - self.normals[:, :1] * self.normals
        self.parts = np.linalg.norm(along, axis=1)
        self.along = along / np.maximum(self.parts, _NO_LENGTH)[:, None]

    def terms(self, ways):
        """At each place (control points, weights, bend, 1/m); None where nothing is told."""
        found = [None] * len(self._cells)
        for place in np.flatnonzero((self.areas > 0.0) & (self.parts > _NO_LENGTH)):
            at = slice(place, place + 1)
            x_axis = np.array([[1.0, 0.0, 0.0]])
            numbers, slopes = self._sums.sum(
                self._control, self._cells[at], self._uv[at], ways[at], x_axis
            )
            if len(numbers):
                numbers, row = np.asarray(numbers), np.asarray(slopes)[:, 0]
                bend = float(np.linalg.norm(row @ self._control[numbers]))
                found[place] = numbers, row, bend
        return found

    def bends(self, terms, weights):
        """Sums of bends; weights (n,)."""
        roots = weights * self.size * np.sqrt(self.areas / len(_AT))
        return [
            (term[0].tolist(), root / self._strength(term[2]) * term[1], np.zeros(3))
            for term, root in zip(terms, roots)
            if term is not None
        ]

    def changes(self, terms, fairness):
        """Sums of differences of bends between places beside one another in a cell. What of them is
        along the surface is its turn, and may stay."""
        found = []
        for first in range(0, len(terms), len(_AT)):
            for one, other in _PAIRS:
                one, other = first + one, first + other
                if terms[one] is None or terms[other] is None:
                    continue
                if min(self.parts[one], self.parts[other]) > _LEAST_PART:
                    found.append(self._change(terms, one, other, fairness))
        return found

    def _change(self, terms, one, other, fairness):
        (numbers, row, bend), (others, other_row, other_bend) = terms[one], terms[other]
        apart = np.linalg.norm(self._points[one] - self._points[other])
        area = 0.5 * (self.areas[one] + self.areas[other]) / len(_AT)
        root = fairness * self.size**2 * np.sqrt(area) / max(apart, _SHORT * self.size)
        root /= self._strength(0.5 * (bend + other_bend))
        both = np.union1d(numbers, others)
        weights = np.zeros(len(both))
        weights[np.searchsorted(both, numbers)] += root * row
        weights[np.searchsorted(both, others)] -= root * other_row
        normal = self.normals[one] + self.normals[other]
        normal /= max(np.linalg.norm(normal), _NO_LENGTH)
        change = weights @ self._control[both]
        return both.tolist(), weights, change - (change @ normal) * normal

    def _strength(self, bend):
        return np.hypot(1.0, bend * self.size / _STRONG)
