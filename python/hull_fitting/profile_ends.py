# SPDX-License-Identifier: GPL-3.0-or-later
"""Stem, stern and transom of a hull, which no station tells, as lines beside its table."""

import numpy as np

from .beside import end_to_end
from .beside import hull_native as hn

# Of the size: points are in a plane across; ends of lines are joined.
_ACROSS, _JOINED = 2e-2, 1e-6
# Stations at an end between which stem and stern are told; places on an edge of the control mesh.
_AT_END, _PER_EDGE = 3, 32


def end_lines(surface, stations):
    """Pairs ("Stem", "Stern" or "Transom", (n, 3) points, m) of a half hull: the profile, from
    below upwards, before the last stations and abaft the first; and the rim of a transom, outwards.
    As many points as there are stations, or less."""
    size, count = surface.mesh.size, len(stations)
    at_centre = hn.tolerances.ON_CENTRE_PLANE * size
    if count <= _AT_END or np.asarray(surface.mesh.points)[:, 1].min() < -at_centre:
        return ()
    lines = [
        (chain.kind.lower(), chain.evaluate(np.linspace(0.0, n, _PER_EDGE * n + 1))[0])
        for chain in hn.crease_curves(surface)
        if not chain.closed
        for n in [chain.edge_count]
    ]
    central = [line for _, line in lines if np.abs(line[:, 1]).max() < at_centre]
    found = []
    contours = end_to_end(central, _JOINED * size, -2.0) if central else []
    if contours:
        contour = max(contours, key=lambda line: np.ptp(line[:, 0]))
        contour = contour if contour[0, 0] < contour[-1, 0] else contour[::-1]
        middle = 0.5 * (stations[0] + stations[-1])
        begin = _last(contour[:, 0] < max(stations[-_AT_END], middle))
        end = _last(contour[::-1, 0] > min(stations[_AT_END - 1], middle))
        found += [("Stem", contour[begin:]), ("Stern", contour[::-1][end:])]
    across = [
        line
        for kind, line in lines
        if "crease" in kind
        and np.ptp(line[:, 0]) < _ACROSS * size
        and line[:, 0].max() < stations[0] + _ACROSS * size
    ]
    rims = end_to_end(across, _JOINED * size, -2.0)
    if rims:
        rim = max(rims, key=lambda line: np.ptp(line[:, 1]))
        found.append(("Transom", rim if rim[0, 1] < rim[-1, 1] else rim[::-1]))
    return tuple((name, _fewer(line, count)) for name, line in found if len(line) > 1)


def _last(is_so):
    """The number of the last that is so, or 0."""
    which = np.flatnonzero(is_so)
    return int(which[-1]) if len(which) else 0


def _fewer(line, count):
    """Up to `count` points of a line between which it is straightest: farthest points are taken
    one after the other."""
    kept = [0, len(line) - 1]
    while len(kept) < min(count, len(line)):
        off = np.zeros(len(line))
        for low, high in zip(kept, kept[1:]):
            way = line[high] - line[low]
            share = (line[low : high + 1] - line[low]) @ way / max(way @ way, 1e-300)
            foot = line[low] + np.clip(share, 0.0, 1.0)[:, None] * way
            off[low : high + 1] = np.linalg.norm(line[low : high + 1] - foot, axis=1)
        if off.max() < 5e-5:  # half of the last digit
            break
        kept = sorted({*kept, int(np.argmax(off))})
    return line[kept]
