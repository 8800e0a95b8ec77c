# SPDX-License-Identifier: GPL-3.0-or-later
"""How a network's curves bend, as sums that a fit meets.

A surface that comes near to curves may wave about them. So it is to bend along each curve as that
does: at places of curves, d the curve's unit tangent and k its curvature vector, the surface's
normal curvature h(d, d) is k · n, whatever angle the curve's plane has with the surface (Meusnier;
do Carmo 1976, section 3-2). What is off costs

    (f L)² A ∫ (h(d, d) - k · n)² / (1 + (k · n / h₀)²) ds / ∫ ds, h₀ = 10 / L

L the size of the mesh, A the surface's area, s along all curves: strong bends, as of bilges, may be
off by a part of themselves.
"""

from dataclasses import dataclass

import numpy as np

from .._core import BendSums, SurfaceTree
from .sampling import on_spline, spline_slopes

# The two places of Gauss in a span, of equal weight.
_AT = 0.5 + np.array([-0.5, 0.5]) / np.sqrt(3.0)
# Over the size: a bend above which more costs less.
_STRONG = 10.0
# Of the size: places farther from the surface do not count; spans that are shorter do not.
_FAR, _SHORT = 5e-3, 1e-5
# Of a tangent: the part that is to be along the surface.
_ALONG = 0.9


@dataclass(frozen=True)
class CurveBends:
    """points, unit tangents and curvature vectors (n, 3), m and 1/m, of places on curves, and the
    lengths of curve (n,), m, that they stand for."""

    points: np.ndarray
    tangents: np.ndarray
    bends: np.ndarray
    lengths: np.ndarray


def network_bends(network):
    """The CurveBends of a CurveNetwork: of all its curves but borders and knuckles, along which a
    surface has two curvatures or none."""
    used = set(np.asarray(network.edge_curves).tolist())
    parts = []
    for curve, (border, crease, _) in enumerate(network.roles):
        if curve not in used or border or crease or network.curves[curve].kind == "knuckle":
            continue
        for degree, knots, points, weights in network.pieces(curve):
            if degree > 1:
                parts.append(_of_spline(degree, np.asarray(knots), points, weights))
    if not parts:
        return CurveBends(*(np.empty((0, 3)) for _ in range(3)), np.empty(0))
    return CurveBends(*(np.concatenate(part) for part in zip(*parts)))


def _of_spline(degree, knots, points, weights):
    ends = np.unique(knots)
    spans = np.diff(ends)
    at = (ends[:-1, None] + _AT * spans[:, None]).ravel()
    slopes, bends = spline_slopes(degree, knots, points, weights, at)
    speeds = np.linalg.norm(slopes, axis=1)
    tangents = slopes / np.maximum(speeds, 1e-300)[:, None]
    bends = bends - np.einsum("ij,ij->i", bends, tangents)[:, None] * tangents
    bends /= np.maximum(speeds**2, 1e-300)[:, None]
    places = on_spline(degree, knots, points, weights, at)
    return places, tangents, bends, 0.5 * np.repeat(spans, len(_AT)) * speeds


def curve_bend_terms(surface, bends, fairness):
    """Tuples (control points, weights, rest) as fit_surface() takes sums: f = fairness."""
    if not fairness > 0.0 or not len(bends.points):
        return []
    size = surface.mesh.size
    near = SurfaceTree(surface).closest_points(bends.points)
    cells, uv = np.asarray(near.cells), np.asarray(near.uv)
    _, by_u, by_v = surface.evaluate(cells, uv, 1)
    normals = np.cross(by_u, by_v)
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    along = bends.tangents - np.einsum("ij,ij->i", bends.tangents, normals)[:, None] * normals
    parts = np.linalg.norm(along, axis=1)
    along /= np.maximum(parts, 1e-300)[:, None]
    wanted = np.einsum("ij,ij->i", bends.bends, normals)
    counts = (np.asarray(near.distances) < _FAR * size) & (parts > _ALONG)
    counts &= bends.lengths > _SHORT * size
    shares = np.where(counts, bends.lengths, 0.0) / max(bends.lengths[counts].sum(), 1e-300)
    roots = fairness * size * np.sqrt(_area(surface) * shares)
    roots /= np.hypot(1.0, wanted * size / _STRONG)
    sums, points, found = BendSums(surface), np.asarray(surface.mesh.points), []
    across = np.array([[1.0, 0.0, 0.0]])
    for i in np.flatnonzero(counts):
        at = slice(i, i + 1)
        numbers, slopes = sums.sum(points, cells[at], uv[at], along[at], across)
        if len(numbers):
            row = roots[i] * np.asarray(slopes)[:, 0]
            found.append((np.asarray(numbers).tolist(), row, roots[i] * wanted[i] * normals[i]))
    return found


def _area(surface):
    cells = np.repeat(np.arange(surface.cell_count), len(_AT) ** 2)
    uv = np.tile(np.stack(np.meshgrid(_AT, _AT), axis=-1).reshape(-1, 2), (surface.cell_count, 1))
    _, by_u, by_v = surface.evaluate(cells, uv, 1)
    return float(np.linalg.norm(np.cross(by_u, by_v), axis=1).sum()) / len(_AT) ** 2
