# SPDX-License-Identifier: GPL-3.0-or-later
"""Righting levers over the heel, with what is read from the curve."""

import contextlib
from dataclasses import dataclass
from math import degrees, radians

from ...bridge import native
from ...bridge.blender.units import METRIC
from ..curves_of_form.ranges import stepped
from ..flotation.afloat import as_typed_angle
from ..hull import deck_edge
from . import loads

IS_LIVE = False

# The intervals whose areas the intact stability code asks for.
_INTERVALS_DEG = ((0.0, 30.0), (0.0, 40.0), (30.0, 40.0))

_AREA_TOLERANCE = 1e-5  # m·rad, finer than is shown; the criteria have their own


@dataclass(frozen=True)
class Inputs:
    load: loads.LoadInputs
    heels: tuple  # rad
    intervals: tuple  # rad, within the heels


@dataclass(frozen=True)
class Result:
    levers: object  # hull_native.RightingLevers
    load: loads.Load
    inputs: Inputs

    def remarks(self):
        """Sentences about what the numbers rest on."""
        yield from loads.remarks(self.load)
        if self.levers.deck_edge_heel == 0.0:
            yield loads.DECK_EDGE_UNDER_WATER
        if not self.levers.can_flood:
            yield loads.NOTHING_FLOODS

    def areas(self):
        """(from, to, area) in rad and m·rad."""
        return [
            (start, end, float(area))
            for (start, end), area in zip(self.inputs.intervals, self.levers.areas)
        ]


def inputs(settings, metres_per_unit):
    return of_inputs(settings, loads.load_inputs(settings, metres_per_unit))


def of_inputs(settings, load):
    """The Inputs of an Object.hull with loads.LoadInputs."""
    heels = _heels(settings.loading)
    return Inputs(load, heels, intervals(heels[-1]))


def heels_of(loading):
    """In rad, of an Object.hull.loading; none where its settings are refused."""
    with contextlib.suppress(ValueError):
        return _heels(loading)
    return ()


def _heels(loading):
    return stepped(0.0, loads.greatest_heel(loading), as_typed_angle(loading.heel_step), "heels")


def intervals(last_heel):
    """(from, to) in rad of the areas that are told of levers up to a heel in rad."""
    return tuple(
        (radians(start), radians(end))
        for start, end in _INTERVALS_DEG
        if radians(end) <= last_heel + 1e-9
    )


def compute(ship, given):
    return of_load(ship, loads.load(ship, given.load), given)


def of_load(ship, load, given):
    """The Result of a loads.Load."""
    body = ship.body
    levers = native.require().righting_levers(
        body,
        **load.arguments(given.load),
        heels=given.heels,
        downflooding_points=given.load.downflooding_points or None,
        deck_edge=deck_edge.points_of(body.surface, ship.deck_edge),
        area_intervals=given.intervals,
        area_tolerance=_AREA_TOLERANCE,
    )
    return Result(levers, load, given)


def header(result):
    return ["heel to starboard [deg]", "GZ [m]", "dGZ/dheel [m/rad]", "trim by the stern [deg]",
            "trim by the stern [m]"]  # fmt: skip


def rows(result):
    found = result.levers
    length_pp = result.inputs.load.where.length_pp
    for heel, lever, slope, trim in zip(found.heels, found.levers, found.slopes, found.trims):
        yield [degrees(heel), lever, slope, degrees(trim), loads.trim_m(trim, heel, length_pp)]


def plot(result, name, shown=METRIC):
    found = result.levers
    greatest = None
    if found.greatest_lever is not None:
        greatest = (found.greatest_lever_heel, found.greatest_lever)
    return native.require().righting_lever_plot(
        found.heels,
        found.levers,
        slopes=found.slopes,
        greatest=greatest,
        subtitles=[loads.describe(result.load, result.inputs.load, name, shown)],
        gm=found.gm,
        vanishing=found.vanishing_heel,
        deck_edge=found.deck_edge_heel,
        downflooding=found.downflooding_heel,
        areas=[area for area in result.areas() if area[0] > 0.0 or area[1] < radians(35.0)],
        units=native.require().PlotUnits(shown.plot_sizes()),
    )
