# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows and columns added to a HullGrid where curves are missed."""

import numpy as np

from .._core import SurfaceTree
from ..polylines import points_at, where_x_is
from .hull_grid import GridRow, keel_range

# An addition that lowers the sum of squares by less, per point and of itself, is not worth another
# one of its kind soon; what the last one was worth is forgotten by and by.
_FORGOTTEN = 1.5


class RowsAndColumns:
    """Adds one row or column after the other, for places (n, 3) that are missed by more than the
    tolerance, m, up to a budget of points. Which of the two follows from what each gained last."""

    def __init__(self, places, tolerance, budget):
        self._places, self.tolerance, self.budget = places, tolerance, budget
        self._gains = {"row": np.inf, "column": np.inf}
        self._last = None

    def add_to(self, fit):
        """Adds to the fit's grid. False where that need not, or can't, be done."""
        of_rows, of_columns, distances = _missed_strips(fit, self._places)
        self._learn(len(fit.points), float(np.sum(distances**2)))
        if distances.max() <= self.tolerance:
            return False
        grid, left = fit.grid, self.budget - len(fit.points)
        has_bar = grid.outline.middle is not None
        row_costs = [grid.columns + 1 + has_bar - row.low for row in grid.rows[:-1]]
        column_costs = [
            sum(row.low <= column for row in grid.rows) + 2 * has_bar
            for column in range(grid.columns)
        ]
        choices = {
            "row": _best(of_rows, row_costs, left),
            "column": _best(of_columns, column_costs, left),
        }
        choices = {kind: best for kind, best in choices.items() if best is not None}
        if not choices:
            return False
        kind = max(choices, key=lambda kind: (self._gains[kind], choices[kind][1]))
        (_add_row if kind == "row" else _add_column)(grid, choices[kind][0])
        self._last = (kind, len(fit.points), float(np.sum(distances**2)))
        return True

    def _learn(self, count, missed):
        if self._last is None:
            return
        kind, before, missed_before = self._last
        for other in self._gains:
            self._gains[other] *= _FORGOTTEN
        gain = np.log(missed_before / max(missed, 1e-300)) / max(count - before, 1)
        self._gains[kind] = max(gain, 1e-6)


def _best(missed, costs, left):
    """(number, what is missed a point) of the strip that is missed most; None where none is within
    what is left."""
    worth = np.array([m / c if c <= left else -1.0 for m, c in zip(missed, costs)])
    most = int(np.argmax(worth))
    return (most, worth[most]) if worth[most] > 0.0 else None


def _missed_strips(fit, places):
    """Σ of squared distances, m², of places from the fitted surface, by the strips between rows and
    between columns that they are nearest to; and all distances."""
    mesh = fit.mesh
    closest = SurfaceTree(fit.surface).closest_points(places)
    face_of_cell = np.repeat(np.arange(len(mesh.faces)), [len(face) for face in mesh.faces])
    strips = np.array(mesh.strips)[face_of_cell[np.asarray(closest.cells)]]
    distances = np.asarray(closest.distances)
    sums = [np.zeros(len(mesh.grid.rows) - 1), np.zeros(mesh.grid.columns)]
    for of_strips, which in zip(sums, strips.T):
        np.add.at(of_strips, which[which >= 0], distances[which >= 0] ** 2)
    return *sums, distances


def _add_row(grid, number):
    """A row between two, half-way: of one x where there are whole sections."""
    aft, forward = grid.rows[number], grid.rows[number + 1]
    # The first column ended in these rows.
    if aft.kind in ("station", "free") and forward.kind == "stem":
        aft.points[0] = _on_keel(grid.outline, float(np.median(aft.points[1:, 0])))
    if aft.kind in ("arch", "post"):
        forward.points[0] = _on_keel(grid.outline, float(np.median(forward.points[1:, 0])))
    points = 0.5 * (aft.points + forward.points)
    x = float(np.nanmedian(points[:, 0]))
    low, high = keel_range(grid.outline)
    if aft.low == 0 and not low <= x <= high:
        row = GridRow("free", None, aft.low)
    else:
        row = GridRow("station", None, aft.low, x)
        points[:, 0] = x
    row.points = points
    row.knuckles = {k: None for k in aft.knuckles if k in forward.knuckles}
    grid.rows.insert(number + 1, row)


def _on_keel(outline, x):
    low = 0.0 if outline.post is None else outline.post
    places = [at for at in where_x_is(outline.contour, x) if at >= low] or [low]
    return points_at(outline.contour, outline.lengths, places[0])


def _add_column(grid, number):
    """A column between two, half-way; where the first one ends, after the second."""
    for row in grid.rows:
        if row.low > number:
            row.points = np.vstack([row.points[:1], row.points])
            row.low += 1
            continue
        at = number + (number == 0 and row.kind in ("stem", "post", "arch"))
        middle = 0.5 * (row.points[at] + row.points[at + 1])
        row.points = np.insert(row.points, at + 1, middle, axis=0)
    grid.columns += 1
    grid.knuckle_columns = [column + (column > number) for column in grid.knuckle_columns]
