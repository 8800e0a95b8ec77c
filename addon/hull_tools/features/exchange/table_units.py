# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables in the units of an imperial scene. Analyses know metres alone: what they give is turned
over by the units in the header's brackets."""

import re

from ...bridge.blender import units
from . import tables

_BRACKET = re.compile(r"\[([^\]]+)\]")
_EACH_ROW_S = "see unit"  # values have the unit that the column "unit" names
# Of units that tables alone have: the name there, and how much of the metric unit one is.
_OTHERS = {
    "m/s": (0.3048, "ft/s"),
    "m/rad": (0.3048, "ft/rad"),
    "kN/deg": (0.0044482216152605, "lbf/deg"),
}


def write_shown(path, header, rows, is_imperial):
    """tables.write_table, in the units of a scene's system."""
    tables.write_table(path, *(in_imperial(header, rows) if is_imperial else (header, rows)))


def in_imperial(header, rows):
    """(header, rows) of a table with feet and their like in place of metres, long tons of tonnes;
    texts and what has no such unit stay."""
    header = list(header)
    columns = [_BRACKET.search(title) for title in header]
    names = [found and found[1] for found in columns]
    own = header.index("unit") if "unit" in header else None
    return [_heading(title) for title in header], [_row(row, names, own) for row in rows]


def _imperial(name):
    """(size, name) of the imperial unit in a metric one's place; None where it stays."""
    if name in _OTHERS:
        return _OTHERS[name]
    size, symbol = units.imperial(name) or (1.0, "")
    return (size, symbol) if symbol else None


def _heading(title):
    return _BRACKET.sub(lambda found: f"[{_name(found[1])}]", title)


def _name(name):
    found = _imperial(name)
    return found[1] if found else name


def _row(row, names, own):
    row = list(row)
    given = row[own] if own is not None else None
    for i, name in enumerate(names):
        found = _imperial(given if name == _EACH_ROW_S else name)
        if found and isinstance(row[i], (int, float)):
            row[i] = row[i] / found[0]
    if own is not None:
        row[own] = _name(given)
    return row
