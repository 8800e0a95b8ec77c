# SPDX-License-Identifier: GPL-3.0-or-later
"""Slits along the centre line of a whole hull: both sides have borders there, with points of their
own at the same places, so that they look joined and are not."""

import numpy as np
from mathutils import kdtree

from .face_sides import ends_of_sides


def pairs(points, face_sizes, face_vertices, on_plane, reach):
    """(k, 2) points (k pairs) that are to become one for the two sides to be joined.

    on_plane: (n,) which points are on the centre plane. reach: how far two points of one place are
    apart at most. Only where two borders, and no third edge, run between the same two places, in
    the opposite sense: anything else would make no surface when joined.
    """
    ends = ends_of_sides(face_sizes, face_vertices)
    ends = ends[on_plane[ends].all(axis=1)]
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
