# SPDX-License-Identifier: GPL-3.0-or-later
"""Planes as (nx, ny, nz, d), where n · p = d and n has length 1; arrays only.

Numbers are as exact as Blender keeps them: a plane across an axis is met exactly in single
precision, any other to its rounding.
"""

import numpy as np

from ...bridge import native

# What rounding to single precision alone makes of it.
_ROUNDING = 2.4e-7
# An axis nearer than this angle to a normal is meant.
_AXIS = 2e-6

# The planes that a flat can be asked to have.
KINDS = ("SIDE", "BOTTOM", "TRANSOM", "RAKED", "BEST")
_NORMALS = {"SIDE": 1, "BOTTOM": 2, "TRANSOM": 0}


def kind_of(plane):
    """Which of KINDS a plane is."""
    for kind, axis in _NORMALS.items():
        if _axis_of(plane) == axis:
            return kind
    return "RAKED" if plane[1] == 0.0 else "BEST"


def _axis_of(plane):
    """0, 1 or 2 for a plane across that axis, else None."""
    across = np.flatnonzero(plane[:3])
    return int(across[0]) if len(across) == 1 else None


def stored(plane):
    """The plane that is kept in single precision: axes that are meant exactly, the largest part of
    the normal positive."""
    plane = np.array(plane, dtype=np.float64)
    plane *= np.copysign(1.0, plane[np.argmax(np.abs(plane[:3]))])
    normal = plane[:3]
    length = np.linalg.norm(normal)
    normal[np.abs(normal) < _AXIS * length] = 0.0
    kept = np.append(normal / np.linalg.norm(normal), plane[3] / length).astype(np.float32)
    normal = kept[:3].astype(np.float64)
    return np.append(normal / np.linalg.norm(normal), np.float64(kept[3]))


def heights(points, plane):
    """(k,) distances of points (k, 3) from a plane, positive on the side that n points to."""
    return points @ plane[:3] - plane[3]


def tolerance(points):
    """Within which points that are to lie in a plane do: part of their coordinates, by which single
    precision rounds."""
    return native.require().tolerances.IN_PLANE * _size(points)


def _size(points):
    return float(np.abs(points).max(initial=0.0))


def fit(points, kind):
    """The plane of a kind in which most of the points (k, 3) lie: the median across an axis;
    otherwise the one with the least sum of squares, which RAKED holds to the athwartships axis.

    ValueError when the points lie in a line, along which a plane may turn, and when they have no
    places.
    """
    if not np.isfinite(points).all():
        raise ValueError("Coordinates of points are no numbers: give them others, or remove them")
    if kind in _NORMALS:
        return across_axis(_NORMALS[kind], float(np.median(points[:, _NORMALS[kind]])))
    centre = points.mean(axis=0)
    spread = points - centre
    if kind == "RAKED":
        spread[:, 1] = 0.0
    spread = np.concatenate([spread, np.zeros((3, 3))])  # so that there are three axes
    _, sizes, axes = np.linalg.svd(spread, full_matrices=False)
    needed = 0 if kind == "RAKED" else 1
    if sizes[needed] <= max(tolerance(points), 1e-5 * sizes[0]):
        raise ValueError("The points lie in a line: select faces that span a plane")
    normal = axes[2] if kind == "BEST" else np.array([-axes[0][2], 0.0, axes[0][0]])
    return np.append(normal, normal @ centre)


def across_axis(axis, position):
    """The plane across the axis 0, 1 or 2 through a position on it."""
    normal = np.zeros(3)
    normal[axis] = 1.0
    return np.append(normal, position)


def through(plane, point):
    """The plane parallel to one through a point."""
    return np.append(plane[:3], plane[:3] @ point)


def into_planes(point, planes):
    """The place nearest to a point (3,) in all the planes (m, 4), or nearest to all when they have
    none in common."""
    planes = np.asarray(planes, dtype=np.float64)
    normals, offsets = planes[:, :3], planes[:, 3]
    # Planes nearly parallel are taken for one: their intersection may be anywhere.
    moved = point + np.linalg.pinv(normals, rcond=1e-4) @ (offsets - normals @ point)
    for plane in planes:
        axis = _axis_of(plane)
        if axis is not None and abs(moved[axis] - plane[3] * plane[axis]) <= tolerance(moved):
            moved[axis] = plane[3] * plane[axis]
    return moved


def lies_in(point, planes):
    """Whether a point that Blender keeps is in all of the planes, as exactly as it can be kept."""
    for plane in planes:
        axis = _axis_of(plane)
        if axis is not None:
            if point[axis] != plane[3] * plane[axis]:
                return False
        elif abs(point @ plane[:3] - plane[3]) > _ROUNDING * max(_size(point), abs(plane[3])):
            return False
    return True
