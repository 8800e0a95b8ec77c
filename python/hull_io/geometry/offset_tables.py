# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of offsets: half-breadths at waterlines and heights at buttocks, station by station.

Stations are rows or columns; lines are named by their headings ("WL 1.5", "Buttock 2", "Deck:
half-breadth", "Profile"), or stand as numbers below titles ("Half-breadths", "Heights") or beside a
corner that names them. Lines such as "unit: mm" or "station spacing: 4.2 m" may stand before.
`docs/geometry-in.md` shows the layouts.
"""

import re
from collections import Counter
from dataclasses import dataclass, field
from functools import cached_property

from ..errors import HullFileError
from ..limits import FURTHEST_POINT, MAX_OFFSETS
from ..table_text import table_rows
from .lengths import Length, is_nothing, length_in, unit_named
from .table_headings import Heading, block_of, has_other_datum, heading_of, is_title
from .values import METRES_PER_UNIT

_SETTING = re.compile(
    r"\s*(units?|(?:station|waterline|buttock) spacing|lpp|stations? apart)\s*[:=,;\t ]\s*"
    r"([^,;\t]+?)[\s,;]*",
    re.IGNORECASE,
)


@dataclass(frozen=True)
class Offset:
    """One value of a table. station, line: Headings; line number in the file; as lengths."""

    station: Heading
    line: Heading
    value: Length
    row: int


@dataclass
class OffsetTable:
    """positions: x by the station's text, where a column or row tells it. settings: by their names.
    knuckles: (station's text, what is said to be on a knuckle). left_out: sentences, each once, as
    keys. Of units once all is read."""

    offsets: list = field(default_factory=list)
    positions: dict = field(default_factory=dict)
    settings: dict = field(default_factory=dict)
    knuckles: list = field(default_factory=list)
    left_out: dict = field(default_factory=dict)
    station_headings: dict = field(default_factory=dict)

    @cached_property
    def unit(self):
        """That all lengths are turned into: the only one that is told, metres where there are
        several; None where none is."""
        told = {unit for unit in self._told_units() if unit}
        return told.pop() if len(told) == 1 else "m" if told else None

    @cached_property
    def default_unit(self):
        """Of lengths that tell none: as a setting says, else what most others are in."""
        if "unit" in self.settings:
            return self.settings["unit"]
        told = Counter(unit for unit in self._told_units() if unit)
        return told.most_common(1)[0][0] if told else None

    def leave_out(self, why):
        self.left_out[f"{why}, and is left out."] = None

    def in_unit(self, length):
        unit = self.unit
        if unit is None:
            return length.value
        own = length.unit or self.default_unit
        if own == unit:
            return length.value
        return length.value * METRES_PER_UNIT[own] / METRES_PER_UNIT[unit]

    def _told_units(self):
        yield self.settings.get("unit")
        for offset in self.offsets:
            yield offset.value.unit
            if offset.line.position is not None:
                yield offset.line.position.unit
        for length in self.positions.values():
            yield length.unit


def looks_like_offsets(text):
    """Whether some line in a text has two headings of a table of offsets, or begins with one."""
    for _, cells in table_rows(text[:100_000])[:200]:
        try:
            headings = [heading_of(cell) for cell in cells[:50]]
        except ValueError:
            continue
        if headings and (block_of(cells) or headings[0].is_line and len(cells) > 1):
            return True
        named = [h for h in headings if h.is_line or h.kind in ("station", "x")]
        if len(named) >= 2 or named and len(headings) > 2 and headings[0].kind == "station":
            return True
    return False


def parse_offset_table(rows, name):
    """The OffsetTable of rows as table_rows() has them; name: of the file, for messages.
    HullFileError with the line."""
    return _Reader(name).read(rows)


class _Reader:
    def __init__(self, name):
        self.name = name
        self.table = OffsetTable()
        self.columns, self.corner, self.block = None, None, ""
        self.rows = []  # of the present header: (line, Heading, cells)
        self.count = 0  # of cells in all rows so far; a row without any counts as one

    def error(self, row, problem, remedy):
        return HullFileError(f"{self.name}: line {row}: {problem}; {remedy}.")

    def read(self, rows):
        for row, cells in rows:
            if self._is_setting(cells):
                continue
            if has_other_datum(cells):
                told = " ".join(cell for cell in cells if cell)[:80]
                raise self.error(
                    row, f"'{told}' are not above the base line", "give all heights above that"
                )
            headings = [self._heading(row, cell) for cell in cells]
            title = block_of(cells)
            is_bare = not any(h.is_line or h.position for h in headings)
            if title and (is_bare or is_title(cells)):
                self._finish()
                self.block, self.columns = title, None
            elif self._is_header(headings):
                self._finish()
                self.corner, self.columns = headings[0], headings[1:]
            elif self.columns is not None:
                self._add_row(row, headings[0], cells[1:])
        self._finish()
        if not self.table.offsets:
            raise HullFileError(
                f"{self.name}: no offsets are found; give a line of headings such as "
                "'Station, WL 0, WL 1' and below it a line for each station."
            )
        return self.table

    def _heading(self, row, cell):
        try:
            return heading_of(cell)
        except ValueError as error:
            raise self.error(row, str(error), "write feet-inches-eighths, such as 5-11-7") from None

    def _is_setting(self, cells):
        found = _SETTING.fullmatch(" ".join(cell for cell in cells if cell))
        if not found:
            return False
        key = found[1].lower().replace("units", "unit")
        value = unit_named(found[2]) if key == "unit" else length_in(found[2])
        if value is None:
            return False
        self.table.settings[key] = value
        return True

    def _is_header(self, headings):
        first, rest = headings[0], headings[1:]
        numbers = [h for h in rest if h.kind == "number"]
        named = [h for h in rest if h.is_line or h.kind in ("x", "station")]
        # What is said to be on a knuckle names lines, too.
        if named and len(named) >= len(numbers):
            return True
        # Numbers alone are headings beside a corner without one.
        return (
            len(numbers) >= 2
            and len(numbers) == sum(bool(h.text) for h in rest)
            and first.position is None
            and not first.is_line
            and first.kind != "x"
            and (self.columns is None or first.kind == "station")
        )

    def _add_row(self, row, heading, cells):
        if self.count > MAX_OFFSETS:
            raise self.error(row, f"there are more than {MAX_OFFSETS} values", "leave some out")
        self.count += max(1, len(cells))
        self.rows.append((row, heading, cells))

    def _finish(self):
        """The rows below one line of headings become offsets."""
        if self.columns is None or not self.rows:
            self.rows = []
            return
        stations_are_rows = self._stations_are_rows()
        for row, heading, cells in self.rows:
            for column, cell in zip(self.columns, cells):
                station, line = (heading, column) if stations_are_rows else (column, heading)
                if not station.text:
                    continue
                if line.kind == "knuckles":
                    self.table.knuckles.append((station.text, cell))
                elif not is_nothing(cell):
                    self._add(row, station, self._meant(line, stations_are_rows), cell)
            if stations_are_rows and self.corner.kind == "x" and heading.position is not None:
                unit = heading.position.unit or self.corner.unit
                self.table.positions[heading.text] = Length(heading.position.value, unit)
        self.rows = []

    def _meant(self, line, stations_are_rows):
        """A number alone is a waterline's height or a buttock's breadth, as title or corner say."""
        if line.kind != "number":
            return line
        kind = {"half_breadth": "waterline", "height": "buttock"}.get(self.block)
        if kind is None and not stations_are_rows and self.corner.kind in ("waterline", "buttock"):
            kind = self.corner.kind
        return Heading(kind or "waterline", line.text, line.position, unit=line.unit)

    def _add(self, row, station, line, cell):
        self.table.station_headings.setdefault(station.text, station)
        value = self._value(row, line, cell)
        if line.kind == "x":
            self.table.positions[station.text] = value
        elif line.is_line:
            what = line.what or {"waterline": "half_breadth", "buttock": "height"}.get(
                line.kind, "height" if line.kind == "profile" else self.block
            )
            line = Heading(line.kind, line.text, line.position, what, line.unit)
            self.table.offsets.append(Offset(station, line, value, row))
        elif line.text:
            self.table.leave_out(f"'{line.text}' is no line that is known")

    def _value(self, row, line, cell):
        try:
            value = length_in(cell, line.unit)
        except ValueError as error:
            raise self.error(row, str(error), "write feet-inches-eighths, as 5-11-7") from None
        if value is None:
            if not line.is_line and line.kind != "x":
                return None
            raise self.error(
                row,
                f"'{cell[:40]}' at '{line.text[:40]}' is no length",
                "write a number such as 3.25 or 10-7-6, or leave the cell empty",
            )
        if abs(value.value) > FURTHEST_POINT:
            raise self.error(row, f"{value.value:g} is no offset of a ship's", "mend the number")
        return value

    def _stations_are_rows(self):
        labels = [heading for _, heading, _ in self.rows]
        # Beside a corner that says so, "Stem" and "Transom" are stations.
        ends = ("stem", "stern")
        in_columns = ends if self.corner.kind in ("waterline", "buttock") else ()
        in_rows = ends if self.corner.kind in ("station", "x") else ()
        if any(h.is_line and h.kind not in in_columns for h in self.columns):
            return True
        if any(label.is_line and label.kind not in in_rows for label in labels):
            return False
        if self.corner.kind in ("waterline", "buttock"):
            return False
        if self.corner.kind == "x" or any(label.kind == "station" for label in labels):
            return True
        if any(h.kind == "station" for h in self.columns):
            return False
        # "Station" in the corner may name what stands below it or beside it.
        numbered = [_are_numbered(headings) for headings in (labels, self.columns)]
        if self.corner.kind == "station" and numbered[0] != numbered[1]:
            return numbered[0]
        return self._rises_along_rows()

    def _rises_along_rows(self):
        """Half-breadths seldom fall upwards along a station; along a waterline they rise and
        fall."""
        grid = [[length_in(cell) for cell in cells] for _, _, cells in self.rows]
        along = [pair for row in grid for pair in zip(row, row[1:])]
        across = [pair for a, b in zip(grid, grid[1:]) for pair in zip(a, b)]
        return self._falls(along) <= self._falls(across)

    @staticmethod
    def _falls(pairs):
        known = [(a.value, b.value) for a, b in pairs if a is not None and b is not None]
        return sum(b < a for a, b in known) / max(1, len(known))


def _are_numbered(headings):
    """Whether they are whole numbers without a unit, one after the other, as stations have."""
    positions = [h.position for h in headings if h.position is not None]
    if any(position.unit for position in positions):
        return False
    values = sorted(position.value for position in positions)
    return all(b - a == 1.0 for a, b in zip(values, values[1:]))
