# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull's stations as files of programs that know hulls by sections alone: GHS, Archimedes,
Michlet, and text that PIAS and others take.

Start at `station_lines`, which makes lines of cuts; each writer takes these, but Michlet's, which
takes a grid of half-breadths. All lengths are m, x forward from the after perpendicular, z up from
the base line. Each format and its source is told in the module that writes it.
"""

from .archimedes import archimedes_text
from .ghs import ghs_text, lines_for_ghs
from .keel_to_deck import StationLine, Stations, station_lines
from .michlet import MichletSpeeds, michlet_text
from .section_text import section_text

__all__ = [
    "MichletSpeeds",
    "StationLine",
    "Stations",
    "archimedes_text",
    "ghs_text",
    "lines_for_ghs",
    "michlet_text",
    "section_text",
    "station_lines",
]
