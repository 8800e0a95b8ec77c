# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance and running trim of prismatic planing hulls by Savitsky (1964), Hydrodynamic design of
planing hulls; equations are numbered as there. Lengths in m, masses in t, forces in kN."""

import math
from dataclasses import dataclass

from . import _core
from ._core import SEA_WATER_DENSITY
from ._resistance import GRAVITY, ittc_1957
from .deadrise import bottom_deadrise
from .positive_fields import check_positive
from .water import water_viscosity

_TRIMS = (0.3, 15.0)  # degrees, between which an equilibrium is looked for
_ROUGHNESS = 0.0004  # the ATTC's standard allowance


@dataclass(frozen=True)
class PlaningBoat:
    """beam: mean over the chines that are wet, b. deadrise_deg: its mean. lcg: centre of gravity
    before the transom, along the keel; vcg: above the keel. thrust_angle_deg: of the shaft against
    the keel, thrust_arm: distance of its line below the centre of gravity, f."""

    mass_t: float
    beam: float
    deadrise_deg: float
    lcg: float
    vcg: float
    thrust_angle_deg: float = 0.0
    thrust_arm: float = 0.0

    def __post_init__(self):
        check_positive(self, "A planing boat's", ("mass_t", "beam", "lcg"))
        for name in ("vcg", "thrust_angle_deg", "thrust_arm"):
            if not math.isfinite(getattr(self, name)):
                raise ValueError(f"A planing boat's {name} must be a finite number.")
        if not 0.0 <= self.deadrise_deg < 45.0:
            raise ValueError(f"The deadrise must be from 0 to below 45°, not {self.deadrise_deg}°.")


@dataclass(frozen=True)
class PlaningResult:
    """Equilibrium at one speed. `outside`: a sentence for each range of the formulas that is
    left."""

    speed: float  # m/s
    speed_coefficient: float  # Cv, V / √(g b)
    trim_deg: float  # of the keel, τ
    wetted_length_ratio: float  # λ: mean wetted length, of the beam
    lift_coefficient: float  # CLβ
    flat_lift_coefficient: float  # CL0
    bottom_speed: float  # Vm, m/s
    reynolds: float
    friction_coefficient: float  # with the roughness allowance
    friction: float  # Df, kN, along the bottom
    pressure: float  # kN: of the total, Δ tan τ
    total: float  # D, kN
    pressure_arm: float  # c, m: the centre of gravity before that of pressure, along the keel
    keel_length: float  # m, wet
    chine_length: float  # m, wet; below zero the chine is dry at the transom
    keel_draft: float  # m, at the transom
    effective_power: float  # kW
    outside: tuple


def attc_1947(reynolds_number):
    """CF of Schoenherr's line (1932), 0.242 / √CF = log10(Rn CF), to rounding. ValueError as
    ittc_1957()."""
    root = math.sqrt(ittc_1957(reynolds_number))
    for _ in range(50):  # Newton's steps in √CF, on a function that is convex
        error = 0.242 / root - math.log10(reynolds_number * root**2)
        step = error / (0.242 / root**2 + 2.0 / (root * math.log(10.0)))
        root += step
        if abs(step) <= 1e-16 * root:
            break
    return root**2


_LINES = {"attc": attc_1947, "ittc": ittc_1957}


def savitsky(
    boat,
    speeds,
    *,
    water_density=SEA_WATER_DENSITY,
    viscosity=None,
    gravity=GRAVITY,
    friction_line="attc",
    roughness_allowance=_ROUGHNESS,
):
    """A list of PlaningResult, one for each speed in m/s, each at the trim that is in equilibrium
    (35).

    viscosity: kinematic, m²/s; None: that of water of the density. friction_line: "attc",
    Schoenherr's, as in the paper, or "ittc". ValueError for what is no
    number above zero, and where no trim from 0.3° to 15° is in equilibrium.
    """
    if friction_line not in _LINES:
        raise ValueError(f'friction_line must be "attc" or "ittc", not {friction_line!r}.')
    if viscosity is None:
        viscosity = water_viscosity(water_density)
    for name, value in (
        ("water_density", water_density),
        ("viscosity", viscosity),
        ("gravity", gravity),
    ):
        if not (value > 0.0 and math.isfinite(value)):
            raise ValueError(f"{name} must be a number above zero, not {value}.")
    line = _LINES[friction_line]

    def friction(reynolds):
        return line(reynolds) + roughness_allowance

    results = []
    for speed in map(float, speeds):
        if not (speed > 0.0 and math.isfinite(speed)):
            raise ValueError(f"The speed must be a number above zero, not {speed}.")
        run = _Run(boat, speed, water_density, viscosity, gravity, friction)
        results.append(run.result(run.equilibrium()))
    return results


def planing_at_trims(boat, speed, trims_deg, **how):
    """PlaningResult at trims that are held, as the columns of the paper's Table 1, with the moments
    that are left there: a list of (PlaningResult, kN·m by the bow). Keywords as savitsky() has
    them, but for the friction line, which is Schoenherr's."""
    allowance = how.pop("roughness_allowance", _ROUGHNESS)
    density = how.pop("water_density", SEA_WATER_DENSITY)
    viscosity = how.pop("viscosity", None) or water_viscosity(density)
    gravity = how.pop("gravity", GRAVITY)
    if how:
        raise TypeError(f"Unknown arguments: {sorted(how)}.")
    run = _Run(boat, speed, density, viscosity, gravity, lambda rn: attc_1947(rn) + allowance)
    return [(run.result(trim), run.moment(trim)) for trim in trims_deg]


