# SPDX-License-Identifier: GPL-3.0-or-later
"""What the title block of a lines plan says of the ship."""

from dataclasses import replace

from ...bridge.blender import units
from ..flotation import afloat, hydrostatics


def particulars(settings, body, scale, shown):
    """Pairs (name, value) of an Object.hull and its body, in units as units.Shown has them; what is
    not given is left out."""
    given = {
        "Length between perpendiculars": settings.length_pp,
        "Beam": settings.beam,
        "Depth": settings.depth,
        "Draft": settings.draft,
    }
    pairs = [
        (name, shown.text(units.as_typed(value) * scale, "m", decimals=2))
        for name, value in given.items()
        if value
    ]
    try:
        where = replace(afloat.afloat(settings, scale), trim_m=0.0, heel=0.0)
        found = hydrostatics.described(hydrostatics.computed(body, where), where)
    except ValueError:
        return pairs  # afloat at no such draft: the drawing is good without
    pairs.append(("Displaced volume", shown.text(found.displaced_volume, "m3", decimals=1)))
    pairs.append(("Displacement", shown.text(found.displacement_t, "t", decimals=1)))
    return pairs
