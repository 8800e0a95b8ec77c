# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows and columns of control points that are even along the girth, whatever the hull's form.

Third differences of what lies along a row or column tell both how unevenly control points are
spaced and how the form bends. Of each only the part in the surface and across the ship is to be
small: the others are asked to stay as they are, so that in a fit that is run in parts they cost
nothing in the end. So points of a row, whose places along the girth the form leaves open, do not
come to lie on one another.
"""

import numpy as np

_THIRD = np.array([-1.0, 3.0, -3.0, 1.0])
_X = np.array([1.0, 0.0, 0.0])
# Of a unit normal's part across the ship: with less there is no telling where the girth goes.
_NO_GIRTH = 0.2
_NO_LENGTH = 1e-12


def even_lines(points, faces, runs, evenness):
    """Tuples (control points, weights, rest) as fit_surface() takes sums, of runs (n, 4) of control
    points that follow one another; points (k, 3), m; faces: lists of their corners. evenness: what
    all of them together count for, of what a distance does."""
    if not evenness > 0.0 or not len(runs):
        return []
    weights = evenness / np.sqrt(len(runs)) * _THIRD
    normals = _normals(points, faces)
    found = []
    for run in runs:
        normal = normals[run].sum(axis=0)
        girth = np.cross(normal / max(np.linalg.norm(normal), _NO_LENGTH), _X)
        length = np.linalg.norm(girth)
        if length > _NO_GIRTH:
            off = weights @ points[run]
            found.append((run, weights, off - (off @ girth) / length**2 * girth))
    return found


def _normals(points, faces):
    """(k, 3): of the faces around each control point the mean unit normal."""
    normals = np.zeros_like(points)
    for face in faces:
        corners = points[face]
        area = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
        normals[face] += area / max(np.linalg.norm(area), _NO_LENGTH)
    return normals / np.maximum(np.linalg.norm(normals, axis=1), _NO_LENGTH)[:, None]
