# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables as CSV files that a spreadsheet opens: commas, decimal points, units in the header."""

import csv
import io
import re
from pathlib import Path

from ....hull_io.bytes_on_disk import write_bytes

# Feet, inches and eighths below the base line are no formula.
_FEET = re.compile(r"-\d+-\d+-\d[+-]?")
_FORMULA_BEGINS = ("=", "+", "-", "@", "\t", "\r")


def write_table(path, header, rows):
    """`path` is replaced only when all is written. None is an empty cell.

    Only a table with names beyond ASCII begins with a mark, by which spreadsheets know UTF-8.
    """
    text = io.StringIO(newline="")
    table = csv.writer(text)
    table.writerow(header)
    for row in rows:
        table.writerow([_cell(value) for value in row])
    content = text.getvalue()
    encoding = "utf-8" if content.isascii() else "utf-8-sig"
    write_bytes(Path(path), content.encode(encoding))


def _cell(value):
    if isinstance(value, str):
        # A spreadsheet would take a name that begins like this for a formula, and compute it.
        is_formula = value[:1] in _FORMULA_BEGINS and not _FEET.fullmatch(value)
        return f"'{value}" if is_formula else value
    if value is None:
        return None
    return f"{value:.10g}"
