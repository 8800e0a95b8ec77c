# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists of points: x, y and z in each line, what follows them passed over.

Empty lines, words, and lines of one number break the list into curves; words name the one that
follows, or the unit ("unit: mm"). Without breaks points that come section by section, one
coordinate
the same, are curves, too; all others are points in no order.
"""

import re

import numpy as np

from ..errors import HullFileError
from ..limits import FURTHEST_POINT, MAX_GEOMETRY_CURVES, MAX_GEOMETRY_POINTS
from ..table_text import number_in, table_rows
from .lengths import unit_named
from .values import Geometry, polyline

_UNIT = re.compile(r"(?i)units?\W+([a-z]+)\W*")
# Curves that are found by one coordinate have at least so many points, and there are so many.
_LEAST_IN_SECTION, _LEAST_SECTIONS = 3, 3


def read_points(text, name):
    """The Geometry of a text. HullFileError with line and remedy."""
    points = _plain_points(text)
    runs, unit = ([("", points)], None) if points is not None else _runs(text, name)
    count = sum(len(run) for _, run in runs)
    if count < 2:
        raise HullFileError(
            f"{name}: no two points are found; give x, y and z in each line, such as '12.5 "
            f"3.0 1.2'."
        )
    if len(runs) > MAX_GEOMETRY_CURVES or count > MAX_GEOMETRY_POINTS:
        raise HullFileError(
            f"{name}: it has more than {MAX_GEOMETRY_POINTS} points or {MAX_GEOMETRY_CURVES} "
            "curves; thin them out."
        )
    for _, run in runs:
        if len(run) and not np.abs(run).max() <= FURTHEST_POINT:
            raise HullFileError(
                f"{name}: a point lies further than {FURTHEST_POINT:.0f} from the origin; give "
                "metres or millimetres, and take out points that are none."
            )
    if len(runs) == 1:
        sections = _sections(runs[0][1])
        if sections is None:
            return Geometry(name, "points", unit, points=runs[0][1])
        runs = [("", section) for section in sections]
    curves = [
        polyline(run, name=words or f"curve {number}")
        for number, (words, run) in enumerate(runs, 1)
    ]
    single = [run for (_, run), curve in zip(runs, curves) if curve is None and len(run)]
    return Geometry(
        name,
        "points",
        unit,
        tuple(curve for curve in curves if curve is not None),
        points=np.concatenate([run[:1] for run in single]) if single else np.empty((0, 3)),
    )


def _plain_points(text):
    """(n, 3) of a text of nothing but three numbers in each line, which may have millions; None for
    others."""
    if not re.fullmatch(r"[-+0-9.eE \t\r\n]*", text) or re.search(r"\n[ \t\r]*\n", text.strip()):
        return None
    try:
        numbers = np.array(text.split(), dtype=float)
    except ValueError:
        return None
    lines = text.strip().split("\n")
    return numbers.reshape(-1, 3) if {len(line.split()) for line in lines} == {3} else None


def _runs(text, name):
    """([(words, (n, 3))], unit)."""
    runs, unit, last = [("", [])], None, None
    for number, cells in table_rows(text):
        values = [number_in(cell) for cell in cells if cell]
        is_break = last is not None and number > last + 1
        last = number
        if len(values) > 3 and values[0] is None:
            values = values[1:]  # a name before each point
        if len(values) >= 3 and all(value is not None for value in values[:3]):
            if is_break and runs[-1][1]:
                runs.append(("", []))
            if not all(map(np.isfinite, values[:3])):
                raise HullFileError(f"{name}: line {number}: a number is not finite; mend it.")
            runs[-1][1].append(values[:3])
            continue
        words = " ".join(cells).strip()
        if len(values) == 2 and all(value is not None for value in values):
            raise HullFileError(
                f"{name}: line {number}: '{words[:40]}' are two numbers; give x, y and z in each "
                "line."
            )
        told = _UNIT.fullmatch(words)
        if told and unit_named(told[1]):
            unit = unit_named(told[1])
            continue
        is_heading = len(cells) >= 3 and all(len(cell) <= 2 for cell in cells[:3])
        runs.append(("" if is_heading or number_in(words) is not None else words[:100], []))
    filled = [(words, np.array(points)) for words, points in runs if points]
    return filled, unit


def _sections(points):
    """Runs of points that have one coordinate the same; None where the list isn't made so."""
    for axis in range(3):
        ends = np.flatnonzero(np.diff(points[:, axis]) != 0.0) + 1
        # Of points in no order nearly each is a run of its own, which is dear to split.
        counts = np.diff(ends, prepend=0, append=len(points))
        if len(counts) >= _LEAST_SECTIONS and counts.min() >= _LEAST_IN_SECTION:
            return np.split(points, ends)
    return None
