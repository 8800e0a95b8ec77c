# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences of the core, which are metric, in the units that a scene shows."""

import re

from .units import IMPERIAL, is_imperial

# Units as sentences write them.
_WRITTEN = ("1/m", "mm", "m²", "m³", "m⁴", "cm³", "m", "t/m³", "t", "kN", "kW")
_SIZES = {**IMPERIAL.plot_sizes(), "cm³": (2.54**3, "in³")}
_FEWEST_DIGITS = 4

_NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
# What stands between numbers that share the unit after the last: "x 1, y 2, z 3 m", "1 to 2 m".
_BETWEEN = r"(?:, (?:and )?| and | to | × | by |–)(?:[xyz] (?:= )?)?"
_QUANTITY = re.compile(
    rf"(?<![\w.(–-])({_NUMBER}(?:{_BETWEEN}{_NUMBER})*) ({'|'.join(_WRITTEN)})"
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
    parts[::2] = (_QUANTITY.sub(_imperial, part) for part in parts[::2])
    return "".join(parts)


def _imperial(match):
    plain, unit, bracketed, bracketed_unit = match.groups()
    size, symbol = _SIZES[unit or bracketed_unit]

    def converted(number):
        return _rounded(float(number[0]) / size, number[0])

    numbers = re.sub(rf"(?<![\w.]){_NUMBER}", converted, plain or bracketed)
    return f"({numbers}) {symbol}" if bracketed else f"{numbers} {symbol}"


def _rounded(value, written):
    """A digit more than were written of the metric number, and no fewer than four."""
    mantissa = written.split("e")[0].lstrip("+-").replace(".", "").lstrip("0")
    text = f"{value:.{max(len(mantissa) + 1, _FEWEST_DIGITS)}g}"
    if "e+" in text and "e" not in written:
        text = f"{float(text):.0f}"
    return f"+{text}" if written.startswith("+") and value >= 0.0 else text
