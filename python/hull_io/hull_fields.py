# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull file tells of a hull's shape fields, in m and the hull's axes:

    "fields": [{"name": "...", "role": "move" or "protect", "on": true, "colour": [r, g, b],
                "base": "point", "crease", "plane" or "line", "place": [x, y, z], "axis": "x",
                "line": [[x, y, z], ...], "closed": false,
                "extent": m, "falloff": 0 to 1, "shift": [x, y, z], "axes": "xyz"}, ...]

All but the extent may be left out. A crease is the one nearest to the place; a plane goes through
the place, square to the axis; line and closed are of a base "line" alone.
"""

from .hull_data import ShapeField
from .limits import FURTHEST_POINT, LONGEST_DIMENSION, MAX_FIELDS, MAX_LINE_POINTS

KEY = "fields"
ROLES = ("move", "protect")
BASES = ("point", "crease", "plane", "line")
_KNOWN = tuple(vars(ShapeField("", 1.0)))


def parsed(check, content):
    """The list of ShapeField in the content of a hull file; raises HullFileError."""
    listed = check.list(content.get(KEY, []), KEY, most=MAX_FIELDS)
    return [_field(check, value, index) for index, value in enumerate(listed)]


def _field(check, value, index):
    where, usual = f"{KEY}[{index}]", ShapeField("", 1.0)
    entries = check.object(value, where, _KNOWN)
    if "extent" not in entries:
        raise check.error(f"{where}.extent", "it is missing", "add it")

    def given(key):
        return entries.get(key, getattr(usual, key)), f"{where}.{key}"

    found = ShapeField(
        name=check.text(entries.get("name", f"Field {index + 1}"), f"{where}.name"),
        extent=check.number(entries["extent"], f"{where}.extent", 0.0, LONGEST_DIMENSION),
        role=check.choice(*given("role"), ROLES),
        on=check.flag(*given("on")),
        colour=_vector(check, *given("colour"), 0.0, 1.0),
        base=check.choice(*given("base"), BASES),
        place=_vector(check, *given("place"), -FURTHEST_POINT, FURTHEST_POINT),
        axis=check.choice(*given("axis"), tuple("xyz")),
        line=_line(check, *given("line")),
        closed=check.flag(*given("closed")),
        falloff=check.number(*given("falloff"), 0.0, 1.0),
        shift=_vector(check, *given("shift"), -LONGEST_DIMENSION, LONGEST_DIMENSION),
        axes=_axes(check, *given("axes")),
    )
    if (found.base == "line") != bool(found.line):
        raise check.error(
            f"{where}.line",
            'a base "line" has points, and no other base',
            "give two points or more, or another base",
        )
    return found


def _vector(check, value, where, least, most):
    numbers = check.list(list(value) if isinstance(value, tuple) else value, where, 3)
    return tuple(check.number(number, where, least, most) for number in numbers)


def _line(check, value, where):
    points = check.list(value, where, most=MAX_LINE_POINTS)
    if len(points) == 1:
        raise check.error(where, "one point is no line", "give two points or more")
    return [
        _vector(check, point, f"{where}[{index}]", -FURTHEST_POINT, FURTHEST_POINT)
        for index, point in enumerate(points)
    ]


def _axes(check, value, where):
    text = check.text(value, where)
    if text != "".join(axis for axis in "xyz" if axis in text):
        raise check.error(where, f"{text!r} are no axes", 'write "xyz", or less of it')
    return text


def entries(data):
    """What a hull file says of a HullData's fields, by its key; nothing where there are none."""
    return {KEY: [_entry(field) for field in data.fields]} if data.fields else {}


def _entry(field):
    entry = {key: _plain(value) for key, value in vars(field).items()}
    if field.base != "line":
        del entry["line"], entry["closed"]
    return entry


def _plain(value):
    if isinstance(value, (tuple, list)):
        return [_plain(part) for part in value]
    return value if isinstance(value, (str, bool)) else float(value)
