# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines as arrays for the graphics card: points and the pairs of them that segments join."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Strokes:
    """points (n, 3) float32; segments (m, 2) int32 indices."""

    points: np.ndarray
    segments: np.ndarray

    def __len__(self):
        return len(self.segments)


def strokes_of(polylines):
    """The Strokes of polylines (k, 3)."""
    if not polylines:
        return Strokes(np.empty((0, 3), dtype=np.float32), np.empty((0, 2), dtype=np.int32))
    lengths = np.array([len(line) for line in polylines])
    points = np.concatenate(polylines).astype(np.float32)
    starts = np.ones(len(points), dtype=bool)
    starts[np.cumsum(lengths) - 1] = False  # no segment leaves the last point of a line
    firsts = np.flatnonzero(starts).astype(np.int32)
    return Strokes(points, np.stack([firsts, firsts + 1], axis=1))


def comb_strokes(points, tips, pairs):
    """The Strokes of teeth from points (n, 3) to their tips, and of the line that joins pairs
    (m, 2) of tips."""
    count = len(points)
    corners = np.empty((2 * count, 3), dtype=np.float32)
    corners[:count], corners[count:] = points, tips
    numbers = np.arange(count, dtype=np.int32)
    teeth = np.stack([numbers, numbers + count], axis=1)
    return Strokes(corners, teeth), Strokes(corners, pairs.astype(np.int32) + count)
