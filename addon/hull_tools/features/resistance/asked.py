# SPDX-License-Identifier: GPL-3.0-or-later
"""What of the resistance is asked for, by the settings of a hull."""

import math
from dataclasses import dataclass, replace
from functools import partial

from ...bridge import limits
from ...bridge.blender.units import METRIC, as_typed
from ..curves_of_form.ranges import stepped
from ..flotation import afloat, resistance_data
from ..variants import afloat as afloat_beside
from ..variants import other_hull

KNOT = 1852.0 / 3600.0  # m/s

NAMES = {
    "HOLTROP": "Holtrop and Mennen 1984",
    "MICHELL": "ITTC 1957 and Michell",
    "SAVITSKY": "Savitsky 1964",
    "DELFT": "Delft series 1998",
}


_BESIDE = {"FOUND": None, "ONE": False, "BESIDE": True}


@dataclass(frozen=True)
class Inputs:
    """given: pairs (field of what hull_native asks of the ship, value) that replace what the hull
    has; others as their settings."""

    where: afloat.Afloat
    method: str
    speeds: tuple  # m/s
    form_factor: float  # 1 + k of the ITTC line
    stern: float
    appendages: tuple  # (area in m², 1 + k2), or none
    propeller: tuple  # pairs (argument of hull_native.Propeller, value), or none
    thruster: tuple  # (diameter of the tunnel in m, coefficient of its opening)
    roughness: float  # m
    planing: tuple  # pairs (argument of hull_native.planing_boat, value), with Savitsky alone
    heel_deg: float  # with the Delft series alone
    given: tuple
    side_by_side: object = None  # True or False, None: as the hull has it
    beside: object = None  # Beside, or None


@dataclass(frozen=True)
class Beside:
    """The hull that is compared with: other_hull.Other and its Inputs, None of both where there is
    a problem, which is told."""

    other: object = None
    inputs: object = None
    problem: str = ""


def inputs(settings, metres_per_unit):
    """Inputs of an Object.hull and of the hull beside it; ValueError for what no ship has."""
    found = own_inputs(settings, metres_per_unit)
    return replace(found, beside=_beside(settings, metres_per_unit, found))


def own_inputs(settings, metres_per_unit):
    """Inputs of the hull alone."""
    own, metres = settings.resistance, partial(afloat.length_in_metres, metres_per_unit)

    def number(name, title, least, greatest):
        return limits.within(as_typed(getattr(own, name)), title, least, greatest)

    area = number("appendage_area", "Appendages in m²", 0.0, 1e6)
    factor = number("appendage_factor", "1 + k2", 0.0, 100.0)
    return Inputs(
        upright(afloat.afloat(settings, metres_per_unit)),
        own.method,
        _speeds(own),
        number("form_factor", "1 + k", 0.0, 10.0),
        float(own.stern),
        (area, factor) if area > 0.0 else (),
        _propeller(own, metres(own.propeller_diameter, "Propeller"), number),
        (
            metres(own.thruster_diameter, "Thruster"),
            number("thruster_coefficient", "CBTO", 0.0, 0.1),
        ),
        1e-6 * number("roughness_um", "Roughness in µm", 1.0, 1e4),
        _planing(settings, metres) if own.method == "SAVITSKY" else (),
        math.degrees(afloat.as_typed_angle(own.heel)) if own.method == "DELFT" else 0.0,
        given(own, own.method, metres_per_unit),
        _BESIDE[own.hulls],
    )


def upright(where):
    if where.heel != 0.0:
        raise ValueError("Resistance is that of the upright hull: set the heel to zero")
    return where


def at(where, shown=METRIC):
    """Words for how a ship lies; shown: a units.Shown."""
    words = f"draft {shown.text(where.draft, 'm')}"
    if where.trim_m:
        words += f", trim {shown.text(where.trim_m, 'm')} by the stern"
    return words


def _speeds(own):
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
    return tuple(speed * KNOT for speed in stepped(first, last, step, "speeds"))


def _propeller(own, diameter, number):
    if not diameter > 0.0:
        return ()
    return (
        ("diameter", diameter),
        ("screws", 2 if own.twin_screw else 1),
        ("open_stern", own.open_stern),
        ("area_ratio", number("blade_area_ratio", "AE/AO", 0.1, 2.0)),
        ("pitch_ratio", number("pitch_ratio", "P/D", 0.1, 5.0)),
        ("open_water_efficiency", number("open_water_efficiency", "Open water", 0.0, 0.99)),
        ("shaft_efficiency", number("shaft_efficiency", "Shaft", 0.01, 1.0)),
    )


def _planing(settings, metres):
    own = settings.resistance
    return (
        ("vcg", metres(settings.loading.kg, "VCG")),
        ("thrust_angle_deg", math.degrees(afloat.as_typed_angle(own.shaft_angle))),
        ("thrust_arm", metres(own.thrust_arm, "Thrust arm", -limits.LONGEST)),
    )


def given(own, method, metres_per_unit):
    """The pairs of Inputs.given of an Object.hull.resistance."""

    def metres(value):
        return limits.within(
            as_typed(value) * metres_per_unit, "Length in m", -limits.LONGEST, limits.LONGEST
        )

    if method == "SAVITSKY":
        values = {
            "mass_t": as_typed(own.planing_mass_t),
            "beam": metres(own.chine_beam),
            "deadrise_deg": math.degrees(afloat.as_typed_angle(own.deadrise)),
            "lcg": metres(own.planing_lcg),
        }
    else:
        values = resistance_data.given(own, method.lower(), metres)
    return tuple((name, value) for name, value in values.items() if value or name in own.zeros)


def _beside(settings, metres_per_unit, own):
    """The Beside of a hull whose own Inputs these are; None where it is compared with nothing, or
    is to be shown alone. The other hull has the speeds and what is told of the ship as this one;
    what was measured is the other's own, and so is what is given in place of it."""
    obj = settings.id_data
    if not (settings.variants.resistance_beside and other_hull.is_chosen(obj)):
        return None
    try:
        other = other_hull.of(obj, metres_per_unit)
        where = upright(afloat_beside.of_other(obj, metres_per_unit))
        theirs = given(other_hull.settings_of(obj).resistance, own.method, metres_per_unit)
        return Beside(other, replace(own, where=where, given=theirs))
    except ValueError as error:
        return Beside(problem=str(error))
