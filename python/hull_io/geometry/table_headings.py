# SPDX-License-Identifier: GPL-3.0-or-later
"""What headings of a table of offsets mean, those of columns and of rows alike."""

import re
from dataclasses import dataclass

from .lengths import Length, length_in, unit_named

_NUMBER = r"""[-+]?\d[\d.]*(?:-\d+)*[-+'"]*(?:\s*(?:mm|cm|m|ft|in)\b)?"""
_BRACKET = re.compile(r"[\[(]\s*([a-z]+)\.?\s*[\])]", re.IGNORECASE)
# In this order: "half-breadth at WL 2" is a waterline, "deck height" no height of its own.
_KINDS = (
    ("knuckles", r"\bon (?:a )?knuckles?\b"),
    ("waterline", r"\b(?:w\.?l\.?|water\s?lines?)(?=[\s\d.:=]|$)"),
    ("buttock", r"\b(?:buttocks?|butt\.?|bk\.?|b\.?l\.?)(?=[\s\d.:=]|$)"),
    ("deck", r"\b(?:deck|sheer|gunwale|rail|bulwark)\b"),
    ("feature", r"\b(?:knuckle|chine|edge|rabbet line)\b"),
    ("profile", r"\b(?:profile|keel|rabbet|c\.?l\.?|cent(?:re|er)\s?line)(?=\W|$)"),
    ("diagonal", r"\b(?:diagonals?|diag\.?)(?=\W|\d|$)"),
    ("stem", r"\b(?:stem|bow|fore? end|forward end)\b"),
    ("stern", r"\b(?:stern|aft(?:er)? end|transom)\b"),
    ("x", r"^(?:x|position|distance|abscissa|from a\.?p)\b"),
    (
        "station",
        r"\b(?:stations?|sta\.?|st\.?|sections?|frames?|fr\.?|ordinates?|ord\.?)(?=\W|\d|$)",
    ),
)
# "Above BL", "from the centre line", "above WL 0": where a length is measured from, which names no
# line.
_DATUM = re.compile(
    r"\b(?:above|over|from)\s+(?:the\s+)?"
    r"(?:b\.?l\.?|base\s?line|c\.?l\.?|cent(?:re|er)\s?line|w\.?l\.?|water\s?line)"
    r"(?:\s*0+(?:\.0*)?(?:\s*(?:mm|cm|m|ft|in)\b)?)?(?!\w|\s*[-+.]?\d)"
)
# "Heights above WL 1": from where z = 0 is not.
_OTHER_DATUM = re.compile(
    r"heights?\b.*\b(?:above|over|from)\s+(?:the\s+)?(?:w\.?l\.?|water\s?line|base\s?line)"
    r"\s*[-+.]?\d[^;,\t]*"
)
# In a title: all lines of a kind, none of which has a number.
_ALL_LINES = re.compile(
    r"\b(?:on|at|of|along|for)\s+(?:the\s+)?(?:buttocks?(?:\s?lines)?|water\s?lines?|w\.?l\.?s?)"
    r"(?=\W|$)|^\s*(?:buttocks?|water\s?lines?)(?=\s+(?:half|breadth|height))"
)
_BREADTH = re.compile(r"half|breadth|width|beam|\bhb\b|\by\b|offset")
_HEIGHT = re.compile(r"height|\bht\b|\bhgt\b|\bz\b|above")


@dataclass(frozen=True)
class Heading:
    """kind: of _KINDS, "number" (a position alone) or "" (nothing known). position: Length or None.
    what: "half_breadth", "height" or "". unit: of the values below it, where it is told."""

    kind: str
    text: str
    position: Length | None = None
    what: str = ""
    unit: str | None = None

    @property
    def is_line(self):
        """Whether it names what stations are measured at."""
        return self.kind in ("waterline", "buttock", "deck", "feature", "profile", "stem", "stern")


def heading_of(cell):
    """The Heading of a cell. ValueError for impossible feet and inches."""
    text = cell.strip()[:200]
    units = [unit_named(word) for word in _BRACKET.findall(text)]
    unit = next((unit for unit in units if unit), None)
    bare = _BRACKET.sub(" ", text).strip().lower()
    alone = length_in(bare)
    if alone is not None:
        return Heading("number", text, alone, unit=unit)
    named = _DATUM.sub(" ", bare)
    kind = next((kind for kind, pattern in _KINDS if re.search(pattern, named)), "")
    what = "half_breadth" if _BREADTH.search(bare) else "height" if _HEIGHT.search(bare) else ""
    position = None
    if kind in ("waterline", "buttock", "station"):
        # After the word itself: "2 m WL" is as usual as "WL 2 m", but numbers in names are not.
        found = re.search(_NUMBER, named)
        position = length_in(found[0]) if found else None
    return Heading(kind, text, position, what, unit)


def block_of(cells):
    """ "half_breadth" or "height" where a line without numbers is the title of such a block; ""
    elsewhere."""
    words = _DATUM.sub(" ", " ".join(cells).lower())
    if re.search(r"\d", words):
        return ""
    if re.search(r"half[- ]?breadth|half[- ]?width|breadths", words):
        return "half_breadth"
    return "height" if re.search(r"heights?", words) else ""


def is_title(cells):
    """Whether a line is the title of a block and names no single line, nor columns: "Heights above
    BL", "Half-breadths on waterlines"."""
    filled = [cell for cell in cells if cell]
    if not block_of(filled) or len(filled) > 1 and any(" " in cell for cell in filled):
        return False
    words = _ALL_LINES.sub(" ", _DATUM.sub(" ", " ".join(filled).lower()))
    heading = heading_of(words)
    return not heading.is_line and heading.position is None


def has_other_datum(cells):
    """Whether a line is the title of heights that are not measured from the base line."""
    filled = [cell for cell in cells if cell]
    if len(filled) > 1 and any(" " in cell for cell in filled):
        return False
    return _OTHER_DATUM.fullmatch(_DATUM.sub(" ", " ".join(filled).lower())) is not None
