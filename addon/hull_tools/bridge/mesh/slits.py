# SPDX-License-Identifier: GPL-3.0-or-later
"""Slits: two borders with points of their own at the same places, so that the faces at them look
joined and are not."""

import numpy as np
from mathutils import kdtree

from .face_sides import ends_of_sides

# No line between points of hulls lies across it, but by chance.
_DIRECTION = np.array([0.5773, 0.6412, 0.5055])
_MOST_AT_A_PLACE = 8


def pairs(points, face_sizes, face_vertices, reach, on_plane=None):
    """(k, 2) points (k pairs) that are to become one for the faces to be joined.

    reach: how far two points of one place are apart at most. on_plane: (n,) which points are looked
    at, all by default. Only where two borders, and no third edge, run between the same two places,
    in the opposite sense: anything else would make no surface when joined.
    """
    twice = _are_twice(points, reach)
    if not twice.any():
        return np.empty((0, 2), dtype=np.int64)
    ends = ends_of_sides(face_sizes, face_vertices)
    is_seen = np.ones(len(points), dtype=bool) if on_plane is None else on_plane
    ends = ends[is_seen[ends].all(axis=1) & twice[ends].any(axis=1)]
    directed, uses = np.unique(np.sort(ends, axis=1), axis=0, return_counts=True)
    if np.count_nonzero(uses == 1) < 2:
        return np.empty((0, 2), dtype=np.int64)
    place = _places(points, np.unique(ends), reach)
    by_places = {}
    for first, second in directed.tolist():
        key = tuple(sorted((place[first], place[second])))
        by_places.setdefault(key, []).append((first, second))
    borders = {tuple(edge) for edge in directed[uses == 1].tolist()}
    sense = {tuple(sorted(edge)): edge for edge in map(tuple, ends.tolist())}
    found = set()
    for (start, end), edges in by_places.items():
        if start == end or len(edges) != 2 or not borders.issuperset(edges):
            continue
        one, other = (sense[edge] for edge in edges)
        if place[one[0]] == place[other[1]]:
            found |= {tuple(sorted(pair)) for pair in zip(one, other[::-1]) if pair[0] != pair[1]}
    return _apart(np.array(sorted(found), dtype=np.int64).reshape(-1, 2), face_sizes, face_vertices)


def _are_twice(points, reach):
    """(n,) which points have another one at the same place: quickly, as at each step of a drag."""
    found = np.zeros(len(points), dtype=bool)
    along = points @ _DIRECTION
    order = np.argsort(along)
    along = along[order]
    for step in range(1, min(len(points), _MOST_AT_A_PLACE)):
        near = np.flatnonzero(along[step:] - along[:-step] <= reach)
        if not len(near):
            break
        one, other = order[near], order[near + step]
        is_same = np.linalg.norm(points[one] - points[other], axis=1) <= reach
        found[one[is_same]] = found[other[is_same]] = True
    return found


def _places(points, indices, reach):
    """{point: the first point at the same place}."""
    tree, place = kdtree.KDTree(len(indices)), {}
    for index in indices.tolist():
        tree.insert(points[index], index)
    tree.balance()
    for index in indices.tolist():
        if index not in place:
            for _, other, _ in tree.find_range(points[index], reach):
                place.setdefault(other, index)
    return place


def _apart(found, face_sizes, face_vertices):
    """The pairs without those of one face, which would lose a corner."""
    face = np.repeat(np.arange(len(face_sizes)), face_sizes)
    faces_of = {}
    for vertex, number in zip(face_vertices.tolist(), face.tolist()):
        faces_of.setdefault(vertex, set()).add(number)
    is_apart = [faces_of[a].isdisjoint(faces_of[b]) for a, b in found.tolist()]
    return found[np.array(is_apart, dtype=bool)]
