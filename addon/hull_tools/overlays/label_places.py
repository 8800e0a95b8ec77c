# SPDX-License-Identifier: GPL-3.0-or-later
"""Which labels of a picture are written, where all of them would cover one another."""

import numpy as np


def written(corners, sizes, depths):
    """(n,) which of n labels are written: each that overlaps none of the nearer ones written.

    corners, (n, 2): their lower left, and sizes, (n, 2), both in dots; depths (n,) grow away from
    the eye, and of equal ones the first counts as nearer. Labels that only touch do not overlap.
    """
    corners, sizes = np.asarray(corners, dtype=np.float64), np.asarray(sizes, dtype=np.float64)
    is_written = np.zeros(len(corners), dtype=bool)
    if not len(corners):
        return is_written
    # Labels that overlap are in the same cell or in cells that touch: none is larger than a cell.
    cells = np.floor(corners / sizes.max(axis=0)).astype(np.int64).tolist()
    boxes = np.hstack([corners, corners + sizes]).tolist()
    by_cell = {}
    for label in np.argsort(depths, kind="stable").tolist():
        (column, row), box = cells[label], boxes[label]
        around = ((column + i, row + j) for i in (-1, 0, 1) for j in (-1, 0, 1))
        if any(_overlap(box, other) for cell in around for other in by_cell.get(cell, ())):
            continue
        by_cell.setdefault((column, row), []).append(box)
        is_written[label] = True
    return is_written


def _overlap(a, b):
    """Of boxes (left, bottom, right, top)."""
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
