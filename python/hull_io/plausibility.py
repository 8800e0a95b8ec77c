# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether what is said of a hull can be true of its surface: pure numbers, in m.

Nothing is refused here. Each doubt names what is odd and what to look at; `remedy` says which help
there is: TAKE the particulars named in `takes` from the surface, count the hull as WHOLE or HALF,
put its KEEL on the base line.
"""

from dataclasses import dataclass

import numpy as np

from . import sides

TAKE, WHOLE, HALF, KEEL = "TAKE", "WHOLE", "HALF", "KEEL"

# Shares of the surface's length and beam that ships have between perpendiculars, and moulded.
# Of sterns and stems that hang over far a fast boat's leave 0.85 of the length, a classic yacht's
# 0.65, which is about the length of its waterline.
LENGTHS = (0.8, 1.1)
LEAST_LENGTH, LEAST_OF_WATERLINE = 0.6, 0.9
BEAMS = (0.7, 1.1)
# What counts as about the middle: so far from it, as a part of the length.
MIDDLE = 0.1
# A keel further from the base line than this part of the height of the hull is not on it.
ON_BASE_LINE = 0.02
# A barge has Cb = Cm = 1.
FULL = 1.0 + 1e-6


@dataclass(frozen=True)
class Doubt:
    """A sentence, the remedy or "", and the names of particulars that TAKE would take."""

    message: str
    remedy: str = ""
    takes: tuple = ()


@dataclass(frozen=True)
class Extents:
    """low, high: (3,) of the surface as it is modelled. keel: z of its lowest point about the
    middle of its length, where no bulb or dome is."""

    low: tuple
    high: tuple
    keel: float

    @property
    def length(self):
        return self.high[0] - self.low[0]

    def beam(self, half):
        if half:
            return 2.0 * max(abs(self.low[1]), abs(self.high[1]))
        return self.high[1] - self.low[1]


def extents(points):
    """Extents of points (n, 3), n > 0, that lie closely on a surface."""
    low, high = points.min(axis=0), points.max(axis=0)
    away = np.abs(points[:, 0] - 0.5 * (low[0] + high[0]))
    about = away <= max(MIDDLE * (high[0] - low[0]), away.min())
    return Extents(tuple(low.tolist()), tuple(high.tolist()), float(points[about, 2].min()))


def doubts(particulars, half, found, block=None, midship=None, waterline=None):
    """A list of Doubt about a hull.

    particulars: has length_pp, beam and draft, 0 where not given. half: whether the hull is the
    port half and counts twice. found: the Extents of its surface. block, midship: Cb and Cm on
    these particulars, waterline: the length of the upright hull's waterline; None where unknown.
    """
    about_sides = _about_sides(half, found)
    dimensions = _about_units(particulars) or _about_dimensions(particulars, half, found, waterline)
    keel = _about_keel(found)
    # Both sides count twice, and a keel below the base line lies deeper than the draft.
    is_explained = bool(about_sides) or bool(keel) and found.keel < 0.0
    return about_sides + dimensions + keel + _about_fullness(block, midship, is_explained)


def taken(names, half, found):
    """{name: value} of "length_pp", "beam" and "depth" as the Extents of a surface have them."""
    values = {
        "length_pp": found.length,
        "beam": found.beam(half),
        "depth": max(found.high[2], 0.0),
    }
    return {name: values[name] for name in names}


def _about_sides(half, found):
    port, starboard = sides.reaches(found.low[1], found.high[1])
    if half and sides.has_both(found.low[1], found.high[1]):
        return [
            Doubt(
                f"Both sides are modelled, from y = {-starboard:.4g} to {port:.4g} m, but the hull "
                "counts as its port half, twice: count it as whole",
                WHOLE,
            )
        ]
    if not half and sides.has_one(found.low[1], found.high[1]):
        side = "port" if port > starboard else "starboard"
        return [Doubt(f"Only the {side} side is modelled, but the hull counts as whole", HALF)]
    return []


def _about_units(particulars):
    given = (particulars.length_pp, particulars.beam, particulars.draft)
    if given != (1.0, 1.0, 1.0):
        return []
    return [
        Doubt(
            "Lpp, beam and draft are all 1 m, as nobody gave them: take Lpp and beam from the "
            "surface, and give the draft",
            TAKE,
            ("length_pp", "beam"),
        )
    ]


def _about_dimensions(particulars, half, found, waterline):
    least, most = LENGTHS
    longest = max(found.length, waterline or 0.0)
    if waterline is not None and longest > 0.0:
        floating = LEAST_OF_WATERLINE * waterline / longest
        least = min(least, max(LEAST_LENGTH, floating))
    far = []
    for name, title, (least, most), extent in (
        ("length_pp", "Lpp", (least, most), found.length),
        ("beam", "The beam", BEAMS, found.beam(half)),
    ):
        given = getattr(particulars, name)
        if given > 0.0 and extent > 0.0 and not least <= given / extent <= most:
            message = f"{title} of {given:.4g} m is far from the surface's {extent:.4g} m"
            far.append(Doubt(message, TAKE, (name,)))
    return far


def _about_keel(found):
    near = ON_BASE_LINE * (found.high[2] - found.low[2])
    # A keel that rises from an end, as a raked one, is on the base line by its lowest point.
    rises_from_it = found.keel > 0.0 and abs(found.low[2]) <= near
    if abs(found.keel) <= near or rises_from_it:
        return []
    where = "below" if found.keel < 0.0 else "above"
    return [
        Doubt(
            f"The keel is {abs(found.keel):.4g} m {where} the base line z = 0, from which drafts "
            "are measured: put it there",
            KEEL,
        )
    ]


def _about_fullness(block, midship, is_explained):
    full = [
        f"{name} is {value:.3f}"
        for name, value in (("Cb", block), ("Cm", midship))
        if value is not None and value > FULL
    ]
    if not full or is_explained:
        return []
    return [
        Doubt(
            f"{' and '.join(full)}, more than 1: Lpp, beam or draft are not those of the surface",
            TAKE,
            ("length_pp", "beam"),
        )
    ]
