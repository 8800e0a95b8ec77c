# SPDX-License-Identifier: GPL-3.0-or-later
"""The wind on the ship, and what damps her roll, from the settings."""

from dataclasses import dataclass

from ...bridge.blender.units import as_typed


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
    """WindInputs of an Object.hull; None while the wind areas are not known."""
    wind = settings.wind
    if wind.source == "NONE":
        return None
    return WindInputs(
        hull_profile=wind.source == "HULL",
        areas=tuple((as_typed(one.area), as_typed(one.z) * metres_per_unit) for one in wind.areas),
        lever=as_typed(wind.lever) * metres_per_unit or None,
        pressure=as_typed(wind.pressure),
        keel_area=as_typed(wind.keel_area),
        sharp_bilges=wind.sharp_bilges,
        roll_period=as_typed(wind.roll_period) or None,
    )
