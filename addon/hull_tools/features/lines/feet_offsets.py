# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of offsets as American lofts have them: 5-3-4 is 5 feet, 3 inches and 4 eighths, 5-3-4+ a
sixteenth more."""

import re

_FOOT, _SIXTEENTHS = 0.3048, 192  # m; in a foot
_METRES = re.compile(r"(-?\d+(?:\.\d+)?(?:e[+-]?\d+)?) m\b")


def in_feet(header, rows):
    """(header, rows) of a table of offsets in m and mm: what is in mm as feet, inches and eighths,
    what is in m in decimal feet, in headings and words too."""
    header = list(header)
    return [_words(title).replace(" [mm]", "").replace("[m]", "[ft]") for title in header], [
        [_cell(title, value) for title, value in zip(header, row)] for row in rows
    ]


def feet_text(metres):
    """To a sixteenth of an inch."""
    count = round(abs(metres) / _FOOT * _SIXTEENTHS)
    feet, rest = divmod(count, _SIXTEENTHS)
    inches, sixteenths = divmod(rest, 16)
    sign = "-" if metres < 0.0 and count else ""
    return f"{sign}{feet}-{inches}-{sixteenths // 2}" + ("+" if sixteenths % 2 else "")


def _cell(title, value):
    if isinstance(value, str):
        return _words(value)
    if value is None:
        return None
    if title.endswith("[mm]"):
        return feet_text(1e-3 * value)
    return value / _FOOT if title.endswith("[m]") else value


def _words(text):
    """With positions in feet; eight digits, that they are read as they were."""
    return _METRES.sub(lambda found: f"{float(found[1]) / _FOOT:.8g} ft", text)
