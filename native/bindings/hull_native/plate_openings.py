# SPDX-License-Identifier: GPL-3.0-or-later
"""Where tunnels, stern tubes and trunks go through the shell, as marks on its plates."""

import numpy as np

# Radii that differ by less, of the larger, are those of a cylinder.
_SAME = 1e-9


def opening_marks(curves, appendages):
    """("OUTLINE", SurfaceCurve) of the openings that cylinders among Appendages have in the shell,
    by their names, made by HullCurves: as plate_drawing() takes marks. Of those that are mirrored
    both sides count.

    Parts of the shell beyond a cylinder's ends are left out, and so are cones, foils and bulbs and
    what does not meet the shell. ValueError, naming it, for a cylinder that touches the shell
    without a certain course.
    """
    marks = []
    for appendage in appendages:
        if appendage.shape != "cylinder":
            continue
        radius, end_radius = 0.5 * np.asarray(appendage.chords)
        if abs(radius - end_radius) > _SAME * max(radius, end_radius):
            continue
        for side in (1.0, -1.0) if appendage.mirrored else (1.0,):
            start, end = np.asarray(appendage.ends) * [1.0, side, 1.0]
            marks += [
                ("OUTLINE", curve)
                for curve in _met(curves, start, end - start, radius, appendage.name)
                if _is_between(curve.points, start, end)
            ]
    return marks


def _met(curves, point, direction, radius, name):
    try:
        return curves.on_cylinder(point, direction=direction, radius=radius, name=name)
    except ValueError as error:
        if "does not meet" in str(error):
            return []
        raise


def _is_between(points, start, end):
    """Whether all of a curve is between the planes of a cylinder's ends."""
    way = end - start
    along = (points - start) @ way / (way @ way)
    return bool((along >= 0.0).all() and (along <= 1.0).all())
