# SPDX-License-Identifier: GPL-3.0-or-later
"""Bounded reading of FREE!ship's two encodings, binary and text, through one interface.

A cursor walks over bytes that are already in memory and never trusts them: a length or a count is
held against the bytes that are left before anything is made from it. Records are named by a layout
of one letter per value: `i` integer, `f` real, `?` boolean. `element` says what is being read and
appears in every error. Errors are HullFileError.
"""

import struct

from .errors import HullFileError
from .limits import MAX_COUNT

CODE_PAGE = "cp1251"
REMEDY = "save it again from FREE!ship or use another copy"


class Cursor:
    """What both encodings share: the place in the data, counts, and errors."""

    def __init__(self, data, file_name):
        self.data = data
        self.file_name = file_name
        self.offset = 0
        self.start = 0
        self.element = "the header"

    def error(self, problem, remedy=REMEDY):
        return HullFileError(
            f"{self.file_name}: {self.element}, {self.place()}: {problem}; {remedy}."
        )

    def count(self, element, layout, limit=MAX_COUNT):
        """A count of `element`, each at least one record of `layout`; refused when impossible."""
        self.element = f"the number of {element}"
        (number,) = self.record("i")
        if number < 0:
            raise self.error(f"it is {number}, which can't be")
        if number > limit:
            raise self.error(f"it is {number}, more than the {limit} that are read")
        if number > self.most_records(layout):
            raise self.error(
                f"it is {number}, more than the rest of the file can hold; "
                "the file is cut short or damaged"
            )
        return number


class BinaryCursor(Cursor):
    """`.fbm`: packed little-endian values; 32-bit integers and reals, one-byte booleans."""

    def place(self):
        return f"byte {self.start}"

    def most_records(self, layout):
        return (len(self.data) - self.offset) // struct.calcsize("<" + layout)

    def record(self, layout):
        """The values of one record, as a tuple."""
        layout = "<" + layout
        self.start = self.offset
        end = self.offset + struct.calcsize(layout)
        if end > len(self.data):
            raise self.error("the file ends here, cut short")
        values = struct.unpack_from(layout, self.data, self.offset)
        self.offset = end
        return values

    def _take(self, length, what):
        if not 0 <= length <= len(self.data) - self.offset:
            raise self.error(
                f"a {what} of {length} bytes is announced, but {len(self.data) - self.offset} "
                "bytes are left"
            )
        self.offset += length
        return self.data[self.offset - length : self.offset]

    def text(self):
        """A string: its length, then bytes of the legacy code page; any byte is accepted."""
        (length,) = self.record("i")
        return self._take(length, "text").decode(CODE_PAGE, errors="replace")

    def skip_image(self):
        """Pass over a picture: width, height, length, bytes."""
        _, _, length = self.record("iii")
        self._take(length, "picture")


class TextCursor(Cursor):
    """`.ftm`: one value a line, but several numbers may share a line; decimal commas accepted.

    A line is split at blanks only when numbers are wanted; a string always takes a whole line.
    """

    TRUE_WORDS = {"1", "-1", "true"}
    FALSE_WORDS = {"0", "false"}

    def __init__(self, data, file_name):
        super().__init__(data, file_name)
        self.line = 0
        self.words = []

    def place(self):
        return f"line {max(self.line, 1)}"

    def most_records(self, layout):
        letters_left = len(self.data) - self.offset + sum(len(word) + 1 for word in self.words) + 1
        return letters_left // (2 * len(layout))

    def _next_line(self):
        if self.offset >= len(self.data):
            raise self.error("the file ends here, cut short")
        end = self.data.find(b"\n", self.offset)
        end = len(self.data) if end < 0 else end
        line = self.data[self.offset : end]
        self.offset = end + 1
        self.line += 1
        return line

    def record(self, layout):
        """The values of one record, as a tuple."""
        return tuple(self._value(letter) for letter in layout)

    def _value(self, letter):
        if not self.words:
            line = self._next_line().decode(CODE_PAGE, errors="replace")
            self.words = line.split()[::-1] or [""]
        word = self.words.pop()
        try:
            return self._READERS[letter](self, word)
        except ValueError:
            wanted = {"i": "a whole number", "f": "a number", "?": "1 or 0"}[letter]
            raise self.error(f"{wanted} is wanted, but there is '{word[:40]}'") from None

    def _integer(self, word):
        number = int(self._plain(word))
        if not -(2**31) <= number < 2**31:
            raise ValueError
        return number

    def _real(self, word):
        return float(self._plain(word).replace(",", "."))

    def _boolean(self, word):
        word = word.lower()
        if word not in self.TRUE_WORDS and word not in self.FALSE_WORDS:
            raise ValueError
        return word in self.TRUE_WORDS

    @staticmethod
    def _plain(word):
        """The word itself, unless it is longer than a number or spelt as only Python reads it."""
        if len(word) > 40 or "_" in word:
            raise ValueError
        return word

    _READERS = {"i": _integer, "f": _real, "?": _boolean}

    def text(self):
        """A string: one whole line, in which \\n and \\\\ stand for a line end and a backslash."""
        if self.words:
            raise self.error(f"a text on its own line is wanted, but '{self.words[-1]}' is left")
        line = self._next_line().decode(CODE_PAGE, errors="replace").rstrip("\r")
        parts = [part.replace("\\n", "\n") for part in line.split("\\\\")]
        return "\\".join(parts)

    def skip_image(self):
        """Pass over a picture: width, height, length, one line of hexadecimal digits."""
        self.record("iii")
        self._next_line()
