# SPDX-License-Identifier: GPL-3.0-or-later
"""The resistance of the hull that a hull is compared with, on that hull's own surface."""

from dataclasses import dataclass
from functools import lru_cache

from . import methods

# Other hulls and settings of which rows are kept: while this hull is edited they stay the same.
_KEPT = 8


@dataclass(frozen=True, eq=False)
class Other:
    """rows: as of the hull itself, none where they cannot be, which message says."""

    name: str
    rows: list
    message: str = ""

    def row_at(self, speed):
        """The row at a speed in m/s, None where there is none."""
        return next((row for row in self.rows if row["speed_m_s"] == speed), None)


def computed(wanted):
    """The Other of an asked.Beside, or None; what was computed is found again."""
    if wanted is None:
        return None
    if wanted.other is None:
        return Other("", [], f"Not compared: {wanted.problem}")
    return _computed(wanted.other, wanted.inputs)


@lru_cache(maxsize=_KEPT)
def _computed(other, inputs):
    try:
        return Other(other.name, methods.found(other.source.new_ship().body, inputs).rows)
    except ValueError as error:
        return Other(other.name, [], f"{other.name}: {error}")
