# SPDX-License-Identifier: GPL-3.0-or-later
"""The viscosity that goes with a density of water, at 15 °C.

ITTC 7.5-02-01-03, Density and viscosity of water, by its tables of 1963: of fresh water and of sea
water of a salinity of 3.5 %. Density and viscosity both grow almost evenly with salinity, so that
brackish water lies on the straight line between the two.
"""

from .._core import SEA_WATER_DENSITY

FRESH_WATER_DENSITY = 1.0  # t/m³
FRESH_WATER_VISCOSITY = 1.13902e-6  # m²/s
SEA_WATER_VISCOSITY = 1.18831e-6  # m²/s


def water_viscosity(water_density):
    """Kinematic viscosity in m²/s of water of a density in t/m³: that of fresh water up to 1 t/m³,
    of sea water from 1.025 t/m³ on, and evenly between them."""
    salt = (water_density - FRESH_WATER_DENSITY) / (SEA_WATER_DENSITY - FRESH_WATER_DENSITY)
    if salt >= 1.0:
        return SEA_WATER_VISCOSITY
    return FRESH_WATER_VISCOSITY + max(salt, 0.0) * (SEA_WATER_VISCOSITY - FRESH_WATER_VISCOSITY)


__all__ = [
    "FRESH_WATER_DENSITY",
    "FRESH_WATER_VISCOSITY",
    "SEA_WATER_VISCOSITY",
    "water_viscosity",
]
