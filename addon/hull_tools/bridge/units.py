# SPDX-License-Identifier: GPL-3.0-or-later
"""Metres and tonnes to what the scene's unit system shows, and back.

Blender's own length is the "unit"; `metres_per_unit` of the scene turns it into metres. Without a
unit system (NONE) a unit is a metre.
"""

_METRES_PER_FOOT = 0.3048
_TONNES_PER_LONG_TON = 1.0160469088

_IMPERIAL_SYMBOLS = {1: "ft", 2: "ft²", 3: "ft³"}
_METRIC_SYMBOLS = {1: "m", 2: "m²", 3: "m³"}


def metres_per_unit(scene):
    settings = scene.unit_settings
    return 1.0 if settings.system == "NONE" else settings.scale_length


def as_typed(value):
    """The decimal number a user typed into one of Blender's single-precision properties."""
    return float(f"{value:.7g}")


def format_length(scene, metres, power=1):
    """A length (power 1), area (2) or volume (3) given in m, m², m³, as text with its unit."""
    if scene.unit_settings.system == "IMPERIAL":
        return f"{_digits(metres / _METRES_PER_FOOT**power)} {_IMPERIAL_SYMBOLS[power]}"
    return f"{_digits(metres)} {_METRIC_SYMBOLS[power]}"


def format_mass(scene, tonnes):
    """A mass given in tonnes, as text: t, or long tons in the imperial system."""
    if scene.unit_settings.system == "IMPERIAL":
        return f"{_digits(tonnes / _TONNES_PER_LONG_TON)} LT"
    return f"{_digits(tonnes)} t"


def _digits(value):
    """Three decimals up to a thousand, fewer above: seven figures at most, as tables print them."""
    decimals = 3 if abs(value) < 1e3 else 2 if abs(value) < 1e4 else 1
    return f"{value:.{decimals}f}"
