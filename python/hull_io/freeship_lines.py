# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a hull's stations, buttocks and waterlines lie, for files that hold planes."""

import numpy as np

from .errors import HullFileError
from .limits import MAX_LISTED
from .number_lists import numbers


def line_positions(data):
    """{0: stations, 1: buttocks, 2: waterlines, 3: none}: arrays of x, y and z in m, rising, within
    the hull; of a HullData that does not say none."""
    found = {axis: np.empty(0) for axis in range(4)}
    choice = data.lines
    if choice is None or not len(data.points):
        return found
    low, high = data.points.min(axis=0), data.points.max(axis=0)
    length = data.particulars.length_pp
    spacing = length / choice.station_count if choice.station_count else 0.0
    stations = numbers(choice.stations, "Stations")
    if choice.stations_in == "frames":
        stations = _of_frames(data, stations)
    found[0] = _within(stations or _spaced(low[0], high[0], spacing), low[0], high[0])
    for axis, listed, step in (
        (1, numbers(choice.buttocks, "Buttocks"), choice.buttock_spacing),
        (2, numbers(choice.waterlines, "Waterlines"), choice.waterline_spacing),
    ):
        least = max(low[axis], 0.0) if axis == 1 else low[axis]
        found[axis] = _within(listed or _spaced(least, high[axis], step), least, high[axis])
    return found


def _spaced(low, high, spacing):
    if not spacing > 0.0:
        return []
    if high - low > MAX_LISTED * spacing:
        raise HullFileError(
            f"Lines {spacing:g} m apart are more than {MAX_LISTED}: take a larger spacing."
        )
    return spacing * np.arange(np.ceil(low / spacing), np.floor(high / spacing) + 1.0)


def _within(positions, low, high):
    positions = np.unique(np.asarray(positions, dtype=float))
    return positions[(positions > low) & (positions < high)]


def _of_frames(data, numbers):
    """Where frames stand, m: by ranges, or else evenly from x = 0."""
    if data.plating is not None and data.plating.ranges:
        return data.plating.frame_places(numbers, data.particulars.length_pp).tolist()
    return [number * data.lines.frame_spacing for number in numbers]
