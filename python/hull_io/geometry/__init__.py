# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls that exist, read from files of other programs: curves, meshes and points.

Start at `read_geometry`, which finds out what a file is, and `Geometry`, which it returns.
`guess_hull` finds axes, unit, half or whole, and `oriented` brings what was read to a ship's axes;
`placed_views` puts the views of a lines plan together first.
"""

from .guessing import Guess, guess_hull
from .orienting import oriented
from .placed_views import placed_views
from .reading import read_geometry
from .splines import Spline
from .values import METRES_PER_UNIT, Geometry, GeometryCurve, GeometryMesh, polyline

__all__ = [
    "METRES_PER_UNIT",
    "Geometry",
    "GeometryCurve",
    "GeometryMesh",
    "Guess",
    "Spline",
    "guess_hull",
    "oriented",
    "placed_views",
    "polyline",
    "read_geometry",
]
