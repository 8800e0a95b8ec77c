# SPDX-License-Identifier: GPL-3.0-or-later
"""Where words have room on a flat plate, and how far a straight line goes within it."""

import numpy as np

_PLACES = 400
# Of the most room that there is: with so much the place nearest to the middle is the best one.
_ENOUGH = 0.9


def roomy_place(flat, lines):
    """((2,), m): of a FlatPlate the middle of the rectangle around it where it has room, else the
    nearest place that has; how far the border is away. lines: (n, 2) of that and of its holes."""
    middle = 0.5 * (flat.points.min(axis=0) + flat.points.max(axis=0))
    corners = flat.points[flat.triangles]
    places = corners[:: max(1, len(corners) // _PLACES)].mean(axis=1)
    if _is_within(corners, middle):
        places = np.vstack([middle, places])
    room = np.full(len(places), np.inf)
    for line in lines:
        np.minimum(room, _distances(places, line), out=room)
    roomy = np.flatnonzero(room >= _ENOUGH * room.max())
    best = roomy[np.argmin(np.linalg.norm(places[roomy] - middle, axis=1))]
    return places[best], float(room[best])


def reach_within(lines, place, way):
    """m: how far one can go from a place both along a direction (2,) and against it without meeting
    a line."""
    across = np.array([-way[1], way[0]])
    reach = np.inf
    for line in lines:
        off, along = (line - place) @ across, (line - place) @ way
        at = np.flatnonzero((off[:-1] < 0.0) != (off[1:] < 0.0))
        share = off[at] / (off[at] - off[at + 1])
        met = np.abs(along[at] + share * (along[at + 1] - along[at]))
        reach = min(reach, met.min(initial=np.inf))
    return reach


def _is_within(corners, place):
    """Whether a place is in one of triangles (n, 3, 2) that turn one way."""
    sides = np.roll(corners, -1, axis=1) - corners
    to_place = place - corners
    turns = sides[..., 0] * to_place[..., 1] - sides[..., 1] * to_place[..., 0]
    return bool(((turns >= 0.0).all(axis=1) | (turns <= 0.0).all(axis=1)).any())


def _distances(places, line):
    """(m,) m from a line (n, 2)."""
    start, way = line[:-1], np.diff(line, axis=0)
    squares = np.maximum((way**2).sum(axis=1), 1e-300)
    share = np.clip(((places[:, None] - start) * way).sum(axis=-1) / squares, 0.0, 1.0)
    feet = start + share[..., None] * way
    return np.linalg.norm(feet - places[:, None], axis=-1).min(axis=1)
