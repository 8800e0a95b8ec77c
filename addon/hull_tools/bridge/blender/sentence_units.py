# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences of the core, which are metric, in the units that a scene shows."""

import re

from .units import in_unit, is_imperial

# By how sentences write a unit: its name in tables; or the size and symbol of the imperial one.
_UNITS = {
    "m": "m",
    "m²": "m2",
    "m³": "m3",
    "m⁴": "m4",
    "t": "t",
    "t/m³": "t/m3",
    "kN": "kN",
    "kW": "kW",
    "mm": (25.4, "in"),
    "1/m": (1.0 / 0.3048, "1/ft"),
}
_FEWEST_DIGITS = 4

_NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
# What stands between numbers that share the unit after the last: "x 1, y 2, z 3 m", "1 to 2 m".
_BETWEEN = r"(?:, (?:and )?| and | to | × | by |–)(?:[xyz] (?:= )?)?"
_QUANTITY = re.compile(
    rf"(?<![\w.(–-])({_NUMBER}(?:{_BETWEEN}{_NUMBER})*) (1/m|mm|m²|m³|m⁴|m|t/m³|t|kN|kW)"
    r"(?![\w·/²³⁴-])"
    rf"|\(({_NUMBER}(?:, {_NUMBER})+)\) (m)(?![\w-])"
)
_QUOTED = re.compile(r'("[^"\n]*")')


def in_scene_units(scene, text):
    """A sentence with its metres, tonnes and the like as the scene's unit system has them; names in
    quotes stay. In a metric scene, and where nothing of the kind is in it, it is the same."""
    if not is_imperial(scene):
        return text
    # Every second part is a name.
    parts = _QUOTED.split(text)
    parts[::2] = (_QUANTITY.sub(lambda match: _imperial(scene, match), part) for part in parts[::2])
    return "".join(parts)


def _imperial(scene, match):
    plain, unit, bracketed, bracketed_unit = match.groups()
    numbers, symbol = plain or bracketed, unit or bracketed_unit

    def converted(number):
        return _rounded(_value(scene, float(number[0]), symbol)[0], number[0])

    numbers = re.sub(rf"(?<![\w.]){_NUMBER}", converted, numbers)
    named = _value(scene, 1.0, symbol)[1]
    return f"({numbers}) {named}" if bracketed else f"{numbers} {named}"


def _value(scene, value, symbol):
    """(number, symbol) in the scene's system."""
    unit = _UNITS[symbol]
    if isinstance(unit, tuple):
        return value / unit[0], unit[1]
    return in_unit(scene, value, unit)


def _rounded(value, written):
    """A digit more than were written of the metric number, and no fewer than four."""
    mantissa = written.split("e")[0].lstrip("+-").replace(".", "").lstrip("0")
    text = f"{value:.{max(len(mantissa) + 1, _FEWEST_DIGITS)}g}"
    if "e+" in text and "e" not in written:
        text = f"{float(text):.0f}"
    return f"+{text}" if written.startswith("+") and value >= 0.0 else text
