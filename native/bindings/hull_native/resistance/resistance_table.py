# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance of a hull over speeds, by Holtrop and Mennen or by Michell: rows, and their text."""

import math

from .. import _core
from .._resistance import GRAVITY, MichellIntegral
from ..csv_rows import csv_text
from .delft_series import delft
from .holtrop_form import holtrop_ship
from .holtrop_resistance import HoltropResult, holtrop
from .michell_form import FrictionLine, thin_ship
from .planing import savitsky
from .positive_numbers import require_positive
from .water import water_viscosity

KNOT = 1852.0 / 3600.0  # m/s

_HOLTROP = ("friction", "form", "appendages", "wave", "bulb", "transom", "correlation", "total")


# Froude numbers that MichellIntegral takes, on its own length; Reynolds numbers of ittc_1957().
_WAVES, _LINE = (0.05, 5.0), 1000.0
_MICHELL = ("friction", "form", "wave", "wave_error", "total")


def michell_table(
    body,
    speeds,
    *,
    draft,
    trim=0.0,
    draft_at=0.0,
    form_factor=1.0,
    length=None,
    wetted_surface=None,
    water_density=_core.SEA_WATER_DENSITY,
    viscosity=None,
    tolerance=1e-3,
):
    """A list of dicts, one for each speed in m/s: friction by the ITTC 1957 line on the exact
    wetted surface times form_factor, 1 + k, and wave resistance by Michell's integral. length (m)
    and wetted_surface (m²) replace those of the waterline and of the shell in the friction; waves
    are those of the exact surface. viscosity: kinematic, m²/s; None: that of water of the density.

    Keys with units: speed_kn, speed_m_s, froude, friction_kN, form_kN, wave_kN, wave_error_kN,
    total_kN, effective_power_kW; "outside" as holtrop_table(). At a speed that the integral or the
    line has no number for, the row has NaN and says why. ValueError as MichellIntegral, for speeds,
    a form factor, a length or a surface that is no number above zero, and where no speed is left.
    """
    if viscosity is None:
        viscosity = water_viscosity(water_density)
    if not (form_factor >= 0.0 and math.isfinite(form_factor)):
        raise ValueError(f"The form factor 1 + k must not be negative, as {form_factor} is.")
    where = {"draft": draft, "trim": trim, "draft_at": draft_at}
    integral = MichellIntegral(body, tolerance=tolerance, water_density=water_density, **where)
    ship = thin_ship(body, **where)
    line = FrictionLine(
        ship.length if length is None else length,
        ship.wetted_surface if wetted_surface is None else wetted_surface,
        form_factor,
        water_density,
        viscosity,
    )
    asked = [(speed, _missing(integral, line, speed)) for speed in map(float, speeds)]
    there = [speed for speed, missing in asked if not missing]
    if not there:
        raise ValueError(asked[0][1] if asked else "There are no speeds: give at least one.")
    waves = dict(zip(there, integral.resistance(there)))
    return [_michell_row(ship, line, speed, waves.get(speed), missing) for speed, missing in asked]


def _missing(integral, line, speed):
    """Why there is no number at a speed; "" where there is one."""
    require_positive(speed=speed)
    froude = speed / math.sqrt(GRAVITY * integral.length)
    if not _WAVES[0] <= froude <= _WAVES[1]:
        low, high = _WAVES
        return f"Froude number of Michell's integral {froude:.3g} is outside {low} to {high:.3g}"
    if not line.reynolds(speed) > _LINE:
        number = line.reynolds(speed)
        return f"Reynolds number of the ITTC line {number:.3g} is not above {_LINE:.0f}"
    return ""


def _michell_row(ship, line, speed, wave, missing):
    row = _speed_columns(speed, ship.length)
    outside = ship.outside(row["froude"], line.reynolds(speed))
    if wave is None:
        values, outside = dict.fromkeys(_MICHELL, math.nan), (missing, *outside)
    else:
        friction, total = line.friction(speed), line.resistance(speed) + wave.resistance
        form = line.resistance(speed) - friction
        values = dict(zip(_MICHELL, (friction, form, wave.resistance, wave.error, total)))
    row.update({f"{name}_kN": value for name, value in values.items()})
    row["effective_power_kW"] = values["total"] * speed
    row["outside"] = "; ".join(outside)
    return row


