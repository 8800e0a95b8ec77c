# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables that people and programs write as text: rows of cells.

Columns stand apart by semicolons, tabs, commas or blanks; beside other signs than commas a decimal
comma counts as a point. Empty lines, and what follows a #, are passed over.
"""

import csv
import re


def decoded(data):
    """The text of a file's bytes, in whichever of the usual encodings; never fails."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def table_rows(text):
    """Pairs (number of the line, its cells) of the lines that say something. A decimal comma is a
    point in them."""
    bare = (
        (number, line.split("#")[0].rstrip()) for number, line in enumerate(text.splitlines(), 1)
    )
    lines = [(number, line) for number, line in bare if line.strip()]
    separator = _separator([line.strip() for _, line in lines])
    return [(number, _cells(line, separator)) for number, line in lines]


def _separator(lines):
    """What stands between the columns; None: blanks."""
    for sign in (";", "\t"):
        if any(sign in line for line in lines):
            return sign
    # "12,5 34,7" has decimal commas, "12.5, 34.7" and "12,34" have columns.
    with_numbers = [line for line in lines if re.match(r"[-+.\d]", line)]
    has_decimal_commas = bool(with_numbers) and all(
        re.search(r"\s", line) and not re.search(r",\s|\s,|,,|\.", line) for line in with_numbers
    )
    return "," if any("," in line for line in lines) and not has_decimal_commas else None


def _cells(line, separator):
    if separator is None:
        parts = line.split()
    else:
        parts = _split(line, separator)
    cells = [_unquoted(part.strip()) for part in parts]
    return cells if separator == "," else [re.sub(r"(\d),(\d)", r"\1.\2", cell) for cell in cells]


def _unquoted(cell):
    """A quote at the end alone is the mark of feet or inches."""
    while len(cell) > 1 and cell[0] == cell[-1] and cell[0] in "\"'":
        cell = cell[1:-1]
    return cell


def _split(line, separator):
    """Quotes keep a separator, as in "WL 1,5"."""
    if '"' not in line:
        return line.split(separator)
    try:
        return next(csv.reader([line], delimiter=separator, skipinitialspace=True))
    except csv.Error:
        return line.split(separator)


def number_in(cell):
    """Of a cell; None where it is none."""
    if len(cell) > 40 or "_" in cell:
        return None
    try:
        return float(cell)
    except ValueError:
        return None
