# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance and power over speeds, by the methods of hull_native, and beside it that of the hull
that this one is compared with."""

import math
from dataclasses import dataclass, replace

from ...bridge import native
from ...bridge.blender.units import METRIC
from . import asked, beside, methods
from .asked import KNOT, NAMES

IS_LIVE = False

inputs = asked.inputs


@dataclass(frozen=True)
class Result:
    rows: list  # of hull_native.holtrop_table() or another method's
    given: asked.Inputs
    measured: dict  # as methods.Found
    told: tuple = ()  # sentences about what was reckoned with
    other: beside.Other = None

    def remarks(self):
        """Sentences about what the numbers rest on, each once."""
        yield from self.told
        yield from self._of_the_other()
        told = dict.fromkeys(row.get("outside", "") for row in self.rows)
        parts = dict.fromkeys(part for text in told for part in text.split("; ") if part)
        yield from (f"Out of the method's range: {part}" for part in _first_of_each(parts))
        known = {row["speed_m_s"] for row in self.rows}
        left_out = [speed for speed in self.given.speeds if speed not in known]
        if left_out and self.given.method == "SAVITSKY":
            knots = _listed([speed / KNOT for speed in left_out])
            yield f"No equilibrium by Savitsky's formulas, and left out: {knots} kn"
        empty = [row["speed_kn"] for row in self.rows if math.isnan(row["total_kN"])]
        if empty:
            yield f"Without numbers, as out of what can be computed: {_listed(empty)} kn"
        worst = max((_error(row) for row in self.rows), default=0.0)
        if worst > 0.01:
            yield f"The wave resistance is known to {100.0 * worst:.1f} % only: the ends are blunt"

    def _of_the_other(self):
        if self.other is None:
            return
        if self.other.message:
            yield self.other.message
        else:
            where = self.given.beside.inputs.where
            yield f"Compared with {self.other.name}, at {asked.at(where)}"


def _listed(numbers):
    return ", ".join(f"{number:.4g}" for number in numbers)


def _first_of_each(sentences):
    """Froude numbers leave a range at many speeds: the first tells."""
    seen = set()
    for sentence in sentences:
        name = sentence.partition(" is ")[0].rstrip("0123456789.e+- ")
        if name not in seen:
            seen.add(name)
            yield sentence


def _error(row):
    return row.get("wave_error_kN", 0.0) / row["total_kN"] if row["total_kN"] > 0.0 else 0.0


def compute(ship, given):
    own = _own(ship, replace(given, beside=None))
    ship.tell(1, 2)
    return Result(own.rows, given, own.measured, own.told, beside.computed(given.beside))


def _own(ship, given):
    """The methods.Found of the hull alone, which stays while only the other hull is another."""
    known_given, known = ship.memory.get("resistance", (None, None))
    if known_given != given:
        known = methods.found(ship.body, given)
        ship.memory["resistance"] = given, known
    return known


# What ends the names of hull_native's columns; others have no unit, but for texts.
_UNITS = {"kn": "kn", "kN": "kN", "kW": "kW", "m_s": "m/s", "m": "m", "deg": "deg"}
_OF_THE_OTHER = (
    *("other hull total [kN]", "difference [kN]", "part [%]"),
    *("other hull effective power [kW]", "compared with"),
)


def _heading(column):
    for ending, unit in _UNITS.items():
        if column.endswith(f"_{ending}"):
            return f"{column[: -len(ending) - 1].replace('_', ' ')} [{unit}]"
    return column if column == "outside" else f"{column.replace('_', ' ')} [-]"


def header(result):
    return [*map(_heading, result.rows[0]), *(_OF_THE_OTHER if is_compared(result) else ())]


def rows(result):
    own = [[_there(value) for value in row.values()] for row in result.rows]
    if not is_compared(result):
        return own
    return [[*cells, *_cells(result.other, row)] for cells, row in zip(own, result.rows)]


def _there(value):
    """None, an empty cell, for NaN."""
    return None if isinstance(value, float) and math.isnan(value) else value


def is_compared(result):
    """Whether there are numbers of another hull beside the hull's own."""
    return result.other is not None and bool(result.other.rows)


def _cells(other, row):
    theirs = other.row_at(row["speed_m_s"])
    if theirs is None:
        return [None, None, None, None, other.name]
    total, power = theirs["total_kN"], theirs["effective_power_kW"]
    difference = row["total_kN"] - total
    part = 100.0 * difference / total if total > 0.0 else None
    return [*map(_there, (total, difference, part, power)), other.name]


def plot(result, name, shown=METRIC):
    at = f"{name}, {NAMES[result.given.method]}, {asked.at(result.given.where, shown)}"
    others = [(result.other.name, result.other.rows)] if is_compared(result) else []
    hull_native = native.require()
    sizes = hull_native.PlotUnits(shown.plot_sizes())
    return hull_native.resistance_plot(result.rows, subtitles=[at], others=others, units=sizes)


def shown(count, most):
    """Which of `count` rows a table of `most` rows shows: first and last, and between at even
    distances."""
    if count <= most:
        return list(range(count))
    return [math.floor(i * (count - 1) / (most - 1) + 0.5) for i in range(most)]
