# SPDX-License-Identifier: GPL-3.0-or-later
"""What entities of DXF files are: curves, points and faces, placed by their own axes and blocks."""

import math
from dataclasses import dataclass, field

import numpy as np

from .dxf_records import DxfError
from .splines import Spline, arc_spline
from .values import polyline, spline_curve

_FULL = 2.0 * math.pi
# Of a smooth polyline's bulge: an arc of less than this is a line.
_NO_BULGE = 1e-12


@dataclass(frozen=True)
class Placement:
    """Where the entities of a block come: p -> matrix p + origin."""

    matrix: np.ndarray = field(default_factory=lambda: np.eye(3))
    origin: np.ndarray = field(default_factory=lambda: np.zeros(3))

    def points(self, points):
        return np.asarray(points, dtype=float) @ self.matrix.T + self.origin

    def shifted(self, shift):
        return Placement(self.matrix, self.origin + self.matrix @ np.array(shift))

    def inserted(self, record, block):
        """That of the entities of a block that an INSERT in this placement shows."""
        angle = math.radians(record.number(50))
        turn = np.array(
            [
                [math.cos(angle), -math.sin(angle), 0.0],
                [math.sin(angle), math.cos(angle), 0.0],
                [0.0, 0.0, 1.0],
            ]
        )
        scale = np.diag([record.number(code, 1.0) for code in (41, 42, 43)])
        own = _own_axes(record)
        matrix = self.matrix @ own @ turn @ scale
        base = np.array([block.number(code) for code in (10, 20, 30)])
        at = own @ np.array([record.number(code) for code in (10, 20, 30)])
        return Placement(matrix, self.origin + self.matrix @ at - matrix @ base)

    def curve(self, value, **about):
        """Of a Spline, or of (points, knuckles)."""
        if isinstance(value, Spline):
            points = self.points(value.points)
            return spline_curve(Spline(value.degree, value.knots, points, value.weights), **about)
        points, knuckles = value
        return polyline(self.points(points), knuckles, **about)


def shape_of(record):
    """("curve", Spline or (points, knuckles)), ("point", (1, 3)), ("face", (4, 3)), or None for an
    entity that is none of these. DxfError or ValueError for one that is damaged."""
    reader = _READERS.get(record.type)
    return reader(record) if reader else None


def _own_axes(record):
    """(3, 3), columns: the axes of an entity's own plane by its extrusion, as the format makes
    them of that direction alone."""
    normal = np.array([record.number(210), record.number(220), record.number(230, 1.0)])
    length = np.linalg.norm(normal)
    if not length > 0.0:
        raise DxfError(f"line {record.line}: {record.type}: its extrusion has no direction")
    normal = normal / length
    near_z = abs(normal[0]) < 1.0 / 64.0 and abs(normal[1]) < 1.0 / 64.0
    first = np.cross((0.0, 1.0, 0.0) if near_z else (0.0, 0.0, 1.0), normal)
    first /= np.linalg.norm(first)
    return np.column_stack([first, np.cross(normal, first), normal])


def _place(record, *codes):
    return np.array([record.number(code) for code in codes])


def _line(record):
    ends = [_place(record, 10, 20, 30), _place(record, 11, 21, 31)]
    return "curve", (np.array(ends), ())


def _point(record):
    return "point", _place(record, 10, 20, 30)[None]


def _face(record):
    corners = [_place(record, 10 + k, 20 + k, 30 + k) for k in range(4)]
    if not any(record.numbers(code) for code in (13, 23, 33)):
        corners[3] = corners[2]  # three corners alone may be written
    return "face", np.array(corners)


def _arc(record):
    axes = _own_axes(record)
    centre, radius = axes @ _place(record, 10, 20, 30), record.number(40)
    if not radius > 0.0:
        raise DxfError(f"line {record.line}: {record.type}: its radius is {radius:g}")
    start, end = 0.0, _FULL
    if record.type == "ARC":
        start = math.radians(record.number(50))
        end = start + _turn(math.radians(record.number(51)) - start)
    return "curve", arc_spline(centre, radius * axes[:, 0], radius * axes[:, 1], start, end)


def _turn(angle):
    """Within (0, 2 pi]."""
    angle = math.fmod(angle, _FULL)
    return angle + _FULL if angle <= 0.0 else angle


