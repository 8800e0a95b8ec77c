# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the mouse drags a point: rays from the eye met with planes and lines; arrays only."""

import numpy as np

# Sine of the angle between ray and plane, or ray and line, below which nothing can be told.
_LEAST_SINE = 0.02


def on_plane(origin, direction, point, normal):
    """Where a ray meets the plane through a point; None when it runs along it."""
    direction = direction / np.linalg.norm(direction)
    normal = normal / np.linalg.norm(normal)
    sine = direction @ normal
    if abs(sine) < _LEAST_SINE:
        return None
    return origin + direction * ((point - origin) @ normal / sine)


def on_line(origin, direction, point, along):
    """Where the line through a point comes nearest to a ray; None when they run side by side."""
    direction = direction / np.linalg.norm(direction)
    along = along / np.linalg.norm(along)
    cosine = direction @ along
    if 1.0 - cosine * cosine < _LEAST_SINE**2:
        return None
    to_point = point - origin
    t = (cosine * (direction @ to_point) - along @ to_point) / (1.0 - cosine * cosine)
    return point + along * t


def in_picture(to_clip, size, points):
    """Places (k, 2) in a picture of a size, in pixels, of points (k, 3); NaN behind the eye.

    to_clip: the 4 × 4 matrix of the view.
    """
    clip = np.column_stack([points, np.ones(len(points))]) @ np.asarray(to_clip).T
    w = np.where(clip[:, 3] > 0.0, clip[:, 3], np.nan)
    return (clip[:, :2] / w[:, None] + 1.0) * 0.5 * np.asarray(size)


def nearest_on_polyline(places, mouse):
    """(distance in pixels, index, part 0 to 1) of the place on a polyline (k, 2) nearest to the
    mouse; places may be NaN."""
    start, way = places[:-1], np.diff(places, axis=0)
    squares = np.maximum((way * way).sum(axis=1), 1e-12)
    part = np.clip(((mouse - start) * way).sum(axis=1) / squares, 0.0, 1.0)
    distance = np.linalg.norm(start + part[:, None] * way - mouse, axis=1)
    distance = np.where(np.isnan(distance), np.inf, distance)
    index = int(np.argmin(distance))
    return float(distance[index]), index, float(part[index])
