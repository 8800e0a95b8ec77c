# SPDX-License-Identifier: GPL-3.0-or-later
"""Hydrostatics over drafts and trims: table, and curves of even keel or the first trim."""

from dataclasses import dataclass, replace
from itertools import product
from math import degrees

import numpy as np

from ....hull_io.number_lists import numbers
from ...bridge import limits, native
from ...bridge.blender.units import METRIC, as_typed
from ..flotation import afloat, hydrostatics
from .ranges import stepped

IS_LIVE = False

_DEFAULT_ROWS = 10
_DRAFTS_AT_ONCE = 50  # then it is told how far the work is
_CURVE_ROWS = 40  # of the plot, whatever the table's step


@dataclass(frozen=True)
class Inputs:
    drafts: tuple  # m
    trims: tuple  # m
    where: afloat.Afloat


@dataclass(frozen=True)
class Result:
    """hydrostatics of each row, all drafts of the first trim before the next; curves: hull_native's
    Hydrostatics of the first trim at close drafts."""

    hydrostatics: list
    curves: list
    inputs: Inputs


def inputs(settings, metres_per_unit):
    table = settings.table
    where = replace(afloat.afloat(settings, metres_per_unit).upright(), trim_m=0.0)
    first, last = (
        limits.within(as_typed(value) * metres_per_unit, "A draft in m", 0.0, limits.LONGEST)
        for value in (table.draft_from, table.draft_to)
    )
    last = last or where.draft
    step = afloat.length_in_metres(metres_per_unit, table.draft_step, "The step between drafts")
    step = step or (last - first) / _DEFAULT_ROWS
    if not last > first:
        raise ValueError(f"The table's last draft, {last:g} m, must be greater than its first")
    if first == 0.0:  # nothing is under water
        drafts = stepped(step, last, step, "drafts") if last > step else (last,)
    else:
        drafts = stepped(first, last, step, "drafts")
    trims = numbers(table.trims, "Trims") or (0.0,)
    limits.at_most(len(drafts) * len(trims), "drafts at all trims", limits.MOST_TABLE_ROWS)
    for trim in trims:
        replace(where, trim_m=trim).trim  # refused here rather than in the middle
    return Inputs(drafts, trims, where)


def compute(ship, given):
    """Rows for the drafts at which something is under water; ValueError if there are none."""
    described = []
    first_trim = replace(given.where, trim_m=given.trims[0])
    starts = range(0, len(given.drafts), _DRAFTS_AT_ONCE)
    for number, (trim_m, start) in enumerate(product(given.trims, starts)):
        ship.tell(number, len(given.trims) * len(starts))
        where = replace(given.where, trim_m=trim_m)
        for found in _afloat(ship.body, where, given.drafts[start : start + _DRAFTS_AT_ONCE]):
            described.append(hydrostatics.described(found, replace(where, draft=found.draft)))
    if not described:
        last = given.drafts[-1]
        raise ValueError(hydrostatics.why_no_volume(*_rows(ship.body, first_trim, [last]), last))
    close = np.linspace(given.drafts[0], given.drafts[-1], _CURVE_ROWS)
    return Result(described, _afloat(ship.body, first_trim, close), given)


def _afloat(body, where, drafts):
    """hull_native.Hydrostatics at those of the drafts at which something is under water."""
    return [row for row in _rows(body, where, drafts) if row.displaced_volume > 0.0]


def _rows(body, where, drafts):
    return native.require().hydrostatic_table(
        body, drafts=drafts, trims=[where.trim], **where.project()
    )


_POSITION = (
    ("draft [m]", "draft"),
    ("draft aft [m]", "draft_aft"),
    ("draft forward [m]", "draft_forward"),
    ("trim by the stern [m]", "trim_m"),
)
_UNIT_NAMES = {"": "-", "%": "% of Lpp"}


def header(result):
    return [title for title, _ in _POSITION] + [
        f"{quantity.title} [{_UNIT_NAMES.get(quantity.unit, quantity.unit)}]"
        for quantity in hydrostatics.QUANTITIES
    ]


def rows(result):
    for row in result.hydrostatics:
        yield [getattr(row, name) for _, name in _POSITION] + [
            _in_unit(getattr(row, quantity.name), quantity.unit)
            for quantity in hydrostatics.QUANTITIES
        ]


def _in_unit(value, unit):
    return degrees(value) if unit == "deg" and value is not None else value


def plot(result, name, shown=METRIC):
    trim_m = result.inputs.trims[0]
    at = "even keel" if trim_m == 0.0 else f"trim {shown.text(trim_m, 'm')} by the stern"
    if not result.curves:
        raise ValueError(
            f"Nothing is under water at the first trim, {at}, of which the curves are: put another "
            "one first, or give greater drafts"
        )
    density = f"water {shown.text(result.inputs.where.water_density, 't/m3')}"
    return native.require().hydrostatic_curves_plot(
        result.curves,
        subtitles=[f"{name}, {at}, {density}"],
        draft=result.inputs.where.draft,
        units=native.require().PlotUnits(shown.plot_sizes()),
    )
