# SPDX-License-Identifier: GPL-3.0-or-later
"""The hull file of ArchimedesMB (`.hll`): XML-like text of the sections of one or more bodies.

Each section has its place along the ship (YCOORD there) and, in OFFSETS, its points "half-breadth
height" from the starboard deck edge down to the keel and up to the port one. Metres, t/m³. As the
files that FREE!ship exports have it.
"""

from xml.sax.saxutils import escape

from ..limits import SEA_WATER_DENSITY
from .numbers_as_text import decimal


def archimedes_text(stations):
    """The text of a Stations."""
    draft = decimal(stations.draft)
    rows = [
        '<?xml version="1.0" encoding="UTF-8" ?>',
        "<HULL>",
        *_named("HULL_NAME", stations.name or "Hull"),
        _value("DENSITY", decimal(stations.water_density or SEA_WATER_DENSITY, 4)),
        _value("AP", "0.0"),
        _value("FP", decimal(stations.length_pp)),
        *(_value(f"{where}_DRAUGHT_MARK", draft) for where in ("FWD", "MID", "AFT")),
        _value("APPENDAGE_COUNT", "1"),
        "<APPENDAGE>",
        *_named("APPENDAGE_NAME", "Main Hull"),
        _value("ACTIVE", "1"),
        _value("FREE_FLOODING", "0"),
        _value("APPENDAGE_COLOUR", "0"),
        _value("SECTION_COUNT", str(len(stations.lines))),
    ]
    for line in sorted(stations.lines, key=lambda line: line.x):
        rows += _section(line)
    return "\n".join([*rows, "</APPENDAGE>", "</HULL>"]) + "\n"


def _section(line):
    points = line.points.tolist()
    port = points[1:] if points[0][0] == 0.0 else points
    around = [(-y, z) for y, z in port[::-1]] + points
    return [
        "<SECTION>",
        *_named("SECTION_NAME", decimal(line.x, 4)),
        _value("YCOORD", decimal(line.x)),
        _value("OFFSET_COUNT", str(len(around))),
        "<OFFSETS>",
        *(f"{decimal(y)} {decimal(z)}" for y, z in around),
        "</OFFSETS>",
        "</SECTION>",
    ]


def _value(name, value):
    return f"<{name}> {value} </{name}>"


def _named(name, text):
    return [f"<{name}>", escape(" ".join(text.split())), f"</{name}>"]
