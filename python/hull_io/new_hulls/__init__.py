# SPDX-License-Identifier: GPL-3.0-or-later
"""Control meshes of new hulls, by type and main dimensions: plain Python and NumPy.

Start at `new_hull`.
"""

from dataclasses import dataclass
from typing import Callable

from . import barge, canoe_body, planing, round_bilge
from .dimensions import Dimensions

# Least and greatest numbers of sections along the hull, and of control points in a section.
SECTIONS = (8, 60)
POINTS = (6, 24)


@dataclass(frozen=True)
class HullType:
    """make(dimensions, sections, points) returns a HullData; the rest is what is usual. Its module
    is looked up at the call: in the add-on it runs only then."""

    name: str
    description: str
    make: Callable
    dimensions: Dimensions
    sections: int
    points: int


TYPES = {
    "BARGE": HullType(
        "Barge",
        "Flat bottom and sides, small bilges, raked ends with headlogs",
        lambda *asked: barge.barge(*asked),
        Dimensions(length=60.0, beam=12.0, draft=2.8, depth=4.0),
        8,
        6,
    ),
    "ROUND_BILGE": HullType(
        "Round Bilge",
        "Displacement hull with flat bottom and sides amidships, raked stem and transom",
        lambda *asked: round_bilge.round_bilge_hull(*asked),
        Dimensions(length=80.0, beam=13.0, draft=5.0, depth=7.2),
        13,
        8,
    ),
    "PLANING": HullType(
        "Hard-chine Planing",
        "Planing hull with one chine, constant deadrise aft and a V forward",
        lambda *asked: planing.planing_hull(*asked),
        Dimensions(length=10.0, beam=3.2, draft=0.6, depth=1.6),
        10,
        8,
    ),
    "CANOE_BODY": HullType(
        "Sailing Yacht",
        "Canoe body of a sailing yacht: round sections, overhangs, no keel or rudder",
        lambda *asked: canoe_body.canoe_body(*asked),
        Dimensions(length=10.0, beam=3.5, draft=0.6, depth=1.7),
        11,
        7,
    ),
}


def new_hull(kind, length, beam, draft, depth, sections, points):
    """The HullData of a hull of TYPES: port half, tagged, particulars and flats included.

    Lengths in m, as in Dimensions; the surface has them exactly. ValueError for what no hull of
    the kind can have.
    """
    for value, (least, most), what in (
        (sections, SECTIONS, "sections"),
        (points, POINTS, "points in a section"),
    ):
        if not least <= value <= most:
            raise ValueError(f"{value} {what}: give {least} to {most}")
    return TYPES[kind].make(Dimensions(length, beam, draft, depth), sections, points)
