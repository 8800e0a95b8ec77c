# SPDX-License-Identifier: GPL-3.0-or-later
"""How a hull lies in the water by its settings, in metres and radians."""

from dataclasses import dataclass, replace
from functools import partial
from math import atan, cos, degrees, radians

from ...bridge import limits
from ...bridge.blender.units import as_typed

# What numbers of hull_native refer to that a hull need not have, by the names of an Afloat.
_REFERRED = {
    "project.block": ("length_pp", "beam"),
    "project.prismatic": ("length_pp",),
    "project.midship": ("length_pp", "beam"),
    "project.waterplane": ("length_pp", "beam"),
    "lcb_percent": ("length_pp",),
    "lcf_percent": ("length_pp",),
    "midship_section.area": ("length_pp",),
}
_TITLES = {"length_pp": "Lpp", "beam": "the beam"}


@dataclass(frozen=True)
class Afloat:
    """draft: on the ship's vertical amidships. trim_m: that at the after perpendicular less that at
    the forward one. length_pp, beam: 0 where not given."""

    draft: float
    trim_m: float
    heel: float
    length_pp: float
    beam: float
    water_density: float

    @property
    def trim(self):
        """The angle in rad. On the vertical of a heeled ship a trim is 1 / cos(heel) longer."""
        if self.trim_m == 0.0:
            return 0.0
        if self.length_pp <= 0.0:
            raise ValueError("Give Lpp first: a trim is measured between the perpendiculars")
        return atan(self.trim_m * cos(self.heel) / self.length_pp)

    @property
    def draft_at(self):
        return 0.5 * self.length_pp

    def upright(self):
        return replace(self, heel=0.0)

    def position(self):
        """Arguments of hull_native's functions of a position."""
        return {
            "draft": self.draft,
            "trim": self.trim,
            "heel": self.heel,
            "draft_at": self.draft_at,
        }

    def check_given(self, number, label):
        """ValueError where a number of hull_native.FORM_NUMBERS, which people know by a label,
        refers to a dimension that is not given: it would be zero whatever the form is."""
        for name in _REFERRED.get(number, ()):
            if not getattr(self, name) > 0.0:
                raise ValueError(f"Give {_TITLES[name]} first: {label} refers to it")

    def project(self):
        """Arguments of hull_native.hydrostatics about ship and water; the design draft is the
        draft."""
        return {
            "length_pp": self.length_pp or None,
            "beam": self.beam or None,
            "water_density": self.water_density,
        }


def afloat(settings, metres_per_unit):
    """Afloat of an Object.hull; ValueError for what no ship has."""
    metres = partial(length_in_metres, metres_per_unit)
    heel = as_typed_angle(settings.heel)
    return Afloat(
        draft=metres(settings.draft, "Draft", -limits.LONGEST),
        trim_m=metres(settings.trim_m, "Trim", -limits.LONGEST),
        heel=limits.within(heel, "Heel in rad", -limits.GREATEST_HEEL, limits.GREATEST_HEEL),
        length_pp=metres(settings.length_pp, "Lpp"),
        beam=metres(settings.beam, "Beam"),
        water_density=limits.within(
            as_typed(settings.water_density), "Density in t/m³", *limits.DENSITIES
        ),
    )


def length_in_metres(metres_per_unit, value, name, least=0.0):
    """A length of the settings, in Blender's units; ValueError, by its name, for what no ship
    has."""
    length = as_typed(value) * metres_per_unit
    return limits.within(length, f"{name} in m", least, limits.LONGEST)


def as_typed_angle(value):
    """The radians of the degrees that a user typed."""
    return radians(as_typed(degrees(value)))
