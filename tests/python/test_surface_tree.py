# SPDX-License-Identifier: GPL-3.0-or-later
"""Closest points and ray hits by arrays: shapes, what is missed, words on mistakes."""

import hull_native as hn
import numpy as np
import pytest

CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
FACES = np.array(
    [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
)
EDGES = np.array([[a, a | bit] for a in range(8) for bit in (1, 2, 4) if not a & bit])
SEED = 20261121


def cube_surface():
    """The cube [0, 1]^3 itself: all of its edges are creases."""
    return hn.LimitSurface(hn.ControlMesh(CORNERS, np.full(6, 4), FACES.ravel(), creases=EDGES))


@pytest.fixture
def surface():
    return cube_surface()


@pytest.fixture
def tree(surface):
    return hn.SurfaceTree(surface)


def test_closest_points_of_a_cube(surface, tree):
    random = np.random.default_rng(SEED)
    points = random.uniform(-1, 2, (500, 3))
    clamped = points.clip(0, 1)
    outside = np.linalg.norm(points - clamped, axis=1)
    inside = np.minimum(points, 1 - points).min(axis=1)
    found = tree.closest_points(points)
    assert len(found) == 500
    np.testing.assert_allclose(found.distances, np.maximum(outside, inside), atol=1e-14)
    np.testing.assert_allclose(found.points[outside > 0], clamped[outside > 0], atol=1e-13)
    np.testing.assert_array_equal(found.sides, np.where(outside > 0, 1, -1))
    np.testing.assert_allclose(surface.positions(found.cells, found.uv), found.points, atol=1e-14)
    beyond = ((points < 0) | (points > 1)).sum(axis=1)
    np.testing.assert_array_equal(found.kinds[beyond > 0], beyond[beyond > 0] - 1)
    assert found.gaps.max() < 1e-12


def test_what_is_too_far_is_not_found(tree):
    found = tree.closest_points([[0.5, 0.5, 3.0], [0.5, 0.5, 1.5]], max_distance=1.0)
    np.testing.assert_array_equal(found.cells >= 0, [False, True])
    np.testing.assert_array_equal(found.distances, [np.inf, 0.5])
    assert np.isnan(found.points[0]).all() and np.isnan(found.uv[0]).all()


def test_first_hits_of_rays(surface, tree):
    origins = [[0.3, 0.4, 3.0], [0.3, 0.4, 3.0], [0.3, 0.4, 0.5]]
    directions = [[0, 0, -7.0], [0, 0, 1.0], [1.0, 0, 0]]
    hits = tree.ray_hits(origins, directions)
    np.testing.assert_allclose(hits.distances, [2.0, np.inf, 0.7], atol=1e-14)
    np.testing.assert_array_equal(hits.cells < 0, [False, True, False])
    np.testing.assert_allclose(hits.points[0], [0.3, 0.4, 1.0], atol=1e-14)
    assert np.isnan(hits.points[1]).all()
    assert hits.uv.shape == (3, 2)
    assert not hits.grazing.any()
    assert tree.ray_hits(origins, directions, max_distance=1.0).cells[0] == -1


def test_all_hits_of_a_ray(tree):
    hits = tree.all_ray_hits([-1, -1, -1], [2, 2, 2])
    np.testing.assert_allclose(hits.distances, np.sqrt(3) * np.array([1, 2]), atol=1e-12)
    along = tree.all_ray_hits([-1, 0.5, 1], [1, 0, 0])
    np.testing.assert_allclose(along.distances, [1, 2], atol=1e-12)
    assert along.grazing.all()


def test_tree_follows_moved_points_after_refit(surface, tree):
    surface.set_points(2 * CORNERS)
    point = [[0.5, 0.5, 3.0]]
    assert tree.closest_points(point).distances[0] == pytest.approx(2.0)
    tree.refit(surface)
    assert tree.closest_points(point).distances[0] == pytest.approx(1.0)
    with pytest.raises(ValueError, match="another surface"):
        tree.refit(cube_surface())


def test_tree_outlives_its_surface():
    tree = hn.SurfaceTree(cube_surface())
    assert tree.closest_points([[0.5, 0.5, 2.0]]).distances[0] == pytest.approx(1.0)


def test_no_queries_no_answers(tree):
    assert tree.closest_points(np.empty((0, 3))).points.shape == (0, 3)
    assert tree.ray_hits(np.empty((0, 3)), np.empty((0, 3))).distances.shape == (0,)


def test_mistakes_are_named(tree):
    with pytest.raises(ValueError, match=r"points\[1\]"):
        tree.closest_points([[0, 0, 0], [0, np.nan, 0]])
    with pytest.raises(ValueError, match="max_distance"):
        tree.closest_points([[0, 0, 0]], max_distance=-1)
    with pytest.raises(ValueError, match="but is -1e-11"):
        tree.closest_points([[0, 0, 0]], max_distance=-1e-11)
    with pytest.raises(ValueError, match="no length to use; give it one near 1"):
        tree.ray_hits([[0, 0, 0]], [[0, 0, 1e200]])
    with pytest.raises(ValueError, match=r"directions\[1\].*no length"):
        tree.ray_hits(np.zeros((2, 3)), [[1, 0, 0], [0, 0, 0]])
    with pytest.raises(ValueError, match=r"origins\[0\].*not finite"):
        tree.ray_hits([[np.inf, 0, 0]], [[1, 0, 0]])
    with pytest.raises(ValueError, match="equal length"):
        tree.ray_hits(np.zeros((2, 3)), np.ones((3, 3)))
    with pytest.raises(ValueError, match=r"shape \(3,\)"):
        tree.all_ray_hits(np.zeros((1, 3)), [1, 0, 0])
    with pytest.raises(ValueError, match="points"):
        tree.closest_points([[0, 0]])


def test_a_tree_of_some_cells_knows_no_others(surface):
    middles = surface.positions(np.arange(24), np.full((24, 2), 0.5))
    low = np.flatnonzero(middles[:, 2] == 0.0)
    tree = hn.SurfaceTree(surface, cells=low)
    found = tree.closest_points([[0.25, 0.5, 3.0], [2.0, 0.5, 0.5]])
    np.testing.assert_allclose(found.points, [[0.25, 0.5, 0.0], [1.0, 0.5, 0.0]], atol=1e-14)
    assert set(found.cells) <= set(low)
    surface.set_points(CORNERS - [0.0, 0.0, 1.0])
    tree.refit(surface)
    np.testing.assert_allclose(tree.closest_points([[0.25, 0.5, 3.0]]).distances, [4.0], atol=1e-14)
