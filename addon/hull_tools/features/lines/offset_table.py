# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of offsets: heights and half-breadths at the stations of the lines plan, and stem,
stern and transom beside it, which no station tells."""

from dataclasses import dataclass, fields

import numpy as np

from ...bridge import native
from . import feet_offsets, line_places

IS_LIVE = False

# m: half-breadths of less are written as nought, to a tenth of a millimetre: half of that.
_NO_HALF_BREADTH = 5e-5


def inputs(settings, metres_per_unit):
    return line_places.line_places(settings, metres_per_unit)


@dataclass(frozen=True)
class OffsetTable:
    """What a hull_native.OffsetTable has; ends: pairs (name, (n, 3) points in m) as end_lines() has
    them."""

    stations: np.ndarray
    waterlines: np.ndarray
    buttocks: np.ndarray
    half_breadths: np.ndarray
    heights: np.ndarray
    half_breadth_on_knuckle: np.ndarray
    height_on_knuckle: np.ndarray
    features: list
    ends: tuple


def with_ends(table, ends):
    """The OffsetTable of a hull_native.OffsetTable and what end_lines() gives."""
    own = {one.name: getattr(table, one.name) for one in fields(OffsetTable)[:-1]}
    return OffsetTable(**own, ends=tuple(ends))


def compute(ship, wanted):
    """The OffsetTable of a hull; the first buttock is 0, the centre line."""
    surface = ship.body.surface
    stations, waterlines, buttocks = wanted.positions(surface.mesh.points)
    if not stations:
        raise ValueError("There are no stations: give Lpp and their number, or a list of them")
    table = native.require().offset_table(
        surface,
        stations=stations,
        waterlines=waterlines,
        buttocks=(0.0, *buttocks),
        mirrored=ship.body.mirrored,
    )
    # With what reads such tables again; loaded where it is wanted.
    from ....hull_fitting.profile_ends import end_lines

    return with_ends(table, end_lines(surface, table.stations))


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
        *(f"{name}: {what}" for name, points in _ends(table) for what in _columns_of(points)),
    ]


def rows(table):
    for i, x in enumerate(table.stations):
        features = [
            value
            for feature in table.features
            for value in (feature.half_breadths[i], feature.heights[i])
        ]
        lengths = [*table.half_breadths[i], *table.heights[i], *features]
        beside = [cell for _, points in _ends(table) for cell in _point(points, i)]
        yield [x, *(_in_mm(value) for value in lengths), _marks(table, i), *beside]


def in_feet(table):
    """(header, rows) in feet: positions as decimal numbers, offsets in feet, inches and eighths."""
    return feet_offsets.in_feet(header(table), rows(table))


def _ends(table):
    """Of a hull_native.OffsetTable none."""
    return getattr(table, "ends", ())


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


def _columns_of(points):
    if np.abs(points[:, 1]).max() < _NO_HALF_BREADTH:
        return ["x [m]", "height [mm]"]
    return ["x [m]", "half-breadth [mm]", "height [mm]"]


def _point(points, i):
    if i >= len(points):
        return [None] * len(_columns_of(points))
    x, y, z = points[i]
    values = [round(float(x), 4), _in_mm(y), _in_mm(z)]
    return values if len(_columns_of(points)) == 3 else [values[0], values[2]]
