# SPDX-License-Identifier: GPL-3.0-or-later
"""What Holtrop and Mennen's method asks of a ship, given or from an exact hull."""

import math
from dataclasses import dataclass, fields, replace

from .. import _core
from .side_by_side import is_side_by_side

# Of the models in the regression: prismatic coefficient, length to beam and Froude numbers from the
# table of ship types in Holtrop & Mennen (1978); beam to draft, and slender hulls and speeds of the
# re-analysis (1984), as usually quoted for it: the paper itself states no such limits.
_RANGES = (
    ("prismatic coefficient", lambda ship: ship.prismatic, 0.55, 0.85),
    ("length to beam", lambda ship: ship.length / ship.beam, 3.9, 14.9),
    ("beam to draft", lambda ship: ship.beam / ship.draft, 2.1, 4.0),
)
_MOST_FROUDE = {1982: 0.45, 1984: 0.8}


@dataclass(frozen=True)
class HoltropShip:
    """Dimensions and form, m, m² and m³. None: by the papers' own formulas.

    length: on the waterline, L. lcb_percent: centre of buoyancy forward of 0.5 L, in % of L.
    midship, waterplane: CM, CWP. bulb_area, bulb_height: ABT, transverse area of the bulb where
    the water meets the stem, and its centre above the keel. transom_area: AT, immersed when at
    rest. appendages: pairs (area, 1 + k2): rudder behind skeg 1.5 to 2, behind stern 1.3 to 1.5,
    twin-screw balance rudders 2.8, shaft brackets 3, skeg 1.5 to 2, strut bossings 3, hull
    bossings 2, shafts 2 to 4, stabilizer fins 2.8, dome 2.7, bilge keels 1.4. stern_coefficient:
    Cstern, -25 pram with gondola, -10 V-shaped, 0 normal, 10 U-shaped with Hogner stern.
    thruster_diameter: of a bow thruster's tunnel; its coefficient is from 0.003 to 0.012.
    side_by_side: hulls beside one another, as a catamaran's, which the method does not know.
    """

    length: float
    beam: float
    draft_forward: float
    draft_aft: float
    displaced_volume: float
    lcb_percent: float
    midship: float
    waterplane: float
    prismatic: float | None = None
    block: float | None = None
    wetted_surface: float | None = None
    entrance_angle_deg: float | None = None
    bulb_area: float = 0.0
    bulb_height: float = 0.0
    transom_area: float = 0.0
    appendages: tuple = ()
    stern_coefficient: float = 0.0
    thruster_diameter: float = 0.0
    thruster_coefficient: float = 0.005
    side_by_side: bool = False

    @property
    def draft(self):
        return 0.5 * (self.draft_forward + self.draft_aft)

    @property
    def appendage_area(self):
        return sum(area for area, _ in self.appendages)

    @property
    def appendage_factor(self):
        """(1 + k2) of all of them together."""
        area = self.appendage_area
        return sum(own * factor for own, factor in self.appendages) / area if area > 0.0 else 0.0

    @property
    def bulb_depth(self):
        """What c3 has of the bulb's centre below the water, above zero."""
        return 0.31 * math.sqrt(self.bulb_area) + self.draft_forward - self.bulb_height

    @property
    def length_of_run(self):
        """LR."""
        cp = self.prismatic
        return self.length * (1.0 - cp + 0.06 * cp * self.lcb_percent / (4.0 * cp - 1.0))

    def completed(self):
        """The same ship with nothing None. ValueError for what the formulas cannot take."""
        self._check()
        box = self.length * self.beam * self.draft
        block = self.displaced_volume / box if self.block is None else self.block
        prismatic = self.prismatic
        if prismatic is None:
            prismatic = self.displaced_volume / (self.midship * box)
        ship = replace(self, block=block, prismatic=prismatic)
        ship._check_fullness()
        if ship.wetted_surface is None:
            ship = replace(ship, wetted_surface=ship._estimated_wetted_surface())
        if ship.entrance_angle_deg is None:
            ship = replace(ship, entrance_angle_deg=ship._estimated_entrance())
        ship._check_estimates()
        return ship

    def outside(self, froude, edition):
        """A sentence for each range of the method that the ship is out of."""
        said = [
            f"{name} {value(self):.3g} is outside {low} to {high}"
            for name, value, low, high in _RANGES
            if not low <= value(self) <= high
        ]
        most = _MOST_FROUDE[edition]
        if froude > most:
            said.append(f"Froude number {froude:.3g} is above {most}")
        if self.side_by_side:
            said.append("hulls beside one another, which the method takes for one ship")
        return tuple(said)

    def _check(self):
        optional = ("prismatic", "block", "wetted_surface", "entrance_angle_deg")
        positive = ("length", "beam", "draft_forward", "draft_aft", "displaced_volume", "midship")
        for each in fields(self):
            value = getattr(self, each.name)
            if each.name == "appendages" or (value is None and each.name in optional):
                continue
            if not math.isfinite(value):
                raise ValueError(f"{each.name} must be a finite number, not {value}.")
            if each.name in (*positive, "waterplane", *optional) and not value > 0.0:
                raise ValueError(f"{each.name} must be above zero, not {value}.")
            if each.name.endswith("area") and value < 0.0:
                raise ValueError(f"{each.name} must not be negative, as {value} is.")
        for area, factor in self.appendages:
            if not (area >= 0.0 and factor >= 0.0 and math.isfinite(area * factor)):
                raise ValueError(f"An appendage needs an area and 1 + k2, not {(area, factor)}.")
        if self.entrance_angle_deg is not None and self.entrance_angle_deg >= 90.0:
            raise ValueError(
                f"The half angle of entrance must be below 90°, not {self.entrance_angle_deg:.4g}°:"
                " take one that leaves out the rounding at the stem."
            )

    def _check_fullness(self):
        for name, value, low, high in (
            ("prismatic", self.prismatic, 0.25, 0.95),
            ("block", self.block, 0.0, 0.95),
            ("midship", self.midship, 0.0, 1.05),
        ):
            if not low < value < high:
                raise ValueError(
                    f"Holtrop's formulas need {name} between {low} and {high}, not {value:.4g}: "
                    "check length, beam, drafts and volume."
                )
        section = self.beam * self.draft * self.midship
        if not 0.8 * self.transom_area < section:  # c5, by which waves are less, above zero
            raise ValueError(
                f"Holtrop's formulas need a transom_area below {1.25 * section:.4g} m², 1.25 times "
                f"the midship section's, not {self.transom_area:.4g} m²."
            )
        if self.bulb_area > 0.0 and not self.bulb_depth > 0.0:
            raise ValueError(
                f"Holtrop's formulas need the bulb in the water: with bulb_height "
                f"{self.bulb_height:.4g} its centre is too far above draft_forward "
                f"{self.draft_forward:.4g}."
            )
        ends = 1.0 - self.prismatic - 0.0225 * abs(self.lcb_percent)
        if not (ends > 0.0 and self.length_of_run > 0.0):
            raise ValueError(
                f"Holtrop's formulas have no value for lcb_percent {self.lcb_percent:.4g} with a "
                f"prismatic coefficient of {self.prismatic:.4g}: the buoyancy lies too near an end."
            )

    def _check_estimates(self):
        if not self.wetted_surface > 0.0:
            raise ValueError(
                "The estimate of the wetted surface has no value for a beam of "
                f"{self.beam / self.draft:.4g} drafts: check the drafts, or give wetted_surface."
            )
        if not self.entrance_angle_deg < 90.0:
            raise ValueError(
                "The estimate of the half angle of entrance is 90° for a waterplane coefficient of "
                f"{self.waterplane:.4g}: give entrance_angle_deg."
            )

    def _estimated_wetted_surface(self):
        form = (
            0.453
            + 0.4425 * self.block
            - 0.2862 * self.midship
            - 0.003467 * self.beam / self.draft
            + 0.3696 * self.waterplane
        )
        girth = (2.0 * self.draft + self.beam) * math.sqrt(self.midship)
        return self.length * girth * form + 2.38 * self.bulb_area / self.block

    def _estimated_entrance(self):
        open_waterplane = max(1.0 - self.waterplane, 0.0) ** 0.30484
        fine = (1.0 - self.prismatic - 0.0225 * self.lcb_percent) ** 0.6367
        run = (self.length_of_run / self.beam) ** 0.34574
        heavy = (100.0 * self.displaced_volume / self.length**3) ** 0.16302
        exponent = (self.length / self.beam) ** 0.80856 * open_waterplane * fine * run * heavy
        return 1.0 + 89.0 * math.exp(-exponent)


