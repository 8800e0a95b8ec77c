# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces that join without making one surface are parted.

A surface has at most two faces at an edge, and around a point its faces are joined over edges.
Where more faces meet at an edge, two stay together: joined another way round, else of the same
layer, else those that go on most smoothly. What stands on a shell, as a bulkhead, comes off, and
the shell stays whole. Of faces that have only a point in common, each part gets a point of its own
at the same place. Points are only added and faces keep their order, so that what is known of both
stays true.
"""

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from .hull_data import edge_key, face_edges

# Faces at an edge of which two may go on: pairs of them are all compared. Hulls have three or four.
_MOST_COMPARED = 32


@dataclass(frozen=True, eq=False)
class Split:
    """faces: lists of indices of points. origins: of each point the old one at its place; the
    points that were there come first, and are their own. points, edges: the old ones that are
    split."""

    faces: list
    origins: list
    points: list
    edges: list

    def carried_points(self, points):
        """Old points with all that came of them, sorted."""
        points = set(points)
        return [new for new, old in enumerate(self.origins) if old in points]

    def carried_edges(self, pairs):
        """Old edges as the edges of the faces that came of them: (a, b) with a < b, sorted."""
        pairs = {edge_key(a, b) for a, b in pairs}
        edges = {edge_key(a, b) for face in self.faces for a, b in face_edges(face)}
        old = self.origins
        return sorted((a, b) for a, b in edges if edge_key(old[a], old[b]) in pairs)


def split(points, faces, layers, shell):
    """The Split of faces, lists of indices into points (n, 3), each with its number in `layers`.

    shell: indices of the faces that are to be one surface; others are left as they are, and so are
    those that are none, with a point twice or fewer than three.
    """
    points = np.asarray(points, dtype=np.float64)
    sound = [index for index in shell if _is_sound(faces[index])]
    users = _users(faces, sound)
    crowded = [edge for edge, at_edge in users.items() if len(at_edge) > 2]
    joins = _joins(points, faces, layers, users)
    while True:
        corners, count = _numbered(faces, sound, joins, len(points))
        if not _cut_where_crowded(faces, sound, corners, joins):
            break
    origins = list(range(len(points))) + [0] * (count - len(points))
    result = [list(face) for face in faces]
    for index in sound:
        result[index] = [corners[index, point] for point in faces[index]]
        for point, new in zip(faces[index], result[index]):
            origins[new] = point
    return Split(result, origins, sorted(set(origins[len(points) :])), sorted(crowded))


def standing_parts(points, faces, layers, shell):
    """Parts of the shell, lists of indices of faces, that stand on others: along an edge at whose
    place two others go on. Bulkheads and decks, split already or not; what is largest is no such
    part. Arguments as those of `split`."""
    distinct, places = np.unique(np.asarray(points, dtype=np.float64), axis=0, return_inverse=True)
    places = places.reshape(-1).tolist()
    at_places = [[places[point] for point in face] for face in faces]
    sound = [index for index in shell if _is_sound(at_places[index])]
    users = _users(at_places, sound)
    joins = _joins(distinct, at_places, layers, users)
    parts = _Sets(len(faces))
    for pairs in joins.values():
        for a, b in pairs:
            parts.join(a, b)
    members = {}
    for index in sound:
        members.setdefault(parts.root(index), []).append(index)
    largest = max(members, key=lambda root: len(members[root]), default=None)
    standing = {
        parts.root(index)
        for edge, at_edge in users.items()
        if len(at_edge) > 2
        for index in set(at_edge).difference(*joins[edge])
    }
    return [members[root] for root in sorted(standing - {largest})]


def _is_sound(face):
    return len(face) >= 3 and len(set(face)) == len(face)


def _users(faces, sound):
    """{edge: the faces that have it}."""
    users = {}
    for index in sound:
        for a, b in face_edges(faces[index]):
            users.setdefault(edge_key(a, b), []).append(index)
    return users


def _joins(points, faces, layers, users):
    """{edge: pairs of faces that go on across it}."""
    joins = {edge: [tuple(at_edge)] for edge, at_edge in users.items() if len(at_edge) == 2}
    regions = _Sets(len(faces))
    for ((a, b),) in joins.values():
        regions.join(a, b)
    groups = [(regions.root(index), layer) for index, layer in enumerate(layers)]
    for edge, at_edge in users.items():
        if len(at_edge) > 2:
            joins[edge] = _best_pairs(points, faces, groups, edge, at_edge)
    return joins


def _best_pairs(points, faces, groups, edge, at_edge):
    """The pair that is most alike by its groups, then least bent, and of the rest those that are
    bent by less than 90°; of more faces than any hull has at an edge, among the first ones."""
    at_edge = at_edge[:_MOST_COMPARED]
    ways = {index: _way(points, faces[index], edge) for index in at_edge}

    def bend(pair):
        return float(ways[pair[0]] @ ways[pair[1]])

    def unlike(pair):
        return *(a != b for a, b in zip(groups[pair[0]], groups[pair[1]])), bend(pair)

    pairs, left = [], set(at_edge)
    for pair in sorted(combinations(at_edge, 2), key=unlike):
        if left.issuperset(pair) and (not pairs or bend(pair) < 0.0):
            pairs.append(pair)
            left.difference_update(pair)
    return pairs


def _way(points, face, edge):
    """The direction, of length 1, in which a face leads away from one of its edges."""
    start, end = points[edge[0]], points[edge[1]]
    along = (end - start) / max(np.linalg.norm(end - start), np.finfo(float).tiny)
    away = points[face].mean(axis=0) - start
    away = away - (away @ along) * along
    return away / max(np.linalg.norm(away), np.finfo(float).tiny)


def _numbered(faces, sound, joins, count):
    """({(face, old point): its new one}, how many there are): one for each of the parts in which
    the faces around a point are joined, the old number for that of most faces."""
    place = {}
    for index in sound:
        for point in faces[index]:
            place[index, point] = len(place)
    sets = _Sets(len(place))
    for edge, pairs in joins.items():
        for a, b in pairs:
            for point in edge:
                sets.join(place[a, point], place[b, point])
    around = {}
    for corner, number in place.items():
        around.setdefault(corner[1], {}).setdefault(sets.root(number), []).append(corner)
    numbers = {}
    for point, parts in sorted(around.items()):
        for which, part in enumerate(sorted(parts.values(), key=len, reverse=True)):
            new = point if which == 0 else count
            count += which > 0
            numbers.update((corner, new) for corner in part)
    return numbers, count


def _cut_where_crowded(faces, sound, corners, joins):
    """Takes joins away where an edge still has more than two faces, since they are joined another
    way round at both of its ends; whether there was such."""
    users = {}
    for index in sound:
        for a, b in face_edges(faces[index]):
            new = edge_key(corners[index, a], corners[index, b])
            users.setdefault(new, []).append((index, edge_key(a, b)))
    is_cut = False
    for at_edge in users.values():
        if len(at_edge) <= 2:
            continue
        is_cut = True
        edge = at_edge[0][1]
        kept = joins[edge][0] if joins[edge] else at_edge[0][:1]
        for index in {index for index, _ in at_edge}.difference(kept):
            for a, b in face_edges(faces[index]):
                side = edge_key(a, b)
                if edge[0] in side and side != edge:
                    joins[side] = [pair for pair in joins.get(side, ()) if index not in pair]
    return is_cut


class _Sets:
    """Disjoint sets of the numbers from 0 on."""

    def __init__(self, count):
        self._above = list(range(count))

    def root(self, number):
        while self._above[number] != number:
            self._above[number] = self._above[self._above[number]]
            number = self._above[number]
        return number

    def join(self, a, b):
        self._above[self.root(b)] = self.root(a)
