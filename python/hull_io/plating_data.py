# SPDX-License-Identifier: GPL-3.0-or-later
"""How a hull's shell is divided into plates, and its frames, as every reader delivers it."""

from dataclasses import dataclass, field

import numpy as np

from .errors import HullFileError

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

    def fault_of_frames(self):
        """(where, what is wrong, remedy) of ranges that do not rise or leave out frame 0; None
        where there is no such fault, or no range."""
        lasts = [self.first_frame, *(each.last for each in self.ranges)]
        for place, (first, last) in enumerate(zip(lasts, lasts[1:])):
            if last <= first:
                problem = f"frame {last} is not beyond frame {first}, where the range begins"
                return f"ranges[{place}].last", problem, "let frames rise"
        if self.ranges and not lasts[0] <= 0 <= lasts[-1]:
            problem = f"frames {lasts[0]} to {lasts[-1]} leave out frame 0"
            return "ranges", problem, "let them contain it, since places are counted from there"
        return None

    def frame_places(self, numbers, length):
        """(n,) x of frames (n,) by the ranges, m, of numbers between two of them in proportion;
        length: between perpendiculars, m. HullFileError for numbers beyond the ranges, and for a
        fault of these."""
        if fault := self.fault_of_frames():
            raise HullFileError("plating.{}: {}; {}.".format(*fault))
        lasts = [self.first_frame, *(each.last for each in self.ranges)]
        for number in numbers:
            if not lasts[0] <= number <= lasts[-1]:
                raise HullFileError(
                    f"Frame {number:g} is beyond the ranges, which have {lasts[0]} to {lasts[-1]}: "
                    "add a range."
                )
        along = np.cumsum(
            [0.0, *(each.spacing * n for each, n in zip(self.ranges, np.diff(lasts)))]
        )
        along = np.interp(numbers, lasts, along) - np.interp(0, lasts, along)
        return along if self.numbered_from == "AP" else length - along
