# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull that is previewed with its shape fields, beside what they make afresh of its start."""

from dataclasses import replace

import numpy as np
from addon_under_test import part

# Of the hull's size: points are kept in single precision, twice where flats take them back.
_TOLERANCE = 1e-6
# Hulls of more points take a second each.
_MOST_POINTS = 400


def differences(hull, scene):
    """Sentences on a hull that is previewed."""
    previews = part("features.fields.preview")
    preview, start_points = previews.of_hull(hull), part("bridge.mesh.start_points")
    if preview is None:
        return []
    start, found = start_points.read(hull.data), part("bridge.objects.hull_mesh").read(hull)
    if start is None:
        return ["it is previewed, and where it was is not kept"]
    if not start_points.are_as_shown(hull.data, found.data.points):
        return [] if preview.problem else ["its points were moved, and its preview says nothing"]
    if len(start) > _MOST_POINTS or "previewed too" in preview.problem:
        return []
    wanted, problem = _afresh(hull, scene, start, found)
    if problem != preview.problem:
        return [f"its preview says {preview.problem!r}, afresh {problem!r}"]
    if problem:
        return []
    beside = np.abs(found.data.points - wanted).max(initial=0.0)
    size = np.abs(wanted).max(initial=0.0)
    return [f"previewed {beside} beside its fields"] if beside > _TOLERANCE * size else []


def _afresh(hull, scene, start, found):
    """(points (n, 3) that the hull is to have, or None, and what is said instead)."""
    field_list, shaping = part("features.fields.field_list"), part("features.fields.shaping")
    scale = part("bridge.blender.units").metres_per_unit(scene)
    points = start.astype(np.float64)
    try:
        own = part("features.fields.prepared").of_hull(
            hull, found.with_points(replace(found.data, points=start)), scale
        )
    except ValueError as error:
        return None, str(error)
    try:
        rows = field_list.in_use(hull)
    except ValueError:  # none shifts: it is shown as it was
        return points, ""
    try:
        applied = shaping.solve(hull, rows, own)
    except ValueError as error:
        return None, str(error)
    if applied is not None:
        which, places = shaping.moved_points(applied.result.moves, own)
        points[which] = places
    return points, ""
