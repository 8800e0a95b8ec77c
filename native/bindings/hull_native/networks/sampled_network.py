# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of a hull as the curves of a network."""

import numpy as np

from .._core import SurfaceTree, crease_curves, plane_across, section_splines
from .._network import NetworkCurve
from .sampling import parameters_within

# Of creases and borders, between control points.
_PARTS_OF_EDGE = 4
# Of a spline's spans: points on it, between which a network's curve is to be the same.
_PARTS_OF_SPAN = 4
# Of the size: points of a curve that are nearer are one.
_SAME = 1e-9

# Of normals: the part upwards of those where the surface is flatter than 45 degrees.
_FLAT = np.sqrt(0.5)
_BISECTIONS = 60
# Of the size: points of curves that are nearer to a station are on it.
_AT_STATION = 1e-8

_AXES = {"station": "x", "buttock": "y", "waterline": "z"}


def network_curves(
    surface,
    *,
    stations=(),
    waterlines=(),
    buttocks=(),
    flat_buttocks=(),
    fading=False,
    tolerance,
):
    """NetworkCurves of a LimitSurface: its sections at x = stations, z = waterlines and y =
    buttocks, in their planes, and all its creases (kind 'knuckle') and borders ('profile').

    Waterlines tell little of bottoms: flat_buttocks are the parts of those at y from station to
    station where the surface is flatter than 45 degrees in the mean. fading: a knuckle that fades
    out within the surface gets a station at its end, so that it ends on a curve.

    tolerance, m: how far a curve may be from the surface, about; join them with a few times as
    much. ValueError for a tolerance that is not above zero. Sections that run in a flat part of the
    surface, or along a border, are left out by `section_splines`.
    """
    if not tolerance > 0.0:
        raise ValueError("tolerance has to be above zero.")
    creases = crease_curves(surface)
    curves = [_crease(surface, number, curve, tolerance) for number, curve in enumerate(creases)]
    stations = [float(x) for x in stations]
    if fading:
        stations += _fading_ends(curves, stations, tolerance)
    for kind, positions in (
        ("station", stations),
        ("waterline", waterlines),
        ("buttock", buttocks),
    ):
        for position in positions:
            curves += _sections(surface, kind, float(position), tolerance)
    tree = SurfaceTree(surface) if len(flat_buttocks) else None
    for position in flat_buttocks:
        curves += _flat_parts(surface, tree, float(position), stations, tolerance)
    return curves


def _fading_ends(curves, stations, tolerance):
    """x of ends of knuckles that lie on no other crease or border, and on no station."""
    found = []
    for curve in curves:
        if curve.kind != "knuckle" or np.allclose(curve.points[0], curve.points[-1]):
            continue
        others = [other.points for other in curves if other is not curve]
        for end in curve.points[[0, -1]]:
            if min(_distance(end, points) for points in others) <= tolerance:
                continue
            if all(abs(end[0] - x) > tolerance for x in [*stations, *found]):
                found.append(end[0])
    return found


def _distance(point, points):
    """m, from the polygon of points."""
    steps = np.diff(points, axis=0)
    along = np.einsum("ij,ij->i", point - points[:-1], steps)
    shares = np.clip(along / np.einsum("ij,ij->i", steps, steps), 0.0, 1.0)
    return np.linalg.norm(points[:-1] + shares[:, None] * steps - point, axis=1).min()


def _flat_parts(surface, tree, position, stations, tolerance):
    """The NetworkCurves of a buttock, from station to station, where the surface is flat."""
    plane = plane_across("y", position)
    (branches,) = section_splines(surface, [plane], tolerance)
    for number, branch in enumerate(branches):
        points, knuckles = _points_and_knuckles(
            branch.splines, surface.mesh.size, tolerance, stations
        )
        if len(points) < 2:
            continue
        for low, high in _flat_ranges(surface, tree, points, stations, knuckles):
            inner = [k - low for k in knuckles if low < k < high]
            name = f"buttock {position:g} ({number + 1}.{low})"
            part = points[low : high + 1]
            yield NetworkCurve(name, part, kind="buttock", knuckles=inner, plane=plane)


