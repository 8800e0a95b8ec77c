# SPDX-License-Identifier: GPL-3.0-or-later
"""Points and faces as writers of meshes take them."""

import numpy as np

from .limits import FURTHEST_POINT
from .real_points import real_points


def checked_faces(points, faces, corners):
    """(points (n, 3), faces (m, corners)) as arrays; ValueError for points that are no places
    within reach, and for faces of other points."""
    points, faces = real_points(points), np.asarray(faces)
    if faces.ndim != 2 or faces.shape[1] != corners or not len(faces):
        raise ValueError(f"faces must have shape (m, {corners}), not {faces.shape}.")
    if not np.isfinite(points).all() or np.abs(points).max(initial=0.0) > FURTHEST_POINT:
        raise ValueError(f"A point is no place within {FURTHEST_POINT:.0f}: check the units.")
    if not (0 <= faces.min() and faces.max() < len(points)):
        raise ValueError(f"A face has other corners than points 0 to {len(points) - 1}.")
    # Without the sign of zeros: texts would show it.
    return points + 0.0, faces


def lines_of(rows, pattern):
    """The bytes of a text of lines: each row in the pattern of the % operator."""
    text = (pattern + "\n") * len(rows)
    return (text % tuple(np.asarray(rows).ravel().tolist())).encode("ascii")
