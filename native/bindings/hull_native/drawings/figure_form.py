# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull's figures are drawn of: its body, main dimensions, and where its lines are."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .._core import upright_hydrostatics

STATIONS = 20
# Of a keel yacht the beam and draft do not tell of a block.
_LEAST_BLOCK_COEFFICIENT = 0.3
# Of the length between perpendiculars: how far hulls reach beyond them. What reaches further has
# its origin elsewhere, or another length.
_OVERHANG = 0.25
# Of the hull's height: water that wets less than this of it is none.
_SHALLOW = 1e-3


@dataclass(frozen=True)
class FigureForm:
    """body: HullBody. length, beam, draft, depth: main dimensions in m as given, 0 where not."""

    body: object
    title: str
    length: float = 0.0
    beam: float = 0.0
    draft: float = 0.0
    depth: float = 0.0

    @property
    def surface(self):
        return self.body.surface

    @cached_property
    def low(self):
        return self._box[0]

    @cached_property
    def high(self):
        return self._box[1]

    @cached_property
    def _box(self):
        points = self.surface.tessellate(6).points
        if self.body.mirrored:
            points = np.vstack([points, points * (1.0, -1.0, 1.0)])
        return points.min(axis=0), points.max(axis=0)

    @cached_property
    def _has_length(self):
        reach = _OVERHANG * self.length
        return reach > 0.0 and -reach < self.low[0] and self.high[0] < self.length + reach

    @property
    def aft(self):
        """x of station 0: the after perpendicular, or the hull's end where there is none."""
        return 0.0 if self._has_length else float(self.low[0])

    @property
    def lpp(self):
        """The length that stations divide."""
        return self.length if self._has_length else float(self.high[0] - self.low[0])

    @property
    def given_length(self):
        """None where there is none, or none that fits the hull."""
        return self.length if self._has_length else None

    @property
    def given_draft(self):
        """The same; a water that does not reach the hull is none."""
        bottom, top = float(self.low[2]), float(self.high[2])
        return self.draft if bottom + _SHALLOW * (top - bottom) < self.draft < top else None

    @property
    def half_beam(self):
        return float(np.abs([self.low[1], self.high[1]]).max())

    def waterline_spacing(self, parts=4):
        """About so many in the draft, or twice as many in all where there is none."""
        if self.given_draft is not None:
            return round_spacing((self.draft - self.low[2]) / parts)
        return round_spacing((self.high[2] - self.low[2]) / (2 * parts))

    def buttock_spacing(self, parts=8):
        return round_spacing(2.0 * self.half_beam / parts)

    def stations(self):
        """[(label, x)]: the length / 20, and half of that in the ends."""
        step = self.lpp / STATIONS
        low, high = ((x - self.aft) / step for x in (self.low[0], self.high[0]))
        halves = np.arange(np.ceil(2.0 * low), 2.0 * high + 1e-9)
        numbers = [n / 2.0 for n in halves if n % 2 == 0 or not 4 < n < 36]
        margin = 1e-6 * (high - low)
        return [
            (_station_name(number), self.aft + number * step)
            for number in numbers
            if low + margin < number < high - margin
        ]

    def waterlines(self):
        """z of waterlines, multiples of their spacing."""
        step = self.waterline_spacing()
        return step * np.arange(np.floor(self.low[2] / step) + 1, np.ceil(self.high[2] / step))

    def particulars(self):
        """Pairs (name, text) of the main dimensions and what the hull displaces."""
        given = (
            ("Length between perpendiculars", self.length),
            ("Beam", self.beam),
            ("Draft", self.draft),
            ("Depth", self.depth),
        )
        pairs = [(name, f"{value:.2f} m") for name, value in given if value > 0.0]
        return pairs + self._displaced()

    def _displaced(self):
        if self.given_draft is None:
            return []
        try:
            found = upright_hydrostatics(
                self.surface, draft=self.draft, mirrored=self.body.mirrored
            )
        except ValueError:
            return []  # it floods at that draft: the drawing is good without
        volume = found.displaced_volume
        pairs = [("Displaced volume", _thousands(volume, "m³"))]
        box = self.length * self.beam * self.draft
        if box > 0.0 and volume / box >= _LEAST_BLOCK_COEFFICIENT:
            pairs.append(("Block coefficient", f"{volume / box:.3f}"))
        pairs.append(("LCB from AP", f"{found.lcb:.2f} m"))
        pairs.append(("Wetted surface", _thousands(found.wetted_surface, "m²")))
        return pairs


def _thousands(value, unit):
    return f"{value:,.1f} {unit}".replace(",", " ")


def _station_name(number):
    half = "½" if number % 1 else ""
    whole = int(abs(number))
    return ("−" if number < 0 else "") + f"{whole or ('' if half else 0)}{half}"


def round_spacing(about):
    """The spacing of a round number of m that is nearest by its ratio."""
    spacings = [factor * 10.0**power for power in range(-4, 4) for factor in (1.0, 2.0, 2.5, 5.0)]
    return min(spacings, key=lambda spacing: abs(np.log(spacing / about)))
