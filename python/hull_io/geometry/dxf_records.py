# SPDX-License-Identifier: GPL-3.0-or-later
"""The records of a DXF file: pairs of group code and value, put together by entity.

Read in plain Python: nothing that a file says decides on memory before it is there.
"""

from dataclasses import dataclass

from ..errors import HullFileError
from ..table_text import decoded

_REMEDY = "save it again as ASCII DXF of release 2000 or later, or use another copy"


@dataclass
class Record:
    """An entity: type, its pairs of code and text, the line where it begins. parts: the records
    that belong to it (vertices of a polyline, entities of a block)."""

    type: str
    pairs: list
    line: int
    parts: list

    def text(self, code, other=""):
        return next((value for own, value in self.pairs if own == code), other)

    def numbers(self, code):
        return [_number(value, self, code) for own, value in self.pairs if own == code]

    def number(self, code, other=0.0):
        return next(iter(self.numbers(code)), other)

    def flags(self, code):
        value = self.number(code)
        return int(value) if abs(value) < 2**31 else 0


class DxfError(ValueError):
    """What is wrong with a record, without the file's name."""


def _number(text, record, code):
    try:
        value = float(text[:40])
    except ValueError:
        value = float("nan")
    if not abs(value) <= 1e12:
        raise DxfError(
            f"line {record.line}: {record.type}: '{text[:20]}' (group {code}) is no number"
        )
    return value


@dataclass
class Drawing:
    """header: {variable: text}. blocks: {name: Record}. entities: Records."""

    header: dict
    blocks: dict
    entities: list


def read_drawing(data, name):
    """The Drawing of a file's bytes. HullFileError with the line."""
    if data.startswith(b"AutoCAD Binary DXF"):
        raise HullFileError(f"{name}: it is a binary DXF file; save it again as ASCII DXF.")
    drawing = Drawing({}, {}, [])
    section, records = "", []
    for record in _records(decoded(data), name):
        if record.type == "SECTION":
            section, records = record.text(2), []
            if section == "HEADER":
                drawing.header = _variables(record.pairs)
        elif record.type == "ENDSEC":
            if section == "ENTITIES":
                drawing.entities = _nested(records)
            elif section == "BLOCKS":
                blocks = _nested(records)
                drawing.blocks = {b.text(2): b for b in blocks if b.type == "BLOCK"}
            section = ""
        elif section in ("ENTITIES", "BLOCKS"):
            records.append(record)
    if section in ("ENTITIES", "BLOCKS", "HEADER"):
        raise HullFileError(f"{name}: the file ends within its {section}, cut short; {_REMEDY}.")
    if not drawing.entities:
        raise HullFileError(f"{name}: nothing is drawn in it; {_REMEDY}.")
    return drawing


def _records(text, name):
    lines = text.splitlines()
    record = None
    for at in range(0, len(lines) - 1, 2):
        try:
            code = int(lines[at][:20])
        except ValueError:
            raise HullFileError(
                f"{name}: line {at + 1}: a group code is wanted, and there is "
                f"'{lines[at].strip()[:20]}'; {_REMEDY}."
            ) from None
        value = lines[at + 1].strip()
        if code == 0:
            if record is not None:
                yield record
            record = Record(value, [], at + 1, [])
        elif record is not None and code != 999:
            record.pairs.append((code, value))
    if record is not None:
        yield record


def _variables(pairs):
    variables, name = {}, ""
    for code, value in pairs:
        if code == 9:
            name = value
        else:
            variables.setdefault(name, value)
    return variables


def _nested(records):
    """Vertices go into their polyline, entities into their block."""
    found, block, line = [], None, None
    for record in records:
        if record.type == "BLOCK":
            block, line = record, None
            found.append(record)
        elif record.type == "ENDBLK":
            block, line = None, None
        elif record.type == "VERTEX" and line is not None:
            line.parts.append(record)
        elif record.type == "SEQEND":
            line = None
        else:
            line = record if record.type == "POLYLINE" else None
            (found if block is None else block.parts).append(record)
    return found
