# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines in space beside or below a table of offsets: the profile, or stem and stern of it, deck
edge, knuckles, the rim of a transom.

Beside it they are columns such as "Stem: x [m]", "Stem: height [mm]", with a half-breadth where the
line is not in the centre plane; what stands in one row is a point of the line, and no matter of the
station in that row. Below it they are a heading "line, x, half-breadth, height", and a row for each
point, with the line's name in the first column.
"""

import re

from ..errors import HullFileError
from ..limits import FURTHEST_POINT, MAX_OFFSETS
from .lengths import is_nothing, length_in
from .table_headings import heading_of
from .values import polyline

_X = re.compile(r"\bx\b|\bposition\b|from a\.?p", re.IGNORECASE)
_COLUMNS = ("x", "half_breadth", "height")
_WORDS = {"x": "x", "half_breadth": "half-breadth", "height": "height"}


def divided(rows):
    """(the rows of the table of offsets, the GeometryCurves' rows) of rows as table_rows() has
    them: a list of (name, [(line, {what: (cell, unit)})]) of lines in space."""
    lines = {}
    for at, (_, cells) in enumerate(rows):
        columns = _columns(cells)
        if cells and cells[0].strip().lower() == "line" and _is_whole(columns.values()):
            for row, values in rows[at + 1 :]:
                _add(lines, values[0], row, {w: (n, u) for n, (w, u) in columns.items()}, values)
            return rows[:at], list(lines.items())
        beside = _beside(cells)
        if beside:
            for row, values in rows[at + 1 :]:
                for name, own in beside.items():
                    _add(lines, name, row, own, values)
            taken = {number for own in beside.values() for number, _ in own.values()}
            kept = [
                (row, [cell for number, cell in enumerate(values) if number not in taken])
                for row, values in rows[at:]
            ]
            return rows[:at] + kept, list(lines.items())
    return rows, []


def _add(lines, name, row, columns, values):
    cells = {
        what: (values[number] if number < len(values) else "", unit)
        for what, (number, unit) in columns.items()
    }
    if not all(is_nothing(cell) for cell, _ in cells.values()):
        lines.setdefault(name, []).append((row, cells))


def _is_whole(columns):
    return set(_COLUMNS) <= {what for what, _ in columns}


def _columns(cells):
    """(what of _COLUMNS, unit) of cells that say so, by their number."""
    columns = {}
    for number, cell in enumerate(cells):
        try:
            heading = heading_of(cell)
        except ValueError:
            continue
        bare = re.sub(r"[\[(].*", "", cell)
        what = heading.what or ("x" if _X.search(bare.split(":")[-1]) else "")
        if what:
            columns[number] = (what, heading.unit)
    return columns


def _beside(cells):
    """Lines by their names: {what: (number of the column, unit)}, of those that have an x."""
    found = {}
    for number, (what, unit) in _columns(cells).items():
        if ":" in cells[number]:
            found.setdefault(cells[number].split(":")[0].strip(), {})[what] = (number, unit)
    return {name: own for name, own in found.items() if {"x", "height"} <= set(own)}


def lines_of(found, table, name):
    """The GeometryCurves of what divided() found, in the unit of an OffsetTable. HullFileError with
    the line."""
    if sum(len(points) for _, points in found) > MAX_OFFSETS:
        raise HullFileError(
            f"{name}: its lines have more than {MAX_OFFSETS} points; leave some out."
        )
    curves = []
    for text, points in found:
        places = [_place(cells, row, table, name) for row, cells in points]
        curves.append(polyline(places, name=text[:80], kind=_kind(text)))
    return [curve for curve in curves if curve is not None]


def _kind(text):
    try:
        kind = heading_of(text).kind
    except ValueError:
        return ""
    if "transom" in text.lower() or kind == "feature" and "edge" in text.lower():
        return "border"
    kinds = {"stem": "profile", "stern": "profile", "deck": "deck_edge", "feature": "knuckle"}
    return kinds.get(kind, kind if kind == "profile" else "")


def _place(cells, row, table, name):
    place = {"half_breadth": 0.0}
    for what, (cell, unit) in cells.items():
        try:
            length = length_in(cell, unit)
        except ValueError:
            length = None
        if length is None or abs(length.value) > FURTHEST_POINT:
            raise HullFileError(
                f"{name}: line {row}: a point of a line has no {_WORDS[what]} that is a length; "
                "write a number such as 3.25, or leave the point out."
            )
        place[what] = table.in_unit(length)
    return tuple(place[what] for what in _COLUMNS)
