# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance and propulsion factors of displacement ships by Holtrop and Mennen.

Holtrop & Mennen (1982), An approximate power prediction method, and Holtrop (1984), A statistical
re-analysis of resistance and propulsion data; symbols are theirs. Both papers' worked examples are
reproduced by the tests. Formulas for wetted surface, entrance angle, appendages, bulb, transom and
correlation are those of 1982, which 1984 kept. Lengths in m, forces in kN, densities in t/m³.
"""

import math
from dataclasses import dataclass, field

from .._core import SEA_WATER_DENSITY
from .._resistance import GRAVITY, ittc_1957
from .coefficients import Coefficients, checked_readings, require_used
from .holtrop_form import HoltropShip
from .positive_numbers import require_positive
from .propulsion import Propeller, propulsion_factors
from .water import water_viscosity

_SPEED_EXPONENT = -0.9  # d


@dataclass(frozen=True)
class HoltropResult:
    """Resistance at one speed, kN; what is not there is 0.

    `coefficients` holds each of the papers' coefficients by its name there ("c1", "m1", "1+k1",
    "iE", …); `outside` a sentence for each range of the method that is left."""

    speed: float  # m/s
    froude: float
    friction: float  # RF, of a flat plate
    form: float  # k1 RF
    appendages: float
    wave: float
    bulb: float
    transom: float
    correlation: float
    effective_power: float  # kW
    coefficients: dict = field(repr=False)
    propulsion: dict = field(default_factory=dict)  # "w", "t", "etaR", "etaH"; without propeller {}
    delivered_power: float = 0.0  # PD at the propeller, kW; 0 without an open water efficiency
    shaft_power: float = 0.0  # PS of the engine: PD by the shaft efficiency, kW
    outside: tuple = ()

    @property
    def total(self):
        parts = (self.friction, self.form, self.appendages, self.wave)
        return sum(parts) + self.bulb + self.transom + self.correlation


def holtrop(
    ship,
    speeds,
    *,
    edition=1984,
    water_density=SEA_WATER_DENSITY,
    viscosity=None,
    gravity=GRAVITY,
    roughness=150e-6,
    propeller=None,
    readings=None,
):
    """A list of HoltropResult, one for each speed in m/s.

    ship: HoltropShip. edition: 1984 or 1982. viscosity: kinematic, m²/s; None: that of water of the
    density. roughness: of the hull, m; 150 µm is that of new ships, which the correlation allowance
    has. propeller: Propeller, for wake and thrust deduction. readings: a dict of coefficients by
    the papers' names, as "1+k1" of a model test, in place of their formulas' at all speeds.
    ValueError for what is no number above zero, for readings of coefficients that are in use at
    none of the speeds, and for forms at which a formula has no value.
    """
    if edition not in _FORM_FACTORS:
        raise ValueError(f"edition must be 1984 or 1982, not {edition!r}.")
    if viscosity is None:
        viscosity = water_viscosity(water_density)
    require_positive(
        water_density=water_density, viscosity=viscosity, gravity=gravity, roughness=roughness
    )
    ship = ship.completed()
    water = _Water(water_density, viscosity, gravity, roughness)
    readings = checked_readings(readings or {})
    results = [
        _at_speed(ship, float(speed), edition, water, propeller, readings) for speed in speeds
    ]
    # Some are in use above a Froude number alone.
    require_used(readings, [result.coefficients for result in results])
    return results


@dataclass(frozen=True)
class _Water:
    density: float
    viscosity: float
    gravity: float
    roughness: float


def _form_factor_1982(ship, c):
    """1 + k1."""
    ratio = ship.draft / ship.length
    if ratio > 0.05:
        c["c12"] = ratio**0.2228446
    elif ratio > 0.02:
        c["c12"] = 48.20 * (ratio - 0.02) ** 2.078 + 0.479948
    else:
        c["c12"] = 0.479948
    c["c13"] = 1.0 + 0.003 * ship.stern_coefficient
    fullness = (0.95 - c["CP"]) ** -0.521448
    run = (1.0 - c["CP"] + 0.0225 * ship.lcb_percent) ** 0.6906
    return c["c13"] * (0.93 + c["c12"] * (ship.beam / c["LR"]) ** 0.92497 * fullness * run)


def _form_factor_1984(ship, c):
    c["c14"] = 1.0 + 0.011 * ship.stern_coefficient
    slender = (ship.beam / ship.length) ** 1.06806 * (ship.draft / ship.length) ** 0.46106
    run = (ship.length / c["LR"]) ** 0.121563
    light = (ship.length**3 / ship.displaced_volume) ** 0.36486
    fullness = (1.0 - c["CP"]) ** -0.604247
    return 0.93 + 0.487118 * c["c14"] * slender * run * light * fullness


_FORM_FACTORS = {1982: _form_factor_1982, 1984: _form_factor_1984}


def _take_form_coefficients(c, ship, edition):
    """What does not depend on the speed."""
    c["CP"], c["CB"], c["iE"] = ship.prismatic, ship.block, ship.entrance_angle_deg
    c["S"], c["LR"] = ship.wetted_surface, ship.length_of_run
    c["1+k1"] = _FORM_FACTORS[edition](ship, c)
    area, draft = ship.bulb_area, ship.draft_forward
    c["c3"] = 0.0
    if area > 0.0:
        c["c3"] = 0.56 * area**1.5 / (ship.beam * ship.draft * ship.bulb_depth)
    c["c2"] = math.exp(-1.89 * math.sqrt(c["c3"]))
    c["c4"] = min(draft / ship.length, 0.04)
    c["c5"] = 1.0 - 0.8 * ship.transom_area / (ship.beam * ship.draft * ship.midship)
    slender = ship.beam / ship.length
    if slender < 0.11:
        c["c7"] = 0.229577 * slender**0.33333
    else:
        c["c7"] = slender if slender <= 0.25 else 0.5 - 0.0625 / slender
    c["c1"] = (
        2223105.0
        * c["c7"] ** 3.78613
        * (ship.draft / ship.beam) ** 1.07961
        * (90.0 - c["iE"]) ** -1.37565
    )
    light = ship.length / ship.displaced_volume ** (1.0 / 3.0)
    if light**3 < 512.0:
        c["c15"] = -1.69385
    else:
        c["c15"] = -1.69385 + (light - 8.0) / 2.36 if light**3 <= 1726.91 else 0.0
    cp = c["CP"]
    c["c16"] = (
        8.07981 * cp - 13.8673 * cp**2 + 6.984388 * cp**3 if cp < 0.8 else 1.73014 - 0.7067 * cp
    )
    c["lambda"] = 1.446 * cp - (0.03 / slender if slender > 1.0 / 12.0 else 0.36)
    c["m1"] = 0.0140407 * ship.length / ship.draft - 1.75254 / light - 4.79323 * slender - c["c16"]
    if c["m1"] > 0.0:
        raise ValueError(
            f"Holtrop's waves would grow without bound at low speeds for a length of "
            f"{ship.length / ship.draft:.4g} drafts: check the drafts, or take Michell's integral."
        )


def _hump(c, froude, edition):
    """The exponent's oscillating part: m2 or m4 times the cosine."""
    if edition == 1982:
        name = "m2"
        c[name] = c["c15"] * c["CP"] ** 2 * math.exp(-0.1 * froude**-2)
    else:
        name = "m4"
        c[name] = c["c15"] * 0.4 * math.exp(-0.034 * froude**-3.29)
    # Read back, as a reading stands in the formula's place.
    return c[name] * math.cos(c["lambda"] * froude**-2)


