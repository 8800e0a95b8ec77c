# SPDX-License-Identifier: GPL-3.0-or-later
"""B-spline surfaces in files of PolyCAD (`.geo`): text of sections in square brackets with lines
KEY=VALUE. A surface ([TBSplineSurface], [TShipLines], [TYachtLines]) has OrderU, OrderV (degree and
one), NumU, NumV and then its control points, a line "x y z" each, V running faster; knots are taken
to be uniform, with the surface beginning and ending at its border points. Metres, x forward.

As FREE!ship's reader takes them, which takes the control points alone.
"""

import re

import numpy as np

from ..errors import HullFileError
from ..limits import FURTHEST_POINT, MAX_COUNT, MAX_GEOMETRY_POINTS
from ..table_text import number_in
from .splines import Spline
from .values import Geometry, GeometryMesh

_SURFACES = ("[TBSplineSurface]", "[TShipLines]", "[TYachtLines]")
_PARTS = 6  # of a span, in each direction
_MOST_ORDER = 20


def is_polycad(text):
    return any(name in text for name in _SURFACES)


def read_polycad(text, name):
    """The Geometry of a file: a GeometryMesh on each surface. HullFileError with the line."""
    lines = text.splitlines()
    starts = [k for k, line in enumerate(lines) if line.strip() in _SURFACES]
    if not starts:
        raise HullFileError(
            f"{name}: no line begins a surface, such as '[TShipLines]' alone; use another copy."
        )
    meshes, count = [], 0
    for number, start in enumerate(starts, 1):
        degrees, grid = _surface(lines, start, name)
        count += int(np.prod([_places(n, degree) for n, degree in zip(grid.shape, degrees)]))
        if count > MAX_GEOMETRY_POINTS:
            raise HullFileError(
                f"{name}: line {start + 1}: its surfaces up to here have more than "
                f"{MAX_GEOMETRY_POINTS} places; write fewer, or with fewer points."
            )
        about = {"name": f"surface {number}", "group": lines[start].strip(" []")}
        meshes.append(_mesh(degrees, grid, about))
    return Geometry(name, "PolyCAD", "m", meshes=tuple(meshes), on_ship_axes=True)


def _surface(lines, start, name):
    """((degree in u, in v), control points (u, v, 3)) of the surface at a line."""
    values, k = {}, start + 1
    while k < len(lines) and not _is_point(lines[k]):
        key, equals, value = lines[k].partition("=")
        if lines[k].strip().startswith("["):
            break
        if equals:
            values[key.strip()] = value.strip()
        k += 1
    order_u, order_v = (_whole(values, key, 4, _MOST_ORDER, name) for key in ("OrderU", "OrderV"))
    count_u, count_v = (_whole(values, key, None, MAX_COUNT, name) for key in ("NumU", "NumV"))
    if count_u * count_v > MAX_COUNT:
        raise HullFileError(
            f"{name}: a surface has more than {MAX_COUNT} points; use another copy."
        )
    points = []
    for row in range(k, k + count_u * count_v):
        if row >= len(lines) or not _is_point(lines[row]):
            raise HullFileError(
                f"{name}: line {row + 1}: {count_u} times {count_v} points are announced, and "
                f"{len(points)} are there; use another copy."
            )
        point = [number_in(word) for word in lines[row].split()[:3]]
        if None in point:
            raise HullFileError(
                f"{name}: line {row + 1}: '{lines[row].strip()[:40]}' is no point; write x, y and "
                "z as '12.5 3.0 1.2'."
            )
        points.append(point)
    grid = np.array(points).reshape(count_u, count_v, 3)
    if not (np.abs(grid) <= FURTHEST_POINT).all():
        raise HullFileError(f"{name}: a point near line {k + 1} can't be a ship's; mend it.")
    return (min(order_u, count_u) - 1, min(order_v, count_v) - 1), grid


def _is_point(line):
    return re.match(r"\s*([-+]?[\d.]+([eE][-+]?\d+)?\s+){2}[-+]?[\d.]", line) is not None


def _whole(values, key, usual, most, name):
    text = values.get(key, "" if usual is None else str(usual))
    if not re.fullmatch(r"\d{1,6}", text) or not 2 <= int(text) <= most:
        raise HullFileError(
            f"{name}: '{key}={text[:20]}' is no whole number from 2 to {most}; use another copy."
        )
    return int(text)


def _mesh(degrees, grid, about):
    """A mesh on the B-spline surface of control points (u, v, 3)."""
    along_u = _curves(degrees[0], grid)
    places = _curves(degrees[1], along_u.swapaxes(0, 1)).swapaxes(0, 1)
    u, v = places.shape[:2]
    at = np.arange(u * v).reshape(u, v)
    a, b, c, d = (x.ravel() for x in (at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]))
    triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return GeometryMesh(places.reshape(-1, 3), triangles, is_exact=False, **about)


def _places(count, degree):
    """How many along a curve of so many control points."""
    return _PARTS * (count - degree) + 1


def _curves(degree, points):
    """Places (m, k, 3) on the k curves of control points (n, k, 3)."""
    n = len(points)
    inner = np.arange(n - degree + 1.0)
    knots = np.concatenate([np.full(degree, inner[0]), inner, np.full(degree, inner[-1])])
    at = np.linspace(inner[0], inner[-1], _places(n, degree))
    ones = np.ones(n)
    return np.stack(
        [Spline(degree, knots, points[:, k], ones).evaluate(at) for k in range(points.shape[1])],
        axis=1,
    )
