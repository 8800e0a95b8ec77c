# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature combs of curves of a network."""

import numpy as np

from . import curve_shapes

# Of the network's size: the length of nearly all teeth, and what is straight.
_HEIGHT = 0.05
_STRAIGHT = 1e-3
_TEETH = 8  # in a span between points


def comb(pieces, scale):
    """(points (n, 3), ends of their teeth, pairs (m, 2) of ends that a line joins), m, of a curve;
    scale in m²: of a tooth by the curvature. Knuckles break the line."""
    points, tips, pairs, count = [np.empty((0, 3))], [np.empty((0, 3))], [], 0
    for piece in pieces:
        at, bends = curve_shapes.curvature(piece, curve_shapes.seen_parameters(piece, _TEETH))
        points.append(at)
        tips.append(at - scale * bends)
        numbers = count + np.arange(len(at))
        pairs.append(np.column_stack([numbers[:-1], numbers[1:]]))
        count += len(at)
    pairs = np.concatenate([np.empty((0, 2), dtype=np.int64), *pairs])
    return np.concatenate(points), np.concatenate(tips), pairs


def handy_scale(curves, size):
    """A scale, m², at which nearly all teeth of curves, lists of pieces, are of a handy length."""
    bends = [np.zeros(1)]
    for pieces in curves:
        for piece in pieces:
            _, own = curve_shapes.curvature(piece, curve_shapes.seen_parameters(piece, _TEETH))
            bends.append(np.linalg.norm(own, axis=1))
    most = max(float(np.percentile(np.concatenate(bends), 95.0)), _STRAIGHT / size)
    return _HEIGHT * size / most