def holtrop_ship(body, *, draft, trim=0.0, draft_at=0.0, **given):
    """HoltropShip of a HullBody in water; what is `given` by the name of its field replaces what
    was measured.

    draft (m) at x = draft_at, trim in rad by the stern. From the exact hull: length and beam of the
    waterline, volume, centre of buoyancy, coefficients on these and the largest section, wetted
    surface, the entrance's chord angle over 5 % of the waterline, the section where the water meets
    the stem for the bulb, and the one at the waterline's after end for the transom. Drafts are to
    z = 0. Hulls lie side by side where no station has most of the waterline's breadth as water
    within the ship. ValueError for a hull out of the water, names that are no fields, and as
    hydrostatics().
    """
    names = {each.name for each in fields(HoltropShip)}
    for name in given:
        if name not in names:
            raise ValueError(f"{name!r} is no field of HoltropShip; these are: {sorted(names)}.")
    water = _core.hydrostatics(body, draft=draft, trim=trim, draft_at=draft_at)
    length, beam = water.waterline_length, water.waterline_beam
    if not (water.displaced_volume > 0.0 and length > 0.0 and beam > 0.0):
        raise ValueError(
            f"The hull is out of the water at a draft of {draft:.4g} m, or wholly below it: set "
            "the draft."
        )

    def draft_of(x):
        return draft - (x - draft_at) * math.tan(trim)

    aft, forward = water.waterline_aft, water.waterline_forward
    mean = 0.5 * (draft_of(aft) + draft_of(forward))
    if not mean > 0.0:
        raise ValueError(
            f"The mean draft to z = 0 is {mean:.4g} m, though the hull is in the water: move the "
            "hull onto its base line first."
        )
    inside = 1e-6 * length
    ends = _core.section_areas(
        body, [aft + inside, forward - inside], draft=draft, trim=trim, draft_at=draft_at
    )
    transom, stem = ends.areas
    measured = {
        "length": length,
        "beam": beam,
        "draft_forward": draft_of(forward),
        "draft_aft": draft_of(aft),
        "displaced_volume": water.displaced_volume,
        "lcb_percent": 100.0 * (water.lcb - 0.5 * (aft + forward)) / length,
        "midship": water.largest_section.area / (beam * mean),
        "waterplane": water.waterplane_area / (length * beam),
        "wetted_surface": water.wetted_surface,
        "entrance_angle_deg": math.degrees(water.entrance_chord_angle),
        "transom_area": transom,
        "bulb_area": stem,
        "bulb_height": ends.centroids[1][2] if stem > 0.0 else 0.0,
        "side_by_side": is_side_by_side(body, water, draft, trim, draft_at),
    }
    return HoltropShip(**{**measured, **given})
