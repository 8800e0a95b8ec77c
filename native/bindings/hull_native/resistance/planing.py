# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance and running trim of prismatic planing hulls by Savitsky (1964), Hydrodynamic design of
planing hulls; equations are numbered as there. Lengths in m, masses in t, forces in kN."""

import math
from dataclasses import dataclass

from .. import _core
from .._core import SEA_WATER_DENSITY
from .._resistance import GRAVITY, ittc_1957
from .deadrise import bottom_deadrise
from .planing_run import PlaningRun
from .positive_numbers import check_positive, require_positive
from .side_by_side import is_side_by_side
from .water import water_viscosity

_ROUGHNESS = 0.0004  # the ATTC's standard allowance


@dataclass(frozen=True)
class PlaningBoat:
    """beam: mean over the chines that are wet, b. deadrise_deg: its mean. lcg: centre of gravity
    before the transom, along the keel; vcg: above the keel. thrust_angle_deg: of the shaft against
    the keel, thrust_arm: distance of its line below the centre of gravity, f. side_by_side:
    hulls beside one another, which the formulas do not know."""

    mass_t: float
    beam: float
    deadrise_deg: float
    lcg: float
    vcg: float
    thrust_angle_deg: float = 0.0
    thrust_arm: float = 0.0
    side_by_side: bool = False

    def __post_init__(self):
        check_positive(self, "A planing boat's", ("mass_t", "beam", "lcg"))
        for name in ("vcg", "thrust_angle_deg", "thrust_arm"):
            if not math.isfinite(getattr(self, name)):
                raise ValueError(f"A planing boat's {name} must be a finite number.")
        if not 0.0 <= self.deadrise_deg < 45.0:
            raise ValueError(f"The deadrise must be from 0 to below 45°, not {self.deadrise_deg}°.")


def attc_1947(reynolds_number):
    """CF of Schoenherr's line (1932), 0.242 / √CF = log10(Rn CF), to rounding. ValueError as
    ittc_1957()."""
    root = math.sqrt(ittc_1957(reynolds_number))
    for _ in range(50):  # Newton's steps in √CF, on a function that is convex
        error = 0.242 / root - math.log10(reynolds_number * root**2)
        step = error / (0.242 / root**2 + 2.0 / (root * math.log(10.0)))
        root += step
        if abs(step) <= 1e-16 * root:
            break
    return root**2


def _rough(line, allowance):
    """A friction line with a roughness allowance."""
    if not math.isfinite(allowance):
        raise ValueError(f"roughness_allowance must be a finite number, not {allowance}.")
    return lambda reynolds: line(reynolds) + allowance


_LINES = {"attc": attc_1947, "ittc": ittc_1957}


def _checked_viscosity(density, viscosity, gravity):
    """The viscosity, that of water of the density for None, where all of them are above zero."""
    if viscosity is None:
        viscosity = water_viscosity(density)
    require_positive(water_density=density, viscosity=viscosity, gravity=gravity)
    return viscosity


def savitsky(
    boat,
    speeds,
    *,
    water_density=SEA_WATER_DENSITY,
    viscosity=None,
    gravity=GRAVITY,
    friction_line="attc",
    roughness_allowance=_ROUGHNESS,
):
    """A list of PlaningResult, one for each speed in m/s, each at the trim that is in equilibrium
    (35).

    viscosity: kinematic, m²/s; None: that of water of the density. friction_line: "attc",
    Schoenherr's, as in the paper, or "ittc". ValueError for what is no
    number above zero, and where no trim from 0.3° to 15° is in equilibrium.
    """
    if friction_line not in _LINES:
        raise ValueError(f'friction_line must be "attc" or "ittc", not {friction_line!r}.')
    viscosity = _checked_viscosity(water_density, viscosity, gravity)
    friction = _rough(_LINES[friction_line], roughness_allowance)
    results = []
    for speed in map(float, speeds):
        require_positive(speed=speed)
        run = PlaningRun(boat, speed, water_density, viscosity, gravity, friction)
        results.append(run.result(run.equilibrium()))
    return results


# What the paper reads off its figures 10, 14 and 17, and this module has by their formulas.
_READINGS = ("wetted_length_ratio", "bottom_speed", "pressure_place")


def planing_at_trims(boat, speed, trims_deg, *, readings=None, **how):
    """PlaningResult at trims that are held, as the columns of the paper's Table 1, with the moments
    that are left there: a list of (PlaningResult, kN·m by the bow).

    readings: a dict for each trim, of what was measured or read off a chart and stands in place of
    the formulas': "wetted_length_ratio", "bottom_speed" (m/s), "pressure_place" (centre of pressure
    before the transom, of the mean wetted length). Other keywords as savitsky() has them, but for
    the friction line, which is Schoenherr's. ValueError for what is no number above zero, and for
    trims from 90°.
    """
    trims_deg = list(trims_deg)
    readings = [{}] * len(trims_deg) if readings is None else list(readings)
    if len(readings) != len(trims_deg):
        raise ValueError(f"{len(trims_deg)} trims have {len(readings)} readings: give one each.")
    for reading in readings:
        _check_reading(reading)
    allowance = how.pop("roughness_allowance", _ROUGHNESS)
    density = how.pop("water_density", SEA_WATER_DENSITY)
    gravity = how.pop("gravity", GRAVITY)
    viscosity = _checked_viscosity(density, how.pop("viscosity", None), gravity)
    if how:
        raise TypeError(f"Unknown arguments: {sorted(how)}.")
    require_positive(speed=speed)
    for trim in trims_deg:
        if not 0.0 < trim < 90.0:
            raise ValueError(f"A trim must be above 0° and below 90°, not {trim}°.")
    friction = _rough(attc_1947, allowance)
    found = []
    for trim, reading in zip(trims_deg, readings):
        run = PlaningRun(boat, speed, density, viscosity, gravity, friction, reading)
        found.append((run.result(trim), run.moment(trim)))
    return found


def _check_reading(reading):
    for name, value in reading.items():
        if name not in _READINGS:
            raise ValueError(f"A reading is one of {', '.join(_READINGS)}, not {name!r}.")
        require_positive(**{name: value})


def planing_boat(body, *, draft, vcg, trim=0.0, draft_at=0.0, **given):
    """PlaningBoat of a HullBody that floats at rest at a draft (m at x = draft_at, trim in rad by
    the stern): mass and centre of gravity those of the displaced water, the transom at the
    waterline's after end, the beam that of the waterline, the deadrise that of bottom_deadrise().
    What is `given` by the name of its field replaces what was measured. ValueError for a hull out
    of the water, and as bottom_deadrise() where no deadrise is given."""
    density = given.pop("water_density", SEA_WATER_DENSITY)
    water = _core.hydrostatics(
        body, draft=draft, trim=trim, draft_at=draft_at, water_density=density
    )
    if not (water.displaced_volume > 0.0 and water.waterline_length > 0.0):
        raise ValueError(f"The hull is out of the water at a draft of {draft:.4g} m: set it.")
    measured = {
        "mass_t": water.displacement_t,
        "beam": water.waterline_beam,
        "lcg": water.lcb - water.waterline_aft,
        "side_by_side": is_side_by_side(body, water, draft, trim, draft_at),
    }
    if "deadrise_deg" not in given:
        angle = bottom_deadrise(body, draft=draft, trim=trim, draft_at=draft_at)
        measured["deadrise_deg"] = math.degrees(angle)
    return PlaningBoat(**{**measured, "vcg": vcg, **given})
