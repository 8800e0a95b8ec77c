# SPDX-License-Identifier: GPL-3.0-or-later
"""What Michell's integral and the ITTC line rest on, and where a ship or a speed leaves them.

We know of no limits that were published with the integral. The manual of Hullspeed, a program by
the same theory, has a rough guide to how slender a hull is to be; that ends of hulls are too blunt,
and hulls too broad or too full, is our judgement of what the theory takes as small.
"""

import math
from dataclasses import dataclass

from .. import _core
from .._resistance import ittc_1957
from .positive_numbers import check_positive

# Of Hullspeed's user manual: least L / ∇^(1/3) at two Froude numbers; evenly between them is ours.
_SLENDER = (0.2, 4.0), (1.0, 7.5)
# Judgement: of slopes along the hull, which the theory takes as small, the square is left out
# against 1. At 20° it is an eighth.
_LEAST_LENGTH_TO_BEAM, _MOST_BLOCK, _MOST_ENTRANCE = 5.0, 0.7, 20.0
# A smooth plate's flow is laminar up to some 3e5 to 1e6; the line is of turbulent flow.
_LEAST_REYNOLDS = 1e6


@dataclass(frozen=True)
class ThinShip:
    """length, wetted_surface: what the friction goes by, m and m². beam, draft: of what is in the
    water, m; volume in m³; entrance_angle_deg: half of that of the waterline, a chord's."""

    length: float
    beam: float
    draft: float
    volume: float
    wetted_surface: float
    entrance_angle_deg: float

    def outside(self, froude, reynolds):
        """A sentence for each assumption of theory and line that the ship does not keep to."""
        said = []
        slender = self.length / self.volume ** (1.0 / 3.0)
        least = _least_slenderness(froude)
        low, high = _SLENDER[0][0], _SLENDER[1][0]
        if not low <= froude <= high:
            said.append(f"Froude number {froude:.3g} is outside {low} to {high}")
        if slender < least:
            said.append(
                f"length to volume^(1/3) {slender:.3g} is below {least:.3g}, what a thin ship has "
                "at this speed"
            )
        if self.length < _LEAST_LENGTH_TO_BEAM * self.beam:
            ratio = self.length / self.beam
            said.append(f"length to beam {ratio:.3g} is below {_LEAST_LENGTH_TO_BEAM:.3g}")
        block = self.volume / (self.length * self.beam * self.draft)
        if block > _MOST_BLOCK:
            said.append(f"block coefficient {block:.3g} is above {_MOST_BLOCK:.3g}")
        if self.entrance_angle_deg > _MOST_ENTRANCE:
            said.append(
                f"half angle of entrance {self.entrance_angle_deg:.3g}° is above "
                f"{_MOST_ENTRANCE:.3g}°"
            )
        if reynolds < _LEAST_REYNOLDS:
            said.append(f"Reynolds number {reynolds:.3g} is below {_LEAST_REYNOLDS:.0e}")
        return tuple(said)


def _least_slenderness(froude):
    """L / ∇^(1/3); beyond the guide's Froude numbers that at its ends."""
    (low, least), (high, most) = _SLENDER
    share = min(max((froude - low) / (high - low), 0.0), 1.0)
    return least + share * (most - least)


def thin_ship(body, *, draft, trim=0.0, draft_at=0.0):
    """The ThinShip of a HullBody in water; draft (m) at x = draft_at, trim in rad by the stern. A
    hull wholly below the water has lengths and breadths of all of it. ValueError for a hull out of
    the water, and as hydrostatics()."""
    water = _core.hydrostatics(body, draft=draft, trim=trim, draft_at=draft_at)
    if not water.displaced_volume > 0.0:
        raise ValueError(f"The hull is out of the water at a draft of {draft:.4g} m: set it.")
    return ThinShip(
        length=water.waterline_length or water.immersed_length,
        beam=water.waterline_beam or water.immersed_beam,
        draft=water.immersed_draft,
        volume=water.displaced_volume,
        wetted_surface=water.wetted_surface,
        entrance_angle_deg=math.degrees(water.entrance_chord_angle),
    )


@dataclass(frozen=True)
class FrictionLine:
    """The ITTC 1957 line for a hull: length in m, wetted_surface in m², form_factor 1 + k, density
    in t/m³, kinematic viscosity in m²/s."""

    length: float
    wetted_surface: float
    form_factor: float
    density: float
    viscosity: float

    def __post_init__(self):
        names = ("length", "wetted_surface", "density", "viscosity")
        check_positive(self, "The friction's", names)

    def reynolds(self, speed):
        return speed * self.length / self.viscosity

    def friction(self, speed):
        """kN at a speed in m/s, without the form factor."""
        line = ittc_1957(self.reynolds(speed))
        return 0.5 * self.density * speed**2 * self.wetted_surface * line

    def resistance(self, speed):
        """kN with the form factor."""
        return self.form_factor * self.friction(speed)
