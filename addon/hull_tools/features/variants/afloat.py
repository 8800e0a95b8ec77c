# SPDX-License-Identifier: GPL-3.0-or-later
"""How the hull that a hull is compared with lies in the water."""

from ..flotation.afloat import afloat
from . import other_hull


def of_other(obj, scale):
    """The flotation.afloat.Afloat of the Other that a hull has: its own, or that of the hull, as
    Object.hull.variants.afloat says. ValueError for what no ship has."""
    is_own = obj.hull.variants.afloat == "OWN"
    return afloat(other_hull.settings_of(obj) if is_own else obj.hull, scale)
