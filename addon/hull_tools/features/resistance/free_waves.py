# SPDX-License-Identifier: GPL-3.0-or-later
"""Free waves of a hull at one speed by Michell's integral, which pattern and spectrum are of."""

from dataclasses import dataclass

from ...bridge import limits, native
from ...bridge.blender.units import as_typed
from ..flotation import afloat
from . import asked


@dataclass(frozen=True)
class Inputs:
    where: afloat.Afloat
    speed: float  # m/s


def inputs(settings, metres_per_unit):
    own = settings.resistance
    knots = own.wave_speed_kn or own.speed_to
    knots = limits.within(as_typed(knots), "Speed of the waves in kn", 0.1, limits.FASTEST)
    where = asked.upright(afloat.afloat(settings, metres_per_unit))
    return Inputs(where, knots * asked.KNOT)


def integral(body, given):
    """The hull_native.MichellIntegral of a body."""
    position = {k: v for k, v in given.where.position().items() if k != "heel"}
    return native.require().MichellIntegral(
        body, water_density=given.where.water_density, **position
    )


def subtitle(name, given, shown):
    at = asked.at(given.where, shown)
    return f"{name}, {given.speed / asked.KNOT:.4g} kn, {at}, by Michell"