def _root(function, low, high):
    """Of a function that has two signs at the ends, by bisection to rounding."""
    sign = function(low) > 0.0
    for _ in range(200):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        if (function(middle) > 0.0) == sign:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


class _Run:
    """A boat at a speed, its trim open."""

    def __init__(self, boat, speed, density, viscosity, gravity, friction):
        self.boat, self.speed, self.density, self.viscosity = boat, speed, density, viscosity
        self.weight = boat.mass_t * gravity
        self.friction = friction
        self.coefficient = speed / math.sqrt(gravity * boat.beam)
        self.lift = self.weight / (0.5 * density * speed**2 * boat.beam**2)
        self.flat_lift = self._flat_lift()

    def _flat_lift(self):
        """CL0 of CLβ = CL0 - 0.0065 β CL0^0.6 (16), the branch that rises."""
        slope = 0.0065 * self.boat.deadrise_deg
        least = slope**2.5  # where CLβ is none
        high = max(1.0, 4.0 * self.lift + 1.0)
        return _root(lambda flat: flat - slope * flat**0.6 - self.lift, least, high)

    def wetted_length_ratio(self, trim):
        """λ of CL0 = τ^1.1 (0.0120 √λ + 0.0055 λ^2.5 / Cv²) (15)."""
        wanted = self.flat_lift / trim**1.1

        def excess(ratio):
            return (
                0.0120 * math.sqrt(ratio) + 0.0055 * ratio**2.5 / self.coefficient**2 - wanted
            )

        high = 1.0
        while excess(high) < 0.0:
            high *= 2.0
        return _root(excess, 0.0, high)

    def _frictional(self, trim):
        """(λ, Vm, Rn, CF, Df)."""
        boat = self.boat
        ratio, angle = self.wetted_length_ratio(trim), math.radians(trim)
        dynamic = 0.0120 * math.sqrt(ratio) * trim**1.1
        dynamic -= 0.0065 * boat.deadrise_deg * dynamic**0.6
        slowed = 1.0 - dynamic / (ratio * math.cos(angle))  # (24), with Figure 14's deadrise
        speed = self.speed * math.sqrt(max(slowed, 0.01))
        reynolds = speed * ratio * boat.beam / self.viscosity
        coefficient = self.friction(reynolds)
        wetted = ratio * boat.beam**2 / math.cos(math.radians(boat.deadrise_deg))
        return (
            ratio,
            speed,
            reynolds,
            coefficient,
            (0.5 * self.density * speed**2 * wetted * coefficient),
        )

    def _pressure_arm(self, ratio):
        """c, by the centre of pressure's place, Figure 17."""
        place = 0.75 - 1.0 / (5.21 * (self.coefficient / ratio) ** 2 + 2.39)
        return self.boat.lcg - place * ratio * self.boat.beam

    def moment(self, trim):
        """Equation (35), kN·m; above zero it brings the bow down."""
        boat, angle = self.boat, math.radians(trim)
        thrust = angle + math.radians(boat.thrust_angle_deg)
        ratio, *_, friction = self._frictional(trim)
        arm = self._pressure_arm(ratio)
        lift = (1.0 - math.sin(angle) * math.sin(thrust)) * arm / math.cos(angle)
        deadrise = 0.25 * boat.beam * math.tan(math.radians(boat.deadrise_deg))
        drag_arm = boat.vcg - deadrise - boat.thrust_arm
        return self.weight * (lift - boat.thrust_arm * math.sin(angle)) + friction * drag_arm

    def equilibrium(self):
        """The least trim at which moments are in balance, degrees."""
        low, high = _TRIMS
        steps = [low * (high / low) ** (i / 40.0) for i in range(41)]
        before = self.moment(low)
        for begin, end in zip(steps, steps[1:]):
            after = self.moment(end)
            if before <= 0.0 < after:
                return _root(self.moment, begin, end)
            before = after
        raise ValueError(
            f"At {self.speed:.4g} m/s no trim from {low}° to {high}° is in equilibrium by "
            "Savitsky's formulas: check lcg, mass and beam, or take a higher speed."
        )

    def result(self, trim):
        boat, angle = self.boat, math.radians(trim)
        ratio, bottom_speed, reynolds, coefficient, friction = self._frictional(trim)
        pressure = self.weight * math.tan(angle)
        total = pressure + friction / math.cos(angle)
        chine = boat.beam * math.tan(math.radians(boat.deadrise_deg))
        chine /= 2.0 * math.pi * math.tan(angle)
        keel = ratio * boat.beam + chine
        return PlaningResult(
            speed=self.speed,
            speed_coefficient=self.coefficient,
            trim_deg=trim,
            wetted_length_ratio=ratio,
            lift_coefficient=self.lift,
            flat_lift_coefficient=self.flat_lift,
            bottom_speed=bottom_speed,
            reynolds=reynolds,
            friction_coefficient=coefficient,
            friction=friction,
            pressure=pressure,
            total=total,
            pressure_arm=self._pressure_arm(ratio),
            keel_length=keel,
            chine_length=ratio * boat.beam - chine,
            keel_draft=keel * math.sin(angle),
            effective_power=total * self.speed,
            outside=self._outside(trim, ratio),
        )

    def _outside(self, trim, ratio):
        ranges = (
            ("speed coefficient Cv", self.coefficient, 0.6, 13.0),
            ("trim in degrees", trim, 2.0, 15.0),
            ("wetted length to beam", ratio, 0.0, 4.0),
        )
        return tuple(
            f"{name} {value:.3g} is outside {low} to {high}"
            for name, value, low, high in ranges
            if not low <= value <= high
        )


