# SPDX-License-Identifier: GPL-3.0-or-later
"""The wind on the ship, and what damps her roll, from the settings."""

from dataclasses import dataclass

from ...bridge import limits
from ...bridge.blender.units import as_typed
from .centres import within_a_ship


@dataclass(frozen=True)
class WindInputs:
    """In m, m², Pa and s. lever, roll_period: None where they are to be found."""

    hull_profile: bool
    areas: tuple  # (area, its centre's height)
    lever: object
    pressure: float
    keel_area: float
    sharp_bilges: bool
    roll_period: object

    def arguments(self):
        """Arguments of hull_native.weather_criterion."""
        return {
            "hull_profile": self.hull_profile,
            "wind_areas": self.areas,
            "wind_lever": self.lever,
            "wind_pressure": self.pressure,
            "keel_area": self.keel_area,
            "sharp_bilges": self.sharp_bilges,
            "roll_period": self.roll_period,
        }


def wind_inputs(settings, metres_per_unit):
    """WindInputs of an Object.hull; None while the wind areas are not known. ValueError for what no
    ship has."""
    wind = settings.wind
    if wind.source == "NONE":
        return None

    def number(value, name, most):
        return limits.within(as_typed(value), name, 0.0, most)

    lever = as_typed(wind.lever) * metres_per_unit
    return WindInputs(
        hull_profile=wind.source == "HULL",
        areas=tuple(
            (
                number(one.area, f"{one.name} in m²", limits.LARGEST_WIND_AREA),
                within_a_ship(one.z, f"The centre of {one.name}", metres_per_unit),
            )
            for one in wind.areas
        ),
        lever=limits.within(lever, "The wind's lever in m", 0.0, limits.LONGEST) or None,
        pressure=number(wind.pressure, "The wind's pressure in Pa", limits.STRONGEST_WIND),
        keel_area=number(wind.keel_area, "The area of keels in m²", limits.LARGEST_WIND_AREA),
        sharp_bilges=wind.sharp_bilges,
        roll_period=number(wind.roll_period, "The roll's period in s", limits.LONGEST_ROLL_PERIOD)
        or None,
    )
