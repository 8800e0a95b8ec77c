# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls that exist as surfaces become control meshes: features found, a layout laid along them, the
fit, and how near it is.

Start at `hull_from_geometry`. Lengths are in metres.
"""

from .making import MadeHull, hull_from_geometry

__all__ = ["MadeHull", "hull_from_geometry"]
