# SPDX-License-Identifier: GPL-3.0-or-later
"""What was read of a hull that exists: curves, meshes of triangles and points, as the file has
them.

Numbers are in the file's own unit of length and on its own axes, whatever these are; `guessing`
finds
out, `orienting` brings them to a ship's. Only points of FREE!ship's stored sections and of CAD
files
have been scaled, as the latter's formats say how.
"""

from dataclasses import dataclass, field

import numpy as np

from .splines import Spline

METRES_PER_UNIT = {"m": 1.0, "cm": 0.01, "mm": 0.001, "ft": 0.3048, "in": 0.0254}
# What a curve of a hull may be, in files that tell; "" elsewhere.
CURVE_KINDS = (
    *("", "station", "waterline", "buttock", "diagonal", "profile", "deck_edge", "knuckle"),
    *("border", "edge"),
)


@dataclass(frozen=True)
class GeometryCurve:
    """points: (n, 3), two or more, in order; of a spline places on it so dense that the polyline is
    it for the eye. knuckles: (n,) bool, where the file says that the curve has a knuckle. kind: one
    of CURVE_KINDS; "border" and "edge" are sides of one and of two CAD faces. group: the layer.
    spline: the exact curve, where the file has one."""

    points: np.ndarray
    knuckles: np.ndarray
    name: str = ""
    kind: str = ""
    group: str = ""
    spline: Spline | None = None


@dataclass(frozen=True)
class GeometryMesh:
    """points (n, 3), triangles (m, 3); of CAD files one for each face. exact: whether the points
    are all that is known, as in an STL file; else triangles are within the chord tolerance."""

    points: np.ndarray
    triangles: np.ndarray
    name: str = ""
    group: str = ""
    is_exact: bool = True


@dataclass(frozen=True)
class Geometry:
    """name: of the file. format: what it was read as. unit: a key of METRES_PER_UNIT, None where
    the file doesn't tell. points: (n, 3), in no order. left_out: sentences. is_half: whether it is
    one side of a hull, where the file tells; None elsewhere. on_ship_axes: whether the file's axes
    are told to be x forward, y to port or to the side, z up."""

    name: str
    format: str
    unit: str | None = None
    curves: tuple = ()
    meshes: tuple = ()
    points: np.ndarray = field(default_factory=lambda: np.empty((0, 3)))
    left_out: tuple = ()
    is_half: bool | None = None
    on_ship_axes: bool = False

    @property
    def is_empty(self):
        return not (self.curves or self.meshes or len(self.points))

    def all_points(self):
        """(n, 3): those of curves, meshes and points."""
        parts = [c.points for c in self.curves] + [m.points for m in self.meshes] + [self.points]
        return np.concatenate(parts)


def polyline(points, knuckles=(), **about):
    """The GeometryCurve of points; knuckles: their indices. None of fewer than two places."""
    points = np.asarray(points, dtype=float).reshape(-1, 3)
    is_knuckle = np.zeros(len(points), dtype=bool)
    is_knuckle[list(knuckles)] = True
    keep = np.ones(len(points), dtype=bool)
    keep[1:] = (points[1:] != points[:-1]).any(axis=1)
    # A knuckle told for one of two points at one place is one of the one that stays.
    for k in np.flatnonzero(~keep & is_knuckle):
        is_knuckle[np.flatnonzero(keep[:k])[-1]] = True
    if keep.sum() < 2:
        return None
    return GeometryCurve(points[keep], is_knuckle[keep], **about)


def spline_curve(spline, chord_share=1e-5, **about):
    """The GeometryCurve of a Spline: `chord_share` of its size from the curve at most, about."""
    points, knuckles = spline.sampled(chord_share)
    return GeometryCurve(points, knuckles, spline=spline, **about)
