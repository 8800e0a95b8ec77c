# SPDX-License-Identifier: GPL-3.0-or-later
"""Sectional area curves from tables: a line for each station, its x in metres and its area in m²,
or in the units that stand in brackets in the headings.

Columns stand apart by commas, semicolons, tabs or blanks; beside other signs than commas a decimal
comma counts as a point. Lines of words before the numbers are headings: where one names columns "x"
and "area", as the add-on's own tables do, these are taken, else the first two. Empty lines, and
what follows a #, are passed over. Stations may be told from forward aft.
"""

import math
import re
from pathlib import Path

import numpy as np

from .bytes_on_disk import read_bytes
from .errors import HullFileError
from .limits import FURTHEST_POINT, LARGEST_SECTION, MAX_AREA_TABLE_BYTES, MAX_AREA_TABLE_ROWS
from .table_text import decoded, number_in, table_rows

_LEAST_ROWS = 3
_SIZES = (
    {"m": 1.0, "mm": 1e-3, "ft": 0.3048},
    {"m2": 1.0, "ft2": 0.3048**2},
)
# In round brackets other words may stand: "x (from AP)", "station (no)".
_UNIT = re.compile(r"\[\s*([^\]]*?)\s*\]|\(\s*((?!(?:ap|fp|no)\b)[a-z]{1,2}\s*[2²]?)\s*\)")
_X_NAMES = ("x", "station", "position", "place")


def read_area_table(path):
    """(x (n,) in m, rising; areas (n,) in m²) of a file; HullFileError with line and remedy."""
    path = Path(path)
    return parse_area_table(decoded(read_bytes(path, MAX_AREA_TABLE_BYTES)), path.name)


def parse_area_table(text, name):
    """The same of a text; name: of the file, for messages."""
    columns, heading, rows = None, (0, []), []
    for number, cells in table_rows(text):
        values = [number_in(cell) for cell in cells]
        if not rows and not any(value is not None for value in values):
            named = _columns_named(cells)
            if named or columns is None:
                columns, heading = named, (number, cells)
            continue
        if len(rows) == MAX_AREA_TABLE_ROWS:
            raise HullFileError(
                f"{name}: it has more than {MAX_AREA_TABLE_ROWS} stations; leave some out."
            )
        if not rows:
            columns = columns or (0, 1)
            sizes = _sizes(heading, columns, name)
        rows.append((number, *_pair(values, columns, sizes, number, name)))
    if len(rows) < _LEAST_ROWS:
        raise HullFileError(
            f"{name}: {len(rows)} lines with a place and an area are found; a sectional area curve "
            f"needs {_LEAST_ROWS} or more, x in metres and the area in m² in each."
        )
    return _rising(rows, name)


def _sizes(heading, columns, name):
    """Of the units of x and area, m and m²: as the brackets of a heading (line, cells) say."""
    number, cells = heading
    sizes = []
    for column, known in zip(columns, _SIZES):
        cell = cells[column] if column < len(cells) else ""
        found = _UNIT.search(cell.lower())
        unit = (found[1] or found[2] or "").replace("²", "2").replace(" ", "") if found else ""
        if found and unit not in known:
            raise HullFileError(
                f"{name}: line {number}: '{cell[:40]}' has a unit that is not read; give x in m, "
                "mm or ft and areas in m2 or ft2."
            )
        sizes.append(known.get(unit, 1.0))
    return sizes


def _columns_named(cells):
    """(column of x, column of the area) by a heading's words; None where it names none."""
    words = [re.split(r"[^a-z]+", cell.lower().strip()) for cell in cells]
    x = next((k for k, found in enumerate(words) if found[0] in _X_NAMES[:1]), None)
    if x is None:
        x = next((k for k, found in enumerate(words) if set(found) & set(_X_NAMES)), None)
    area = next((k for k, found in enumerate(words) if {"area", "areas", "a"} & set(found)), None)
    return None if x is None or area is None or x == area else (x, area)


def _pair(values, columns, sizes, number, name):
    found = [values[k] if k < len(values) else None for k in columns]
    for value, what, column in zip(found, ("x in metres", "an area in m²"), columns):
        if value is None or not math.isfinite(value):
            raise HullFileError(
                f"{name}: line {number}, column {column + 1}: {what} is wanted and there is no "
                "number; write one, or take the line out."
            )
    x, area = (value * size for value, size in zip(found, sizes))
    if abs(x) > FURTHEST_POINT:
        raise HullFileError(
            f"{name}: line {number}: x is {x:g} m, which no ship has; give metres from the after "
            "perpendicular."
        )
    if not 0.0 <= area <= LARGEST_SECTION:
        raise HullFileError(
            f"{name}: line {number}: the area is {area:g} m²; give one from 0 to "
            f"{LARGEST_SECTION:g}."
        )
    return x, area


def _rising(rows, name):
    if rows[0][1] > rows[-1][1]:
        rows = rows[::-1]
    for (_, before, _), (number, x, _) in zip(rows, rows[1:]):
        if not x > before:
            raise HullFileError(
                f"{name}: line {number}: x is {x:g} m beside {before:g} m; have the stations in "
                "order, each once."
            )
    x, areas = np.array([row[1:] for row in rows]).T
    if not areas.any():
        raise HullFileError(f"{name}: all areas are 0; give areas of the immersed sections in m².")
    return x, areas
