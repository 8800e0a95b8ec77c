# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a hull file that tells of bodies joined to the hull or cut out of it.

    "appendages": [{"name": "...", "shape": "cylinder" or "foil" or "bulb", "start": [x, y, z],
                    "end": [x, y, z], "sizes": [m, m], "section": "63-012",
                    "chord_direction": [x, y, z], "thickness_direction": [x, y, z],
                    "thicknesses": [of the chord, of the chord], "on": true, "cut": false,
                    "mirrored": false}, ...]

cylinder: from start to end, sizes its radii there. foil: start and end are the leading edges of
root and tip, sizes the chords, thicknesses 0 those of the section's name. bulb: nose and tail, the
first size its largest diameter.
"""

from math import hypot

from .limits import FURTHEST_POINT, LONGEST_DIMENSION
from .ship_data import Appendage

KEY = "appendages"
SHAPES = ("cylinder", "foil", "bulb")
_KEYS = tuple(vars(Appendage("", "cylinder", (0, 0, 0), (0, 0, 1), (1, 1))))
_REQUIRED = ("shape", "start", "end", "sizes")
MOST = 1000


def parsed(check, content):
    """The list of Appendage of a hull file's content; raises HullFileError."""
    listed = check.list(content.get(KEY, []), KEY, most=MOST)
    return [_appendage(check, entry, f"{KEY}[{place}]") for place, entry in enumerate(listed)]


def _appendage(check, value, where):
    entry = check.object(value, where, _KEYS)
    for key in _REQUIRED:
        if key not in entry:
            raise check.error(f"{where}.{key}", "it is missing", "add it")
    made = Appendage(
        check.text(entry.get("name", ""), f"{where}.name"),
        check.choice(entry["shape"], f"{where}.shape", SHAPES),
        _numbers(check, entry["start"], f"{where}.start", 3, FURTHEST_POINT),
        _numbers(check, entry["end"], f"{where}.end", 3, FURTHEST_POINT),
        _numbers(check, entry["sizes"], f"{where}.sizes", 2, LONGEST_DIMENSION, 0.0),
    )
    if made.start == made.end:
        raise check.error(f"{where}.end", "it is where the start is", "give the body a length")
    made.section = check.text(entry.get("section", made.section), f"{where}.section")
    for name in ("chord_direction", "thickness_direction"):
        own = _numbers(check, entry.get(name, list(getattr(made, name))), f"{where}.{name}", 3, 1e6)
        if not hypot(*own) > 0.0:
            raise check.error(f"{where}.{name}", "it has no direction", "make a part of it other")
        setattr(made, name, own)
    made.thicknesses = _numbers(
        check, entry.get("thicknesses", [0, 0]), f"{where}.thicknesses", 2, 1.0, 0.0
    )
    for name in ("on", "cut", "mirrored"):
        setattr(made, name, check.flag(entry.get(name, getattr(made, name)), f"{where}.{name}"))
    return made


def _numbers(check, value, where, count, highest, lowest=None):
    lowest = -highest if lowest is None else lowest
    listed = check.list(value, where, count)
    return tuple(
        check.number(part, f"{where}[{place}]", lowest, highest)
        for place, part in enumerate(listed)
    )


def entries(data):
    """What a hull file says of a HullData's appendages; nothing of what there is none of."""
    listed = [
        {
            name: [float(part) for part in value] if isinstance(value, tuple) else value
            for name, value in vars(appendage).items()
        }
        for appendage in data.appendages
    ]
    return {KEY: listed} if listed else {}
