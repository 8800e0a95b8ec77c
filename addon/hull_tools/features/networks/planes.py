# SPDX-License-Identifier: GPL-3.0-or-later
"""The planes in which curves of a network stay: normals (unit) and offsets in the world, Blender's
units."""

import numpy as np

_AXES = {"X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0)}
# Of kinds of curves: the plane that a new one has.
PLANE_OF_KIND = {
    "STATION": "X",
    "WATERLINE": "Z",
    "BUTTOCK": "Y",
    "DIAGONAL": "OWN",
    "PROFILE": "Y",
    "FREE": "NONE",
    "DECK_EDGE": "NONE",
}
# Of a curve's size: what is one plane when it is looked for, as a person draws it.
FLAT = 1e-5
_PARALLEL = 1e-9
# Normals shorter than this are none: a person types them, of about 1.
_SHORTEST_NORMAL = 1e-6
# Of the points' distance from the origin: a place is on all planes, but for rounding.
_ON_ALL = 1e-7


def plane_of(settings):
    """(normal (3,), offset) of an Object.hull.curve; None for a curve in space, or with a normal
    that is none."""
    return carrier(settings.plane, settings.normal, settings.position)


def carrier(plane, normal, position):
    """The same of a plane as Object.hull.curve names it; the normal is that of an oblique one."""
    if plane == "NONE":
        return None
    normal = np.array(_AXES.get(plane) or normal, dtype=np.float64)
    length = np.linalg.norm(normal)
    if not (np.isfinite(length) and length > _SHORTEST_NORMAL):
        return None
    return normal / length, float(position)


def onto(points, planes):
    """Points (n, 3) at the least way onto all planes (normal, offset); None where they have no
    place in common."""
    if not planes:
        return points
    normals = np.array([normal for normal, _ in planes])
    offsets = np.array([offset for _, offset in planes])
    off = offsets[:, None] - normals @ points.T
    moves = np.linalg.pinv(normals, rcond=_PARALLEL) @ off
    size = max(np.abs(offsets).max(), np.abs(points).max(), 1e-9)
    if np.abs(normals @ moves - off).max() > _ON_ALL * size:
        return None
    return points + moves.T


def found_in(points):
    """(plane of Object.hull.curve, normal, position) in which points (n, 3) lie; ("NONE", None,
    0.0) where there is none, or more than one as of a line."""
    middle = points.mean(axis=0)
    size = np.ptp(points, axis=0).max()
    for name, axis in _AXES.items():
        heights = points @ axis
        if np.ptp(heights) <= FLAT * size:
            return name, np.array(axis), float(np.median(heights))
    _, sizes, axes = np.linalg.svd(points - middle, full_matrices=True)
    if len(sizes) < 3 or sizes[2] > FLAT * sizes[0] or sizes[1] <= FLAT * sizes[0]:
        return "NONE", None, 0.0
    normal = axes[2] * (1.0 if axes[2][np.abs(axes[2]).argmax()] > 0.0 else -1.0)
    return "OWN", normal, float(normal @ middle)


def kind_of(plane, position, size):
    """The kind that a curve in such a plane is taken for."""
    if plane == "Y" and abs(position) <= FLAT * size:
        return "PROFILE"
    return {"X": "STATION", "Y": "BUTTOCK", "Z": "WATERLINE"}.get(plane, "FREE")


def give(settings, kind, plane, normal, position):
    """Gives an Object.hull.curve kind and plane."""
    settings.kind, settings.plane, settings.position = kind, plane, position
    if plane == "OWN":
        settings.normal = normal
