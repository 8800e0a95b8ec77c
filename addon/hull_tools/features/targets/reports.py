# SPDX-License-Identifier: GPL-3.0-or-later
"""What came of bringing a hull to its targets, in numbers and words."""

from dataclasses import dataclass

from ...bridge.blender import units
from ..hull import hull_state
from . import quantities

# Of a price's own size: what does not bind.
_NO_PRICE = 1e-9
_DIMENSIONS = ("length", "beam", "draft")
_GM = next(each.label for each in quantities.QUANTITIES if each.identifier == quantities.GM)


@dataclass(frozen=True, eq=False)
class Reached:
    """What came of one row, in the unit of its Quantity: before, and as it is reached; number: the
    Quantity's; miss: how far out of its bounds, 0 where met; binds: whether the cost depends on
    it."""

    label: str
    number: str
    unit: str
    wanted: str
    before: float
    reached: float
    miss: float
    binds: bool


@dataclass(frozen=True, eq=False)
class Report:
    """What came of a solution. key: the geometry of the hull it gave; status: as hull_native's
    TargetsReached has it; rows: Reached; rms in m; held: what else is at its limit, in words; lies:
    how the hull lay in the water, see as_it_lies."""

    key: object
    status: str
    rows: tuple
    iterations: int
    rms: float
    scale: tuple
    held: tuple
    lies: tuple = None

    @property
    def is_met(self):
        return self.status == "met"


@dataclass
class LastSolution:
    """The Report of the last solution of a hull, or None."""

    report: object = None


def rows_reached(told, reached, kg):
    """The Reached of rows, told as pairs (Quantity, what is wanted), of a hull_native
    TargetsReached; kg in m."""
    numbers = zip(told, reached.before, reached.reached, reached.misses, reached.prices)
    return tuple(_row(*row, kg) for row in numbers)


def _row(told, before, reached, miss, price, kg):
    quantity, wanted = told
    shift = kg if quantity.identifier == quantities.GM else 0.0
    binds = abs(price) > _NO_PRICE
    return Reached(
        quantity.label,
        quantity.number,
        quantity.unit,
        wanted,
        before - shift,
        reached - shift,
        miss,
        binds,
    )


def note(obj, state, reached, rows, held=()):
    """Notes the Report of a TargetsReached with its rows of a hull whose HullState is up to date;
    returns it. held: what else is at its limit, in words."""
    prices = zip(_DIMENSIONS, reached.scale_prices)
    limits = [f"the limit of {name}" for name, price in prices if abs(price) > _NO_PRICE]
    report = state.of(LastSolution).report = Report(
        state.ship.geometry_key,
        reached.status,
        rows,
        reached.iterations,
        reached.rms,
        tuple(reached.scale),
        (*limits, *held),
        as_it_lies(obj, rows),
    )
    return report


def last_report(obj):
    """(the Report of a hull's last solution or None, whether the hull is as that made it, and lies
    in the water as it did)."""
    report, is_current = hull_state.last_report(obj, LastSolution)
    return report, is_current and report.lies == as_it_lies(obj, report.rows)


def as_it_lies(obj, rows):
    """What of a hull's settings the numbers of these Reached, or Quantities, go by."""
    names = ("draft", "trim_m", "heel", "length_pp", "beam", "water_density", "deck_closed")
    has_gm = any(row.label == _GM for row in rows)
    return tuple(getattr(obj.hull, name) for name in names), obj.hull.loading.kg if has_gm else None


def missed(report):
    return [row for row in report.rows if row.miss]


def _wanted(row, scene):
    """What a row asks for, in the unit that the number reached is told in."""
    wanted = row.wanted
    if units.is_imperial(scene) and units.imperial(row.unit):
        sign, _, number = wanted.partition(" ")
        wanted = f"{sign} {units.in_unit(scene, float(number), row.unit)[0]:g}"
    return f"{row.label} {wanted}"


def warning(report, scene):
    """What is not as wanted, and why, in a sentence, or ""."""
    if report.is_met:
        return ""
    short = "; ".join(
        f"{_wanted(row, scene)}: nearest is {units.format_value(scene, row.reached, row.unit)}"
        for row in missed(report)
    )
    binding = [row.label for row in report.rows if row.binds and not row.miss]
    binding += report.held
    text = f"Not all can be met. {short}" if short else "Not all is settled"
    if binding:
        text += f". Held by {', '.join(binding)}"
    if report.status == "folded":
        text += ". Beyond that the surface would fold"
    if report.status == "unsettled":
        text += ". It may come nearer still: solve again"
    return text


def summary(report, scene):
    """A Report as a sentence."""
    rms = units.format_mm(report.rms)
    if report.is_met:
        waves = [row for row in report.rows if row.number == "wave_resistance"]
        lowered = "".join(f", {row.label} {_reached(row, scene)}" for row in waves)
        return f"All targets met: the surface shifts by {rms} RMS{lowered}"
    return f"{warning(report, scene)}. The surface shifts by {rms} RMS"


def _reached(row, scene):
    """As text; of a wave resistance with what it was changed by, for that is what counts."""
    text = units.format_value(scene, row.reached, row.unit)
    if row.number != "wave_resistance" or not row.before > 0.0:
        return text
    return f"{text}, {100.0 * (row.reached / row.before - 1.0):+.2f} %"


def told(report, scene):
    """Pairs (name, value) of what a panel shows of a Report."""
    pairs = [(_wanted(row, scene), _reached(row, scene)) for row in report.rows]
    names = ("Length", "Beam", "Draft")
    pairs += [
        (f"{name} times", f"{factor:.5f}")
        for name, factor in zip(names, report.scale)
        if factor != 1.0
    ]
    return [*pairs, ("Shift, RMS", units.format_mm(report.rms))]
