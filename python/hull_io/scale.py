# SPDX-License-Identifier: GPL-3.0-or-later
"""What becomes of places, lengths, areas and planes of a hull whose x, y and z are multiplied."""

from dataclasses import dataclass
from math import atan, degrees, isfinite, radians, tan

import numpy as np

# No dimension becomes so many times as large, or so many times as small.
LARGEST_FACTOR = 1000.0
# Of numbers in texts of places: more than single precision has, and no noise of products.
_DIGITS = 9


@dataclass(frozen=True)
class Scale:
    """x, y and z of every place become factor times it plus shift.

    ValueError for factors that are no numbers above zero, or beyond LARGEST_FACTOR.
    """

    factors: tuple
    shift: tuple = (0.0, 0.0, 0.0)

    def __post_init__(self):
        for axis, factor in zip("xyz", self.factors):
            if not (isfinite(factor) and 1.0 / LARGEST_FACTOR <= factor <= LARGEST_FACTOR):
                raise ValueError(
                    f"The hull cannot become {factor:.6g} times as large along {axis}: give a "
                    "dimension nearer to what it has"
                )

    def points(self, points):
        """(…, 3) places."""
        return np.asarray(points, dtype=np.float64) * self.factors + self.shift

    def plane(self, normal, offset):
        """(normal (3,) of length 1, offset) of the plane normal · place = offset, one of length 1
        too; planes across an axis stay so exactly."""
        normal = np.asarray(normal, dtype=np.float64)
        across = np.flatnonzero(normal)
        if len(across) == 1:
            axis = across[0]
            return normal, offset * self.factors[axis] + self.shift[axis] * normal[axis]
        turned = normal / self.factors
        length = np.linalg.norm(turned)
        turned = turned / length
        return turned, offset / length + turned @ self.shift

    def normal(self, normal):
        """(3,) as long as before."""
        normal = np.asarray(normal, dtype=np.float64)
        turned = normal / self.factors
        length = np.linalg.norm(turned)
        return turned if length == 0.0 else turned * (np.linalg.norm(normal) / length)

    def length(self, axis, value):
        return value * self.factors[axis]

    def place(self, axis, value):
        return value * self.factors[axis] + self.shift[axis]

    def volume(self, value):
        x, y, z = self.factors
        return value * x * y * z

    def profile(self, value):
        """An area seen from the side."""
        return value * self.factors[0] * self.factors[2]

    def plan(self, value):
        """An area seen from above."""
        return value * self.factors[0] * self.factors[1]

    def surface(self, value):
        """An area of a shell, as large as its volume: how it lies is not known."""
        return value * float(np.prod(self.factors)) ** (2.0 / 3.0)

    def section(self, value):
        """An area across the ship."""
        return value * self.factors[1] * self.factors[2]

    def sizes(self, appendage):
        """Of an Appendage: chords as the chord's direction is stretched, radii and diameters by
        the mean of what is across the body, so that its volume follows the hull's."""
        factors = np.asarray(self.factors)
        along = np.subtract(appendage.end, appendage.start)
        if appendage.shape == "foil":
            along = np.asarray(appendage.chord_direction)
        stretch = np.linalg.norm(factors * along) / np.linalg.norm(along)
        if appendage.shape != "foil":
            stretch = np.sqrt(factors.prod() / stretch)
        return tuple(float(stretch * size) for size in appendage.sizes)

    def listed(self, axis, text):
        """A text of places as number_lists reads it; the third number of a range is its step."""

        def changed(word):
            parts = [float(part) for part in word.replace(",", ".").split(":")]
            moved = [self.place(axis, part) for part in parts[:2]]
            moved += [self.length(axis, part) for part in parts[2:]]
            return ":".join(map(_shown, moved))

        try:
            return " ".join(map(changed, text.replace(";", " ").split()))
        except ValueError:
            return text  # nobody can read it: it is told where it is used

    def diagonals(self, text):
        """A text of heights and angles as number_lists reads it; each plane goes along."""

        def changed(word):
            height, angle_deg = map(float, word.replace(",", ".").split("/"))
            slope = tan(radians(angle_deg)) * self.factors[2] / self.factors[1]
            if abs(angle_deg) < 90.0:
                angle_deg = degrees(atan(slope))
            return f"{_shown(self.place(2, height))}/{_shown(angle_deg)}"

        try:
            return " ".join(map(changed, text.replace(";", " ").split()))
        except ValueError:
            return text


def _shown(value):
    """A number as text, with so many digits at most."""
    return f"{value:.{_DIGITS}g}"