def _wave_resistance(c, ship, froude, edition, water):
    weight = c["c2"] * c["c5"] * ship.displaced_volume * water.density * water.gravity

    def slow(fn):
        exponent = c["m1"] * fn**_SPEED_EXPONENT + _hump(c, fn, edition)
        return c["c1"] * weight * math.exp(exponent)

    def fast(fn):
        exponent = c["m3"] * fn**_SPEED_EXPONENT + _hump(c, fn, edition)
        return c["c17"] * weight * math.exp(exponent)

    if edition == 1982 or froude <= 0.4:
        return slow(froude)
    slender = ship.length / ship.beam
    if slender <= 2.0:
        raise ValueError(
            "Above a Froude number of 0.4 Holtrop's wave resistance needs a length of more than "
            f"twice the beam, not {slender:.2f} of it: use the 1982 edition, or Michell's integral."
        )
    c["c17"] = (
        6919.3
        * ship.midship**-1.3346
        * (ship.displaced_volume / ship.length**3) ** 2.00977
        * (slender - 2.0) ** 1.40692
    )
    c["m3"] = -7.2035 * slender**-0.326869 * (ship.draft / ship.beam) ** 0.605375
    if froude > 0.55:
        return fast(froude)
    low, high = slow(0.4), fast(0.55)
    _hump(c, froude, edition)
    return low + (10.0 * froude - 4.0) * (high - low) / 1.5


