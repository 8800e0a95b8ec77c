# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull between chines: knuckles through all points given, ruled surfaces between neighbours.

A chain of creases that ends in corners is a uniform cubic B-spline curve without curvature at its
ends. So the control points of a chine are those of such a spline through its points; and a strip of
faces between two creases is straight across.
"""

import numpy as np

from ..hull_data import HullData
from ..mending import mend
from ..mirror import AT_CENTRE_LINE, put_on_centre_plane

# Of the hull's size: ends of chines that are nearer are one point.
_SAME = 1e-7
# Bulkheads where chines have not the same number of points, one beside another.
_MOST_BULKHEADS = 50


def hull_of_chines(chines):
    """The half hull of a Chines, as HullData: a crease along each chine, m."""
    notes = []
    curves = [np.array(curve) for curve in chines.curves]
    size = float(np.linalg.norm(np.ptp(np.concatenate(curves), axis=0)))
    if np.concatenate(curves)[:, 1].mean() < 0.0:
        curves = [curve * [1.0, -1.0, 1.0] for curve in curves]
        notes.append("The chines are to starboard in the file: they were brought to port.")
    curves = [curve if curve[0, 0] <= curve[-1, 0] else curve[::-1] for curve in curves]
    if curves[0][:, 2].mean() > curves[-1][:, 2].mean():
        curves = curves[::-1]
    curves = _with_equal_counts(curves, notes)
    if np.abs(curves[0][:, 1]).max() > AT_CENTRE_LINE * size:
        curves.insert(0, curves[0] * [1.0, 0.0, 1.0])
        notes.append("The lowest chine is beside the centre plane: a level bottom was made.")
    curves[0][:, 1] = 0.0
    grid = np.stack([_through(curve) for curve in curves])
    data = _of_grid(grid, size)
    data.name, data.units, data.source = chines.name, chines.units, chines.source
    data.notes = notes
    put_on_centre_plane(data)
    mend(data)
    return data


def _with_equal_counts(curves, notes):
    counts = {len(curve) for curve in curves}
    if len(counts) == 1:
        return curves
    count = min(max(counts), _MOST_BULKHEADS)
    notes.append(
        f"The chines have from {min(counts)} to {max(counts)} points: splines through them were "
        f"taken at {count} places each."
    )
    return [_sampled(curve, count) for curve in curves]


def _sampled(curve, count):
    """(count, 3) at equal steps of chord length on the natural cubic spline through points."""
    lengths = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1)))
    steps = np.diff(lengths)
    n = len(curve)
    second = np.zeros((n, 3))
    if n > 2:
        slopes = np.diff(curve, axis=0) / steps[:, None]
        diagonal, beside = 2.0 * (steps[:-1] + steps[1:]), steps[1:-1]
        second[1:-1] = _solved(beside, diagonal, beside, 6.0 * np.diff(slopes, axis=0))
    at = np.linspace(0.0, lengths[-1], count)
    k = np.clip(np.searchsorted(lengths, at, "right") - 1, 0, n - 2)
    h = steps[k][:, None]
    b = (at - lengths[k])[:, None] / h
    a = 1.0 - b
    bend = (a**3 - a) * second[k] + (b**3 - b) * second[k + 1]
    return a * curve[k] + b * curve[k + 1] + bend * h**2 / 6.0


def _through(points):
    """Control points (n, 3) of the uniform cubic B-spline curve through points (n, 3) that begins
    and ends at its first and last one without curvature."""
    inner = np.full(len(points) - 2, 1.0 / 6.0)
    below, above = np.append(inner, 0.0), np.append(0.0, inner)
    diagonal = np.concatenate([[1.0], 4.0 * inner, [1.0]])
    return _solved(below, diagonal, above, points)


def _solved(below, diagonal, above, right):
    """Of a tridiagonal system with right sides (n, 3), by Gaussian elimination: each diagonal
    element exceeds those beside it (n - 1), so that no rows have to be exchanged."""
    diagonal, right = diagonal.copy(), np.array(right)
    for k in range(1, len(diagonal)):
        factor = below[k - 1] / diagonal[k - 1]
        diagonal[k] -= factor * above[k - 1]
        right[k] -= factor * right[k - 1]
    right[-1] /= diagonal[-1]
    for k in range(len(diagonal) - 2, -1, -1):
        right[k] = (right[k] - above[k] * right[k + 1]) / diagonal[k]
    return right


def _of_grid(grid, size):
    """The HullData of control points (chines, bulkheads, 3)."""
    chines, bulkheads = grid.shape[:2]
    index = np.arange(chines * bulkheads).reshape(chines, bulkheads)
    # Chines that run together at an end, as in a stem's point.
    for end in (0, bulkheads - 1):
        for k in range(1, chines):
            if np.abs(grid[k, end] - grid[k - 1, end]).max() <= _SAME * size:
                index[k, end] = index[k - 1, end]
    faces = []
    for k in range(chines - 1):
        for b in range(bulkheads - 1):
            face = [index[k, b], index[k, b + 1], index[k + 1, b + 1], index[k + 1, b]]
            distinct = list(dict.fromkeys(face))
            if len(distinct) >= 3:
                faces.append(distinct[::-1])  # outwards
    used, number = np.unique(np.concatenate(faces), return_inverse=True)
    ends = np.cumsum([len(face) for face in faces])[:-1]
    numbered = [face.tolist() for face in np.split(number, ends)]
    new = dict(zip(used.tolist(), range(len(used))))
    creases = {
        tuple(sorted((new[index[k, b]], new[index[k, b + 1]])))
        for k in range(1, chines - 1)
        for b in range(bulkheads - 1)
        if index[k, b] in new and index[k, b + 1] in new
    }
    points = grid.reshape(-1, 3)[used]
    return HullData("", points, numbered, creases=sorted(creases), half=True)
