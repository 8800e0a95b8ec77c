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
"""

import numpy as np

from ._core import BendSums

# Of a cell's square: where it is looked at.
_AT = np.array([[0.25, 0.25], [0.25, 0.75], [0.75, 0.25], [0.75, 0.75]])
# Of the fairness along the ship: what that across it counts for.
_ACROSS = 0.05
# Over the size: a bend above which more costs less.
_STRONG = 10.0
_NO_LENGTH = 1e-9


def bend_terms(surface, fairness):
    """Tuples (control points, weights, rest) as fit_surface() takes sums: f = fairness."""
    if not fairness > 0.0:
        return []
    cells = np.repeat(np.arange(surface.cell_count), len(_AT))
    uv = np.tile(_AT, (surface.cell_count, 1))
    _, by_u, by_v = surface.evaluate(cells, uv, 1)
    normals = np.cross(by_u, by_v)
    areas = np.linalg.norm(normals, axis=1)
    normals /= np.maximum(areas, 1e-300)[:, None]
    along = np.array([1.0, 0.0, 0.0]) - normals[:, :1] * normals
    parts = np.linalg.norm(along, axis=1)
    along /= np.maximum(parts, _NO_LENGTH)[:, None]
    roots = fairness * surface.mesh.size * np.sqrt(areas / len(_AT))
    points, sums, found = np.asarray(surface.mesh.points), BendSums(surface), []
    for ways, weights in (
        (along, roots * parts**2),
        (np.cross(normals, along), _ACROSS * roots),
    ):
        for place in np.flatnonzero((areas > 0.0) & (parts > _NO_LENGTH)):
            term = _term(sums, points, slice(place, place + 1), (cells, uv, ways))
            if term is not None:
                numbers, row, bend = term
                strong = bend * surface.mesh.size / _STRONG
                row = weights[place] / np.hypot(1.0, strong) * row
                found.append((numbers, row, np.zeros(3)))
    return found


def _term(sums, points, at, places):
    """(control points, weights, bend, 1/m) at one place; None where nothing is told."""
    cells, uv, ways = (array[at] for array in places)
    numbers, slopes = sums.sum(points, cells, uv, ways, np.array([[1.0, 0.0, 0.0]]))
    if not len(numbers):
        return None
    row = np.asarray(slopes)[:, 0]
    return np.asarray(numbers).tolist(), row, float(np.linalg.norm(row @ points[numbers]))