def _bulb_resistance(c, ship, speed, water):
    if not ship.bulb_area > 0.0:
        return 0.0
    side = math.sqrt(ship.bulb_area)
    depth = ship.draft_forward - 1.5 * ship.bulb_height
    height = ship.draft_forward - ship.bulb_height - 0.25 * side
    square = water.gravity * height + 0.15 * speed**2
    if not (depth > 0.0 and square > 0.0):
        return 0.0  # the bulb emerges: the formula has no value, and falls off to none
    c["PB"] = 0.56 * side / depth
    c["Fni"] = speed / math.sqrt(square)
    lift = c["Fni"] ** 3 * ship.bulb_area**1.5 * water.density * water.gravity
    return 0.11 * math.exp(-3.0 * c["PB"] ** -2) * lift / (1.0 + c["Fni"] ** 2)


def _transom_resistance(c, ship, speed, pressure, water):
    if not ship.transom_area > 0.0:
        return 0.0
    breadth = ship.beam + ship.beam * ship.waterplane
    c["FnT"] = speed / math.sqrt(2.0 * water.gravity * ship.transom_area / breadth)
    c["c6"] = max(0.2 * (1.0 - 0.2 * c["FnT"]), 0.0)
    return pressure * ship.transom_area * c["c6"]


def _correlation_allowance(c, ship, roughness):
    slow = 0.003 * math.sqrt(ship.length / 7.5) * c["CB"] ** 4 * c["c2"] * (0.04 - c["c4"])
    allowance = 0.006 * (ship.length + 100.0) ** -0.16 - 0.00205 + slow
    if roughness > 150e-6:
        allowance += (0.105 * roughness ** (1.0 / 3.0) - 0.005579) / ship.length ** (1.0 / 3.0)
    return allowance


def _at_speed(ship, speed, edition, water, propeller, readings):
    require_positive(speed=speed)
    c = Coefficients(readings)
    _take_form_coefficients(c, ship, edition)
    c["Fn"] = speed / math.sqrt(water.gravity * ship.length)
    c["CF"] = ittc_1957(speed * ship.length / water.viscosity)
    pressure = 0.5 * water.density * speed**2
    friction = pressure * c["S"] * c["CF"]
    c["1+k2"] = ship.appendage_factor
    appendages = pressure * ship.appendage_area * c["1+k2"] * c["CF"]
    appendages += 2.0 * pressure * math.pi * ship.thruster_diameter**2 * ship.thruster_coefficient
    c["CA"] = _correlation_allowance(c, ship, water.roughness)
    parts = {
        "friction": friction,
        "form": (c["1+k1"] - 1.0) * friction,
        "appendages": appendages,
        "wave": _wave_resistance(c, ship, c["Fn"], edition, water),
        "bulb": _bulb_resistance(c, ship, speed, water),
        "transom": _transom_resistance(c, ship, speed, pressure, water),
        # On hull and appendages together, as in both papers' examples.
        "correlation": pressure * (c["S"] + ship.appendage_area) * c["CA"],
    }
    power = sum(parts.values()) * speed
    factors, delivered, shaft = {}, 0.0, 0.0
    if propeller is not None:
        factors = propulsion_factors(ship, propeller, c, edition)
        if propeller.open_water_efficiency > 0.0:
            efficiency = factors["etaH"] * factors["etaR"] * propeller.open_water_efficiency
            delivered = power / efficiency
            shaft = delivered / propeller.shaft_efficiency
    return HoltropResult(
        speed=speed,
        froude=c["Fn"],
        effective_power=power,
        coefficients=dict(c),
        propulsion=factors,
        delivered_power=delivered,
        shaft_power=shaft,
        outside=ship.outside(c["Fn"], edition),
        **parts,
    )


__all__ = ["HoltropResult", "HoltropShip", "Propeller", "holtrop"]
