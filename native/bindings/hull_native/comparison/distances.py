# SPDX-License-Identifier: GPL-3.0-or-later
"""How far one exact surface lies from another one, inwards and outwards. Lengths are in metres."""

from copy import copy
from dataclasses import dataclass

import numpy as np

from .._core import SurfaceTree, field_weights, tolerances

# A foot so near to a cell's side, in u or v, is on it.
_ON_SIDE = 1e-9
# Of the size: what is nearer is on the surface but for rounding.
_ON_SURFACE = 1e-12
# Of the distance: a step off the plane that a point is in, beside a knuckle.
_STEP = 1e-6
# Further along the surface from a border than off it: at more than 45°.
_LEAST_PART_OFF = np.sqrt(0.5)

# Of the points of a tessellation every so many is looked at to tell whose it is.
_EVERY = 16
# The largest distance is looked for closer in so many cells, on so many points along each side.
_CLOSER_CELLS, _CLOSER_POINTS = 4, 33


class DistanceField:
    """Signed distances of points from an exact surface: positive on its outer side, in the water.

    A point whose nearest place is on a border, and that is further along the surface from there
    than off it, has none (NaN): it lies beyond the border, where there is nothing to compare with.
    mirrored: the surface is the half y >= 0, and its mirror image counts too.

    It keeps to the surface as it is when made.
    """

    def __init__(self, surface, *, mirrored):
        # Its own: the tree does not follow set_points(), and normals must not either.
        self._surface = copy(surface)
        self._tree, self._mirrored = SurfaceTree(surface), mirrored
        self._is_border = _border_sides(surface.mesh, mirrored)

    def distances(self, points):
        """(n,) of points (n, 3)."""
        points = np.array(points, dtype=float).reshape(-1, 3)
        if self._mirrored:
            points[:, 1] = np.abs(points[:, 1])
        found = self._tree.closest_points(points)
        sizes = found.distances
        is_off = sizes > _ON_SURFACE * self._surface.mesh.size
        signed = np.where(is_off, sizes * found.sides, 0.0)
        aside = np.flatnonzero(is_off & (found.sides == 0))
        signed[aside] = sizes[aside] * self._sides_at_knuckles(points, found, aside)
        signed[is_off & self._is_beyond(points, found)] = np.nan
        return signed

    def _sides_at_knuckles(self, points, found, aside):
        """(k,) sides of the points `aside`, which are in the plane of the surface at their foot;
        NaN for those that have none. Beside a knuckle the face across it tells: a step off the
        plane leads there."""
        if not len(aside):
            return np.empty(0)
        normals = self._surface.normals(found.cells[aside], found.uv[aside])
        steps = _STEP * found.distances[aside, None] * normals
        sides = self._tree.closest_points(points[aside] + steps).sides.astype(float)
        return np.where(sides == 0.0, np.nan, sides)

    def _is_beyond(self, points, found):
        cells, uv = found.cells, found.uv
        at_border = (self._is_border[cells] & (uv[:, ::-1] <= _ON_SIDE)).any(axis=1)
        ends = np.flatnonzero(at_border)
        beyond = np.zeros(len(points), dtype=bool)
        if len(ends):
            normals = self._surface.normals(cells[ends], uv[ends])
            steps = points[ends] - found.points[ends]
            off = np.abs(np.einsum("ij,ij->i", steps, normals))
            beyond[ends] = off < _LEAST_PART_OFF * found.distances[ends]
        return beyond


