# SPDX-License-Identifier: GPL-3.0-or-later
"""Metres and tonnes to what the scene's unit system shows, and back.

Blender's own length is the "unit"; `metres_per_unit` of the scene turns it into metres. Without a
unit system (NONE) a unit is a metre.
"""

from dataclasses import dataclass
from math import degrees

import numpy as np

_FOOT = 0.3048
_INCH = 0.0254
_LONG_TON = 1.0160469088
_POUND_FORCE = 0.0044482216152605  # kN
_POUND_A_CUBIC_FOOT = 0.01601846337396014  # t/m³
_HORSEPOWER = 0.74569987158227022  # kW
_POUND_A_SQUARE_FOOT = 47.880258980335840  # Pa

# By the unit of tables and fields: what the panels write, and for the imperial system the size of
# its unit.
_METRIC_SYMBOLS = {
    "m": "m",
    "m2": "m²",
    "m3": "m³",
    "m4": "m⁴",
    "t": "t",
    "t/m3": "t/m³",
    "t/cm": "t/cm",
    "t m/cm": "t·m/cm",
    "m rad": "m·rad",
    "s": "s",
    "kN": "kN",
    "kW": "kW",
    "1/m": "1/m",
    "1/m2": "1/m²",
    "mm": "mm",
    "µm": "µm",
    "Pa": "Pa",
    "°/m": "°/m",
}
_IMPERIAL = {
    "m": (_FOOT, "ft"),
    "m2": (_FOOT**2, "ft²"),
    "m3": (_FOOT**3, "ft³"),
    "m4": (_FOOT**4, "ft⁴"),
    "t": (_LONG_TON, "LT"),
    "t/m3": (_POUND_A_CUBIC_FOOT, "lb/ft³"),
    "t/cm": (_LONG_TON * 0.01 / _INCH, "LT/in"),
    "t m/cm": (_LONG_TON * _FOOT * 0.01 / _INCH, "LT·ft/in"),
    "m rad": (_FOOT, "ft·rad"),
    "s": (1.0, "s"),
    "kN": (_POUND_FORCE, "lbf"),
    "kW": (_HORSEPOWER, "hp"),
    "1/m": (1.0 / _FOOT, "1/ft"),
    "1/m2": (_FOOT**-2, "1/ft²"),
    "mm": (1e3 * _INCH, "in"),
    "µm": (1e3 * _INCH, "mil"),
    "Pa": (_POUND_A_SQUARE_FOOT, "lb/ft²"),
    "°/m": (1.0 / _FOOT, "°/ft"),
}


@dataclass(frozen=True)
class Shown:
    """The system of units in which numbers are shown: for threads, which ask no scene."""

    is_imperial: bool = False

    def in_unit(self, value, unit):
        """(number, symbol) of a value in a unit of tables."""
        if self.is_imperial:
            size, symbol = _IMPERIAL[unit]
            return value / size, symbol
        return value, _METRIC_SYMBOLS[unit]

    def text(self, value, unit, decimals=None):
        """The same as text; decimals: None for as many as tables have."""
        number, symbol = self.in_unit(value, unit)
        digits = _digits(number) if decimals is None else f"{number:.{decimals}f}"
        return f"{digits} {symbol}"

    def plot_sizes(self):
        """{metric symbol: (size of the unit that stands for it, its symbol)} of those that another
        does, as hull_native.PlotUnits takes them."""
        if not self.is_imperial:
            return {}
        return {_METRIC_SYMBOLS[unit]: found for unit, found in _IMPERIAL.items()}


METRIC, IMPERIAL = Shown(), Shown(is_imperial=True)


def shown_in(scene):
    return Shown(is_imperial(scene))


def metres_per_unit(scene):
    settings = scene.unit_settings
    return 1.0 if settings.system == "NONE" else settings.scale_length


def as_typed(value):
    """The decimal number a user typed into one of Blender's single-precision properties."""
    return float(f"{value:.7g}")


def as_stored(value):
    """The shortest decimal number that one of Blender's single-precision numbers stands for."""
    return float(str(np.float32(value)))


def all_as_stored(values):
    """The same of a float32 array."""
    return values.astype("U32").astype(np.float64)


def format_value(scene, value, unit):
    """A number in one of the units of tables, as text with its unit in the scene's system.

    "deg": radians, shown in degrees. "%" and "": as they are. None: not known.
    """
    if value is None:
        return "–"
    if unit == "deg":
        return f"{degrees(value):.2f}°"
    if unit == "%":
        return f"{value:.2f} %"
    if not unit:
        return f"{value:.4f}"
    return shown_in(scene).text(value, unit)


def in_unit(scene, value, unit):
    """(number, symbol) of a value in a unit of tables, in the scene's system."""
    return shown_in(scene).in_unit(value, unit)


_SUPERSCRIPTS = str.maketrans("²³⁴·", "234 ")


def imperial(unit):
    """(size, name in plain letters) of the imperial unit that stands for one of the units of
    tables, None for what is none: ("m2" → (0.0929…, "ft2"))."""
    if unit not in _IMPERIAL:
        return None
    size, symbol = _IMPERIAL[unit]
    return size, symbol.translate(_SUPERSCRIPTS)


def is_imperial(scene):
    return scene.unit_settings.system == "IMPERIAL"


def metric_symbol(unit):
    """How one of the units of tables is written: "m³"; "" where there is none."""
    return _METRIC_SYMBOLS.get(unit, unit)


def unit_of_label(label):
    """The unit of tables that a field's name ends in, of those that an imperial one stands for:
    "m3" of "∇ in m³", "mm" of "Deviation (mm)"; None where there is none."""
    symbol = label.rpartition(" ")[2].strip("()")
    return next(
        (
            unit
            for unit, (size, _) in _IMPERIAL.items()
            if size != 1.0 and _METRIC_SYMBOLS[unit] == symbol
        ),
        None,
    )


def imperial_texts(values, unit):
    """Numbers in a unit of tables as one text in the imperial one: "2.000, 0.1969 in"."""
    _, symbol = IMPERIAL.in_unit(0.0, unit)
    numbers = (IMPERIAL.in_unit(value, unit)[0] for value in values)
    return f"{', '.join(map(_all_digits, numbers))} {symbol}"


def _all_digits(value):
    """As tables print it, and four digits of what is small."""
    return f"{value:.4g}" if 0.0 < abs(value) < 1.0 else _digits(value)


# What is smaller is rounding of the numbers, and of no use to people.
_LEAST_SHOWN = 1e-6


def format_mm(metres):
    """A small length as text, in millimetres."""
    return f"{_small(1e3 * metres)} mm"


def format_small_angle(radians):
    """A small angle as text, in degrees."""
    return f"{_small(degrees(radians))}°"


def format_jump(curvature):
    """A small difference of curvatures in 1/m as text."""
    return f"{_small(curvature)} 1/m"


def _small(value):
    if 0.0 < value < _LEAST_SHOWN:
        return f"below {_LEAST_SHOWN:.0e}"
    # From here on three digits are "1e+03".
    return f"{value:.3g}" if value < 999.5 else f"{value:.0f}"


def _digits(value):
    """Three decimals up to a thousand, fewer above, as tables print them."""
    decimals = 3 if abs(value) < 1e3 else 2 if abs(value) < 1e4 else 1 if abs(value) < 1e5 else 0
    text = f"{value:.{decimals}f}"
    return text[1:] if text.startswith("-") and not text.strip("-0.") else text
