# SPDX-License-Identifier: GPL-3.0-or-later
"""A studio around a hull: water or a floor, light, paint, lines on the hull, cameras, a turntable.

All that is made is in one collection, and goes with it; what is changed of the scene is kept there
and put back. A scene has one studio at a time.
"""

from .building import find, hull_of, look_from, make, remove, turn
from .cameras import TURNTABLE, VIEWS

__all__ = ["TURNTABLE", "VIEWS", "find", "hull_of", "look_from", "make", "remove", "turn"]
