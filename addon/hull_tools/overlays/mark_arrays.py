# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks of places on lines as arrays for the graphics card: a ring where the bend changes sides, a
triangle that points up where a line bends most, and one that points down where least."""

import numpy as np

_RING = 12


def _ring():
    angles = np.linspace(0.0, 2.0 * np.pi, _RING + 1)
    circle = np.column_stack([np.cos(angles), np.sin(angles)])
    return np.repeat(circle, 2, axis=0)[1:-1]


_UP = np.array([(0.0, 1.15), (1.0, -0.6), (-1.0, -0.6)])

# Of each of combs.MARKS (what to draw it from, places (k, 2) around it for radius 1).
SHAPES = {
    "inflection": ("LINES", _ring()),
    "maximum": ("TRIS", _UP),
    "minimum": ("TRIS", -_UP),
}


def in_picture(points, to_clip):
    """Places (n, 3) in the picture, each part from -1 to 1, of the points (n, 3) before the eye.

    to_clip: 4 × 4 matrix from the points' coordinates to those that the graphics card clips by.
    """
    full = np.column_stack([points, np.ones(len(points))]) @ np.asarray(to_clip).T
    full = full[full[:, 3] > 0.0]
    places = full[:, :3] / full[:, 3:]
    return places[(np.abs(places) <= 1.0).all(axis=1)]


def symbols(name, places, radius, viewport):
    """Corners (n k, 3) of the symbols of a kind of combs.MARKS at places in the picture; radius and
    viewport (width, height) in dots."""
    shape = SHAPES[name][1] * (2.0 * radius / np.asarray(viewport, dtype=np.float64))
    corners = np.repeat(places[:, None, :], len(shape), axis=1)
    corners[:, :, :2] += shape
    return corners.reshape(-1, 3).astype(np.float32)
