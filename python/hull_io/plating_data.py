# SPDX-License-Identifier: GPL-3.0-or-later
"""How a hull's shell is divided into plates, and its frames, as every reader delivers it."""

from dataclasses import dataclass, field

import numpy as np

# What seams and butts are made by; see hull_native.SeamRule.
SEAM_KINDS = (
    "strakes",
    "from_deck",
    "from_centre",
    "waterline",
    "buttock",
    "station",
    "butts",
    "projected",
    "openings",
)


@dataclass
class SeamRule:
    """kind: of SEAM_KINDS. value: its number, m. line: points (x, y, z), m, of "projected"."""

    kind: str
    value: float = 0.0
    line: list = field(default_factory=list)
    on: bool = True


@dataclass
class FrameRange:
    """Frames up to number `last`, `spacing` m apart."""

    last: int
    spacing: float


@dataclass
class Plating:
    """rules: SeamRule. along_knuckles: seams along these, too; across_centre: keel plates are one
    with their mirror images. thickness: of the plates, m. ranges: FrameRange, from first_frame on;
    numbered_from "AP" or "FP", in_roman numerals. mark_waterlines, mark_buttocks: whether those of
    the lines plan are marked on plates."""

    rules: list = field(default_factory=list)
    along_knuckles: bool = True
    across_centre: bool = True
    thickness: float = 0.01
    first_frame: int = -5
    ranges: list = field(default_factory=list)
    numbered_from: str = "AP"
    in_roman: bool = False
    mark_waterlines: bool = False
    mark_buttocks: bool = False

    def frame_places(self, numbers, length):
        """(n,) x of frames (n,) by the ranges, m, of numbers between two of them in proportion;
        length: between perpendiculars, m. Numbers beyond the ranges are NaN."""
        lasts = [self.first_frame, *(each.last for each in self.ranges)]
        along = np.cumsum(
            [0.0, *(each.spacing * n for each, n in zip(self.ranges, np.diff(lasts)))]
        )
        along = np.interp(numbers, lasts, along, np.nan, np.nan) - np.interp(0, lasts, along)
        return along if self.numbered_from == "AP" else length - along
