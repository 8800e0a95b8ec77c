# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull file tells of how the resistance is reckoned.

    "resistance": {"method": one of RESISTANCE_METHODS, "speeds_kn": [first, last, step],
                   "form_factor": 1 + k, "stern": -25, -10, 0 or 10, "appendage_area": m2,
                   "appendage_factor": 1 + k2, "propeller_diameter": m, "twin_screw": false,
                   "deadrise_deg": degrees, "chine_beam": m, "shaft_angle_deg": degrees,
                   "thrust_arm": m, "heel_deg": degrees, "open_water_efficiency": 0 to below 1,
                   "shaft_efficiency": to 1, "blade_area_ratio": AE/AO, "pitch_ratio": P/D,
                   "open_stern": false, "thruster_diameter": m, "thruster_coefficient": CBTO,
                   "roughness_um": µm, "hulls": one of HULLS_BESIDE,
                   "planing_mass_t": t, "planing_lcg": m, "wave_speed_kn": knots,
                   "zeros": names of ZERO_INPUTS,
                   "holtrop": numbers by the names of HoltropInputs,
                   "delft": numbers by the names of DelftInputs,
                   "michell": numbers by the names of MichellInputs}

All may be left out; lengths and areas of 0 are not given, and none of the numbers in place of what
the hull has, but those that `zeros` names.
"""

from .checked_json import shown
from .limits import FASTEST_KN, HEAVIEST_LOAD, LARGEST_WIND_AREA, LONGEST_DIMENSION
from .ship_data import (
    DELFT_UNITS,
    HOLTROP_UNITS,
    HULLS_BESIDE,
    MICHELL_UNITS,
    RESISTANCE_METHODS,
    STERNS,
    ZERO_INPUTS,
    DelftInputs,
    HoltropInputs,
    MichellInputs,
    Resistance,
)

KEY = "resistance"
# Least and greatest number.
_NUMBERS = {
    "form_factor": (0.0, 10.0),
    "appendage_area": (0.0, LARGEST_WIND_AREA),
    "appendage_factor": (0.0, 10.0),
    "propeller_diameter": (0.0, LONGEST_DIMENSION),
    "deadrise_deg": (0.0, 44.0),
    "chine_beam": (0.0, LONGEST_DIMENSION),
    "shaft_angle_deg": (-45.0, 45.0),
    "thrust_arm": (-LONGEST_DIMENSION, LONGEST_DIMENSION),
    "heel_deg": (0.0, 35.0),
    "open_water_efficiency": (0.0, 0.99),
    "shaft_efficiency": (0.01, 1.0),
    "blade_area_ratio": (0.1, 2.0),
    "pitch_ratio": (0.1, 5.0),
    "thruster_diameter": (0.0, LONGEST_DIMENSION),
    "thruster_coefficient": (0.0, 0.1),
    "roughness_um": (1.0, 10000.0),
    "planing_mass_t": (0.0, HEAVIEST_LOAD),
    "planing_lcg": (0.0, LONGEST_DIMENSION),
    "wave_speed_kn": (0.0, FASTEST_KN),
}
# What is given in place of what the hull has, and the bounds of its units.
_INPUTS = {
    "holtrop": (HoltropInputs, HOLTROP_UNITS),
    "delft": (DelftInputs, DELFT_UNITS),
    "michell": (MichellInputs, MICHELL_UNITS),
}
_FLAGS = ("twin_screw", "open_stern")
_OF_UNITS = {
    "m": (0.0, LONGEST_DIMENSION),
    "m2": (0.0, LARGEST_WIND_AREA),
    "m3": (0.0, HEAVIEST_LOAD),
    "%": (-50.0, 50.0),
    "°": (0.0, 89.0),
    "": (0.0, 1.1),
}
# A skeg's centre may lie above the canoe body's lowest point.
_OF_NAMES = {"keel_centre": (-LONGEST_DIMENSION, LONGEST_DIMENSION)}


def parsed(check, content):
    """The Resistance of a hull file's content; raises HullFileError."""
    known = ("method", "speeds_kn", "stern", "hulls", "zeros", *_FLAGS, *_NUMBERS, *_INPUTS)
    entries = check.object(content.get(KEY, {}), KEY, known)
    found = Resistance()
    for name, bounds in _NUMBERS.items():
        value = entries.get(name, getattr(found, name))
        setattr(found, name, check.number(value, f"{KEY}.{name}", *bounds))
    found.method = _one_of(check, found.method, entries, "method", RESISTANCE_METHODS)
    found.stern = _one_of(check, found.stern, entries, "stern", STERNS)
    found.hulls = _one_of(check, found.hulls, entries, "hulls", HULLS_BESIDE)
    for name in _FLAGS:
        setattr(found, name, check.flag(entries.get(name, False), f"{KEY}.{name}"))
    speeds = check.list(entries.get("speeds_kn", list(found.speeds_kn)), f"{KEY}.speeds_kn", 3)
    found.speeds_kn = tuple(
        check.number(speed, f"{KEY}.speeds_kn", 0.0, FASTEST_KN) for speed in speeds
    )
    zeros = check.list(entries.get("zeros", []), f"{KEY}.zeros")
    for name in zeros:
        _checked(check, name, "zeros", ZERO_INPUTS)
    found.zeros = tuple(name for name in ZERO_INPUTS if name in zeros)
    for name, (kind, units) in _INPUTS.items():
        setattr(found, name, _given(check, entries.get(name, {}), f"{KEY}.{name}", kind, units))
    return found


def _given(check, content, place, kind, units):
    entries = check.object(content, place, tuple(units))
    values = {
        name: check.number(value, f"{place}.{name}", *_OF_NAMES.get(name, _OF_UNITS[units[name]]))
        for name, value in entries.items()
    }
    return kind(**{name: value or None for name, value in values.items()})


def _one_of(check, usual, entries, name, choices):
    return _checked(check, entries.get(name, usual), name, choices)


def _checked(check, value, name, choices):
    if isinstance(value, bool) or value not in choices:
        raise check.error(
            f"{KEY}.{name}",
            f"{shown(value)} is unknown",
            f"write one of {', '.join(map(str, choices))}",
        )
    return value


def entries(data):
    """What a hull file says of a HullData's resistance, by its key; nothing of the usual one."""
    own = data.resistance
    if own == Resistance():
        return {}
    return {
        KEY: {
            "method": own.method,
            "speeds_kn": [float(speed) for speed in own.speeds_kn],
            "stern": int(own.stern),
            "hulls": own.hulls,
            **{name: bool(getattr(own, name)) for name in _FLAGS},
            **{name: float(getattr(own, name)) for name in _NUMBERS},
            **({"zeros": list(own.zeros)} if own.zeros else {}),
            **{name: given for name in _INPUTS if (given := _entries_of(getattr(own, name)))},
        }
    }


def _entries_of(inputs):
    return {name: float(value) for name, value in vars(inputs).items() if value is not None}
