# SPDX-License-Identifier: GPL-3.0-or-later
"""Creases and borders on which shape fields are based lead the surface: as they depend on their own
control points alone, these are brought where the fields want them, and all others follow.

Least squares over the whole surface alone would leave a crease off by what suits its sides.
"""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from . import base_curves

# Points of each of a crease's edges that are brought where they are wanted, and at which it is
# looked how far that came.
_SAMPLES, _LOOKED = 8, 32
# Of hull_native.ControlMesh.vertex_kinds.
_DART = 1


@dataclass(frozen=True, eq=False)
class Led:
    """points (p,): control points that move as told by moves (p, 3), m. distance: of the creases
    then from the curves that they are to be, at most, m; None without creases."""

    points: np.ndarray
    moves: np.ndarray
    distance: float


def led(rows, fields, own, staying):
    """The Led of a hull's rows. fields: the hull_native.ShapeFields of them; own: the
    prepared.Prepared; staying (k,): control points that do not move."""
    staying = np.union1d(staying, own.limits["locked"]).astype(np.int64)
    moves, wanted = {}, []
    for number, crease in _creases(rows, own):
        t, _, shifts = _wanted(crease, fields, _SAMPLES)
        if not shifts.any():
            continue
        wanted.append((number, crease))
        found = native.require().crease_moves(own.surface, number, t, shifts, staying=staying)
        moves.update(zip(found[0].tolist(), found[1]))
    if not wanted:
        return Led(np.empty(0, dtype=np.int64), np.empty((0, 3)), None)
    which = np.setdiff1d(np.array(sorted(moves), dtype=np.int64), staying)
    told = np.array([moves[point] for point in which.tolist()]).reshape(-1, 3)
    limits = {**own.limits, "locked": staying}
    allowed = native.require().allowed_moves(own.surface, which, told, **limits)
    by_point = dict(zip(which.tolist(), allowed))
    distances = [_distance(own.surface, by_point, fields, *each) for each in wanted]
    return Led(which, allowed, max(distances))


def distance(rows, fields, own, moves):
    """As Led.distance, after moves (n, 3), m, of all control points."""
    by_point = dict(enumerate(moves))
    found = [_distance(own.surface, by_point, fields, *each) for each in _creases(rows, own)]
    return max(found, default=None)


def _creases(rows, own):
    """(number, hull_native.CreaseCurve) of those on which rows are based, but for what is protected
    on all axes, which stays, and for what fades out, which depends on points beside it."""
    based = [row for row in rows if row.base == "CREASE"]
    based = [row for row in based if row.role != "PROTECT" or not all(row.axes)]
    found = dict(base_curves.base_crease(row, own.surface, own.scale) for row in based)
    kinds = own.surface.mesh.vertex_kinds
    return [(n, crease) for n, crease in found.items() if (kinds[crease.vertices] != _DART).all()]


def _wanted(crease, fields, samples):
    """(t (k,), points (k, 3), their shifts (k, 3)) of so many places an edge of a crease."""
    t = np.linspace(0.0, crease.edge_count, samples * crease.edge_count + 1)
    points = crease.evaluate(t)[0]
    return t, points, fields.at(points)[0]


def _distance(surface, moves, fields, number, crease):
    """Of a crease, after moves {point: (3,)}, from the curve that it is to become, at most."""
    hull_native = native.require()
    t, points, shifts = _wanted(crease, fields, _LOOKED)
    # A corner where the crease both begins and ends is one control point.
    vertices = dict.fromkeys(crease.vertices.tolist())
    own = np.array([moves.get(point, np.zeros(3)) for point in vertices])
    now = points + hull_native.crease_shifts(surface, number, t, own)
    if crease.closed:
        points, shifts = points[:-1], shifts[:-1]
    return float(hull_native.FieldCurve(points + shifts, closed=crease.closed).distances(now).max())
