# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of tables as text."""

import csv
import io
import math


def csv_text(rows, digits):
    """Rows, dictionaries with the same keys, as comma-separated values with the keys above; numbers
    that are not whole with so many digits, NaN as an empty cell."""
    text = io.StringIO()
    writer = csv.DictWriter(text, fieldnames=list(rows[0]), lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow({name: _cell(value, digits) for name, value in row.items()})
    return text.getvalue()


def _cell(value, digits):
    if not isinstance(value, float):
        return value
    return "" if math.isnan(value) else f"{value:.{digits}g}"
