# SPDX-License-Identifier: GPL-3.0-or-later
"""Bonjean curves: areas of the stations of the lines plan over the draft."""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.blender.units import METRIC
from ..flotation import afloat
from ..lines.line_places import station_spaces

IS_LIVE = False

_DRAFTS = 20
# In the plot so many stations stand apart from one another.
_MOST_PLOTTED = 21


@dataclass(frozen=True)
class Inputs:
    stations: tuple  # x, m
    drafts: tuple  # m
    draft: float


@dataclass(frozen=True)
class Result:
    curves: object  # hull_native.BonjeanCurves
    inputs: Inputs


def inputs(settings, metres_per_unit):
    where = afloat.afloat(settings, metres_per_unit)
    count = station_spaces(settings.lines) or _DRAFTS
    if where.length_pp <= 0.0:
        raise ValueError("Give Lpp first: stations divide the length between perpendiculars")
    depth = afloat.length_in_metres(metres_per_unit, settings.depth, "Depth")
    highest = max(depth, where.draft)
    if highest <= 0.0:
        raise ValueError("Give a draft or a depth first")
    return Inputs(
        tuple(where.length_pp * k / count for k in range(count + 1)),
        tuple(highest * k / _DRAFTS for k in range(_DRAFTS + 1)),
        where.draft,
    )


def compute(ship, given):
    low, high = np.sort(ship.body.surface.mesh.points[:, 0])[[0, -1]]
    # Stations at the hull's ends are cut inside: in the plane of a transom there is no telling what
    # belongs to the station.
    margin = native.require().tolerances.SAME_POSITION * (high - low)
    stations = [_inside(x, low, high, margin) for x in given.stations]
    curves = native.require().bonjean(ship.body, stations=stations, drafts=given.drafts)
    return Result(curves, given)


def _inside(x, low, high, margin):
    """x, or where it is an end of the hull the place a margin inside."""
    if abs(x - low) < margin:
        return low + margin
    return high - margin if abs(x - high) < margin else x


def header(result):
    return ["station", "x from AP [m]", "draft [m]", "area [m2]", "centroid z [m]", "girth [m]",
            "breadth at water [m]"]  # fmt: skip


def rows(result):
    found = result.curves
    for i, x in enumerate(result.inputs.stations):
        for j, draft in enumerate(found.drafts):
            yield [i, x, draft, found.areas[i, j], found.centroids[i, j, 2], found.girths[i, j],
                   found.breadths[i, j]]  # fmt: skip


def plot(result, name, shown=METRIC):
    found = result.curves
    every = -(-len(found.stations) // _MOST_PLOTTED)
    chosen = np.arange(0, len(found.stations), every)
    return native.require().bonjean_plot(
        found.stations[chosen],
        found.drafts,
        found.areas[chosen],
        subtitles=[name],
        draft=result.inputs.draft,
        labels=[str(number) for number in chosen],
        units=native.require().PlotUnits(shown.plot_sizes()),
    )
