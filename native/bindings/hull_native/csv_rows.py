# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of tables as text."""

import csv
import io


def csv_text(rows, digits):
    """Rows, dictionaries with the same keys, as comma-separated values with the keys above; numbers
    that are not whole with so many digits."""
    text = io.StringIO()
    writer = csv.DictWriter(text, fieldnames=list(rows[0]), lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow(
            {k: f"{v:.{digits}g}" if isinstance(v, float) else v for k, v in row.items()}
        )
    return text.getvalue()