def _flat_ranges(surface, tree, points, stations, knuckles):
    """Pairs of numbers of points, at stations, knuckles or ends, between which the surface is
    flat."""
    x = points[:, :1] - np.asarray(stations)[None]
    at_station = np.abs(x).min(axis=1, initial=np.inf) <= _AT_STATION * surface.mesh.size
    cuts = np.unique(np.r_[0, np.flatnonzero(at_station), knuckles, len(points) - 1]).astype(int)
    closest = tree.closest_points(points)
    upwards = np.abs(surface.normals(closest.cells, closest.uv)[:, 2])
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    weighted = steps * 0.5 * (upwards[1:] + upwards[:-1])
    ranges = []
    for low, high in zip(cuts[:-1], cuts[1:]):
        if weighted[low:high].sum() < _FLAT * steps[low:high].sum():
            continue
        if ranges and ranges[-1][1] == low:
            ranges[-1] = (ranges[-1][0], high)
        else:
            ranges.append((low, high))
    return ranges


def _crease(surface, number, curve, tolerance):
    count = _PARTS_OF_EDGE * curve.edge_count

    def places(at):
        return np.asarray(curve.evaluate(at, 0)[0])

    even = np.linspace(0.0, curve.edge_count, count + 1)
    points = places(parameters_within(places, even, tolerance))
    kind = "profile" if curve.kind == "border" else "knuckle"
    return NetworkCurve(f"{curve.kind} {number}", _apart(points, surface.mesh.size), kind=kind)


def _sections(surface, kind, position, tolerance):
    plane = plane_across(_AXES[kind], position)
    (branches,) = section_splines(surface, [plane], tolerance)
    for number, branch in enumerate(branches):
        points, knuckles = _points_and_knuckles(branch.splines, surface.mesh.size, tolerance)
        if len(points) < 2:
            continue
        name = f"{kind} {position:g}" + (f" ({number + 1})" if len(branches) > 1 else "")
        yield NetworkCurve(name, points, kind=kind, knuckles=knuckles, plane=plane)


def _points_and_knuckles(splines, size, tolerance, stations=()):
    """Points of all splines, one after the other, those at x = stations among them, and the numbers
    of those where two splines meet."""
    points, knuckles = np.empty((0, 3)), []
    for spline in splines:
        knots = np.unique(spline.knots)
        shares = np.arange(_PARTS_OF_SPAN) / _PARTS_OF_SPAN
        inner = (knots[:-1, None] + shares * np.diff(knots)[:, None]).ravel()
        at = np.append(inner, knots[-1])
        if len(stations):
            at = np.sort(np.append(at, _station_parameters(spline, at, stations)))
        at = parameters_within(spline.evaluate, at, tolerance)
        part = _apart(np.asarray(spline.evaluate(at)), size)
        if len(part) < 2:
            continue
        if len(points):
            knuckles.append(len(points) - 1)
            part = part[1:]
        points = np.concatenate([points, part])
    return points, knuckles


def _station_parameters(spline, at, stations):
    """Where a spline crosses x = stations between the parameters at."""
    x = np.asarray(spline.evaluate(at))[:, 0]
    rows, crossings = np.nonzero((x[:-1, None] - stations) * (x[1:, None] - stations) < 0.0)
    low, high, wanted = at[rows], at[rows + 1], np.asarray(stations)[crossings]
    rises = x[rows + 1] > x[rows]
    if not len(low):
        return low
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        is_beyond = (np.asarray(spline.evaluate(middle))[:, 0] > wanted) == rises
        low, high = np.where(is_beyond, low, middle), np.where(is_beyond, middle, high)
    return 0.5 * (low + high)


def _apart(points, size):
    """Without those that are where the one before is; the last one stays."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    keep = np.append(steps > _SAME * size, True)
    keep[0] = len(points) > 1
    return points[keep]
