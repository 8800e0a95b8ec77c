# SPDX-License-Identifier: GPL-3.0-or-later
"""Where along a contour the stem begins, the stern post ends, and it arches above that."""

import numpy as np

# Steepness of the contour, degrees, beyond which it is stem or stern post; where it is nowhere so
# steep the next one.
_STEEP = (45.0, 30.0, 20.0, 10.0)
# Above a stern post the contour arches: it is as steep as this over so much of the depth.
_POST, _POST_HEIGHT = 50.0, 0.12


def find_ends(outline):
    """Tells an outline that has its lines where stem, stern post and arch are. ValueError where the
    contour rises to none."""
    _find_stem(outline)
    _find_post(outline)


def _slopes(outline):
    """Lengths along the contour, points there, and the steepness between them, degrees."""
    at = np.linspace(0.0, outline.lengths[-1], 600)
    points = outline.on_contour(at)
    way = np.diff(points, axis=0)
    return at, points, np.degrees(np.arctan2(way[:, 2], way[:, 0]))


def _find_stem(outline):
    if outline.forward is not None:
        return
    at, points, angles = _slopes(outline)
    amidships = 0.5 * (outline.low[0] + outline.high[0])
    is_forward = points[:-1, 0] > amidships
    for steep in _STEEP:
        found = np.flatnonzero(is_forward & ((angles > steep) | (angles < -100.0)))
        if len(found) and found[0] < len(angles) - 8:
            outline.stem = float(at[found[0]])
            return
    raise ValueError("The contour rises to no stem, and there is no flat bow: give the stem.")


def _find_post(outline):
    at, points, angles = _slopes(outline)
    is_aft = points[:-1, 0] < 0.5 * (outline.low[0] + outline.high[0])
    if outline.aft is not None:
        found = np.flatnonzero((np.abs(angles) > _POST) & is_aft)
        depth = outline.high[2] - outline.low[2]
        if len(found) and points[found[0], 2] - points[found[-1], 2] > _POST_HEIGHT * depth:
            outline.arch, outline.post = float(at[found[0]]), float(at[found[-1] + 1])
        return
    for steep in _STEEP:
        found = np.flatnonzero(is_aft & ((angles < -steep) | (angles > 100.0)))
        if len(found) and found[-1] > 8:
            outline.post = float(at[found[-1] + 1])
            return
    raise ValueError("The contour rises to no stern, and there is no transom: give the stern.")
