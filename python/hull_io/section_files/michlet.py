# SPDX-License-Identifier: GPL-3.0-or-later
"""The input file of Michlet (`.mlt`, its in.mlt): one value a line, "#" before remarks.

The hull is a table of half-breadths below the water: a row for each station from the bow aft, a
column for each depth from the keel up to the water, both in equal steps over the waterline's length
and the draft. As Michlet's manual (version 8) and the files that FREE!ship exports have it. Michlet
takes 5 to 81 stations and depths, odd numbers, and up to 50 speeds.
"""

from dataclasses import dataclass

import numpy as np

from ..errors import HullFileError
from ..limits import GRAVITY, SEA_WATER_DENSITY
from .numbers_as_text import decimal, plain_name

_DENSITIES = (0.995, 1.030)


@dataclass(frozen=True)
class MichletSpeeds:
    """In m/s, and how many from the first to the last: 2 to 50."""

    first: float
    last: float
    count: int = 50


def michlet_text(
    name,
    half_breadths,
    *,
    length,
    draft,
    volume,
    speeds,
    water_density=SEA_WATER_DENSITY,
    viscosity=1.18831e-6,
):
    """The text. half_breadths: (s, w) in m, stations from aft forward, waterlines from the keel up,
    both odd, 5 to 81. length: of the waterline, draft in m; volume: displaced, m³; water_density in
    t/m³ and its kinematic viscosity in m²/s, both of sea water unless given. HullFileError for what
    Michlet does not take."""
    half_breadths = np.asarray(half_breadths, dtype=float)
    _check(half_breadths, speeds, water_density)
    rows = [f"# {plain_name(name)}"]
    rows += _general(speeds, (water_density, viscosity), half_breadths.shape)
    rows += [*_waves(length), "# First hull", "# Offsets"]
    rows += [",".join(decimal(y) for y in row) for row in half_breadths[::-1]]
    rows += _values(
        ("Displacement volume (cubic metres)", decimal(volume)),
        ("Length (metres)", decimal(length)),
        ("Draft (metres)", decimal(draft)),
        ("Longitudinal separation (metres)", "0.0"),
        ("Lateral separation (metres)", "0.0"),
        ("Loading type", "3"),
        ("Loading parameters", "1.0,0.0,0.0"),
    )
    for what in ("Trim", "Sinkage", "Heel"):
        rows += _values((f"{what}: method", "0"), (f"{what}: number of speeds", "2"))
        rows += [f"# {what}: speed, amount", "0.0,0.0", "10.0,0.0"]
    rows += _values(("Appendages", "0"), ("Other particulars", "0"))
    return "\r\n".join(rows) + "\r\n"


def _check(half_breadths, speeds, water_density):
    if half_breadths.ndim != 2 or not all(
        5 <= count <= 81 and count % 2 for count in half_breadths.shape
    ):
        raise HullFileError(
            "Michlet takes 5 to 81 stations and waterlines, odd numbers: make as many."
        )
    if not (np.isfinite(half_breadths).all() and (half_breadths >= 0.0).all()):
        raise HullFileError("A half-breadth is negative or no number: Michlet takes one half.")
    if not (0.01 <= speeds.first < speeds.last <= 40.0 and 2 <= speeds.count <= 50):
        raise HullFileError(
            "Michlet takes 2 to 50 speeds from 0.01 to 40 m/s, rising: choose such."
        )
    if not _DENSITIES[0] <= water_density <= _DENSITIES[1]:
        raise HullFileError(
            f"Michlet takes water of {_DENSITIES[0]} to {_DENSITIES[1]} t/m³: set such a density."
        )


def _general(speeds, water, shape):
    water_density, viscosity = water
    return _values(
        ("Input file type", "0"),
        ("Input file subtype", "0"),
        ("Output file type", "0"),
        ("Output file subtype", "0"),
        ("Course particulars", "0"),
        ("Number of hulls", "1"),
        ("Gravitational acceleration (m/sec/sec)", decimal(GRAVITY)),
        ("Water density (kg/cubic metre)", decimal(1e3 * water_density, 2)),
        ("Water kinematic viscosity (sq. m/sec * 10^-6)", decimal(1e6 * viscosity)),
        ("Base eddy kinematic viscosity", "10.0"),
        ("Water depth (metres)", "10000.0"),
        ("Air density (kg/cubic metre)", "1.26"),
        ("Air kinematic viscosity (sq. m/sec * 10^-6)", "14.4"),
        ("Wind speed (m/sec)", "0.0"),
        ("Wind direction (degrees)", "0.0"),
        ("Minimum speed (m/sec)", decimal(speeds.first, 3)),
        ("Maximum speed (m/sec)", decimal(speeds.last, 3)),
        ("Number of speeds", str(speeds.count)),
        ("Leeway", "0"),
        ("Wave drag Ntheta", "1024"),
        ("Skin friction (1 = ITTC 1957)", "1"),
        ("Viscous drag form factor", "1.0"),
        ("Wave drag form factor", "1.0"),
        ("Pressure signature (1 = slender body)", "1"),
        ("Number of offset stations (rows)", str(shape[0])),
        ("Number of offset waterlines (columns)", str(shape[1])),
        ("Ship loading type", "3"),
        ("Ship loading parameters", "1.0,0.0,0.0"),
    )


def _waves(length):
    """Where wave elevations are asked for: sectors and a rectangle behind the ship, a beach."""
    near, far, side = 1.5 * length, 5.0 * length, 5.0 * length * np.tan(np.radians(30.0))
    return _values(
        ("R0", decimal(near, 3)),
        ("R1", decimal(far, 3)),
        ("Beta", "22.5"),
        ("Nr", "100"),
        ("Nbeta", "100"),
        ("x0", decimal(near, 3)),
        ("x1", decimal(far, 3)),
        ("y0", decimal(-side, 3)),
        ("y1", decimal(side, 3)),
        ("Nwx", "100"),
        ("Nwy", "100"),
        ("Beach x0", "200.0"),
        ("Beach x1", "2200.0"),
        ("Beach y0", "500.0"),
        ("Beach z0", "-1.0"),
        ("Beach z1", "0.0"),
        ("Beach slope", "90.0"),
        ("Beach Nbx", "11"),
        ("Beach Nbz", "11"),
    )


def _values(*pairs):
    return [row for words, value in pairs for row in (f"# {words}", value)]