def _ellipse(record):
    centre, major = _place(record, 10, 20, 30), _place(record, 11, 21, 31)
    minor = record.number(40, 1.0) * np.cross(_own_axes(record)[:, 2], major)
    start = record.number(41)
    end = start + _turn(record.number(42, _FULL) - start)
    return "curve", arc_spline(centre, major, minor, start, end)


def _spline(record):
    rows = [record.numbers(code) for code in (10, 20, 30)]
    points = _columns(record, rows)
    if not len(points):
        fit = _columns(record, [record.numbers(code) for code in (11, 21, 31)])
        if len(fit) < 2:
            raise DxfError(f"line {record.line}: SPLINE: it has no points")
        # The format leaves open which curve goes through them.
        return "curve", (fit, ())
    weights = record.numbers(41)
    weights = np.array(weights) if len(weights) == len(points) else np.ones(len(points))
    return "curve", Spline(record.flags(71), np.array(record.numbers(40)), points, weights)


def _columns(record, rows):
    if not rows[2]:
        rows[2] = [0.0] * len(rows[0])
    if len({len(row) for row in rows}) != 1:
        raise DxfError(f"line {record.line}: {record.type}: it has not x, y and z of each point")
    return np.array(rows).T.reshape(-1, 3)


def _light_polyline(record):
    xs, ys = record.numbers(10), record.numbers(20)
    if len(xs) != len(ys) or len(xs) < 2:
        raise DxfError(f"line {record.line}: LWPOLYLINE: it has not x and y of two points or more")
    bulges, at = np.zeros(len(xs)), -1
    for code, value in record.pairs:
        at += code == 10
        if code == 42 and at >= 0:
            bulges[at] = float(value)
    points = np.column_stack([xs, ys, np.full(len(xs), record.number(38))])
    return "curve", _bulged(record, points, bulges, bool(record.flags(70) & 1))


def _polyline(record):
    flags = record.flags(70)
    if flags & (16 | 64):
        return None  # meshes
    # Of a curve that was smoothed, 16 marks the frame, which is not drawn.
    vertices = [v for v in record.parts if not v.flags(70) & 16]
    if len(vertices) < 2:
        raise DxfError(f"line {record.line}: POLYLINE: it has not two vertices")
    points = np.array([_place(v, 10, 20, 30) for v in vertices])
    if flags & 8:
        return "curve", (np.concatenate([points, points[:1]]) if flags & 1 else points, ())
    points[:, 2] = record.number(30)
    bulges = np.array([v.number(42) for v in vertices])
    return "curve", _bulged(record, points, bulges, bool(flags & 1))


def _bulged(record, points, bulges, is_closed):
    """(points, knuckles) of lines and arcs by the tangents of a quarter of the arcs' angles; in
    the entity's own plane."""
    if is_closed:
        points, bulges = np.concatenate([points, points[:1]]), np.append(bulges, 0.0)
    axes = _own_axes(record)
    placed = [points[:1]]
    for a, b, bulge in zip(points, points[1:], bulges):
        if not abs(bulge) <= _NO_BULGE and (a != b).any():
            if not abs(bulge) <= 1e6:
                raise DxfError(f"line {record.line}: {record.type}: its bulge is {bulge:g}")
            placed.append(_bulge_arc(a, b, bulge))
        placed.append(b[None])
    return np.concatenate(placed) @ axes.T, ()


def _bulge_arc(a, b, bulge):
    """Points of the arc between two points of a plane z = constant, without them."""
    angle = 4.0 * math.atan(bulge)
    chord = b - a
    sideways = np.array([-chord[1], chord[0], 0.0])
    centre = 0.5 * (a + b) + sideways * 0.25 * (1.0 / bulge - bulge)
    # A chord misses 1e-5 of the radius.
    count = max(2, math.ceil(abs(angle) / 9e-3))
    t = angle * np.arange(1, count) / count
    arm = a - centre
    across = np.array([-arm[1], arm[0], 0.0])
    return centre + np.outer(np.cos(t), arm) + np.outer(np.sin(t), across)


_READERS = {
    "LINE": _line,
    "POINT": _point,
    "3DFACE": _face,
    "ARC": _arc,
    "CIRCLE": _arc,
    "ELLIPSE": _ellipse,
    "SPLINE": _spline,
    "LWPOLYLINE": _light_polyline,
    "POLYLINE": _polyline,
}
