# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of offsets: heights and half-breadths at the stations of the lines plan, and stem,
stern and transom beside it, which no station tells."""

from dataclasses import dataclass, fields

import numpy as np

from ...bridge import native
from . import line_places

IS_LIVE = False


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


def with_ends(hn, table, surface):
    """The OffsetTable of a hull_native.OffsetTable of a surface."""
    own = {one.name: getattr(table, one.name) for one in fields(OffsetTable)[:-1]}
    return OffsetTable(**own, ends=end_lines(hn, surface, table.stations))


def compute(ship, wanted):
    """The OffsetTable of a hull; the first buttock is 0, the centre line."""
    surface = ship.body.surface
    stations, waterlines, buttocks = wanted.positions(surface.mesh.points)
    if not stations:
        raise ValueError("There are no stations: give Lpp and their number, or a list of them")
    hn = native.require()
    table = hn.offset_table(
        surface, stations=stations, waterlines=waterlines, buttocks=(0.0, *buttocks)
    )
    return with_ends(hn, table, surface)


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


# Of the size: points are in the centre plane, in a plane across; ends of lines are joined.
_CENTRE, _ACROSS, _JOINED = 1e-6, 2e-2, 1e-6
# Stations at an end between which stem and stern are told; places on an edge of the control mesh.
_AT_END, _PER_EDGE = 3, 32


def end_lines(hn, surface, stations):
    """Pairs ("Stem", "Stern" or "Transom", (n, 3) points, m) of a half hull: the profile, from
    below upwards, before the last stations and abaft the first; and the rim of a transom, outwards.
    As many points as there are stations, or less."""
    size, count = surface.mesh.size, len(stations)
    if count <= _AT_END or np.asarray(surface.mesh.points)[:, 1].min() < -_CENTRE * size:
        return ()
    lines = [
        (chain.kind.lower(), chain.evaluate(np.linspace(0.0, n, _PER_EDGE * n + 1))[0])
        for chain in hn.crease_curves(surface)
        if not chain.closed
        for n in [chain.edge_count]
    ]
    central = [line for _, line in lines if np.abs(line[:, 1]).max() < _CENTRE * size]
    found = []
    contours = hn.polylines.end_to_end(central, _JOINED * size, -2.0) if central else []
    if contours:
        contour = max(contours, key=lambda line: np.ptp(line[:, 0]))
        contour = contour if contour[0, 0] < contour[-1, 0] else contour[::-1]
        middle = 0.5 * (stations[0] + stations[-1])
        begin = _last(contour[:, 0] < max(stations[-_AT_END], middle))
        end = _last(contour[::-1, 0] > min(stations[_AT_END - 1], middle))
        found += [("Stem", contour[begin:]), ("Stern", contour[::-1][end:])]
    across = [
        line
        for kind, line in lines
        if "crease" in kind
        and np.ptp(line[:, 0]) < _ACROSS * size
        and line[:, 0].max() < stations[0] + _ACROSS * size
    ]
    rims = hn.polylines.end_to_end(across, _JOINED * size, -2.0)
    if rims:
        rim = max(rims, key=lambda line: np.ptp(line[:, 1]))
        found.append(("Transom", rim if rim[0, 1] < rim[-1, 1] else rim[::-1]))
    return tuple((name, _fewer(line, count)) for name, line in found if len(line) > 1)


def _last(is_so):
    """The number of the last that is so, or 0."""
    which = np.flatnonzero(is_so)
    return int(which[-1]) if len(which) else 0


def _fewer(line, count):
    """Up to `count` points of a line between which it is straightest: farthest points are taken
    one after the other."""
    kept = [0, len(line) - 1]
    while len(kept) < min(count, len(line)):
        off = np.zeros(len(line))
        for low, high in zip(kept, kept[1:]):
            way = line[high] - line[low]
            share = (line[low : high + 1] - line[low]) @ way / max(way @ way, 1e-300)
            foot = line[low] + np.clip(share, 0.0, 1.0)[:, None] * way
            off[low : high + 1] = np.linalg.norm(line[low : high + 1] - foot, axis=1)
        if off.max() < 5e-5:  # half of the last digit
            break
        kept = sorted({*kept, int(np.argmax(off))})
    return line[kept]


def _columns_of(points):
    if np.abs(points[:, 1]).max() < 5e-5:
        return ["x [m]", "height [mm]"]
    return ["x [m]", "half-breadth [mm]", "height [mm]"]


def _point(points, i):
    if i >= len(points):
        return [None] * len(_columns_of(points))
    x, y, z = points[i]
    values = [round(float(x), 4), _in_mm(y), _in_mm(z)]
    return values if len(_columns_of(points)) == 3 else [values[0], values[2]]
