# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces that join without making one surface are parted, and nothing else is changed."""

from collections import Counter

import numpy as np
import pytest
from hull_io import splitting
from hull_io.splitting import split, standing_parts

SEED = 1204


def edges_of(face):
    return [tuple(sorted(pair)) for pair in zip(face, face[1:] + face[:1])]


def assert_one_surface(faces):
    """At most two faces at an edge, and all at a point joined over edges there."""
    counts = Counter(edge for face in faces for edge in edges_of(face))
    assert max(counts.values()) <= 2
    for point in {point for face in faces for point in face}:
        left = [set(edges_of(face)) for face in faces if point in face]
        left = [{edge for edge in edges if point in edge} for edges in left]
        reached = left.pop()
        while True:
            joined = [edges for edges in left if edges & reached]
            if not joined:
                break
            left = [edges for edges in left if not edges & reached]
            reached = reached.union(*joined)
        assert not left, f"point {point}"


def assert_same_places(points, faces, made):
    assert made.origins[: len(points)] == list(range(len(points)))
    back = [[made.origins[point] for point in face] for face in made.faces]
    assert back == [list(face) for face in faces]


def parted(points, faces, layers=None):
    layers = layers or [0] * len(faces)
    made = split(points, faces, layers, range(len(faces)))
    assert_one_surface(made.faces)
    assert_same_places(points, faces, made)
    return made


def grid(rows, columns):
    """A sheet in the plane z = 0 and its faces."""
    points = [(float(i), float(j), 0.0) for i in range(rows + 1) for j in range(columns + 1)]
    width = columns + 1
    faces = [
        [i * width + j, (i + 1) * width + j, (i + 1) * width + j + 1, i * width + j + 1]
        for i in range(rows)
        for j in range(columns)
    ]
    return points, faces


def test_a_surface_stays_as_it_is():
    points, faces = grid(3, 4)
    made = parted(points, faces)
    assert made.faces == faces and not made.points and not made.edges


def test_two_faces_at_a_point_get_one_each():
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)]
    made = parted(points, [[0, 1, 2], [0, 3, 4]])
    assert made.faces == [[0, 1, 2], [5, 3, 4]]
    assert made.origins[5:] == [0] and made.points == [0] and not made.edges


def with_bulkhead(rows=4, columns=3, height=2):
    """A sheet with a wall on the middle line across."""
    points, faces = grid(rows, columns)
    width = columns + 1
    foot = [rows // 2 * width + j for j in range(width)]
    wall = []
    for level in range(1, height + 1):
        top = list(range(len(points), len(points) + width))
        points += [(float(rows // 2), float(j), float(level)) for j in range(width)]
        wall += [[foot[j], foot[j + 1], top[j + 1], top[j]] for j in range(columns)]
        foot = top
    return points, faces + wall, list(range(len(faces), len(faces) + len(wall)))


def test_a_bulkhead_comes_off_and_the_shell_stays_whole():
    points, faces, wall = with_bulkhead()
    made = parted(points, faces)
    shell = [face for index, face in enumerate(made.faces) if index not in wall]
    assert shell == faces[: len(shell)]
    assert len(made.edges) == 3 and len(made.origins) == len(points) + 4
    assert {made.origins[new] for new in range(len(points), len(made.origins))} == set(made.points)


def test_standing_parts_are_found_before_and_after_the_split():
    points, faces, wall = with_bulkhead()
    layers = [0] * len(faces)
    assert standing_parts(points, faces, layers, range(len(faces))) == [wall]
    made = parted(points, faces)
    places = np.asarray(points)[made.origins]
    assert standing_parts(places, made.faces, layers, range(len(faces))) == [wall]
    assert standing_parts(*grid(3, 3), [0] * 9, range(9)) == []


def test_faces_of_one_layer_stay_together():
    """A deck that meets the side at its foot: by angle alone it would go on into the bulwark."""
    points = [(x, y, z) for y, z in ((2, 0), (2, 3), (0, 3.1), (2.0, 4)) for x in (0, 1)]
    side, deck, bulwark = [0, 1, 3, 2], [2, 3, 5, 4], [2, 3, 7, 6]
    made = parted(points, [deck, side, bulwark], [1, 0, 0])
    assert made.faces[1:] == [side, bulwark] and made.faces[0] != deck


def test_only_the_shell_is_parted():
    points, faces, wall = with_bulkhead()
    shell = [index for index in range(len(faces)) if index not in wall]
    made = split(points, faces, [0] * len(faces), shell)
    assert made.faces == faces and len(made.origins) == len(points)


def test_tags_come_along():
    points, faces, _ = with_bulkhead()
    made = parted(points, faces)
    edge = made.edges[0]
    copies = made.carried_edges([edge])
    assert len(copies) == 2 and edge in copies
    for a, b in copies:
        assert (made.origins[a], made.origins[b]) in (edge, edge[::-1])
    assert len(made.carried_points([edge[0]])) == 2


def test_faces_that_are_none_are_left_alone():
    made = split(
        [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [[0, 1, 2], [0, 0, 1], [1, 2]], [0] * 3, range(3)
    )
    assert made.faces == [[0, 1, 2], [0, 0, 1], [1, 2]]


@pytest.mark.parametrize("trial", range(60))
def test_any_faces_become_a_surface(trial):
    """Faces between few points, joined in every way there is."""
    random = np.random.default_rng(SEED + trial)
    points = random.normal(size=(int(random.integers(4, 12)), 3))
    faces, seen = [], set()
    for _ in range(int(random.integers(2, 30))):
        size = min(int(random.integers(3, 6)), len(points))
        face = random.choice(len(points), size=size, replace=False).tolist()
        if frozenset(face) not in seen:
            seen.add(frozenset(face))
            faces.append(face)
    parted(points, faces, random.integers(0, 3, size=len(faces)).tolist())


@pytest.mark.parametrize("count", [30, 300])
def test_faces_at_one_edge_are_not_all_compared(count, monkeypatch):
    """However many: two go on, opposite pairs too, and the rest come off, each by itself."""
    compared = []
    pairs = splitting.combinations
    monkeypatch.setattr(
        splitting,
        "combinations",
        lambda *given: (compared.append(pair) or pair for pair in pairs(*given)),
    )
    angles = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    points = [(0, 0, 0), (1, 0, 0), *((0.5, np.cos(a), np.sin(a)) for a in angles)]
    made = parted(points, [[0, 1, 2 + k] for k in range(count)])
    assert made.edges == [(0, 1)] and made.points == [0, 1]
    assert 0 < len(compared) <= 500


def test_the_same_faces_give_the_same():
    points, faces, _ = with_bulkhead()
    assert parted(points, faces).faces == parted(points, faces).faces
