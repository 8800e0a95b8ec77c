# SPDX-License-Identifier: GPL-3.0-or-later
"""A vessel's lines plan, and what it is drawn from: particulars, and places of lines."""

import hull_native as hn
import numpy as np

# Sheets in mm, the smallest first; the scale is the largest that the last one takes.
SHEETS = sorted(
    (
        (width, round(width / ratio))
        for width in range(240, 421, 20)
        for ratio in (2.0, 1.7, 2.0**0.5)
    ),
    key=lambda sheet: sheet[0] * sheet[1],
)
SCALES = [
    factor * 10.0**power for power in (1, 2, 3) for factor in (1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 7.5)
]
# Stations in Lpp; about how many waterlines in the draft and buttocks in the beam, the first that
# a sheet takes.
STATIONS = 20
SPACINGS = ((4, 8), (3, 6), (2, 6), (2, 4))
# Of a keel yacht the beam and draft do not tell of a block.
LEAST_BLOCK_COEFFICIENT = 0.3


def particulars(vessel):
    """Pairs (name, text) of a vessel's main dimensions and what it displaces."""
    given = vessel.data.particulars
    found = hn.upright_hydrostatics(vessel.surface, draft=given.draft, mirrored=vessel.data.half)
    volume = found.displaced_volume
    block = volume / (given.length_pp * given.beam * given.draft)
    pairs = [
        ("Length between perpendiculars", f"{given.length_pp:.2f} m"),
        ("Beam", f"{given.beam:.2f} m"),
        ("Draft", f"{given.draft:.2f} m"),
        ("Depth", f"{given.depth:.2f} m"),
        ("Displaced volume", f"{volume:,.1f} m³".replace(",", " ")),
        ("Block coefficient", f"{block:.3f}"),
        ("LCB from AP", f"{found.lcb:.2f} m"),
        ("Wetted surface", f"{found.wetted_surface:,.1f} m²".replace(",", " ")),
    ]
    if block < LEAST_BLOCK_COEFFICIENT:
        del pairs[5]
    return pairs


def draw(vessel, stem):
    """Writes `stem`.pdf and .png."""
    path = f"{stem}.pdf"
    spacing = next(s for s in SPACINGS if _fits(vessel, path, s, SHEETS[-1], None))
    scale = next(s for s in SCALES if _fits(vessel, path, spacing, SHEETS[-1], s))
    sheet = next(sheet for sheet in SHEETS if _fits(vessel, path, spacing, sheet, scale))
    _write(vessel, f"{stem}.png", spacing, sheet, scale)


def _fits(vessel, path, *how):
    try:
        _write(vessel, path, *how)
    except ValueError:
        return False
    return True


def _write(vessel, path, spacing, sheet, scale):
    given = vessel.data.particulars
    hn.write_lines_drawing(
        vessel.surface,
        path,
        mirrored=vessel.data.half,
        stations=given.length_pp / STATIONS,
        waterlines=round_spacing(given.draft / spacing[0]),
        buttocks=round_spacing(given.beam / spacing[1]),
        draft=given.draft,
        length=given.length_pp,
        title=vessel.data.name,
        particulars=particulars(vessel),
        offsets=False,
        paper=sheet,
        scale=scale,
    )


def round_spacing(about):
    """The spacing of a round number of m that is nearest by its ratio."""
    spacings = [factor * 10.0**power for power in range(-2, 3) for factor in (1.0, 2.0, 2.5, 5.0)]
    return min(spacings, key=lambda spacing: abs(np.log(spacing / about)))


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
