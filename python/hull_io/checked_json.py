# SPDX-License-Identifier: GPL-3.0-or-later
"""JSON from an untrusted file, and the checks that turn its values into plain Python ones."""

import json
import math

from .errors import HullFileError
from .limits import LONGEST_TEXT


def shown(value):
    """A value for a message, cut to a readable length."""
    text = json.dumps(value) if isinstance(value, (str, int, float)) else type(value).__name__
    return text if len(text) <= 40 else text[:37] + "..."


def _either(choices):
    *first, last = (f'"{choice}"' for choice in choices)
    return f"{', '.join(first)} or {last}" if first else last


class CheckedJson:
    """Checks of single values; `where` is the key that a HullFileError names. before: what comes
    before each."""

    def __init__(self, file_name, before=""):
        self.file_name = file_name
        self._before = before

    def within(self, before):
        """The same checks for a part of the file whose keys come after `before`."""
        return CheckedJson(self.file_name, self._before + before)

    def error(self, where, problem, remedy):
        return HullFileError(f"{self.file_name}: {self._before}{where}: {problem}; {remedy}.")

    def parse(self, data):
        """The object { } that the bytes of a whole file hold."""
        try:
            content = json.loads(data.decode("utf-8-sig"), parse_constant=self._refuse_constant)
        except UnicodeDecodeError as error:
            where, problem = f"byte {error.start}", "it is not UTF-8 text"
        except json.JSONDecodeError as error:
            where = f"line {error.lineno}, column {error.colno}"
            problem = f"it is not JSON ({error.msg[0].lower()}{error.msg[1:]})"
        except RecursionError:
            where, problem = "the file", "lists are nested too deep"
        except HullFileError:
            raise
        except ValueError:
            where, problem = "the file", "a number has too many digits"
        else:
            return self.object(content, "the file")
        raise self.error(where, problem, "mend it there or use another copy")

    def _refuse_constant(self, word):
        raise self.error("the file", f"{word} is not a number", "write a finite number")

    def list(self, value, where, length=None, most=None):
        """A list, of `length` entries where that is given, or of so many at most."""
        if not isinstance(value, list):
            raise self.error(where, f"{shown(value)} is no list", "write a list [ ]")
        if length is not None and len(value) != length:
            raise self.error(
                where, f"it has {len(value)} entries, not {length}", f"write {length} entries"
            )
        if most is not None and len(value) > most:
            raise self.error(where, f"it has {len(value)} entries", f"write at most {most}")
        return value

    def object(self, value, where, keys=None):
        """An object { } with no other keys than `keys` (all are taken where None)."""
        if not isinstance(value, dict):
            raise self.error(where, f"{shown(value)} is no object", "write an object { }")
        for key in value if keys is not None else ():
            if key not in keys:
                raise self.error(
                    where, f"the key {shown(key)} is unknown", "take it out or correct its spelling"
                )
        return value

    def number(self, value, where, lowest, highest):
        """A float from lowest to highest."""
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if not is_number or not lowest <= value <= highest or not math.isfinite(value):
            raise self.error(
                where,
                f"{shown(value)} is not a number from {lowest:g} to {highest:g}",
                "correct it",
            )
        return float(value)

    def index(self, value, where, count, of):
        """An index of one of `count` things called `of`."""
        if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < count:
            raise self.error(
                where, f"{shown(value)} is no index of a {of}", f"{of}s are 0 to {count - 1}"
            )
        return value

    def faces_apart(self, value, where, count, seen):
        """A list of one or more of `count` faces, of which none is in the set `seen`: they are put
        into it."""
        faces = self.list(value, where)
        if not faces:
            raise self.error(where, "it is empty", "name at least one face")
        for place, face in enumerate(faces):
            self.index(face, f"{where}[{place}]", count, "face")
            if face in seen:
                raise self.error(f"{where}[{place}]", "it is named twice", "name it once")
            seen.add(face)
        return faces

    def choice(self, value, where, choices):
        """One of some texts."""
        if value not in choices:
            raise self.error(where, f"{shown(value)} is unknown", f"write {_either(choices)}")
        return value

    def flag(self, value, where):
        if not isinstance(value, bool):
            raise self.error(where, f"{shown(value)} is not true or false", "write one of them")
        return value

    def text(self, value, where):
        if not isinstance(value, str) or len(value) > LONGEST_TEXT:
            raise self.error(
                where, f"it is no text of at most {LONGEST_TEXT} characters", "write a short text"
            )
        # JSON may name these by their numbers; no text that is to be shown or stored has them.
        for place, letter in enumerate(value):
            if letter < " " and letter not in "\t\n" or "\ud800" <= letter <= "\udfff":
                raise self.error(
                    where, f"character {place} is no letter ({letter!a})", "take it out"
                )
        return value
