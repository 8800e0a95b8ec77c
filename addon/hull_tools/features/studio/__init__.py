# SPDX-License-Identifier: GPL-3.0-or-later
"""A studio around a hull: water or a floor, light, paint, lines on the hull, cameras, a turntable.

All that is made is in one collection, and goes with it; what is changed of the scene is kept there
and put back. A scene has one studio at a time.
"""

from .building import look_from, make, remove, turn
from .following import ask, before_picture, follow, forget, stop
from .place import find, hull_of
from .views import TURNTABLE, VIEWS

__all__ = [
    "TURNTABLE",
    "VIEWS",
    "ask",
    "before_picture",
    "find",
    "follow",
    "forget",
    "hull_of",
    "look_from",
    "make",
    "remove",
    "stop",
    "turn",
]
