# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields as arrays for the graphics card: bases, lines of intensity, the arrow of a shift."""

import numpy as np

from . import line_arrays

# Dots, at a scale of 1.
_HEAD, _HEAD_BREADTH = 13.0, 0.38


def base_strokes(bases):
    """The line_arrays.Strokes of the polylines of seen_bases.Base, images included; m."""
    polylines = [line for base in bases for line in base.polylines]
    images = [line * _IMAGE for base in bases for line in base.polylines]
    return line_arrays.strokes_of(polylines + images)


def level_strokes(segments, is_mirrored):
    """The line_arrays.Strokes of segments (m, 2, 3), and of their images."""
    both = np.concatenate([segments, segments * _IMAGE]) if is_mirrored else segments
    pairs = np.arange(2 * len(both), dtype=np.int32).reshape(-1, 2)
    return line_arrays.Strokes(both.reshape(-1, 3).astype(np.float32), pairs)


def dots(base):
    """(k, 3), m: where dots of a seen_bases.Base are, the second one that of its image; none of one
    that is drawn as a line."""
    if base.polylines:
        return np.empty((0, 3))
    if base.anchor[1] != 0.0:
        return np.array([base.anchor, base.anchor * _IMAGE])
    return base.anchor[None]


def arrow(start, tip, scale):
    """(corners (n, 3) of the segments, corners (3, 3) of the head) of an arrow in the picture, in
    dots; both empty where it is too short to be seen."""
    way = np.subtract(tip, start).astype(np.float64)
    length = np.hypot(*way)
    if length < 2.0:
        return np.empty((0, 3), np.float32), np.empty((0, 3), np.float32)
    along = way / length
    head = min(_HEAD * scale, 0.6 * length)
    back, side = tip - along * head, np.array([-along[1], along[0]]) * head * _HEAD_BREADTH
    return _flat([start, back]), _flat([tip, back + side, back - side])


def _flat(points):
    points = np.array(points)
    return np.column_stack([points, np.zeros(len(points))]).astype(np.float32)


_IMAGE = np.array([1.0, -1.0, 1.0])
