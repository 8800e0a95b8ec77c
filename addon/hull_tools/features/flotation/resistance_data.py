# SPDX-License-Identifier: GPL-3.0-or-later
"""How the resistance is reckoned: from hull_io's Resistance to Object.hull.resistance, and back."""

from math import degrees, radians

from ....hull_io.ship_data import (
    DELFT_UNITS,
    HOLTROP_UNITS,
    MICHELL_UNITS,
    ZERO_INPUTS,
    DelftInputs,
    HoltropInputs,
    MichellInputs,
    Resistance,
)
from ...bridge.blender.units import as_stored, as_typed

_SPEEDS = ("speed_from", "speed_to", "speed_step")
_LENGTHS = ("propeller_diameter", "thruster_diameter", "chine_beam", "planing_lcg", "thrust_arm")
_NUMBERS = (
    "form_factor",
    "appendage_area",
    "appendage_factor",
    "open_water_efficiency",
    "shaft_efficiency",
    "blade_area_ratio",
    "pitch_ratio",
    "thruster_coefficient",
    "roughness_um",
    "planing_mass_t",
    "wave_speed_kn",
)
_ANGLES = ("deadrise", "shaft_angle", "heel")
_INPUTS = {
    "holtrop": (HoltropInputs, HOLTROP_UNITS),
    "delft": (DelftInputs, DELFT_UNITS),
    "michell": (MichellInputs, MICHELL_UNITS),
}


def give(settings, own, scale):
    """To an Object.hull.resistance; scale: metres of Blender's unit."""
    settings.method, settings.stern = own.method.upper(), str(own.stern)
    settings.hulls, settings.zeros = own.hulls.upper(), set(own.zeros)
    settings.twin_screw, settings.open_stern = own.twin_screw, own.open_stern
    for name, speed in zip(_SPEEDS, own.speeds_kn):
        _set(settings, name, speed)
    for name in _NUMBERS:
        _set(settings, name, getattr(own, name))
    for name in _LENGTHS:
        _set(settings, name, getattr(own, name) / scale)
    for name in _ANGLES:
        _set(settings, name, radians(getattr(own, f"{name}_deg")))
    for group, (_, units) in _INPUTS.items():
        for name, unit in units.items():
            value = getattr(getattr(own, group), name) or 0.0
            _set(getattr(settings, group), name, value / scale if unit == "m" else value)


def _set(settings, name, number):
    """A number that is the usual one is left unset: each variant would keep all of them."""
    if number == as_stored(settings.bl_rna.properties[name].default):
        settings.property_unset(name)
    else:
        setattr(settings, name, number)


def taken(settings, metres):
    """The Resistance of an Object.hull.resistance; metres: (a length in Blender's unit) → in m."""
    inputs = {
        group: kind(
            **{name: value or None for name, value in given(settings, group, metres).items()}
        )
        for group, (kind, _) in _INPUTS.items()
    }
    return Resistance(
        method=settings.method.lower(),
        speeds_kn=tuple(as_stored(getattr(settings, name)) for name in _SPEEDS),
        stern=int(settings.stern),
        hulls=settings.hulls.lower(),
        twin_screw=settings.twin_screw,
        open_stern=settings.open_stern,
        zeros=tuple(name for name in ZERO_INPUTS if name in settings.zeros),
        **{f"{name}_deg": as_typed(degrees(getattr(settings, name))) for name in _ANGLES},
        **{name: as_stored(getattr(settings, name)) for name in _NUMBERS},
        **{name: metres(getattr(settings, name)) for name in _LENGTHS},
        **inputs,
    )


def given(settings, group, metres):
    """The numbers in place of what the hull has, by their names, 0 of none; group: "holtrop",
    "delft" or "michell"."""
    _, units = _INPUTS[group]
    own = getattr(settings, group)
    return {
        name: (metres if unit == "m" else as_stored)(getattr(own, name))
        for name, unit in units.items()
    }