def _border_sides(mesh, mirrored):
    """(cells, 2): whether the sides v = 0 and u = 0 of a cell, along the edges to the next and to
    the previous corner of its face, are borders. The centre line of a mirrored half is none."""
    sizes, corners = mesh.face_sizes, mesh.face_vertices
    ends = np.cumsum(sizes)
    following = np.arange(1, len(corners) + 1)
    following[ends - 1] = ends - sizes
    previous = np.empty_like(following)
    previous[following] = np.arange(len(corners))
    borders = mesh.border_edges
    if mirrored:
        on_plane = np.abs(mesh.points[:, 1]) <= tolerances.ON_CENTRE_PLANE * mesh.size
        borders = borders[~on_plane[borders].all(axis=1)]
    known = {frozenset(edge) for edge in borders.tolist()}
    is_border = np.array(
        [frozenset(pair) in known for pair in zip(corners.tolist(), corners[following].tolist())],
        dtype=bool,
    )
    return np.stack([is_border, is_border[previous]], axis=1)


@dataclass(frozen=True, eq=False)
class SurfaceDistances:
    """How far a surface lies from another one.

    values (l,): signed, of the tessellation's normals, as those of `surface_field`; NaN where there
    is none. outwards, inwards: the largest in size, with sign, None without any; and where, (3,).
    mean_size, rms: over the area that has a distance, None without any. share: of the area that
    has one.
    """

    values: np.ndarray
    outwards: float
    outwards_at: np.ndarray
    inwards: float
    inwards_at: np.ndarray
    mean_size: float
    rms: float
    share: float


def surface_distances(surface, tessellation, field):
    """SurfaceDistances of a LimitSurface, at a tessellation of it, from a DistanceField.

    The largest ones are looked for closer in the cells where they are. ValueError for a
    tessellation of another surface, or of this one before its points were set.
    """
    _require_of(surface, tessellation)
    values = field.distances(tessellation.points[_points_of_normals(tessellation)])
    weights, known = field_weights(tessellation), np.isfinite(values)
    area = weights[known].sum()
    mean_size = rms = None
    if area > 0.0:
        mean_size = float(np.abs(values[known]) @ weights[known] / area)
        rms = float(np.sqrt(values[known] ** 2 @ weights[known] / area))
    outwards = _largest(surface, tessellation, field, values, 1.0)
    inwards = _largest(surface, tessellation, field, values, -1.0)
    share = float(area / weights.sum()) if weights.sum() > 0.0 else 0.0
    return SurfaceDistances(values, *outwards, *inwards, mean_size, rms, share)


def _require_of(surface, tessellation):
    cells, some = np.asarray(tessellation.cells), slice(None, None, _EVERY)
    if cells.max() < surface.cell_count:
        found = surface.positions(cells[some], tessellation.uv[some])
        off = np.abs(found - tessellation.points[some]).max()
        if off <= tolerances.SAME_POSITION * surface.mesh.size:
            return
    raise ValueError("The tessellation is not of the surface as it is: make it anew.")


def _points_of_normals(tessellation):
    points = np.empty(len(tessellation.normals), dtype=np.int64)
    points[tessellation.normal_indices.reshape(-1)] = tessellation.quads.reshape(-1)
    return points


def _largest(surface, tessellation, field, values, sign):
    """(the largest distance to the side of a sign, where); (None, None) without any."""
    found = np.where(np.isfinite(values), sign * values, -np.inf)
    cells = np.asarray(tessellation.normal_cells)
    of_cells = np.full(surface.cell_count, -np.inf)
    np.maximum.at(of_cells, cells, found)
    if not of_cells.max() > 0.0:
        return None, None
    best = np.argsort(of_cells)[-_CLOSER_CELLS:]
    best = best[of_cells[best] > 0.0]
    steps = np.linspace(0.0, 1.0, _CLOSER_POINTS)
    uv = np.stack(np.meshgrid(steps, steps, indexing="ij"), axis=-1).reshape(-1, 2)
    points = surface.positions(np.repeat(best, len(uv)), np.tile(uv, (len(best), 1)))
    closer = sign * field.distances(points)
    closer[np.isnan(closer)] = -np.inf
    worst = int(closer.argmax())
    if closer[worst] >= of_cells.max():
        return float(sign * closer[worst]), points[worst]
    worst = int(found.argmax())
    return float(values[worst]), tessellation.points[_points_of_normals(tessellation)[worst]]
