# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of a study kept as they come: JSON lines that survive whatever ends the run.

The first line tells whose rows these are; each other line is a whole row, under the digest of its
variant. Lines are written in one piece each batch, and brought to the disk about once a second. A
last line without its end, as a killed run may leave it, is no row and is cut off; any other fault
is told, and the file left as it is.
"""

import fcntl
import hashlib
import json
import os
import stat
import time
from dataclasses import dataclass
from math import isfinite
from pathlib import Path

from hull_io.checked_json import CheckedJson
from hull_io.errors import HullFileError

from .evaluation import REFUSED, STATUSES, Row

FORMAT, VERSION = "hull study journal", 1
MOST_BYTES = 2**31
_LONGEST_LINE = 2**20
_SYNC_SECONDS = 1.0
_CUT = "cut the file off before that line, and the rows from there on are made again"


def variant_key(digest, values):
    """The digest of a variant of the study with this digest: what has the same one has one row."""
    text = " ".join([digest, *(float(value).hex() for value in values)])
    return hashlib.sha256(text.encode()).hexdigest()[:32]


@dataclass(frozen=True)
class Expected:
    """What a journal may hold: study, the Study; keys, of all of its variants; columns, the names
    of a row's numbers; hulls: digest of the HullSet that they are made of."""

    study: object
    keys: frozenset
    columns: tuple
    hulls: str = ""

    @property
    def parts(self):
        """{part: its digest}. Arrays are a part beside the files: who runs a study may have others
        than are read from these."""
        return {**self.study.parts, "arrays of hulls": self.hulls}

    @property
    def header(self):
        told = {"journal": FORMAT, "version": VERSION, "study": self.study.digest}
        return _line({**told, "parts": self.parts, "name": self.study.name})


class Journal:
    """The rows of a study in a file, {key: Row} in `rows`; a context. HullFileError (a ValueError)
    for a file that is none of this study, that another run has open, or that has faults."""

    def __init__(self, path, expected):
        self.path, self._expected = Path(path), expected
        self.rows = {}
        self._file = None
        self._synced = time.monotonic()

    def __enter__(self):
        self._file = _opened(self.path)
        try:
            self._read()
        except BaseException:
            self._file.close()
            raise
        return self

    def __exit__(self, *error):
        try:
            self._sync()
        finally:
            self._file.close()  # and lets go of the lock

    def add(self, rows):
        """Appends {key: Row}."""
        lines = b"".join(_line(_content(key, row)) for key, row in rows.items())
        self._write(lines)
        self.rows |= rows
        if time.monotonic() - self._synced >= _SYNC_SECONDS:
            self._sync()

    def _write(self, data):
        try:
            while data:
                data = data[self._file.write(data) :]
        except OSError as error:
            raise _error(
                self.path,
                f"it can't be written ({error.strerror})",
                "make room, and go on with the same journal",
            ) from error

    def _sync(self):
        os.fsync(self._file.fileno())
        self._synced = time.monotonic()

    def _read(self):
        header = self._expected.header
        begin = self._file.read(len(header))
        if begin != header:
            self._begin_anew(begin, header)
            return
        end = len(header)
        for number, line in enumerate(_lines(self._file, self.path), start=2):
            if not line.endswith(b"\n"):
                break
            self._take(number, line)
            end += len(line)
        self._file.truncate(end)
        self._file.seek(end)

    def _begin_anew(self, begin, header):
        """A file that ends within its first line has no rows; else it is another study's, or no
        journal."""
        if not header.startswith(begin):
            raise self._foreign(begin)
        self._file.truncate(0)
        self._file.seek(0)
        self._write(header)
        self._sync()

    def _foreign(self, begin):
        remedy = "take another file for this study"
        self._file.seek(0)
        first = self._file.readline(_LONGEST_LINE)
        try:
            told = CheckedJson(self.path.name).parse(first)
        except HullFileError:
            told = {}
        if told.get("journal") != FORMAT:
            return _error(self.path, "it is no journal of a study", remedy)
        if told.get("version") != VERSION:
            return _error(self.path, "it is of another version", remedy)
        parts = told.get("parts")
        own = self._expected.parts
        other = parts if isinstance(parts, dict) else {}
        changed = [key for key in own if other.get(key) != own[key]]
        what = f"{', '.join(changed)} differ" if changed else "its digest differs"
        return _error(
            self.path,
            f"its rows are of another study ({what})",
            f"{remedy}, or the study as it was",
        )

    def _take(self, number, line):
        check = CheckedJson(f"{self.path.name}, line {number}")
        try:
            key, row = _row(check, check.parse(line), self._expected)
        except HullFileError as error:
            raise HullFileError(f"{error} Or {_CUT}.") from error
        if key in self.rows:
            raise _error(self.path, f"line {number} has a row that is there before", _CUT)
        self.rows[key] = row


def _opened(path):
    """The file, new or old, for this run alone."""
    try:
        handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC | os.O_NONBLOCK, 0o666)
    except OSError as error:
        raise _error(
            path, f"it can't be opened ({error.strerror})", "check its place and your rights to it"
        ) from error
    file = os.fdopen(handle, "r+b", buffering=0)
    try:
        status = os.fstat(handle)
        if not stat.S_ISREG(status.st_mode):
            raise _error(path, "it is not a file", "choose a journal")
        if status.st_size > MOST_BYTES:
            raise _error(path, "it is larger than any journal", "choose another file")
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            raise _error(path, "another run has it open", "wait for its end, or stop it") from error
        except OSError as error:
            raise _error(
                path,
                f"it can't be kept for this run alone ({error.strerror})",
                "take a file on a disk of this machine",
            ) from error
    except BaseException:
        file.close()
        raise
    return file


def _lines(file, path):
    """The lines from where the file stands, the last one maybe without its end."""
    rest = b""
    while block := file.read(2**20):
        *whole, rest = (rest + block).split(b"\n")
        for line in whole:
            yield line + b"\n"
        if len(rest) > _LONGEST_LINE:
            raise _error(path, "it has a line that is longer than any row", "choose a journal")
    if rest:
        yield rest


def _content(key, row):
    return {"key": key, "status": row.status, "reason": row.reason, "numbers": row.numbers}


def _line(content):
    return json.dumps(content, separators=(",", ":"), allow_nan=False).encode() + b"\n"


def _row(check, content, expected):
    """(key, Row) of a line's content."""
    check.object(content, "the row", {"key", "status", "reason", "numbers"})
    key = content.get("key")
    if not isinstance(key, str) or key not in expected.keys:
        raise check.error("key", "it is of no variant of the study", "take the line out")
    status = check.choice(content.get("status"), "status", STATUSES)
    reason = check.text(content.get("reason"), "reason")
    numbers = check.object(content.get("numbers"), "numbers", expected.columns)
    columns = () if status == REFUSED else expected.columns
    if len(numbers) != len(columns):
        raise check.error("numbers", f"there are {len(numbers)}", f"{len(columns)} are wanted")
    return key, Row(status, reason, {name: _number(check, numbers[name]) for name in columns})


def _number(check, value):
    if value is None:
        return None
    if not isinstance(value, float) or not isfinite(value):
        raise check.error("numbers", "one is no number", "take the line out")
    return value


def _error(path, problem, remedy):
    return HullFileError(f"{path.name}: {problem}; {remedy}.")
