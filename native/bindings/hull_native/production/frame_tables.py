# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames: where they stand, by spacings that hold from one frame to another, and their names."""

from dataclasses import dataclass

import numpy as np

from ..polylines import length_of

MOST_FRAMES = 2000
_ROMAN = [
    (1000, "M"), (900, "CM"), (500, "D"), (400, "CD"), (100, "C"), (90, "XC"),
    (50, "L"), (40, "XL"), (10, "X"), (9, "IX"), (5, "V"), (4, "IV"), (1, "I"),
]  # fmt: skip


def roman(number):
    """A whole number in Roman numerals; 0 is "0", negative ones have a minus sign."""
    if number == 0:
        return "0"
    text, left = "", abs(number)
    for value, numeral in _ROMAN:
        text += numeral * (left // value)
        left %= value
    return text if number > 0 else f"−{text}"


@dataclass(frozen=True)
class FrameTable:
    """numbers: (n,) of frames, rising. positions: (n,) their x, m. spacings: (n - 1,) from each to
    the next, m. names: as they are drawn."""

    numbers: np.ndarray
    positions: np.ndarray
    spacings: np.ndarray
    names: tuple

    def position(self, number):
        """x of a frame, m. ValueError for one that the table does not have."""
        at = np.flatnonzero(self.numbers == number)
        if len(at) == 0:
            raise ValueError(
                f"There is no frame {number}: the table has {self.names[0]} to {self.names[-1]}."
            )
        return float(self.positions[at[0]])

    def places(self, numbers):
        """(n,) x of frames (n,), m, of numbers between two of them in proportion. ValueError for
        numbers beyond the table."""
        numbers = np.asarray(numbers, dtype=float)
        for number in numbers:
            if not self.numbers[0] <= number <= self.numbers[-1]:
                raise ValueError(
                    f"Frame {number:g} is beyond the table, which has {self.names[0]} to "
                    f"{self.names[-1]}: add a range."
                )
        return np.interp(numbers, self.numbers, self.positions)

    def within(self, low, high):
        """The numbers of frames from x = low to high."""
        return self.numbers[(self.positions >= low) & (self.positions <= high)]


def _whole(number):
    if not (np.isfinite(number) and int(number) == number):
        raise ValueError(f"Frames have whole numbers, not {number:g}: end the range at one.")
    return int(number)


def frame_table(ranges, *, numbered_from="AP", length=None, in_roman=False):
    """The FrameTable of ranges (first number, last number, spacing in m), each of which begins
    where the one before ends.

    Frame 0 is at the after perpendicular, x = 0, and numbers rise forward; numbered_from="FP": it
    is at the forward one, x = length (m), and numbers rise aft. in_roman: names are Roman
    numerals. ValueError for numbers that are not whole, for ranges that do not follow one another
    or leave out frame 0, for spacings that are not positive, and for more than 2,000 frames.
    """
    ranges = [(_whole(a), _whole(b), float(s)) for a, b, s in ranges]
    if not ranges:
        raise ValueError("A frame table needs a range: first frame, last frame, spacing.")
    for k, (first, last, spacing) in enumerate(ranges):
        if not (last > first and np.isfinite(spacing) and spacing > 0.0):
            raise ValueError(
                f"The range of frames {first} to {last} with a spacing of {spacing:g} m is none: "
                "numbers rise, and spacings are above 0 m."
            )
        if k > 0 and first != ranges[k - 1][1]:
            raise ValueError(
                f"A range begins with frame {first}, and the one before ends with "
                f"{ranges[k - 1][1]}: let them meet."
            )
    begin, end = ranges[0][0], ranges[-1][1]
    if not begin <= 0 <= end:
        raise ValueError(f"Frames {begin} to {end} leave out frame 0, from which they are counted.")
    if end - begin >= MOST_FRAMES:
        raise ValueError(f"More than {MOST_FRAMES} frames are too many: widen the ranges.")
    if numbered_from not in ("AP", "FP"):
        raise ValueError(f'Frames are numbered from "AP" or "FP", not "{numbered_from}".')
    if numbered_from == "FP" and not (length is not None and np.isfinite(length)):
        raise ValueError("Frames numbered from FP need the length between perpendiculars.")
    spacings = np.concatenate([np.full(b - a, s) for a, b, s in ranges])
    along = np.concatenate([[0.0], np.cumsum(spacings)])
    along -= along[-begin]
    numbers = np.arange(begin, end + 1)
    x = along if numbered_from == "AP" else length - along
    names = tuple(roman(int(n)) if in_roman else str(n).replace("-", "−") for n in numbers)
    return FrameTable(numbers, x, spacings, names)


def frame_rows(table, surface=None, *, mirrored=False):
    """Rows of a FrameTable for a list: number, name, x, spacing to the next; with a surface its
    half breadth, heights and girth at the frame, all in m, both sides for the girth where it is
    mirrored. Frames beyond the hull have zeros."""
    from .._core import sections

    cuts = [[] for _ in table.numbers]
    if surface is not None:
        cuts = sections(surface, [[1.0, 0.0, 0.0, x] for x in table.positions])
    rows = []
    for k, cut in enumerate(cuts):
        row = {
            "frame": int(table.numbers[k]),
            "name": table.names[k],
            "x_m": float(table.positions[k]),
            "spacing_m": float(table.spacings[k]) if k < len(table.spacings) else 0.0,
        }
        if surface is not None:
            points = np.concatenate([c.points for c in cut]) if cut else np.zeros((1, 3))
            girth = sum(length_of(c.points) for c in cut)
            row |= {
                "half_breadth_m": float(np.abs(points[:, 1]).max()),
                "lowest_m": float(points[:, 2].min()),
                "highest_m": float(points[:, 2].max()),
                "girth_m": float(girth) * (2.0 if mirrored else 1.0),
            }
        rows.append(row)
    return rows