def planing_boat(body, *, draft, vcg, trim=0.0, draft_at=0.0, **given):
    """PlaningBoat of a HullBody that floats at rest at a draft (m at x = draft_at, trim in rad by
    the stern): mass and centre of gravity those of the displaced water, the transom at the
    waterline's after end, the beam that of the waterline, the deadrise that of bottom_deadrise().
    What is `given` by the name of its field replaces what was measured. ValueError for a hull out
    of the water, and as bottom_deadrise() where no deadrise is given."""
    density = given.pop("water_density", SEA_WATER_DENSITY)
    water = _core.hydrostatics(
        body, draft=draft, trim=trim, draft_at=draft_at, water_density=density
    )
    if not (water.displaced_volume > 0.0 and water.waterline_length > 0.0):
        raise ValueError(f"The hull is out of the water at a draft of {draft:.4g} m: set it.")
    measured = {
        "mass_t": water.displacement_t,
        "beam": water.waterline_beam,
        "lcg": water.lcb - water.waterline_aft,
    }
    if "deadrise_deg" not in given:
        angle = bottom_deadrise(body, draft=draft, trim=trim, draft_at=draft_at)
        measured["deadrise_deg"] = math.degrees(angle)
    return PlaningBoat(**{**measured, "vcg": vcg, **given})
