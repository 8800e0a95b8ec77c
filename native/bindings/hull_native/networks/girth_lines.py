# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections of a HullOutline's shell as lines from the contour to the deck edge, at any x.

Between two stations of the network sections are blended from these; where there are none they are
cut from the surface of its patches.
"""

from collections import defaultdict
from functools import cached_property

import numpy as np

from ..polylines import bend_shares, end_to_end, foot_on, lengths_along, points_at, where_x_is

# Points on an edge, parts of a patch's sides, of these more where patches are few, parts of a
# blended section.
_EDGE_PARTS, _PATCH_PARTS, _ALL_PARTS, _BLEND_PARTS = 8, 4, 40, 160
# Of the length: stations are across, ends are joined, a section ends at the border, pieces go on.
_ACROSS, _SAME, _AT_BORDER, _GAP = 1e-6, 1e-7, 3e-3, 3e-3


class GirthLines:
    """surface: (points (n, 3) m, triangles (k, 3)) that the sections are cut from where there is no
    network."""

    def __init__(self, outline, surface=None):
        self.outline, self._surface = outline, surface
        self._contour_lengths = outline.lengths
        self._keel = [
            (x, line) for x, line in self._stations() if self._on_keel(self._contour_at(line[0]))
        ]
        self._counter = [
            (x, line)
            for x, line in self._stations()
            if outline.arch is not None and self._contour_at(line[0]) <= outline.arch
        ]
        if outline.aft is not None:
            stern = (float(np.median(outline.aft[:, 0])), outline.aft)
            (self._keel if outline.arch is None else self._counter).insert(0, stern)

    def at(self, x, on_counter=False):
        """(n, 3) m: the section at x; on_counter: the one that begins abaft the arch. ValueError
        where there is none."""
        outline = self.outline
        crossings = where_x_is(outline.contour, x)
        if on_counter:
            crossings = [t for t in crossings if t <= outline.arch] or [outline.arch]
            start = crossings[-1]
        else:
            crossings = [t for t in crossings if self._on_keel(t)]
            if not crossings:
                raise ValueError(f"The contour does not come to x = {x:.3f} m.")
            start = crossings[0]
        first = outline.on_contour(start)
        line = self._blended(self._counter if on_counter else self._keel, x)
        if line is None:
            return self._cut(x, first)
        line[0] = first
        ends = where_x_is(outline.deck, x)
        if ends:
            line[-1] = points_at(outline.deck, lengths_along(outline.deck), ends[0])
        return line

    def _on_keel(self, at):
        outline = self.outline
        low = 0.0 if outline.post is None else outline.post
        high = self._contour_lengths[-1] if outline.stem is None else outline.stem
        slack = 1e-6 * outline.length
        return low - slack <= at <= high + slack

    def _contour_at(self, place):
        return foot_on(self.outline.contour, self._contour_lengths, place)[0]

    def _stations(self):
        """(x, line) of the network's own curves across the ship from contour to deck, from aft."""
        network, length = self.outline.network, self.outline.length
        if network is None:
            return []
        at_x = defaultdict(list)
        inner = _inner_edges(network, self.outline.in_shell)
        for edge in inner:
            points = network.edge_points(int(edge), _EDGE_PARTS)
            if np.ptp(points[:, 0]) < _ACROSS * length:
                at_x[round(float(points[0, 0]) / (10.0 * _ACROSS * length))].append(points)
        found = []
        for parts in at_x.values():
            for line in end_to_end(parts, _SAME * length, -2.0):
                line = self._from_contour(line)
                if line is not None:
                    found.append((float(line[0, 0]), line))
        return sorted(found, key=lambda station: station[0])

    def _from_contour(self, line):
        """Upwards; None where it does not go all the way."""
        deck, reach = self.outline.deck, _AT_BORDER * self.outline.length

        def apart(border, place):
            return foot_on(border, lengths_along(border), place)[1]

        for whole in (line, line[::-1]):
            if apart(self.outline.contour, whole[0]) < reach and apart(deck, whole[-1]) < reach:
                return whole
        return None

    def _blended(self, stations, x):
        before = [station for station in stations if station[0] <= x]
        after = [station for station in stations if station[0] > x]
        if not (before and after):
            return None
        (low, first), (high, second) = before[-1], after[0]
        share, at = (x - low) / (high - low), np.linspace(0.0, 1.0, _BLEND_PARTS + 1)
        first, second = (points_at(line, bend_shares(line), at) for line in (first, second))
        line = (1.0 - share) * first + share * second
        line[:, 0] = x
        return line

    @cached_property
    def _triangles(self):
        if self._surface is not None:
            return self._surface
        network, count = self.outline.network, 0
        points, triangles = [], []
        parts = max(_PATCH_PARTS, int(_ALL_PARTS / np.sqrt(self.outline.in_shell.sum())))
        for region in np.flatnonzero(self.outline.in_shell):
            patch = network.patch(int(region))
            places, corners = patch.grid(parts)
            points.append(patch.evaluate(places)[0])
            triangles.append(np.asarray(corners) + count)
            count += len(places)
        return np.concatenate(points), np.concatenate(triangles)

    @property
    def surface_points(self):
        """(n, 3) m: points of the patches."""
        return self._triangles[0]

    def _cut(self, x, start):
        pieces = _cut_pieces(*self._triangles, x)
        line, tip = [start[None]], start
        reach = _GAP * self.outline.length
        while pieces:
            gaps = [min(np.linalg.norm(piece[[0, -1]] - tip, axis=1)) for piece in pieces]
            nearest = int(np.argmin(gaps))
            if gaps[nearest] > reach:
                break
            piece = pieces.pop(nearest)
            if np.linalg.norm(piece[-1] - tip) < np.linalg.norm(piece[0] - tip):
                piece = piece[::-1]
            if lengths_along(piece)[-1] < 1e-2 * reach:
                continue
            line.append(piece[np.linalg.norm(piece - tip, axis=1) > 1e-9])
            tip = piece[-1]
        if len(line) == 1:
            raise ValueError(f"The network's surface has no section at x = {x:.3f} m.")
        return np.concatenate(line)


def _inner_edges(network, in_shell):
    beside = defaultdict(list)
    for region in range(network.region_count):
        for side in network.sides(region):
            for edge, _ in side:
                beside[edge].append(in_shell[region])
    return [edge for edge, inside in beside.items() if len(inside) == 2 and all(inside)]


def _cut_pieces(points, triangles, x):
    """Lines in which triangles come through the plane across, each within one patch."""
    off = points[:, 0] - x
    above = off >= 0.0
    count = above[triangles].sum(axis=1)
    beside, places = defaultdict(list), {}
    for corners in triangles[(count > 0) & (count < 3)].tolist():
        ends = []
        for a, b in zip(corners, corners[1:] + corners[:1]):
            if above[a] != above[b]:
                a, b = min(a, b), max(a, b)
                share = off[a] / (off[a] - off[b])
                places[a, b] = (1.0 - share) * points[a] + share * points[b]
                ends.append((a, b))
        beside[ends[0]].append(ends[1])
        beside[ends[1]].append(ends[0])
    lines, seen = [], set()
    for first, others in beside.items():
        if first in seen or len(others) != 1:
            continue
        line, tip = [], first
        while tip is not None:
            seen.add(tip)
            line.append(places[tip])
            tip = next((end for end in beside[tip] if end not in seen), None)
        lines.append(np.array(line))
    return lines
