# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the lines of a hull lie, as its Object.hull.lines says: for the 3D view, the lines plan and
the table of offsets alike."""

from dataclasses import dataclass, field

import numpy as np

from ....hull_io.number_lists import diagonals, numbers
from ...bridge import limits
from ...bridge.blender.units import as_typed
from .frames import frame_table


@dataclass(frozen=True)
class LinePlaces:
    """Positions and spacings in m; positions given one by one count before spacings.

    diagonals: pairs of height in m and angle in rad. in_frames: whether stations are to be named
    by frames, and then frame_numbers: theirs, and frames: the hull_native.FrameTable of ranges,
    None where frames are evenly spaced.
    """

    length: float
    station_spacing: float
    waterline_spacing: float
    buttock_spacing: float
    stations: tuple
    waterlines: tuple
    buttocks: tuple
    diagonals: tuple
    frame_spacing: float
    in_frames: bool
    frame_numbers: tuple = ()
    frames: object = field(default=None, compare=False)

    def positions(self, points):
        """(stations, waterlines, buttocks) in m, as far as control points (n, 3) in m reach.

        Stations stand at Lpp / count from the after perpendicular, and go on beyond both ends.
        Buttocks are measured to port and stand for both sides.
        """
        low, high = points.min(axis=0), points.max(axis=0)
        aft, fore = min(low[0], 0.0), max(high[0], self.length)
        half_beam = max(abs(low[1]), abs(high[1]))
        return (
            self.stations or multiples(self.station_spacing, aft, fore, "stations", with_ends=True),
            self.waterlines or multiples(self.waterline_spacing, low[2], high[2], "waterlines"),
            self.buttocks or multiples(self.buttock_spacing, 0.0, half_beam, "buttocks"),
        )


def line_places(settings, metres_per_unit):
    """LinePlaces of an Object.hull; ValueError for lists that can't be understood."""
    lines = settings.lines

    def metres(value, name):
        length = as_typed(value) * metres_per_unit
        return limits.within(length, f"{name} in m", 0.0, limits.LONGEST)

    length = metres(settings.length_pp, "Lpp")
    frame_spacing = metres(lines.frame_spacing, "Frame spacing")
    spaces = station_spaces(lines)
    stations = _listed(lines.stations, "Stations")
    frame_numbers, table = stations if lines.stations_in == "FRAMES" else (), None
    if frame_numbers:
        table = frame_table(settings, metres_per_unit)
        stations = _of_frames(frame_numbers, table, frame_spacing)
    return LinePlaces(
        length,
        length / spaces if spaces else 0.0,
        metres(lines.waterline_spacing, "Spacing of waterlines"),
        metres(lines.buttock_spacing, "Spacing of buttocks"),
        stations,
        _listed(lines.waterlines, "Waterlines"),
        _listed(lines.buttocks, "Buttocks"),
        _of_a_number(diagonals(lines.diagonals), "diagonals"),
        frame_spacing,
        bool(frame_numbers),
        frame_numbers,
        table,
    )


def _of_frames(numbers, table, spacing):
    """Where frames stand, m: by their table, or else evenly from x = 0."""
    if table is not None:
        return tuple(table.places(numbers).tolist())
    if not spacing:
        raise ValueError(
            "Give the frame spacing first, or ranges of frames under Plates: the stations are in "
            "frames"
        )
    return tuple(number * spacing for number in numbers)


def station_spaces(lines):
    """How many spaces the stations of an Object.hull.lines divide Lpp into; 0 for none."""
    return limits.within(
        lines.station_count, "The number of spaces Lpp /", 0, limits.MOST_STATION_SPACES
    )


def _listed(text, name):
    return _of_a_number(numbers(text, name), name.lower())


def _of_a_number(places, name):
    limits.at_most(len(places), name, limits.MOST_LINES)
    return places


def multiples(spacing, low, high, name, with_ends=False):
    """Multiples of the spacing between two positions, which themselves count only with_ends; none
    when the spacing is 0."""
    if spacing <= 0.0:
        return ()
    if (high - low) / spacing > limits.MOST_LINES:
        raise ValueError(
            f"A spacing of {spacing:.4g} m gives more than {limits.MOST_LINES} {name}: widen it"
        )
    margin = 1e-6 * spacing * (-1.0 if with_ends else 1.0)
    first = int(np.floor((low + margin) / spacing)) + 1
    last = int(np.ceil((high - margin) / spacing)) - 1
    return tuple(k * spacing for k in range(first, last + 1))


def handy_spacing(extent, parts):
    """1, 2 or 5 times a power of ten that divides an extent into about so many parts; 0 for 0."""
    if extent <= 0.0:
        return 0.0
    wanted = extent / parts
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(min((1.0, 2.0, 5.0, 10.0), key=lambda m: abs(np.log(m * power / wanted))) * power)
