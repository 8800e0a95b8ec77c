# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance and power over speeds, by the methods of hull_native."""

import math
from dataclasses import dataclass

from ...bridge import limits, native
from ...bridge.blender.units import as_typed
from ..curves_of_form.ranges import stepped
from ..flotation import afloat

IS_LIVE = False

KNOT = 1852.0 / 3600.0  # m/s

NAMES = {
    "HOLTROP": "Holtrop and Mennen 1984",
    "MICHELL": "ITTC 1957 and Michell",
    "SAVITSKY": "Savitsky 1964",
    "DELFT": "Delft series 1998",
}


@dataclass(frozen=True)
class Inputs:
    where: afloat.Afloat
    method: str
    speeds: tuple  # m/s
    form_factor: float  # 1 + k of the ITTC line
    stern: float
    appendages: tuple  # (area in m², 1 + k2), or none
    propeller: tuple  # (diameter in m, screws), or none
    planing: tuple  # pairs (argument of hull_native.planing_boat, value), with Savitsky alone
    heel_deg: float  # with the Delft series alone


@dataclass(frozen=True)
class Result:
    rows: list  # of hull_native.holtrop_table() or another method's
    given: Inputs
    told: tuple = ()  # sentences about what was reckoned with

    def remarks(self):
        """Sentences about what the numbers rest on, each once."""
        yield from self.told
        told = dict.fromkeys(row.get("outside", "") for row in self.rows)
        parts = dict.fromkeys(part for text in told for part in text.split("; ") if part)
        yield from (f"Out of the method's range: {part}" for part in _first_of_each(parts))
        known = {row["speed_m_s"] for row in self.rows}
        left_out = [speed for speed in self.given.speeds if speed not in known]
        if left_out and self.given.method == "SAVITSKY":
            knots = ", ".join(f"{speed / KNOT:.4g}" for speed in left_out)
            yield f"No equilibrium by Savitsky's formulas, and left out: {knots} kn"
        worst = max((_error(row) for row in self.rows), default=0.0)
        if worst > 0.01:
            yield f"The wave resistance is known to {100.0 * worst:.1f} % only: the ends are blunt"


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


def inputs(settings, metres_per_unit):
    own = settings.resistance
    where = afloat.afloat(settings, metres_per_unit)
    if where.heel != 0.0:
        raise ValueError("Resistance is that of the upright hull: set the heel to zero")
    first, last, step = (
        limits.within(as_typed(value), f"{name} in kn", 0.0, limits.FASTEST)
        for name, value in (
            ("First speed", own.speed_from),
            ("Last speed", own.speed_to),
            ("Step of speeds", own.speed_step),
        )
    )
    if not first > 0.0:
        raise ValueError("The first speed must be more than zero")
    knots = stepped(first, last, step, "speeds")
    area = limits.within(as_typed(own.appendage_area), "Appendages in m²", 0.0, 1e6)
    factor = limits.within(as_typed(own.appendage_factor), "1 + k2", 0.0, 100.0)
    diameter = as_typed(own.propeller_diameter) * metres_per_unit
    limits.within(diameter, "Propeller in m", 0.0, limits.LONGEST)
    return Inputs(
        where,
        own.method,
        tuple(speed * KNOT for speed in knots),
        limits.within(as_typed(own.form_factor), "1 + k", 0.0, 10.0),
        float(own.stern),
        (area, factor) if area > 0.0 else (),
        (diameter, 2 if own.twin_screw else 1) if diameter > 0.0 else (),
        _planing(settings, metres_per_unit) if own.method == "SAVITSKY" else (),
        math.degrees(afloat.as_typed_angle(own.heel)) if own.method == "DELFT" else 0.0,
    )


def _planing(settings, metres_per_unit):
    own = settings.resistance

    def metres(value, name, least):
        length = as_typed(value) * metres_per_unit
        return limits.within(length, f"{name} in m", least, limits.LONGEST)

    found = {
        "deadrise_deg": math.degrees(afloat.as_typed_angle(own.deadrise)),
        "vcg": metres(settings.loading.kg, "VCG", 0.0),
        "thrust_angle_deg": math.degrees(afloat.as_typed_angle(own.shaft_angle)),
        "thrust_arm": metres(own.thrust_arm, "Thrust arm", -limits.LONGEST),
    }
    if beam := metres(own.chine_beam, "Chine beam", 0.0):
        found["beam"] = beam
    return tuple(found.items())


def compute(ship, given):
    hull_native = native.require()
    position = {k: v for k, v in given.where.position().items() if k != "heel"}
    density = given.where.water_density
    if given.method == "MICHELL":
        rows = hull_native.michell_table(
            ship.body,
            given.speeds,
            form_factor=given.form_factor,
            water_density=density,
            **position,
        )
        return Result(rows, given)
    if given.method == "SAVITSKY":
        boat = hull_native.planing_boat(
            ship.body, water_density=density, **position, **dict(given.planing)
        )
        return Result(hull_native.savitsky_table(boat, given.speeds, water_density=density), given)
    if given.method == "DELFT":
        return _of_a_yacht(ship, given, position)
    own = {"stern_coefficient": given.stern}
    if given.appendages:
        own["appendages"] = (given.appendages,)
    propeller = None
    if given.propeller:
        diameter, screws = given.propeller
        propeller = hull_native.Propeller(diameter, screws=screws)
    rows = hull_native.holtrop_table(
        ship.body, given.speeds, given=own, propeller=propeller, water_density=density, **position
    )
    return Result(rows, given)


def _of_a_yacht(ship, given, position):
    hull_native = native.require()
    fins = hull_native.delft_fins(ship.body, **position)
    rows = hull_native.delft_table(
        hull_native.delft_yacht(ship.body, **position),
        given.speeds,
        heel_deg=given.heel_deg,
        keel=fins.keels,
        rudder=fins.rudders,
        form_factor=given.form_factor,
        water_density=given.where.water_density,
    )
    return Result(rows, given, tuple(_told_of(fins)))


def _told_of(fins):
    """Which appendages count as what."""
    for word, found in (("Keel", fins.keels), ("Rudder", fins.rudders)):
        if found:
            yield f"{word}: {', '.join(fin.name for fin in found)}"
    if not fins.keels and not fins.rudders:
        yield "No keel, no rudder: what is in the hull's own mesh counts as hull"
    if fins.left_out:
        yield f"Left out, as no fin in the water: {', '.join(fins.left_out)}"


# What ends the names of hull_native's columns; others have no unit, but for texts.
_UNITS = {"kn": "kn", "kN": "kN", "kW": "kW", "m_s": "m/s", "m": "m", "deg": "deg"}


def _heading(column):
    for ending, unit in _UNITS.items():
        if column.endswith(f"_{ending}"):
            return f"{column[: -len(ending) - 1].replace('_', ' ')} [{unit}]"
    return column if column == "outside" else f"{column.replace('_', ' ')} [-]"


def header(result):
    return [_heading(column) for column in result.rows[0]]


def rows(result):
    return [list(row.values()) for row in result.rows]


def plot(result, name):
    where = result.given.where
    at = f"{name}, {NAMES[result.given.method]}, draft {where.draft:.3f} m"
    if where.trim_m:
        at += f", trim {where.trim_m:.3f} m by the stern"
    return native.require().resistance_plot(result.rows, subtitles=[at])


def shown(count, most):
    """Which of `count` rows a table of `most` rows shows: first and last, and between at even
    distances."""
    if count <= most:
        return list(range(count))
    return [math.floor(i * (count - 1) / (most - 1) + 0.5) for i in range(most)]
