# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance of sailing yachts by the regressions of the Delft Systematic Yacht Hull Series.

Keuning & Sonnenberg (1998), Approximation of the hydrodynamic forces on a sailing yacht based on
the 'Delft Systematic Yacht Hull Series'; symbols are theirs. The coefficients are those on which at
least three of five independent listings agree, which differ in two digits at most. Lengths in m,
forces in kN, densities in t/m³.
"""

import math
from dataclasses import dataclass, fields

import numpy as np

from .._core import SEA_WATER_DENSITY
from .._resistance import GRAVITY, ittc_1957
from .delft_coefficients import HEELED, HEELED_KEEL, HULL, KEEL, WETTED
from .delft_form import DelftFin, one_fin
from .positive_numbers import require_positive
from .water import water_viscosity

_REYNOLDS_LENGTH = 0.7  # of the waterline
_LARGEST_HEEL = 35.0  # degrees, of the wetted surface's table


@dataclass(frozen=True)
class DelftResult:
    """Resistance at one speed and heel, kN; what is not there is 0. `outside`: a sentence for each
    range of the series that is left."""

    speed: float  # m/s
    froude: float
    friction: float  # of the upright canoe body, form factor included
    residuary: float  # Rrh
    keel_friction: float
    keel_residuary: float  # Rrk
    rudder_friction: float
    heeled_friction: float  # what the heel adds to each of three
    heeled_residuary: float
    heeled_keel: float
    effective_power: float  # kW
    outside: tuple

    @property
    def total(self):
        parts = (self.friction, self.residuary, self.keel_friction, self.keel_residuary)
        heeled = (self.heeled_friction, self.heeled_residuary, self.heeled_keel)
        return sum(parts) + self.rudder_friction + sum(heeled)


def delft(
    yacht,
    speeds,
    *,
    heel_deg=0.0,
    keel=None,
    rudder=None,
    form_factor=1.0,
    water_density=SEA_WATER_DENSITY,
    viscosity=None,
    gravity=GRAVITY,
):
    """A list of DelftResult, one for each speed in m/s.

    yacht: DelftYacht. keel, rudder: DelftFin, several of them, or None; keels' waves are those of
    one keel of their volume about their centre. form_factor: 1 + k of the canoe body. viscosity:
    kinematic, m²/s; None: that of water of the density. Between
    the Froude numbers of the tables values are interpolated by cubics through four neighbours'
    slopes; below the first they fall to zero at rest, above the last they are those of the last,
    and that is told. Side force and what it induces are left out. ValueError for what is no number
    above zero.
    """
    if viscosity is None:
        viscosity = water_viscosity(water_density)
    require_positive(
        form_factor=form_factor, water_density=water_density, viscosity=viscosity, gravity=gravity
    )
    if not 0.0 <= abs(heel_deg) <= _LARGEST_HEEL:
        raise ValueError(f"The heel must be up to {_LARGEST_HEEL:.0f}°, not {heel_deg}°.")
    run = _Run(yacht, abs(heel_deg), keel, rudder, form_factor, water_density, viscosity, gravity)
    return [run.result(float(speed)) for speed in speeds]


def _interpolated(places, values, at):
    """By cubics with the slopes of parabolas through neighbours; beyond the ends the ends'
    values."""
    at = min(max(at, places[0]), places[-1])
    i = min(int(np.searchsorted(places, at, side="right")) - 1, len(places) - 2)
    steps, rises = np.diff(places), np.diff(values)
    slopes = rises / steps

    def tangent(k):
        if k in (0, len(places) - 1):
            return slopes[min(k, len(slopes) - 1)]
        before, after = steps[k - 1], steps[k]
        return (slopes[k - 1] * after + slopes[k] * before) / (before + after)

    t, h = (at - places[i]) / steps[i], steps[i]
    blend = t * t * (3.0 - 2.0 * t)
    return (
        values[i]
        + blend * rises[i]
        + h * t * (1.0 - t) * ((1.0 - t) * tangent(i) - t * tangent(i + 1))
    )


def _all_of(fins):
    if fins is None:
        return ()
    return (fins,) if isinstance(fins, DelftFin) else tuple(fins)


class _Run:
    """A yacht at a heel in her water."""

    def __init__(self, yacht, heel_deg, keel, rudder, form_factor, density, viscosity, gravity):
        self.yacht, self.heel_deg = yacht, heel_deg
        self.keels, self.rudders = _all_of(keel), _all_of(rudder)
        self.keel = one_fin([keel for keel in self.keels if keel.volume is not None])
        self.heel = math.radians(heel_deg)
        self.form_factor, self.density = form_factor, density
        self.viscosity, self.gravity = viscosity, gravity
        self.weight = yacht.volume * density * gravity
        self.slender = yacht.length / yacht.volume ** (1.0 / 3.0)
        self.hull_places, self.hull_values = self._table(HULL, self._hull_terms())
        self.heel_places, self.heel_values = self._table(HEELED, self._heeled_terms())
        if self.keel is not None:
            self.keel_places, self.keel_values = self._table(KEEL, self._keel_terms())

    @staticmethod
    def _table(rows, terms):
        """(Froude numbers, values), 0 at rest among them."""
        places = [0.0, *rows]
        values = [0.0] + [float(np.dot(row, terms)) for row in rows.values()]
        return np.array(places), np.array(values)

    def _hull_terms(self):
        """Of Rrh / (∇c ρ g)."""
        y = self.yacht
        light = y.volume ** (2.0 / 3.0)
        own = (
            y.lcb / y.length,
            y.prismatic,
            light / y.waterplane_area,
            y.beam / y.length,
            light / y.wetted_surface,
            y.lcb / y.lcf,
            (y.lcb / y.length) ** 2,
            y.prismatic**2,
        )
        return np.array((1.0, *(term / self.slender for term in own)))

    def _heeled_terms(self):
        """Of what 20° of heel add, of a thousandth of ∇c ρ g."""
        y = self.yacht
        broad = y.beam / y.draft
        lcb = y.lcb_percent
        return np.array((1.0, y.length / y.beam, broad, broad**2, lcb, lcb**2))

    def _keel_terms(self):
        """Of Rrk / (∇k ρ g)."""
        y, k = self.yacht, self.keel
        return np.array(
            (
                1.0,
                k.total_draft / y.beam,
                (y.draft + k.centre) / k.volume ** (1.0 / 3.0),
                y.volume / k.volume,
            )
        )

    def _friction(self, speed, length, area, factor):
        line = ittc_1957(speed * length / self.viscosity)
        return 0.5 * self.density * speed**2 * area * factor * line

    def _heeled_surface(self):
        """What the heel adds to the wetted surface, of it."""
        broad = self.yacht.beam / self.yacht.draft
        terms = np.array((1.0, broad, broad**2, self.yacht.midship))
        places, values = self._table(WETTED, terms)
        return 0.01 * _interpolated(places, values, self.heel_deg)

    def _heeled_keel(self, froude):
        if self.keel is None:
            return 0.0
        y, k = self.yacht, self.keel
        terms = (y.draft / k.total_draft, y.beam / y.draft, y.beam / k.total_draft, self.slender)
        factor = float(np.dot(HEELED_KEEL, terms))
        return k.volume * self.density * self.gravity * factor * froude**2 * self.heel

    def result(self, speed):
        require_positive(speed=speed)
        y = self.yacht
        froude = speed / math.sqrt(self.gravity * y.length)
        friction = self._friction(
            speed, _REYNOLDS_LENGTH * y.length, y.wetted_surface, self.form_factor
        )
        fins = [
            sum(self._friction(speed, f.chord, f.wetted_surface, f.form_factor) for f in group)
            for group in (self.keels, self.rudders)
        ]
        keel_waves = 0.0
        if self.keel is not None:
            weight = self.keel.volume * self.density * self.gravity
            keel_waves = weight * _interpolated(self.keel_places, self.keel_values, froude)
        heeled = 1e-3 * _interpolated(self.heel_places, self.heel_values, froude)
        found = DelftResult(
            speed=speed,
            froude=froude,
            friction=friction,
            residuary=self.weight * _interpolated(self.hull_places, self.hull_values, froude),
            keel_friction=fins[0],
            keel_residuary=keel_waves,
            rudder_friction=fins[1],
            heeled_friction=friction * self._heeled_surface(),
            heeled_residuary=self.weight * heeled * 6.0 * self.heel**1.7,
            heeled_keel=self._heeled_keel(froude),
            effective_power=0.0,
            outside=self._outside(froude),
        )
        return _with_power(found)

    def _outside(self, froude):
        y = self.yacht
        ranges = [
            ("Froude number", froude, 0.1, 0.6),
            ("length to beam", y.length / y.beam, 2.73, 5.0),
            ("beam to draft", y.beam / y.draft, 2.46, 19.38),
            ("length to volume^(1/3)", self.slender, 4.34, 8.5),
            ("LCB in % of the length", y.lcb_percent, -8.2, 0.0),
            ("LCF in % of the length", 50.0 - 100.0 * y.lcf / y.length, -9.5, -1.8),
            ("prismatic coefficient", y.prismatic, 0.52, 0.60),
            ("midship coefficient", y.midship, 0.645, 0.78),
            (
                "waterplane to volume^(2/3)",
                y.waterplane_area / y.volume ** (2.0 / 3.0),
                3.78,
                12.67,
            ),
        ]
        if self.heel_deg > 0.0:
            ranges.append(("Froude number heeled", froude, 0.25, 0.55))
        said = [
            f"{name} {value:.3g} is outside {low} to {high}"
            for name, value, low, high in ranges
            if not low <= value <= high
        ]
        if y.side_by_side:
            said.append("hulls beside one another, which the series takes for one yacht")
        return tuple(said)


def _with_power(found):
    values = {each.name: getattr(found, each.name) for each in fields(found)}
    values["effective_power"] = found.total * found.speed
    return DelftResult(**values)
