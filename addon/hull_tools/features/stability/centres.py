# SPDX-License-Identifier: GPL-3.0-or-later
"""Masses with their centres of gravity, from entries of lists."""

from ...bridge import limits
from ...bridge.blender.units import as_typed


def within_a_ship(value, name, metres_per_unit):
    """A coordinate in m of one in Blender's units."""
    place = as_typed(value) * metres_per_unit
    return limits.within(place, f"{name} in m", -limits.LONGEST, limits.LONGEST)


def named_mass(entry, metres_per_unit):
    """(name, mass in t, (LCG, TCG, VCG) in m) of an entry."""
    mass_t = limits.within(as_typed(entry.mass_t), f"{entry.name}: mass in t", 0.0, limits.HEAVIEST)
    centre = tuple(
        within_a_ship(value, entry.name, metres_per_unit)
        for value in (entry.lcg, entry.tcg, entry.vcg)
    )
    return entry.name, mass_t, centre
