# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls for tests of panels and models, and what is checked of their faces."""

import hull_native as hn
import numpy as np
from transformation_hulls import SAMPLES, Sample, grid_mesh

__all__ = ["SAMPLES", "body_of", "hemisphere", "odd_sides", "side_uses"]


def body_of(name):
    """(Sample, HullBody): keep the first as long as the second."""
    sample = Sample(name)
    return sample, hn.HullBody(sample.surface, mirrored=sample.half)


def hemisphere(radius, around=96):
    """LimitSurface of a whole sphere about the origin, cut level at the height radius / 2, as round
    as cubic B-splines through `around` points of great circles are."""
    step = 2 * np.pi / around
    polar = np.arange(around // 3 + 1) * step
    turn = np.arange(around) * step
    rows = np.eye(len(polar))
    for i in range(1, len(polar) - 1):
        rows[i, i - 1 : i + 2] = 1 / 6, 4 / 6, 1 / 6
    r, z = np.linalg.solve(rows, np.stack([np.sin(polar), -np.cos(polar)], axis=1) * radius).T
    # Of the closed B-spline around whose knots are on the unit circle.
    wide = 6 / (4 + 2 * np.cos(step)) * r[:, None]
    points = [wide * np.cos(turn), wide * np.sin(turn), np.repeat(z[:, None], around, 1)]
    return hn.LimitSurface(grid_mesh(np.stack(points, axis=-1), is_round=True))


def side_uses(points, faces):
    """Counts of directed sides of faces (n, k) between places: what is at one place to 1e-7 is one
    point. A dictionary (place, place) -> count, and the place of each point."""
    _, place = np.unique(np.round(np.asarray(points) / 1e-7), axis=0, return_inverse=True)
    place = place.ravel()
    uses = {}
    for face in place[faces]:
        corners = face[face != np.roll(face, 1)]
        if len(corners) < 3:
            continue
        for side in zip(corners.tolist(), np.roll(corners, -1).tolist()):
            uses[side] = uses.get(side, 0) + 1
    return uses, place


def odd_sides(points, faces):
    """Sides that are not run through once in each direction, as (k, 2) places, and all places."""
    uses, place = side_uses(points, faces)
    odd = [s for s, n in uses.items() if n != 1 or uses.get(s[::-1], 0) != 1]
    return np.array(odd, dtype=int).reshape(-1, 2), place
