# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull file tells of a hull's shape fields, in m and the hull's axes:

    "fields": [{"name": "...", "role": "move" or "protect", "on": true, "colour": [r, g, b],
                "base": "point", "crease", "plane", "section", "line" or "faces",
                "place": [x, y, z], "axis": "x", "line": [[x, y, z], ...], "closed": false,
                "faces": [face, ...], "becomes": [[x, y, z], ...],
                "extent": m, "falloff": 0 to 1, "shift": [x, y, z], "axes": "xyz",
                "along_surface": false,
                "end": {"extent": m, "falloff": 0 to 1, "shift": [x, y, z]}}, ...]

All but the extents may be left out. A crease is the one nearest to the place; a plane goes through
the place, square to the axis; a section is the line in which such a plane cuts the hull, nearest to
the place; line and closed are of a base "line" alone, faces of a base "faces". With becomes the
base becomes that curve; with end the field varies along its base.
"""

from .hull_data import FieldEnd, ShapeField
from .limits import FURTHEST_POINT, LONGEST_DIMENSION, MAX_FIELDS, MAX_LINE_POINTS

KEY = "fields"
ROLES = ("move", "protect")
BASES = ("point", "crease", "plane", "section", "line", "faces")
CURVES = ("crease", "section", "line")
_KNOWN = tuple(vars(ShapeField("", 1.0)))
_KNOWN_OF_ENDS = tuple(vars(FieldEnd(1.0)))


def parsed(check, content, face_count):
    """The list of ShapeField in the content of a hull file of so many faces; raises
    HullFileError."""
    listed = check.list(content.get(KEY, []), KEY, most=MAX_FIELDS)
    return [_field(check, value, index, face_count) for index, value in enumerate(listed)]


def _field(check, value, index, face_count):
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
        faces=_faces(check, *given("faces"), face_count),
        becomes=_line(check, *given("becomes")),
        end=_end(check, *given("end")),
        along_surface=check.flag(*given("along_surface")),
    )
    if (found.base == "line") != bool(found.line):
        raise check.error(
            f"{where}.line",
            'a base "line" has points, and no other base',
            "give two points or more, or another base",
        )
    for key, is_given in (("becomes", found.becomes), ("end", found.end)):
        if is_given and found.base not in CURVES:
            raise check.error(
                f"{where}.{key}", f'a base "{found.base}" has none', "leave it out, or take a curve"
            )
    if found.faces and found.base != "faces":
        raise check.error(
            f"{where}.faces", f'a base "{found.base}" has none', 'leave them out, or write "faces"'
        )
    return found


def _faces(check, value, where, face_count):
    faces = check.list(value, where)
    for place, face in enumerate(faces):
        check.index(face, f"{where}[{place}]", face_count, "face")
    return sorted(set(faces))


def _end(check, value, where):
    if value is None:
        return None
    entries, usual = check.object(value, where, _KNOWN_OF_ENDS), FieldEnd(1.0)
    if "extent" not in entries:
        raise check.error(f"{where}.extent", "it is missing", "add it")
    shift = entries.get("shift", usual.shift)
    return FieldEnd(
        extent=check.number(entries["extent"], f"{where}.extent", 0.0, LONGEST_DIMENSION),
        falloff=check.number(entries.get("falloff", usual.falloff), f"{where}.falloff", 0.0, 1.0),
        shift=_vector(check, shift, f"{where}.shift", -LONGEST_DIMENSION, LONGEST_DIMENSION),
    )


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
    entry = {key: _plain(value) for key, value in vars(field).items() if value is not None}
    if field.base != "line":
        del entry["line"], entry["closed"]
    for key in ("faces", "becomes", "along_surface"):
        if not entry[key]:
            del entry[key]
    return entry


def _plain(value):
    if isinstance(value, FieldEnd):
        return {key: _plain(part) for key, part in vars(value).items()}
    if isinstance(value, (tuple, list)):
        return [_plain(part) for part in value]
    return value if isinstance(value, (str, bool, int)) else float(value)
