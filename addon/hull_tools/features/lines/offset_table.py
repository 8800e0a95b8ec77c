# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of offsets: heights and half-breadths at the stations of the lines plan."""

import numpy as np

from ...bridge import native
from . import line_places

IS_LIVE = False


def inputs(settings, metres_per_unit):
    return line_places.line_places(settings, metres_per_unit)


def compute(ship, wanted):
    """hull_native.OffsetTable; the first buttock is 0, the centre line."""
    surface = ship.body.surface
    stations, waterlines, buttocks = wanted.positions(surface.mesh.points)
    if not stations:
        raise ValueError("There are no stations: give Lpp and their number, or a list of them")
    return native.require().offset_table(
        surface, stations=stations, waterlines=waterlines, buttocks=(0.0, *buttocks)
    )


def header(table):
    return [
        "x from AP [m]",
        *(f"half-breadth at WL {z:.10g} m [mm]" for z in table.waterlines),
        *(f"height at buttock {y:.10g} m [mm]" for y in table.buttocks),
        *(
            f"{feature.name}: {what} [mm]"
            for feature in table.features
            for what in ("half-breadth", "height")
        ),
        "on a knuckle",
    ]


def rows(table):
    for i, x in enumerate(table.stations):
        features = [
            value
            for feature in table.features
            for value in (feature.half_breadths[i], feature.heights[i])
        ]
        lengths = [*table.half_breadths[i], *table.heights[i], *features]
        yield [x, *(_in_mm(value) for value in lengths), _marks(table, i)]


def _in_mm(value):
    """To a tenth of a millimetre, None where there is no such point."""
    return None if np.isnan(value) else round(1000.0 * value, 1) + 0.0


def _marks(table, i):
    """The offsets of a station that lie on knuckles, in words."""
    waterlines = table.waterlines[table.half_breadth_on_knuckle[i]]
    buttocks = table.buttocks[table.height_on_knuckle[i]]
    return "; ".join(
        [*(f"WL {z:.10g} m" for z in waterlines), *(f"buttock {y:.10g} m" for y in buttocks)]
    )
