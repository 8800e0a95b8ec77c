# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull file tells of the lines that are shown and drawn: lengths in m.

    "lines": {"shown": ["stations", ...], "station_count": n, "waterline_spacing": m,
              "buttock_spacing": m, "stations": "...", "stations_in": "metres" or "frames",
              "waterlines": "...", "buttocks": "...", "diagonals": "...", "frame_spacing": m,
              "planes": [{"name": "...", "normal": [x, y, z], "point": [x, y, z],
                          "shown": true}, ...]}

All may be left out. Lists of positions are texts, as number_lists reads them.
"""

from .hull_data import LINE_KINDS, CutPlane, LineChoice
from .limits import FURTHEST_POINT, LONGEST_DIMENSION, MAX_CUT_PLANES, MAX_LINE_SPACES
from .number_lists import diagonals, numbers

KEY = "lines"
_LENGTHS = ("waterline_spacing", "buttock_spacing", "frame_spacing")
_LISTS = ("stations", "waterlines", "buttocks")
_UNITS = ("metres", "frames")
_KEYS = ("shown", "station_count", "stations_in", "diagonals", "planes", *_LENGTHS, *_LISTS)


def parsed(check, content):
    """The LineChoice in the content of a hull file, None without; raises HullFileError."""
    if KEY not in content:
        return None
    entries = check.object(content[KEY], KEY, _KEYS)
    choice = LineChoice(shown=_shown(check, entries.get("shown", list(LINE_KINDS))))
    if "station_count" in entries:
        choice.station_count = check.index(
            entries["station_count"], "lines.station_count", MAX_LINE_SPACES + 1, "number"
        )
    for key in _LENGTHS:
        value = check.number(entries.get(key, 0), f"lines.{key}", 0.0, LONGEST_DIMENSION)
        setattr(choice, key, value)
    for key in (*_LISTS, "diagonals"):
        setattr(choice, key, _list_text(check, entries.get(key, ""), key))
    choice.stations_in = entries.get("stations_in", _UNITS[0])
    if choice.stations_in not in _UNITS:
        raise check.error("lines.stations_in", "it is unknown", f'write "{_UNITS[0]}"')
    choice.planes = _planes(check, entries.get("planes", []))
    return choice


def _shown(check, value):
    for index, kind in enumerate(check.list(value, "lines.shown")):
        if kind not in LINE_KINDS:
            raise check.error(
                f"lines.shown[{index}]", "it is unknown", f"lines are {', '.join(LINE_KINDS)}"
            )
    return tuple(kind for kind in LINE_KINDS if kind in value)


def _list_text(check, value, key):
    where = f"lines.{key}"
    text = check.text(value, where)
    try:
        diagonals(text) if key == "diagonals" else numbers(text, key)
    except ValueError as error:
        raise check.error(where, str(error), "correct it") from None
    return text


def _planes(check, value):
    entries = check.list(value, "lines.planes")
    if len(entries) > MAX_CUT_PLANES:
        raise check.error(
            "lines.planes", f"it has {len(entries)} entries", f"write at most {MAX_CUT_PLANES}"
        )
    return [_plane(check, entry, f"lines.planes[{i}]") for i, entry in enumerate(entries)]


def _plane(check, value, where):
    entries = check.object(value, where, ("name", "normal", "point", "shown"))
    vectors = {}
    for key, limit in (("normal", 1e3), ("point", FURTHEST_POINT)):
        if key not in entries:
            raise check.error(f"{where}.{key}", "it is missing", "add [x, y, z]")
        numbers_there = check.list(entries[key], f"{where}.{key}", 3)
        vectors[key] = tuple(
            check.number(number, f"{where}.{key}", -limit, limit) for number in numbers_there
        )
    if not any(abs(part) > 1e-6 for part in vectors["normal"]):
        raise check.error(f"{where}.normal", "it has no direction", "write one of length 1")
    return CutPlane(
        name=check.text(entries.get("name", "Plane"), f"{where}.name"),
        shown=check.flag(entries.get("shown", True), f"{where}.shown"),
        **vectors,
    )


def entries(data):
    """What a hull file says of a HullData's lines, by its key."""
    choice = data.lines
    if choice is None:
        return {}
    said = {"shown": list(choice.shown), "station_count": int(choice.station_count)}
    said.update({key: float(getattr(choice, key)) for key in _LENGTHS})
    said.update({key: getattr(choice, key) for key in (*_LISTS, "diagonals", "stations_in")})
    said["planes"] = [
        {
            "name": plane.name,
            "normal": [float(part) for part in plane.normal],
            "point": [float(part) for part in plane.point],
            "shown": bool(plane.shown),
        }
        for plane in choice.planes
    ]
    return {KEY: said}
