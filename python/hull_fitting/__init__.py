# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls that exist as surfaces become control meshes: features found, a layout laid along them, the
fit, and how near it is.

Start at `hull_from_geometry`. Lengths are in metres.
"""

from .making import MadeHull, hull_from_geometry
from .overlays import StationOverlay, station_overlays

__all__ = ["MadeHull", "StationOverlay", "hull_from_geometry", "station_overlays"]
