# SPDX-License-Identifier: GPL-3.0-or-later
"""The sectional area curve at the draft, trim and heel of the hydrostatics."""

from dataclasses import dataclass, fields

import numpy as np

from ...bridge import native
from ...bridge.blender.units import METRIC
from ..flotation import afloat
from ..lines import lines

IS_LIVE = True

_SPACES = 80
_FINER = 4  # so many times, the two spaces at either end: there the curve bends most
# Stations are rounded to 1e-8 m, so that they stay while other parts of the hull move.
_DECIMALS = 8


@dataclass(frozen=True)
class Areas:
    """As hull_native.SectionAreas: arrays with one entry per station."""

    positions: np.ndarray
    areas: np.ndarray
    centroids: np.ndarray
    girths: np.ndarray
    breadths: np.ndarray


@dataclass(frozen=True)
class Result:
    areas: Areas
    hydrostatics: object  # hull_native.Hydrostatics
    where: afloat.Afloat


def inputs(settings, metres_per_unit):
    return afloat.afloat(settings, metres_per_unit)


def compute(ship, where):
    found = ship.hydrostatics(where)
    low, high = _reach(ship.body, found)
    # The ends are cut so far inside the hull, where a transom still has its area.
    margin = native.require().tolerances.SAME_POSITION * (high - low)
    numbers = np.arange(_FINER * _SPACES + 1)
    inside = (numbers > 2 * _FINER) & (numbers < numbers[-1] - 2 * _FINER)
    numbers = numbers[~inside | (numbers % _FINER == 0)]
    stations = np.interp(numbers, numbers[[0, -1]], (low + margin, high - margin))
    return Result(_areas(ship, stations.round(_DECIMALS), where), found, where)


def _areas(ship, stations, where):
    """Areas at these stations; those of a body that follows edits are kept where it stays."""
    if ship.moved is None:
        return _computed(ship, stations, where)
    known_key, known_where, known = ship.memory.get("sectional areas", (None, None, None))
    stays = np.zeros(len(stations), dtype=bool)
    if known_where == where and np.array_equal(known.positions, stations):
        planes = np.column_stack([np.tile((1.0, 0.0, 0.0), (len(stations), 1)), stations])
        stays = ship.moved.kept(known_key, planes, lines.flat_tolerance(ship.body.surface))
    found = _computed(ship, stations[~stays], where)
    if stays.any():
        found = Areas(*(_merged(getattr(known, f.name), getattr(found, f.name), stays)
                        for f in fields(Areas)))  # fmt: skip
    ship.memory["sectional areas"] = ship.moved.after, where, found
    return found


def _computed(ship, stations, where):
    if ship.moved is None:
        found = native.require().section_areas(ship.body, stations, **where.position())
    else:
        found = ship.kept_stations.section_areas(stations, **where.position())
    return Areas(*(getattr(found, f.name) for f in fields(Areas)))


def _merged(known, new, stays):
    merged = known.copy()
    merged[~stays] = new
    return merged


def _reach(body, found):
    """The stations between which something may be under water."""
    points = body.surface.mesh.points[:, 0]
    if found.waterline_forward <= found.waterline_aft:
        return points.min(), points.max()
    # The immersed shell reaches beyond the waterline at a bulb or a counter.
    beyond = max(found.immersed_length - found.waterline_length, 0.0)
    low = max(points.min(), found.waterline_aft - beyond)
    high = min(points.max(), found.waterline_forward + beyond)
    return low, high


def header(result):
    return [
        "x from AP [m]",
        "area [m2]",
        "centroid y [m]",
        "centroid z [m]",
        "girth [m]",
        "breadth at water [m]",
    ]


def rows(result):
    found = result.areas
    return np.column_stack(
        [
            found.positions,
            found.areas,
            found.centroids[:, 1:],
            found.girths,
            found.breadths,
        ]
    ).tolist()


# Of its range: what an axis has beyond the curves where handles need room.
_ROOM_BESIDE, _ROOM_ABOVE = 0.04, 0.25


def frame(result, others):
    """((low, high) of x, the same of areas) that the plot's axes have beside such beside.Curves;
    None where none has handles: then the plot has what it needs."""
    if not any(curve.handles is not None for curve in others):
        return None
    held = [curve.frame for curve in others if curve.frame is not None]
    if held:
        return held[0]
    found = result.areas
    x = np.concatenate([found.positions, *(curve.x for curve in others)])
    areas = np.concatenate([found.areas, *(curve.y for curve in others)])
    length = x.max() - x.min()
    return (
        (float(x.min() - _ROOM_BESIDE * length), float(x.max() + _ROOM_BESIDE * length)),
        (0.0, float((1.0 + _ROOM_ABOVE) * areas.max())),
    )


def plot(result, name, others=(), shown=METRIC):
    """others: beside.Curves that are drawn with it."""
    where, found = result.where, result.areas
    at = f"{name}, draft {shown.text(where.draft, 'm')}"
    if where.trim_m:
        at += f", trim {shown.text(where.trim_m, 'm')} by the stern"
    if where.heel:
        at += f", heel {np.degrees(where.heel):.1f}°"
    at += f", ∇ {shown.text(result.hydrostatics.displaced_volume, 'm3', 1)}"
    return native.require().sectional_area_plot(
        found.positions,
        found.areas,
        subtitles=[at],
        lcb=result.hydrostatics.lcb,
        length_pp=where.length_pp or None,
        others=[(curve.name, curve.x, curve.y, curve.colour) for curve in others],
        frame=frame(result, others),
        units=native.require().PlotUnits(shown.plot_sizes()),
    )
