# SPDX-License-Identifier: GPL-3.0-or-later
"""What the title block of a lines plan says of the ship."""

from dataclasses import replace

from ...bridge.blender import units
from ..flotation import afloat, hydrostatics


def particulars(settings, body, scale):
    """Pairs (name, value) of an Object.hull and its body; what is not given is left out."""
    given = {
        "Length between perpendiculars": settings.length_pp,
        "Beam": settings.beam,
        "Depth": settings.depth,
        "Draft": settings.draft,
    }
    pairs = [
        (name, f"{units.as_typed(value) * scale:.2f} m") for name, value in given.items() if value
    ]
    try:
        where = replace(afloat.afloat(settings, scale), trim_m=0.0, heel=0.0)
        found = hydrostatics.described(hydrostatics.computed(body, where), where)
    except ValueError:
        return pairs  # afloat at no such draft: the drawing is good without
    pairs.append(("Displaced volume", f"{found.displaced_volume:.1f} m³"))
    pairs.append(("Displacement", f"{found.displacement_t:.1f} t"))
    return pairs
