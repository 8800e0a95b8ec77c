# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of a study as a table: CSV always, Parquet where pandas writes it."""

import csv
import io
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from hull_io.bytes_on_disk import write_bytes

from .evaluation import MADE, STATUSES


@dataclass(frozen=True, eq=False)
class Table:
    """rows: the Rows of all variants of a Study in their order; columns: names of their numbers."""

    study: object
    columns: list
    rows: list

    @property
    def names(self):
        """Of all columns: the variant's number, from 1 on, its variables as "$name", what became of
        it, its numbers."""
        variables = [f"${name}" for name in self.study.variables]
        return ["variant", *variables, "status", "reason", *self.columns]

    def lines(self):
        """Yields a list of values for each variant, None of what there is none."""
        for number, (values, row) in enumerate(zip(self.study.variants, self.rows), start=1):
            numbers = [row.numbers.get(name) for name in self.columns]
            yield [number, *values, row.status, row.reason, *numbers]

    def column(self, name):
        """(n,) floats of a column by its name, NaN of what there is none. ValueError for a name
        that is none, and for words."""
        numbers = [one for one in self.names if one not in ("status", "reason")]
        if name not in numbers:
            raise ValueError(f"The table has no numbers {name!r}: it has {', '.join(numbers)}.")
        place = self.names.index(name)
        return np.array([np.nan if line[place] is None else line[place] for line in self.lines()])

    @property
    def made(self):
        """(n,) whether a variant has all that was wanted."""
        return np.array([row.status == MADE for row in self.rows], dtype=bool)

    def counts(self):
        """{status: how many}."""
        found = [row.status for row in self.rows]
        return {status: found.count(status) for status in STATUSES}


def csv_bytes(table):
    """Numbers with all of their digits, so that equal tables are equal bytes."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(table.names)
    for line in table.lines():
        writer.writerow(["" if one is None else one for one in line])
    return text.getvalue().encode()


def write_csv(table, path):
    """Completely, or not at all. HullFileError (a ValueError) where that can't be."""
    write_bytes(Path(path), csv_bytes(table))


def write_parquet(table, path):
    """The same as Parquet. ValueError where there is no pandas, or none that can write it."""
    try:
        import pandas
    except ImportError as error:
        raise ValueError("There is no pandas here: write the table as CSV.") from error
    frame = pandas.DataFrame(list(table.lines()), columns=table.names)
    words = ["status", "reason"]
    numbers = [name for name in table.names if name not in ("variant", *words)]
    frame = frame.astype({name: "float64" for name in numbers})
    data = io.BytesIO()
    try:
        frame.to_parquet(data, index=False)
    except ImportError as error:
        raise ValueError(
            "This pandas can't write Parquet: install pyarrow or fastparquet, or write CSV."
        ) from error
    write_bytes(Path(path), data.getvalue())
