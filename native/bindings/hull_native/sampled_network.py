# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of a hull as the curves of a network."""

import numpy as np

from ._core import crease_curves, plane_across, section_splines
from ._network import NetworkCurve

# Of creases and borders, between control points.
_PARTS_OF_EDGE = 4
# Of a spline's spans: points on it, between which a network's curve is to be the same.
_PARTS_OF_SPAN = 4
# Of the size: points of a curve that are nearer are one.
_SAME = 1e-9

_AXES = {"station": "x", "buttock": "y", "waterline": "z"}


def network_curves(surface, *, stations=(), waterlines=(), buttocks=(), tolerance):
    """NetworkCurves of a LimitSurface: its sections at x = stations, z = waterlines and y =
    buttocks, in their planes, and all its creases (kind 'knuckle') and borders ('profile').

    tolerance, m: how far a curve may be from the surface, about; join them with a few times as
    much. ValueError for a tolerance that is not above zero. Sections that run in a flat part of the
    surface, or along a border, are left out by `section_splines`.
    """
    if not tolerance > 0.0:
        raise ValueError("tolerance has to be above zero.")
    creases = crease_curves(surface)
    curves = [_crease(surface, number, curve) for number, curve in enumerate(creases)]
    for kind, positions in (
        ("station", stations),
        ("waterline", waterlines),
        ("buttock", buttocks),
    ):
        for position in positions:
            curves += _sections(surface, kind, float(position), tolerance)
    return curves


def _crease(surface, number, curve):
    count = _PARTS_OF_EDGE * curve.edge_count
    points = np.asarray(curve.evaluate(np.linspace(0.0, curve.edge_count, count + 1), 0)[0])
    kind = "profile" if curve.kind == "border" else "knuckle"
    return NetworkCurve(f"{curve.kind} {number}", _apart(points, surface.mesh.size), kind=kind)


def _sections(surface, kind, position, tolerance):
    plane = plane_across(_AXES[kind], position)
    (branches,) = section_splines(surface, [plane], tolerance)
    for number, branch in enumerate(branches):
        points, knuckles = _points_and_knuckles(branch.splines, surface.mesh.size)
        if len(points) < 2:
            continue
        name = f"{kind} {position:g}" + (f" ({number + 1})" if len(branches) > 1 else "")
        yield NetworkCurve(name, points, kind=kind, knuckles=knuckles, plane=plane)


def _points_and_knuckles(splines, size):
    """Points of all splines, one after the other, and the numbers of those where two meet."""
    points, knuckles = np.empty((0, 3)), []
    for spline in splines:
        knots = np.unique(spline.knots)
        shares = np.arange(_PARTS_OF_SPAN) / _PARTS_OF_SPAN
        inner = (knots[:-1, None] + shares * np.diff(knots)[:, None]).ravel()
        part = _apart(np.asarray(spline.evaluate(np.append(inner, knots[-1]))), size)
        if len(part) < 2:
            continue
        if len(points):
            knuckles.append(len(points) - 1)
            part = part[1:]
        points = np.concatenate([points, part])
    return points, knuckles


def _apart(points, size):
    """Without those that are where the one before is; the last one stays."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    keep = np.append(steps > _SAME * size, True)
    keep[0] = len(points) > 1
    return points[keep]
