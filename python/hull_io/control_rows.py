# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of a control mesh: points that follow one another across faces, as on the lines of a net.

A row goes on across a point of four faces to the edge that has no face with the one it comes by,
along a border to the border's next edge, and along a crease to the crease's. It ends where none of
these tells how: at irregular points, at the border that it comes across, where creases meet. Where
it crosses a crease or passes a corner it has a knuckle.
"""

from dataclasses import dataclass

import numpy as np

from .hull_data import edge_key

LEAST_POINTS = 3


@dataclass(frozen=True)
class Row:
    """points: control points in their order, (n,); is_closed: the first follows the last, and is
    not there twice. knuckles: places in `points`, rising, ends left out unless it is closed."""

    points: np.ndarray
    is_closed: bool
    knuckles: tuple

    def parts(self):
        """(places in `points`, whether closed) of each part between knuckles, which belong to
        both."""
        count, knuckles = len(self.points), self.knuckles
        if not self.is_closed:
            borders = [0, *knuckles, count - 1]
        elif not knuckles:
            return [(np.arange(count), True)]
        else:
            borders = [*knuckles, knuckles[0] + count]
        pairs = zip(borders, borders[1:])
        return [(np.arange(first, last + 1) % count, False) for first, last in pairs]


class RowNet:
    """The edges of a control mesh, and how rows go on along them; edges are pairs of its points,
    the lower one first.

    control: has face_sizes, face_vertices, creases (k, 2) and corners, as ShellArrays.
    """

    def __init__(self, control):
        self._faces = _faces_of_edges(control)
        self._around = {}
        for edge in self._faces:
            for point in edge:
                self._around.setdefault(point, []).append(edge)
        creases = {edge_key(*edge) for edge in np.asarray(control.creases).reshape(-1, 2).tolist()}
        borders = {edge for edge, faces in self._faces.items() if len(faces) == 1}
        self._creases, self._borders = creases | borders, borders
        self._corners = set(np.asarray(control.corners).tolist())

    def edges_at(self, point):
        return self._around.get(point, [])

    def following(self, edge, point):
        """The edge on which a row goes on that comes along an edge to one of its points, or
        None."""
        around = self.edges_at(point)
        for lines in (self._borders, self._creases):
            along = [other for other in around if other in lines]
            if edge in lines and len(along) == 2 and len(around) > 2:
                return _other(along, edge)
        if len(around) != 4 or any(other in self._borders for other in around):
            return None
        across = [other for other in around if not self._faces[edge] & self._faces[other]]
        is_like = len(across) == 1 and (across[0] in self._creases) == (edge in self._creases)
        return across[0] if is_like else None

    def row_through(self, edge, within=None):
        """The Row that an edge is of, along edges `within` alone unless None."""
        edges, closed = self._walk(edge, edge[0], within)
        if closed:
            points = _points_along(edges)[:-1]
        else:
            back, _ = self._walk(edge, edge[1], within)
            edges = back[:0:-1] + edges
            points = _points_along(edges)
        own = set(edges)
        inner = range(len(points)) if closed else range(1, len(points) - 1)
        knuckles = tuple(place for place in inner if self._is_knuckle(points[place], own))
        return Row(np.array(points, dtype=np.int64), closed, knuckles)

    def rows_of(self, edges, are_whole=True):
        """The Rows of edges, each once: whole ones, or the parts along these edges alone."""
        wanted = {edge_key(*edge) for edge in edges} & self._faces.keys()
        rows, seen = [], set()
        for edge in sorted(wanted):
            if edge not in seen:
                rows.append(self.row_through(edge, None if are_whole else wanted))
                seen |= set(edges_of(rows[-1]))
        return rows

    def _walk(self, edge, start, within):
        """(edges from one on, away from its point `start`, whether they come back to it)."""
        edges, seen, point = [edge], {edge}, _end(edge, start)
        while True:
            following = self.following(edges[-1], point)
            if following == edge and len(edges) > 2:
                return edges, True
            if following is None or following in seen or not _is_in(following, within):
                return edges, False
            edges.append(following)
            seen.add(following)
            point = _end(following, point)

    def _is_knuckle(self, point, own):
        creases = self._creases.intersection(self.edges_at(point))
        return point in self._corners or len(creases) > 2 or bool(creases and not creases & own)


def edges_of(row):
    """The edges of a Row, in their order."""
    points = row.points.tolist()
    following = points[1:] + (points[:1] if row.is_closed else [])
    return [edge_key(a, b) for a, b in zip(points, following)]


def _is_in(edge, within):
    return within is None or edge in within


def _end(edge, start):
    return edge[1] if edge[0] == start else edge[0]


def _other(pair, edge):
    return pair[1] if pair[0] == edge else pair[0]


def _points_along(edges):
    """The points of edges that follow one another."""
    if len(edges) == 1:
        return list(edges[0])
    first = _end(edges[0], (set(edges[0]) & set(edges[1])).pop())
    points = [first]
    for edge in edges:
        points.append(_end(edge, points[-1]))
    return points


def _faces_of_edges(control):
    """{edge: the set of its faces}."""
    found, first = {}, 0
    vertices = np.asarray(control.face_vertices).tolist()
    for face, size in enumerate(np.asarray(control.face_sizes).tolist()):
        corners = vertices[first : first + size]
        for a, b in zip(corners, corners[1:] + corners[:1]):
            found.setdefault(edge_key(a, b), set()).add(face)
        first += size
    return found
