# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections at any x of a hull that is told by a table of offsets, from its waterlines, its profile
and its deck edge."""

import numpy as np

from .beside import lengths_along, points_at, where_x_is
from .table_curves import Station
from .table_lines import station_line

# Of the length: a station is at x; heights are the same; the contour is within the keel's part.
_AT, _SAME, _SLACK, _NEAR = 2e-4, 1e-6, 1e-6, 1e-3


class TableSections:
    """Has at(x, on_counter) as GirthLines. outline: the HullOutline of the TableCurves."""

    def __init__(self, curves, outline, waterlines):
        self.outline, self._curves = outline, curves
        self._lengths = outline.lengths
        self._levels = {}
        for line in waterlines:
            order = np.argsort(line[:, 0], kind="stable")
            self._levels.setdefault(float(line[0, 2]), []).append(line[order])

    def at(self, x, on_counter=False):
        """(n, 3) m: the section at x, from the contour to the deck edge; on_counter: the one that
        begins abaft the arch. ValueError where there is none."""
        outline = self.outline
        crossings = where_x_is(outline.contour, x)
        if on_counter:
            start = ([t for t in crossings if t <= outline.arch] or [outline.arch])[-1]
        else:
            crossings = [t for t in crossings if self._on_keel(t)]
            if not crossings:
                raise ValueError(f"The contour does not come to x = {x:.3f} m.")
            start = crossings[0]
        line = self.piece(x, outline.on_contour(start)[2])
        if line is None:
            raise ValueError(f"The table has no section at x = {x:.3f} m.")
        return line

    def _on_keel(self, at):
        outline = self.outline
        low = 0.0 if outline.post is None else outline.post
        high = self._lengths[-1] if outline.stem is None else outline.stem
        slack = _SLACK * outline.length
        return low - slack <= at <= high + slack

    def piece(self, x, low, high=np.inf):
        """(n, 3) m: the section at x from the centre plane at the height low to the deck edge, or
        to the centre plane at `high`; None where nothing is there."""
        length, same = self.outline.length, _SAME * self.outline.length
        for station in self._curves.stations:
            is_there = abs(station.x - x) < _AT * length
            ends = station.points[[0, -1], 2]
            is_there &= abs(ends[0] - low) < _NEAR * length
            if station.is_dense and high < np.inf:
                is_there &= abs(ends[1] - high) < _NEAR * length
            if is_there and (high == np.inf or station.is_dense):
                line = station_line(station, length)
                line[:, 0] = x
                return line
        places = [(x, 0.0, low, False)]
        top = self._deck_at(x)
        end = high if high < np.inf else top[2] if top is not None else np.inf
        for z, pieces in self._levels.items():
            # Where the bottom is flat, the level is that of the contour itself.
            if not low - same <= z < end - same:
                continue
            y = _breadth(pieces, x)
            if y is not None and (y > same or z > low + same):
                places.append((x, y, z, False))
        for line in self._curves.knuckles:
            for t in where_x_is(line, x)[:1]:
                _, y, z = points_at(line, lengths_along(line), t)
                if low + same < z < end - same:
                    places = [p for p in places if abs(p[2] - z) > same or abs(p[1] - y) > same]
                    places.append((x, y, z, True))
        places = [places[0], *sorted(places[1:], key=lambda place: place[2])]
        if high < np.inf:
            places.append((x, 0.0, high, False))
        elif top is not None:
            places.append((*top, False))
        if len(places) < 2:
            return None
        points = np.array([place[:3] for place in places])
        kept = np.append(True, np.abs(np.diff(points, axis=0)).max(axis=1) > same)
        sharp = np.array([place[3] for place in places])
        if kept.sum() < 2:
            return None
        return station_line(Station(x, points[kept], sharp[kept]), length)

    def _deck_at(self, x):
        deck = self.outline.deck
        there = where_x_is(deck, x)
        return points_at(deck, lengths_along(deck), there[-1]) if there else None

    def lines_at(self, x):
        """The pieces (n, 3), m, of the section at x from below: from where the contour is crossed
        to where it is next, or to the deck edge."""
        contour = self.outline.contour
        heights = sorted(
            float(points_at(contour, self._lengths, t)[2]) for t in where_x_is(contour, x)
        )
        ends = [*heights, np.inf] if len(heights) % 2 else heights
        pieces = (self.piece(x, *ends[i : i + 2]) for i in range(0, len(ends), 2))
        return [line for line in pieces if line is not None]


def _breadth(pieces, x):
    """y of the piece of a waterline that x is in, None where it is in none."""
    for line in pieces:
        if line[0, 0] <= x <= line[-1, 0]:
            return float(np.interp(x, line[:, 0], line[:, 1]))
    return None
