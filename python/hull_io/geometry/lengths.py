# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths as tables have them: plain numbers, and feet, inches and eighths of an inch.

5-3-4 is 5 feet, 3 inches and 4 eighths, 5-3-4+ a sixteenth more, 5-3-4- a sixteenth less; 5-3 has
no
eighths. 5' 3 1/2" is the same in another way. A value with a K or a * behind it lies on a knuckle.
"""

import re
from dataclasses import dataclass

from ..table_text import number_in

_UNITS = {
    **{"m": "m", "metre": "m", "metres": "m", "meter": "m", "meters": "m"},
    **{"mm": "mm", "millimetres": "mm", "millimeters": "mm", "cm": "cm"},
    **{"ft": "ft", "feet": "ft", "foot": "ft", "in": "in", "inch": "in", "inches": "in"},
}
_FEET = re.compile(r"(-?)(\d{1,4})-(\d{1,2})(?:-(\d)([+-]?))?")
_QUOTED = re.compile(
    r"(-?)(?:(\d{1,4})\s*')?\s*-?\s*"
    r"(?:(\d{1,2}(?:\.\d+)?)?(?:\s*(\d{1,2})/(\d{1,2}))?\s*(?:\"|''))?"
)
_NOTHING = {"", "-", "--", "---", "–", "—", "...", "n/a", "na", "nan", "x"}


@dataclass(frozen=True)
class Length:
    """value in unit, a key of METRES_PER_UNIT, or in whatever the table is in (None)."""

    value: float
    unit: str | None = None
    on_knuckle: bool = False


def unit_named(word):
    """The unit of a word such as "metres" or "ft."; None for other words."""
    return _UNITS.get(word.lower().strip(" .[]()"))


def length_in(cell, unit=None):
    """The Length of a cell, of `unit` unless it is in feet and inches; None where it is none.

    ValueError for 12 inches or 8 eighths and more.
    """
    bare = cell.strip()
    on_knuckle = len(bare) > 1 and bare[-1] in "Kk*"
    bare = bare[:-1].strip() if on_knuckle else bare
    if len(bare) > 40:
        return None
    feet = _in_feet(bare)
    if feet is not None:
        return Length(feet, "ft", on_knuckle)
    found = re.fullmatch(r"(.*?[\d.])\s*([a-z]{1,2})", bare, re.IGNORECASE)
    if found and unit_named(found[2]):
        bare, unit = found[1], unit_named(found[2])
    number = number_in(bare)
    if number is None or number != number or abs(number) == float("inf"):
        return None
    return Length(number, unit, on_knuckle)


def is_nothing(cell):
    """Whether a cell says that there is no value."""
    return cell.strip().lower() in _NOTHING


def _in_feet(text):
    found = _FEET.fullmatch(text)
    if found:
        sign, feet, inches, eighths, more = found.groups()
        sixteenths = 2 * int(eighths or 0) + {"+": 1, "-": -1}.get(more, 0)
        if int(eighths or 0) > 7:
            raise ValueError(f"'{text}' has more than 7 eighths of an inch")
        return _feet(sign, int(feet), int(inches), sixteenths / 16.0, text)
    found = _QUOTED.fullmatch(text) if "'" in text or '"' in text else None
    if not found or not (found[2] or found[3] or found[4]):
        return None
    sign, feet, inches, over, under = found.groups()
    if under is not None and int(under) == 0:
        return None
    part = int(over) / int(under) if over else 0.0
    return _feet(sign, int(feet or 0), float(inches or 0.0), part, text)


def _feet(sign, feet, inches, part, text):
    if inches >= 12:
        raise ValueError(f"'{text}' has more than 11 inches")
    return (-1.0 if sign else 1.0) * (feet + (inches + part) / 12.0)
