# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat regions with their borders, and what is at fault where a part is not flat."""

import hull_native as hn
import numpy as np
import pytest

SIDE = 8
N = SIDE + 1


def grid(height, shift=lambda x, y: 0 * x, **tags):
    at = np.arange(N) - SIDE / 2
    x, y = np.meshgrid(at, at)
    points = np.stack([x + shift(x, y), y, height(x, y)], axis=-1).reshape(-1, 3)
    first = (np.arange(SIDE)[:, None] * N + np.arange(SIDE)).reshape(-1)
    faces = np.stack([first, first + 1, first + N + 1, first + N], axis=1)
    return hn.ControlMesh(points, np.full(len(faces), 4), faces.ravel(), **tags)


def turned(mesh, seed):
    q, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    q *= np.sign(np.linalg.det(q))
    return q, hn.ControlMesh(mesh.points @ q.T, mesh.face_sizes, mesh.face_vertices, mesh.creases)


def half_flat(x, y):
    return 0.2 * np.maximum(x, 0) ** 2


def test_flat_half_of_a_sheet():
    surface = hn.LimitSurface(grid(half_flat))
    (region,) = hn.flat_regions(surface)
    # The faces whose sixteen control points are in the plane.
    assert abs(region.area - 3 * SIDE) < 1e-12
    np.testing.assert_allclose(region.plane, [0, 0, 1, 0], atol=1e-15)
    (border,) = region.borders
    points = border.points(4)
    np.testing.assert_array_equal(points[0], points[-1])
    x, y = points[:, 0], points[:, 1]
    assert abs(0.5 * np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]) - 3 * SIDE) < 1e-12
    assert abs(x.max() + 1) < 1e-12
    (given,) = hn.flat_regions(surface, plane=(0, 0, -2, 0))
    np.testing.assert_array_equal(given.cells, region.cells)
    np.testing.assert_allclose(given.plane, [0, 0, 1, 0], atol=1e-15)
    assert hn.flat_regions(surface, plane=(0, 0, 1, 0.1)) == []
    assert hn.flat_regions(surface, smallest_area=25.0) == []


def test_borders_are_exact_and_turn_with_the_surface():
    mesh = grid(half_flat, shift=lambda x, y: 0.2 * np.sin(1.3 * y))
    q, mesh = turned(mesh, 4)
    surface = hn.LimitSurface(mesh)
    (region,) = hn.flat_regions(surface, tolerance=1e-12)
    np.testing.assert_allclose(region.plane[:3], q[:, 2], atol=1e-13)
    (border,) = region.borders
    assert border.cubics.shape[1:] == (4, 3)
    np.testing.assert_allclose(border.cubics[1:, 0], border.cubics[:-1, 3], atol=1e-14)
    points = border.points(9)
    assert hn.SurfaceTree(surface).closest_points(points).distances.max() < 1e-13
    # Along the surface's own border: the ruling x = -1 of the control lines beside it.
    inner = (points @ q)[:, 0] > -1.5
    t = (points @ q)[inner, 1]
    assert np.ptp((points @ q)[inner, 0]) > 0.2 and np.ptp(t) > 7.9


def test_two_planes_and_a_ridge():
    ridge = [(j * N + SIDE // 2, (j + 1) * N + SIDE // 2) for j in range(SIDE)]
    surface = hn.LimitSurface(grid(lambda x, y: -0.5 * np.maximum(x, 0), creases=ridge))
    level, slope = sorted(hn.flat_regions(surface), key=lambda r: -r.plane[2])
    assert abs(level.area - 32) < 1e-12 and abs(slope.area - 32 * np.hypot(1, 0.5)) < 1e-12
    np.testing.assert_allclose(slope.plane[:3], np.array([0.5, 0, 1]) / np.hypot(1, 0.5))
    # A plane that goes through a crease is one region.
    (one,) = hn.flat_regions(hn.LimitSurface(grid(lambda x, y: 0.1 * y, creases=ridge)))
    assert abs(one.area - 64 * np.hypot(1, 0.1)) < 1e-11 and len(one.borders) == 1


def test_a_hole_has_a_border_of_its_own():
    def height(x, y):
        return np.where((x == 0) & (y == 0), 0.5, 0.0)

    (region,) = hn.flat_regions(hn.LimitSurface(grid(height)))
    assert abs(region.area - (64 - 16)) < 1e-12 and len(region.borders) == 2


def test_flat_around_irregular_points():
    """A flat fan of five faces in a flat sheet: borders towards the irregular point, too."""
    angle = 2 * np.pi * np.arange(10) / 10
    points = [[0, 0, 0]]
    for r in (1, 2, 3):
        points += [[r * np.cos(a), r * np.sin(a), 0] for a in angle]
    points = np.array(points, float)
    points[21] = [3, 0, 0.4]  # bends the outer ring about (3, 0)
    at = lambda r, k: 1 + (r - 1) * 10 + k % 10  # noqa: E731
    faces = [[0, at(1, 2 * k), at(1, 2 * k + 1), at(1, 2 * k + 2)] for k in range(5)]
    faces += [
        [at(r, k), at(r + 1, k), at(r + 1, k + 1), at(r, k + 1)] for r in (1, 2) for k in range(10)
    ]
    surface = hn.LimitSurface(hn.ControlMesh(points, np.full(25, 4), np.ravel(faces)))
    (region,) = hn.flat_regions(surface)
    (border,) = region.borders
    assert hn.SurfaceTree(surface).closest_points(border.points(5)).distances.max() < 1e-7
    x, y = border.points(64)[:, :2].T
    assert abs(0.5 * np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]) - region.area) < 2e-3


