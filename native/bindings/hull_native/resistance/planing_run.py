# SPDX-License-Identifier: GPL-3.0-or-later
"""A planing boat at a speed, by the equations of Savitsky (1964), numbered as there."""

import math
from dataclasses import dataclass

_TRIMS = (0.3, 15.0)  # degrees, between which an equilibrium is looked for


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


class PlaningRun:
    """A boat at a speed, its trim open; reading: what stands in place of formulas, by _READINGS."""

    def __init__(self, boat, speed, density, viscosity, gravity, friction, reading=None):
        self._reading = reading or {}
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
        if "wetted_length_ratio" in self._reading:
            return self._reading["wetted_length_ratio"]
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
        ratio = self.wetted_length_ratio(trim)
        speed = self._reading.get("bottom_speed") or self._bottom_speed(trim, ratio)
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

    def _bottom_speed(self, trim, ratio):
        """Vm by (24), with Figure 14's deadrise."""
        dynamic = 0.0120 * math.sqrt(ratio) * trim**1.1
        dynamic -= 0.0065 * self.boat.deadrise_deg * dynamic**0.6
        slowed = 1.0 - dynamic / (ratio * math.cos(math.radians(trim)))
        return self.speed * math.sqrt(max(slowed, 0.01))

    def _pressure_arm(self, ratio):
        """c, by the centre of pressure's place, Figure 17."""
        place = 0.75 - 1.0 / (5.21 * (self.coefficient / ratio) ** 2 + 2.39)
        place = self._reading.get("pressure_place", place)
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
        said = [
            f"{name} {value:.3g} is outside {low} to {high}"
            for name, value, low, high in ranges
            if not low <= value <= high
        ]
        if self.boat.side_by_side:
            said.append("hulls beside one another, which the formulas take for one boat")
        return tuple(said)
