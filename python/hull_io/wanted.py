# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wanted of a hull beside what it is: numbers of its form, and a sectional area curve."""

from dataclasses import dataclass, field

# What can be wanted, as hull files name it.
QUANTITIES = (
    "volume",
    "displacement",
    "lcb_percent",
    "lcb",
    "cb",
    "cp",
    "cm",
    "cwp",
    "cvp",
    "awp",
    "lcf_percent",
    "lcf",
    "kb",
    "gm",
    "kmt",
    "bmt",
    "kml",
    "wetted",
    "midship_area",
    "section_area",
    "lwl",
    "bwl",
    "wave_resistance",
)
SENSES = ("equal", "at least", "at most")
MOVING = ("all", "selected", "none")
STAYING = ("profile", "deck_edge", "greatest_beam")
DIMENSIONS = ("length", "beam", "draft")


@dataclass
class Target:
    """A number that is wanted: one of QUANTITIES, in m, m², m³, t, kN or percent of Lpp.

    sense: one of SENSES. tolerance: by how much the value may be missed. station: x in m of a
    section_area; speed_kn of a wave_resistance. on: whether it counts.
    """

    quantity: str
    value: float
    sense: str = "equal"
    tolerance: float = 0.0
    station: float = 0.0
    on: bool = True
    speed_kn: float = 0.0


@dataclass
class FreeDimension:
    """Whether the hull may be scaled along an axis, and by how many percent at most."""

    free: bool = False
    percent: float = 5.0


@dataclass
class Targets:
    """rows: Target. moving: which control points may move, one of MOVING. staying: of STAYING.
    length, beam, draft: FreeDimension. fairness: what bending costs, as a part of the hull's
    length over which a change is spread."""

    rows: list = field(default_factory=list)
    moving: str = MOVING[0]
    staying: tuple = STAYING
    length: FreeDimension = field(default_factory=FreeDimension)
    beam: FreeDimension = field(default_factory=FreeDimension)
    draft: FreeDimension = field(default_factory=FreeDimension)
    fairness: float = 0.05


@dataclass
class AreaPoint:
    """x in m from the after perpendicular, and the area of the section there in m², both sides."""

    x: float
    area: float


@dataclass
class AreaTarget:
    """A sectional area curve that is wanted: base, the AreaPoints it was at first; points, those it
    goes through; source: where it comes from, for people."""

    base: list = field(default_factory=list)
    points: list = field(default_factory=list)
    source: str = ""