def test_a_point_at_fault_is_named():
    mesh = grid(lambda x, y: 0.3 * x + 0.1 * y)
    fault = 4 * N + 4
    for seed, bump in ((1, 0.05), (2, -3.0)):
        points = mesh.points.copy()
        points[fault, 2] += bump
        bumped = hn.ControlMesh(points, mesh.face_sizes, mesh.face_vertices)
        q, other = turned(bumped, seed)
        result = hn.flatness(hn.LimitSurface(other), faces=np.arange(SIDE * SIDE))
        assert list(result.at_fault) == [fault] and len(result.neighbours_at_fault) == 0
        normal = q @ (np.array([-0.3, -0.1, 1]) / np.sqrt(1.1))
        np.testing.assert_allclose(np.abs(result.plane[:3] @ normal), 1, atol=1e-12)
        # A smooth regular point has the weight (2/3)^2 at its own place.
        height = abs(bump) / np.sqrt(1.1)
        assert abs(result.control_distance - height) < 1e-9
        assert abs(result.surface_distance - 4 / 9 * height) < 2e-8
        assert (
            np.linalg.norm(result.surface_point @ q - (points[fault] - [0, 0, 5 / 9 * bump])) < 1e-3
        )
        assert len(result.vertices) == len(result.distances) == N * N


def test_neighbours_bend_the_rim_unless_a_crease_parts_them():
    surface = hn.LimitSurface(grid(half_flat))
    faces = [j * SIDE + i for j in range(SIDE) for i in range(4)]  # x <= 0
    result = hn.flatness(surface, faces=faces, plane=(0, 0, 1, 0))
    assert len(result.at_fault) == 0 and result.control_distance == 0
    assert list(result.neighbours_at_fault) == [j * N + 5 for j in range(N)]
    # At x = 0 a sixth of the next control point's height.
    assert abs(result.surface_distance - 0.2 / 6) < 1e-9
    ridge = [(j * N + 4, (j + 1) * N + 4) for j in range(SIDE)]
    parted = hn.LimitSurface(grid(half_flat, creases=ridge))
    result = hn.flatness(parted, faces=faces)
    assert len(result.neighbours_at_fault) == 0 and result.surface_distance < 1e-14
    vertices = [j * N + i for j in range(N) for i in range(5)]
    again = hn.flatness(parted, vertices=vertices, plane=(0, 0, 3, 0.3))
    assert abs(again.surface_distance - 0.1) < 1e-14 and len(again.at_fault) == len(vertices)
    np.testing.assert_allclose(again.distances, -0.1)


def test_largest_distance_of_a_bowl():
    surface = hn.LimitSurface(grid(lambda x, y: 0.1 * x * x + 0.03 * x * y))
    cells, uv = np.meshgrid(np.arange(surface.cell_count), np.linspace(0, 1, 9))
    u, v, c = np.meshgrid(np.linspace(0, 1, 33), np.linspace(0, 1, 33), np.arange(256))
    heights = surface.positions(c.ravel(), np.stack([u.ravel(), v.ravel()], 1))[:, 2]
    result = hn.flatness(surface, faces=np.arange(SIDE * SIDE), plane=(0, 0, 1, 0.4))
    assert 0 <= result.surface_distance - np.abs(heights - 0.4).max() < 1e-3
    assert abs(abs(result.surface_point[2] - 0.4) - result.surface_distance) < 1e-12


@pytest.mark.parametrize(
    "options, message",
    [
        ({}, "either"),
        ({"faces": [0], "vertices": [0]}, "either"),
        ({"faces": []}, "select"),
        ({"faces": [64]}, "no face 64"),
        ({"vertices": [-1, 3, 4]}, "no control point -1"),
        ({"vertices": [0, 1]}, "Fewer than three"),
        ({"vertices": [0, 1, 2, 3]}, "in a line"),
        ({"faces": [0], "tolerance": 0.0}, "positive"),
        ({"faces": [0], "plane": (0, 0, 0, 1)}, "no plane"),
        ({"faces": [0], "plane": (0, 0, 1)}, "shape"),
    ],
)
def test_selections_that_have_no_flatness(options, message):
    surface = hn.LimitSurface(grid(half_flat))
    with pytest.raises(ValueError, match=message):
        hn.flatness(surface, **options)


def test_regions_out_of_range():
    surface = hn.LimitSurface(grid(half_flat))
    with pytest.raises(ValueError, match="positive"):
        hn.flat_regions(surface, tolerance=0.0)
    with pytest.raises(ValueError, match="1 to 1024"):
        hn.flat_regions(surface)[0].borders[0].points(0)
