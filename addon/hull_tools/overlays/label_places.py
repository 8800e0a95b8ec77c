# SPDX-License-Identifier: GPL-3.0-or-later
"""Which labels of a picture are written, where all of them would cover one another."""

from math import floor

import numpy as np


def written(corners, sizes, depths, taken=()):
    """(n,) which of n labels are written: each that overlaps nothing of what is taken, and none of
    the nearer ones written.

    corners, (n, 2): their lower left, and sizes, (n, 2), both in dots; depths (n,) grow away from
    the eye, and of equal ones the first counts as nearer. taken, (m, 4): left, bottom, right and
    top of boxes. What only touches does not overlap.
    """
    corners, sizes = np.asarray(corners, dtype=np.float64), np.asarray(sizes, dtype=np.float64)
    is_written = np.zeros(len(corners), dtype=bool)
    if not len(corners):
        return is_written
    taken = np.asarray(taken, dtype=np.float64).reshape(-1, 4)
    # What overlaps is in the same cell or in cells that touch: nothing is larger than a cell.
    cell = np.concatenate([sizes, taken[:, 2:] - taken[:, :2]]).max(axis=0)
    room = _Room(cell)
    for box in taken.tolist():
        room.take(box)
    boxes = np.hstack([corners, corners + sizes]).tolist()
    for label in np.argsort(depths, kind="stable").tolist():
        if room.is_free(boxes[label]):
            room.take(boxes[label])
            is_written[label] = True
    return is_written


class _Room:
    """Boxes (left, bottom, right, top) by the cells of their lower left corners."""

    def __init__(self, cell):
        self._width, self._height = cell.tolist()
        self._boxes = {}

    def _cell_of(self, box):
        return floor(box[0] / self._width), floor(box[1] / self._height)

    def take(self, box):
        self._boxes.setdefault(self._cell_of(box), []).append(box)

    def is_free(self, box):
        column, row = self._cell_of(box)
        around = ((column + i, row + j) for i in (-1, 0, 1) for j in (-1, 0, 1))
        return not any(_overlap(box, one) for cell in around for one in self._boxes.get(cell, ()))


def _overlap(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
