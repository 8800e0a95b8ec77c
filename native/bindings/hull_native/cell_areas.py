# SPDX-License-Identifier: GPL-3.0-or-later
"""Areas of the exact surface and their centres, cell by cell."""

from dataclasses import dataclass

import numpy as np

# Gauss points along each side of a square, and halvings at most: towards irregular points areas
# fall by about four each time.
_ORDER, _HALVINGS = 8, 40
# Of the whole area: a square and its four quarters differ by less.
_TOLERANCE = 1e-13
_BATCH = 4096  # squares that are evaluated at once: some 40 MB
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(_ORDER)
_AT = 0.5 * (_NODES + 1.0)
_U, _V = (axis.ravel() for axis in np.meshgrid(_AT, _AT, indexing="ij"))
_SHARES = 0.25 * np.outer(_WEIGHTS, _WEIGHTS).ravel()


@dataclass(frozen=True)
class SurfaceAreas:
    """areas: (cells,) m². moments: (cells, 3) m³, the integrals of x, y and z over them."""

    areas: np.ndarray
    moments: np.ndarray

    def of(self, cells):
        """(area in m², its centre (3,) in m) of cells, a mask or indices; the centre of no area is
        0."""
        area = float(self.areas[cells].sum())
        moment = self.moments[cells].sum(axis=0)
        return area, moment / area if area > 0.0 else np.zeros(3)


def surface_areas(surface):
    """The SurfaceAreas of a LimitSurface, to some 1e-12 of the whole: Gauss's quadrature on squares
    that are quartered until that changes nothing, as it does at once but around irregular points.
    ValueError where it has no finite area.
    """
    count = surface.cell_count
    cells = np.arange(count)
    places, sides = np.zeros((count, 2)), np.ones(count)
    whole = _integrals(surface, cells, places, sides)
    size = np.full(4, 1e-300)  # of the whole, known after the first halving
    found = np.zeros((count, 4))
    for halving in range(_HALVINGS):
        quarters = [
            _integrals(surface, cells, places + 0.5 * sides[:, None] * corner, 0.5 * sides)
            for corner in ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
        ]
        better = sum(quarters)
        if halving == 0:
            total = better[:, 0].sum()
            if not np.isfinite(total):
                raise ValueError("The surface has no finite area: its control points are too far.")
            if total == 0.0:  # all in one line, or one point
                return SurfaceAreas(found[:, 0], found[:, 1:])
            size[1:] += np.abs(better[:, 1:]).sum(axis=0).max()
            size[0] = total
        off = (np.abs(better - whole) / size).max(axis=1)
        is_done = off <= _TOLERANCE
        if halving == _HALVINGS - 1:
            is_done[:] = True
        np.add.at(found, cells[is_done], better[is_done])
        left = ~is_done
        if not left.any():
            break
        places = np.concatenate(
            [
                places[left] + 0.5 * sides[left, None] * corner
                for corner in ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
            ]
        )
        whole = np.concatenate([quarter[left] for quarter in quarters])
        cells, sides = np.tile(cells[left], 4), np.tile(0.5 * sides[left], 4)
    return SurfaceAreas(found[:, 0], found[:, 1:])


def _integrals(surface, cells, places, sides):
    """(n, 4) of squares: area, and x, y, z over it."""
    batches = [slice(first, first + _BATCH) for first in range(0, len(cells), _BATCH)]
    return np.concatenate([_integrals_of(surface, cells[b], places[b], sides[b]) for b in batches])


def _integrals_of(surface, cells, places, sides):
    uv = places[:, None] + sides[:, None, None] * np.stack([_U, _V], axis=1)
    points, by_u, by_v = surface.evaluate(
        np.repeat(cells, len(_U)), np.ascontiguousarray(uv.reshape(-1, 2)), 1
    )
    stretch = np.linalg.norm(np.cross(by_u, by_v), axis=1).reshape(len(cells), -1)
    weights = stretch * _SHARES * (sides**2)[:, None]
    points = points.reshape(len(cells), -1, 3)
    return np.column_stack([weights.sum(axis=1), np.einsum("ij,ijk->ik", weights, points)])
