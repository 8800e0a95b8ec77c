# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces are turned consistently and outwards, however they came."""

import hull_io
import numpy as np
import pytest
from hull_io.orientation import consistent_components, face_area_vectors, turn_outwards

# A half box, 10 x 2 x 3, of which single sides are taken; all faces here are turned outwards.
POINTS = np.array([(x, y, z) for x in (0.0, 10.0) for y in (0.0, 2.0) for z in (0.0, 3.0)])
SIDE, BOTTOM, TRANSOM, BOW, DECK = (
    [2, 3, 7, 6],
    [0, 2, 6, 4],
    [0, 1, 3, 2],
    [4, 6, 7, 5],
    [1, 5, 7, 3],
)
OPEN_BOX = [SIDE, BOTTOM, TRANSOM, BOW]


def same_way(face, other):
    """Whether two faces of the same points run around them in the same direction."""
    start = other.index(face[0])
    return other[start:] + other[:start] == face


def assert_restored(points, faces, half, seed):
    random = np.random.default_rng(seed)
    for _ in range(8):
        spoilt = [face[::-1] if random.random() < 0.5 else face for face in faces]
        turned, _ = turn_outwards(points, spoilt, half)
        assert all(same_way(face, back) for face, back in zip(faces, turned)), f"seed {seed}"


@pytest.mark.parametrize(
    "faces",
    [OPEN_BOX, OPEN_BOX + [DECK], [SIDE], [BOTTOM, SIDE], [SIDE, BOW], OPEN_BOX[:2] + [DECK]],
)
def test_parts_of_a_half_box(faces):
    assert_restored(POINTS, faces, True, 1)


def test_the_keel_may_lie_anywhere():
    """The water side does not depend on where the origin of x and z is."""
    for shift in ((-100.0, 0.0, 0.0), (0.0, 0.0, 50.0), (30.0, 0.0, -80.0)):
        assert_restored(POINTS + shift, OPEN_BOX, True, 2)


def test_a_deck_or_bottom_that_touches_nothing_else_is_turned_away_from_the_hull():
    points = np.vstack([POINTS, POINTS])
    loose = [[point + 8 for point in face] for face in (DECK, BOTTOM, TRANSOM, BOW)]
    for face in loose:
        assert_restored(points, OPEN_BOX + [face], True, 3)


def test_a_whole_hull_away_from_the_centre_plane():
    mirrored = POINTS * [1, -1, 1]
    points = np.vstack([POINTS, mirrored])
    # Both halves sewn by making points 0, 1, 4, 5 of the second those of the first.
    image = {point: point if point in (0, 1, 4, 5) else point + 8 for point in range(8)}
    faces = OPEN_BOX + [[image[point] for point in face][::-1] for face in OPEN_BOX]
    assert len(consistent_components(faces)) == 1
    for shift in (0.0, 40.0, -40.0):
        assert_restored(points + [0.0, shift, 0.0], faces, False, 4)


def test_demihulls_and_a_rudder_are_turned_each_for_itself():
    box = OPEN_BOX + [DECK, [0, 4, 5, 1]]
    demihull = POINTS + [0.0, 5.0, 0.0]
    rudder = POINTS * [0.1, 0.05, 0.5] + [-1.5, 0.0, 0.0]
    points = np.vstack([demihull, rudder])
    faces = box + [[point + 8 for point in face] for face in box]
    assert_restored(points, faces, True, 5)


def test_a_plate_in_the_centre_plane_faces_to_port():
    points = POINTS[[0, 4, 5, 1]] * [1.0, 0.0, 1.0]
    assert_restored(points, [[3, 2, 1, 0]], True, 6)


def test_edges_of_three_faces_join_nothing():
    faces = OPEN_BOX + [[2, 6, 8]]
    components = consistent_components(faces)
    assert sorted(len(component) for component in components) == [1, 4]


def test_a_moebius_strip_keeps_its_twist_for_the_mesh_check():
    strip = [[0, 1, 3, 2], [2, 3, 5, 4], [4, 5, 0, 1]]
    points = np.random.default_rng(7).normal(size=(6, 3))
    turned, _ = turn_outwards(points, strip, False)
    edges = [edge for face in turned for edge in zip(face, face[1:] + face[:1])]
    assert len(set(edges)) < len(edges)


def test_area_vectors_of_polygons_of_several_sizes():
    points = np.array([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (1, 3, 0)], dtype=float)
    vectors, centres = face_area_vectors(points, [[0, 1, 2], [0, 1, 2, 3], [0, 1, 2, 4, 3]])
    np.testing.assert_allclose(vectors, [(0, 0, 2), (0, 0, 4), (0, 0, 5)], atol=1e-14)
    np.testing.assert_allclose(centres[1], [1, 1, 0])


def test_reference_hulls_however_their_faces_are_turned(freeship_files):
    for path in freeship_files:
        hull = hull_io.read_hull(path)
        assert_restored(hull.points, hull.faces, hull.half, 8)


def test_reference_hulls_moved_renumbered_and_scaled(freeship_files):
    random = np.random.default_rng(9)
    for path in freeship_files:
        hull = hull_io.read_hull(path)
        order = random.permutation(len(hull.points))
        points = np.empty_like(hull.points)
        points[order] = hull.points * 1e-3 + [7.0, 0.0, -5.0]
        faces = [[int(order[point]) for point in face] for face in hull.faces]
        assert_restored(points, faces, hull.half, 10)
