# SPDX-License-Identifier: GPL-3.0-or-later
"""The geometry file of GHS (`.gf`): text, one shape, component and part HULL.

    name; "L:", "W:": length and beam; "OL:", "OT:", "OV:": what the origins are; "P:M" or "P:F":
    metres or feet; lines that begin with a backslash: remarks
    "*", the shape: its name; how many sections; each "x,n", x positive aft of the origin and
    rising, and n lines "y,z" upwards from the centre plane; "0,0,0": the shell's thickness
    "**", the component: its name; side 0 (centre line); effectiveness; its shift; its shape
    "***", the part: its name; what is in it; kind 1 (displacer); specific gravity; reference
    point; how many components; their names
    "****", the end

A point that is there twice is a corner. Sections are closed to the centre plane. As the manual of
GHS and the files that FREE!ship exports have it.
"""

import numpy as np

from ..errors import HullFileError
from ..limits import SEA_WATER_DENSITY
from .numbers_as_text import decimal, plain_name

FOOT = 0.3048
MOST_SECTIONS, MOST_POINTS = 149, 164


def ghs_text(stations, unit="m"):
    """The text of a Stations; unit: "m" or "ft", of its numbers. HullFileError for more sections or
    points than GHS takes."""
    scale = {"m": 1.0, "ft": FOOT}[unit]
    lines = sorted(stations.lines, key=lambda line: -line.x)
    if len(lines) > MOST_SECTIONS:
        raise HullFileError(
            f"There are {len(lines)} stations, and GHS takes {MOST_SECTIONS}: make fewer."
        )
    rows = [
        plain_name(stations.name),
        f"L:{decimal(stations.length_pp / scale, 3)}",
        f"W:{decimal(stations.beam / scale, 3)}",
        "OL:After perpendicular",
        "OT:Centerplane",
        "OV:Baseline",
        "P:M" if unit == "m" else "P:F",
        "\\Hull Tools",
        "*",
        "HULL",
        str(len(lines)),
    ]
    for line in lines:
        rows += _section(line, scale)
    rows += ["0,0,0", "**", "HULL.C", "0", "1.0", "0,0,0", "HULL"]
    density = stations.water_density or SEA_WATER_DENSITY
    rows += ["***", "HULL", "WATER", "1", decimal(density, 4), "0,0,0", "1", "HULL.C", "****"]
    return "\r\n".join(rows) + "\r\n"


def lines_for_ghs(cut, tolerance):
    """The list of StationLine that cut(tolerance), with a tolerance in m, gives, and the tolerance:
    that given, doubled until no line has more points than GHS takes. HullFileError where knuckles
    alone, which stay whatever the tolerance, are too many."""
    while True:
        lines = cut(tolerance)
        longest = max(lines, key=lambda line: len(_doubled(line)))
        if len(_doubled(longest)) <= MOST_POINTS:
            return lines, tolerance
        points, knuckles = longest.closed
        if 2 * np.count_nonzero(knuckles) > MOST_POINTS or tolerance > np.ptp(points, axis=0).max():
            raise HullFileError(
                f"The station at x = {longest.x:.4g} m has {np.count_nonzero(knuckles)} knuckles, "
                f"and GHS takes {MOST_POINTS // 2}: take off creases, or export another format."
            )
        tolerance *= 2.0


def _doubled(line):
    points, knuckles = line.closed
    return np.repeat(points, np.where(knuckles, 2, 1), axis=0)


def _section(line, scale):
    doubled = _doubled(line) / scale
    if len(doubled) > MOST_POINTS:
        raise HullFileError(
            f"The station at x = {line.x:.4g} m has {len(doubled)} points, and GHS takes "
            f"{MOST_POINTS}: cut the hull with a larger tolerance."
        )
    rows = [f"{decimal(-line.x / scale)},{len(doubled)}"]
    return rows + [f"{decimal(y)},{decimal(z)}" for y, z in doubled]
