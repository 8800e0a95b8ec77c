# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading files of chines. The formats are those that FREE!ship's readers take:

Carlson's Hulls (`.hul`): one value a line, what follows it in the line passed over; inches. How
many points a bulkhead has; of each of five bulkheads, of each point, from the keel to the sheer,
half-breadth, height, and place aft of any origin; one line; of thirteen intermediate bulkheads the
same; eight stations; nine lines about the rig; designer; name. Only the five bulkheads are needed.

Carene (`.xyz`): a description of 18 letters; for each chine a line that begins with LINE, one more
line, and lines x y z up to an empty one; metres.

Text: a line 0 (metres) or 1 (feet); chines as lines x y z, an empty line between them; EOF.
"""

from dataclasses import dataclass

import numpy as np

from ..errors import HullFileError
from ..limits import FURTHEST_POINT, MAX_COUNT, MAX_GEOMETRY_CURVES
from ..table_text import decoded

_INCH, _FOOT = 0.0254, 0.3048
_CARLSON_BULKHEADS = 5
_MOST_CARLSON_CHINES = 100


@dataclass(frozen=True)
class Chines:
    """name: of the boat. curves: (n, 3) each, n >= 2, m, x forward, y to port or to the side, z up,
    in the file's order. units: "m" or "ft". source: the program."""

    name: str
    curves: tuple
    units: str
    source: str


def looks_like_chines(data, ending):
    """Whether bytes of a file of this ending ('.hul', in small letters) are chines."""
    if ending == ".hul":
        return True
    start = data[:4096]
    if b"\0" in start:
        return False
    lines = [line.strip() for line in decoded(data).splitlines()]
    if ending == ".xyz" and any(line.startswith("LINE") for line in lines[1:]):
        return True
    said = [line for line in lines if line]
    return len(said) > 3 and said[0] in ("0", "1") and said[-1].upper() == "EOF"


def read_chines(data, file_name):
    """The Chines of a file's bytes; HullFileError with line and remedy."""
    reader = _Lines(decoded(data).splitlines(), file_name)
    if file_name.lower().endswith(".hul"):
        return _carlson(reader)
    if file_name.lower().endswith(".xyz"):
        return _carene(reader)
    return _text(reader)


class _Lines:
    """Lines of a text, one after another."""

    def __init__(self, lines, file_name):
        self.lines, self.file_name, self.number = lines, file_name, 0

    def error(self, problem, remedy="mend it, or use another copy"):
        return HullFileError(f"{self.file_name}: line {self.number}: {problem}; {remedy}.")

    @property
    def is_at_end(self):
        return self.number >= len(self.lines)

    def next(self):
        if self.is_at_end:
            raise self.error("the file ends here, cut short")
        self.number += 1
        return self.lines[self.number - 1].strip()

    def numbers(self, line, count):
        words = line.replace(";", " ").split()
        try:
            found = [float(word.replace(",", ".")) for word in words[:count]]
        except ValueError:
            found = []
        if len(found) < count:
            wanted = "a number is wanted" if count == 1 else "x, y and z are wanted"
            raise self.error(f"{wanted}, but there is '{line[:40]}'")
        if not all(abs(value) <= FURTHEST_POINT for value in found):
            raise self.error(f"'{line[:40]}' can't be of a boat")
        return found


def _carlson(reader):
    count = reader.numbers(reader.next(), 1)[0]
    if not (count == int(count) and 2 <= count <= _MOST_CARLSON_CHINES):
        raise reader.error(f"a boat of {count:g} chines can't be", "give a whole number from 2")
    points = np.empty((_CARLSON_BULKHEADS, int(count), 3))
    for bulkhead in points:
        for point in bulkhead:
            for axis in (1, 2, 0):
                point[axis] = _INCH * reader.numbers(reader.next(), 1)[0]
    points[:, :, 0] = points[:, :, 0].max() - points[:, :, 0]
    designer, name = reader.lines[-2:] if len(reader.lines) > 60 else ("", "")
    is_name = any(letter.isalpha() for letter in name)
    return Chines(
        name.strip() if is_name else "",
        tuple(points[:, k] for k in range(int(count))),
        "ft",
        "Carlson's Hulls" + (f", {designer.strip()}" if is_name and designer.strip() else ""),
    )


def _carene(reader):
    name = reader.next()[:18].strip()
    curves = []
    while not reader.is_at_end:
        if not reader.next().startswith("LINE"):
            continue
        reader.next()
        curve = []
        while not reader.is_at_end and (line := reader.next()):
            curve.append(reader.numbers(line, 3))
        curves.append(curve)
    return Chines(name, _checked(reader, curves), "m", "Carene")


def _text(reader):
    unit = reader.next()
    if unit not in ("0", "1"):
        raise reader.error(f"'{unit[:20]}' is neither 0 (metres) nor 1 (feet)", "give one of them")
    scale = _FOOT if unit == "1" else 1.0
    curves = [[]]
    while not reader.is_at_end:
        line = reader.next()
        if line.upper() == "EOF":
            break
        if not line:
            curves.append([])
            continue
        curves[-1].append([scale * value for value in reader.numbers(line, 3)])
    curves = [curve for curve in curves if curve]
    return Chines("", _checked(reader, curves), "ft" if unit == "1" else "m", "chines as text")


def _checked(reader, curves):
    """The curves as arrays, without points that are there twice in a row."""
    if len(curves) > MAX_GEOMETRY_CURVES or sum(map(len, curves)) > MAX_COUNT:
        raise reader.error("there are more chines or points than a boat has", "thin them out")
    found = []
    for curve in curves:
        points = np.array(curve, dtype=float).reshape(-1, 3)
        keep = np.ones(len(points), dtype=bool)
        keep[1:] = (points[1:] != points[:-1]).any(axis=1)
        if keep.sum() >= 2:
            found.append(points[keep])
    if len(found) < 2:
        raise reader.error(
            f"there are {len(found)} chines of two points or more, and a hull has two at least",
            "give keel and sheer, too",
        )
    return tuple(found)