def holtrop_table(body, speeds, *, draft, trim=0.0, draft_at=0.0, given=None, **how):
    """A list of dicts, one for each speed in m/s, by Holtrop and Mennen's method for a HullBody.

    given: dict of what replaces measured fields of HoltropShip; other keywords as holtrop(). Keys
    with units as michell_table(): parts, total_kN, effective_power_kW, with a propeller
    wake_fraction, thrust_deduction, rotative_efficiency, hull_efficiency, and where its open water
    efficiency is known delivered_power_kW and shaft_power_kW; "outside" tells in words what is out
    of the method's range.
    """
    ship = holtrop_ship(body, draft=draft, trim=trim, draft_at=draft_at, **(given or {}))
    return holtrop_rows(ship, speeds, **how)


def holtrop_rows(ship, speeds, **how):
    """The rows of holtrop_table() for a HoltropShip; keywords as holtrop()."""
    gravity = how.get("gravity", GRAVITY)
    return [_holtrop_row(result, ship.length, gravity) for result in holtrop(ship, speeds, **how)]


def savitsky_table(boat, speeds, **how):
    """A list of dicts, one for each speed in m/s at which a PlaningBoat is in equilibrium by
    Savitsky's method; keywords as savitsky(). Other speeds, as those at which she does not plane,
    are left out.

    Keys with units: speed_kn, speed_m_s, friction_kN (along the water), pressure_kN, total_kN,
    effective_power_kW, trim_deg, wetted_length_ratio, keel_length_m, chine_length_m, keel_draft_m,
    and "outside" as holtrop_table(). ValueError as savitsky() where no speed is left.
    """
    rows, problem = [], None
    for speed in speeds:
        try:
            (found,) = savitsky(boat, [speed], **how)
        except ValueError as error:
            problem = problem or error
            continue
        rows.append(_planing_row(found))
    if not rows:
        raise problem or ValueError("There are no speeds: give at least one.")
    return rows


def delft_table(yacht, speeds, **how):
    """A list of dicts, one for each speed in m/s, of a DelftYacht by the Delft series; keywords as
    delft().

    Keys with units as michell_table(): friction_kN, residuary_kN, keel_kN and rudder_kN (friction
    and waves of each), heel_kN (what the heel adds to all), total_kN, effective_power_kW; "outside"
    as holtrop_table().
    """
    rows = []
    for found in delft(yacht, speeds, **how):
        heel = found.heeled_friction + found.heeled_residuary + found.heeled_keel
        rows.append(
            {
                **_speed_columns(found.speed, yacht.length, how.get("gravity", GRAVITY)),
                "friction_kN": found.friction,
                "residuary_kN": found.residuary,
                "keel_kN": found.keel_friction + found.keel_residuary,
                "rudder_kN": found.rudder_friction,
                "heel_kN": heel,
                "total_kN": found.total,
                "effective_power_kW": found.effective_power,
                "outside": "; ".join(found.outside),
            }
        )
    return rows


def _planing_row(found):
    return {
        "speed_kn": found.speed / KNOT,
        "speed_m_s": found.speed,
        "friction_kN": found.total - found.pressure,
        "pressure_kN": found.pressure,
        "total_kN": found.total,
        "effective_power_kW": found.effective_power,
        "trim_deg": found.trim_deg,
        "wetted_length_ratio": found.wetted_length_ratio,
        "keel_length_m": found.keel_length,
        "chine_length_m": found.chine_length,
        "keel_draft_m": found.keel_draft,
        "outside": "; ".join(found.outside),
    }


def _speed_columns(speed, length, gravity=GRAVITY):
    froude = speed / math.sqrt(gravity * length)
    return {"speed_kn": speed / KNOT, "speed_m_s": speed, "froude": froude}


def _holtrop_row(result: HoltropResult, length, gravity):
    row = _speed_columns(result.speed, length, gravity)
    row.update({f"{name}_kN": getattr(result, name) for name in _HOLTROP})
    row["effective_power_kW"] = result.effective_power
    if result.propulsion:
        row["wake_fraction"] = result.propulsion["w"]
        row["thrust_deduction"] = result.propulsion["t"]
        row["rotative_efficiency"] = result.propulsion["etaR"]
        row["hull_efficiency"] = result.propulsion["etaH"]
    if result.delivered_power:
        row["delivered_power_kW"] = result.delivered_power
        row["shaft_power_kW"] = result.shaft_power
    row["outside"] = "; ".join(result.outside)
    return row


def resistance_csv(rows):
    """The text of rows as comma-separated values, numbers with six digits. ValueError for none."""
    if not rows:
        raise ValueError("There are no speeds to write: give at least one.")
    return csv_text(rows, 6)
