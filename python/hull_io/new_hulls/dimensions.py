# SPDX-License-Identifier: GPL-3.0-or-later
"""What a new hull is asked to be."""

from dataclasses import dataclass

from ..limits import LONGEST_DIMENSION


@dataclass(frozen=True)
class Dimensions:
    """Lengths in m.

    length: of the design waterline, whose ends are the perpendiculars x = 0 and x = length. beam:
    the greatest, anywhere. draft: design waterline over the lowest point of the hull, z = 0.
    depth: lowest point of the sheer line over z = 0.
    """

    length: float
    beam: float
    draft: float
    depth: float

    def __post_init__(self):
        for name in ("length", "beam", "draft", "depth"):
            if not getattr(self, name) > 0.0:
                raise ValueError(f"The {name} is {getattr(self, name):g} m: give more than 0")
            if getattr(self, name) > LONGEST_DIMENSION:
                raise ValueError(
                    f"The {name} is {getattr(self, name):g} m: give at most {LONGEST_DIMENSION:g} m"
                )
        if self.depth < LEAST_DEPTH * self.draft:
            raise ValueError(
                f"The depth {self.depth:g} m leaves no freeboard over the draft {self.draft:g} m: "
                f"give at least {LEAST_DEPTH * self.draft:.4g} m, or a smaller draft"
            )


# Depth over draft, at least.
LEAST_DEPTH = 1.05
