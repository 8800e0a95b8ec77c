# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacement and LCB of a hull that are kept while its surface is faired."""

from ....hull_fairness import kept_numbers
from ....hull_fairness.kept_numbers import LCB, VOLUME
from ..flotation import afloat

__all__ = ["LCB", "VOLUME", "keeping"]


def keeping(obj, scale, source, names):
    """The hull_fairness.kept_numbers.KeptNumbers of a hull whose ShipSource is given; None without
    names."""
    if not names:
        return None
    where = afloat.afloat(obj.hull, scale)
    if where.heel != 0.0:
        raise ValueError("Displacement and LCB are kept upright: set the heel to zero first")
    position = where.position()
    position.pop("heel")
    position["length_pp"] = where.length_pp or None
    position["water_density"] = where.water_density

    def new_body(points):
        surface = source.new_surface()
        surface.set_points(points)
        return source.bare_body(surface)

    return kept_numbers.kept_numbers(new_body, source.control.points, names, **position)
