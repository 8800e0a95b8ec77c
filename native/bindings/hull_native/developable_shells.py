# SPDX-License-Identifier: GPL-3.0-or-later
"""Developable surfaces by their rulings from curves along edges of a control mesh: the strip
between two, cones to a point, cylinders along a direction. Lengths are in metres."""

from dataclasses import dataclass
from math import isfinite

import numpy as np

from ._production import DevelopableStrip

# Where along half an edge the curve is taken, and the cubic's Bézier points through these.
_THIRDS = np.array([0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0])
_TO_BEZIER = np.linalg.inv(
    np.stack([(1 - _THIRDS) ** 3, 3 * _THIRDS * (1 - _THIRDS) ** 2,
              3 * _THIRDS**2 * (1 - _THIRDS), _THIRDS**3], axis=1)
)  # fmt: skip
# Sine of the least angle between a curve and a ruling, and of the size, the shortest ruling.
_LEAST_ANGLE, _SHORTEST = 1e-3, 1e-6


@dataclass(frozen=True)
class RuledShell:
    """Rulings of a developable surface: first, second (n, 3), their ends."""

    first: np.ndarray
    second: np.ndarray

    @property
    def area(self):
        """m², of the triangles between the rulings."""
        a, b = self.first, self.second
        one = np.cross(a[1:] - a[:-1], b[:-1] - a[:-1])
        other = np.cross(b[1:] - a[1:], b[:-1] - a[1:])
        return 0.5 * float((np.linalg.norm(one, axis=1) + np.linalg.norm(other, axis=1)).sum())


def edge_curve(surface, vertices):
    """Bézier points (8 (k - 1), 3) of the curve of a LimitSurface along edges between control
    points (k,), in order, two cubics an edge: exactly the curve of creases and borders, and
    elsewhere through four points of it. ValueError where two points have no edge between them."""
    vertices = [int(one) for one in vertices]
    if len(vertices) < 2:
        raise ValueError("A curve along edges needs two control points or more.")
    where = _sides(surface.mesh)
    cells, uv = [], []
    for a, b in zip(vertices, vertices[1:]):
        if (a, b) in where:
            (own, beyond), is_turned = where[a, b], False
        elif (b, a) in where:
            (beyond, own), is_turned = where[b, a], True
        else:
            raise ValueError(f"There is no edge between the control points {a} and {b}.")
        # From a corner along its side, and back to the other corner.
        along, back = (_THIRDS, 0.0 * _THIRDS), (0.0 * _THIRDS, 1.0 - _THIRDS)
        if is_turned:
            along, back = (0.0 * _THIRDS, _THIRDS), (1.0 - _THIRDS, 0.0 * _THIRDS)
        cells += [own] * 4 + [beyond] * 4
        uv += [np.stack(along, axis=1), np.stack(back, axis=1)]
    (points,) = surface.evaluate(np.array(cells), np.concatenate(uv))
    return (_TO_BEZIER @ points.reshape(-1, 4, 3)).reshape(-1, 3)


def _sides(mesh):
    """{(a, b): (cell at a, cell at b)} of the sides of all faces, in their direction."""
    found, first = {}, 0
    corners = np.asarray(mesh.face_vertices).tolist()
    for size in np.asarray(mesh.face_sizes).tolist():
        for k in range(size):
            following = first + (k + 1) % size
            found[corners[first + k], corners[following]] = first + k, following
        first += size
    return found


def strip_between(a, b, count=60):
    """The RuledShell of the DevelopableStrip between curves of Bézier points, turned so that they
    run the same way."""
    if np.linalg.norm(a[0] - b[0]) + np.linalg.norm(a[-1] - b[-1]) > (
        np.linalg.norm(a[0] - b[-1]) + np.linalg.norm(a[-1] - b[0])
    ):
        b = b[::-1]
    return RuledShell(*map(np.asarray, DevelopableStrip(a, b, count).ends))


def cone_to(curve, apex, count=60):
    """The RuledShell of the cone from a curve of Bézier points to an apex (3,), m. ValueError where
    the apex is on the curve, or a ruling runs along it."""
    points, ways = _sampled(curve, count)
    apex = np.asarray(apex, dtype=float)
    _check_rulings(points, ways, apex - points, "The apex lies on the chain, or along it")
    return RuledShell(points, np.broadcast_to(apex, points.shape).copy())


def cylinder_along(curve, shift, count=60):
    """The RuledShell of the cylinder from a curve of Bézier points along a shift (3,), m, which its
    rulings are as long as. ValueError for no shift and where the curve runs along it."""
    points, ways = _sampled(curve, count)
    shift = np.asarray(shift, dtype=float)
    if not all(map(isfinite, shift)) or not np.linalg.norm(shift) > 0.0:
        raise ValueError("A cylinder needs a direction and a length above 0 m.")
    rulings = np.broadcast_to(shift, points.shape)
    _check_rulings(points, ways, rulings, "The chain runs along the direction")
    return RuledShell(points, points + shift)


def _sampled(curve, count):
    """(points (n, 3), derivatives (n, 3)) of Bézier points, evenly in the spans' parameters."""
    spans = np.asarray(curve, dtype=float).reshape(-1, 4, 3)
    at = np.linspace(0.0, len(spans), count + 1)
    which = np.minimum(at.astype(int), len(spans) - 1)
    t = (at - which)[:, None]
    p = spans[which].transpose(1, 0, 2)
    points = (1 - t) ** 3 * p[0] + 3 * t * (1 - t) ** 2 * p[1]
    points += 3 * t**2 * (1 - t) * p[2] + t**3 * p[3]
    ways = (1 - t) ** 2 * (p[1] - p[0]) + 2 * t * (1 - t) * (p[2] - p[1]) + t**2 * (p[3] - p[2])
    return points, 3.0 * ways


def _check_rulings(points, ways, rulings, what):
    lengths = np.linalg.norm(rulings, axis=1)
    sines = np.linalg.norm(np.cross(ways, rulings), axis=1)
    sines /= np.maximum(np.linalg.norm(ways, axis=1) * lengths, 1e-300)
    short = lengths <= _SHORTEST * np.linalg.norm(np.ptp(points, axis=0))
    bad = np.flatnonzero(short | (sines < _LEAST_ANGLE))
    if len(bad):
        x, y, z = points[bad[0]]
        raise ValueError(
            f"{what} at ({x:.3f}, {y:.3f}, {z:.3f}) m: there is no surface there; choose another."
        )
