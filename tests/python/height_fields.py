# SPDX-License-Identifier: GPL-3.0-or-later
"""Control meshes of heights over a square."""

import hull_native as hn
import numpy as np

SIDE = 8  # faces along each side of a grid


def grid(height, side=SIDE, **tags):
    """Control points (x, y, height(x, y)) over a square about the origin, normals up."""
    at = np.arange(side + 1) - side / 2
    x, y = np.meshgrid(at, at)
    points = np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3)
    first = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).reshape(-1)
    faces = np.stack([first, first + 1, first + side + 2, first + side + 1], axis=1)
    return hn.ControlMesh(points, np.full(len(faces), 4), faces.ravel(), **tags)
