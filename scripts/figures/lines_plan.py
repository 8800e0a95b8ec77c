# SPDX-License-Identifier: GPL-3.0-or-later
"""A vessel's lines plan, and what it is drawn from: particulars, and places of lines."""

import hull_native as hn
import numpy as np

PAPER = "A3"
# Stations in Lpp; waterlines in the draft and buttocks in the beam, the first that the sheet takes.
STATIONS = 20
SPACINGS = ((4, 8), (3, 6), (2, 6), (2, 4))


def particulars(vessel):
    """Pairs (name, text) of a vessel's main dimensions and what it displaces."""
    given = vessel.data.particulars
    found = hn.upright_hydrostatics(vessel.surface, draft=given.draft, mirrored=vessel.data.half)
    block = given.length_pp * given.beam * given.draft
    return [
        ("Length between perpendiculars", f"{given.length_pp:.2f} m"),
        ("Beam", f"{given.beam:.2f} m"),
        ("Draught", f"{given.draft:.2f} m"),
        ("Depth", f"{given.depth:.2f} m"),
        ("Displaced volume", f"{found.displaced_volume:,.1f} m³".replace(",", " ")),
        ("Block coefficient", f"{found.displaced_volume / block:.3f}"),
        ("LCB from AP", f"{found.lcb:.2f} m"),
        ("Wetted surface", f"{found.wetted_surface:,.1f} m²".replace(",", " ")),
    ]


def draw(vessel, stem):
    """Writes `stem`.pdf and .png."""
    given = vessel.data.particulars
    for ending in ("pdf", "png"):
        _write(vessel, given, f"{stem}.{ending}")


def _write(vessel, given, path):
    refused = None
    for waterlines, buttocks in SPACINGS:
        try:
            hn.write_lines_drawing(
                vessel.surface,
                path,
                mirrored=vessel.data.half,
                stations=given.length_pp / STATIONS,
                waterlines=given.draft / waterlines,
                buttocks=given.beam / buttocks,
                draft=given.draft,
                length=given.length_pp,
                title=vessel.data.name,
                particulars=particulars(vessel),
                offsets=False,
                paper=PAPER,
            )
            return
        except ValueError as error:
            refused = error
    raise refused


def stations(vessel):
    """[(label, x)] of a sections plan: Lpp / 20, and half of that in the ends."""
    length = vessel.data.particulars.length_pp
    points = vessel.surface.tessellate(4).points[:, 0]
    low, high = points.min(), points.max()
    numbers = [n for n in np.arange(-4.0, 24.5, 0.5) if n % 1 == 0 or not 2 < n < 18]
    found = []
    for number in numbers:
        x = number * length / STATIONS
        if low < x < high:
            half = "½" if number % 1 else ""
            whole = int(abs(number))
            found.append((("−" if number < 0 else "") + f"{whole or ('' if half else 0)}{half}", x))
    return found
