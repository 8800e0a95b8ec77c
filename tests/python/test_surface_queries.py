# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature and crease curves of surfaces, against closed forms and differences."""

import hull_native as hn
import numpy as np
import pytest

SIDE = 7  # faces along each side of a grid


def grid(height, **tags):
    """Control points (x, y, height(x, y)) over [-3.5, 3.5]^2, normals up."""
    x, y = np.meshgrid(np.arange(SIDE + 1) - SIDE / 2, np.arange(SIDE + 1) - SIDE / 2)
    points = np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3)
    first = (np.arange(SIDE)[:, None] * (SIDE + 1) + np.arange(SIDE)).reshape(-1)
    faces = np.stack([first, first + 1, first + SIDE + 2, first + SIDE + 1], axis=1)
    return hn.ControlMesh(points, np.full(len(faces), 4), faces.ravel(), **tags)


def inner_places(count, seed):
    """Places in the faces that no border reaches."""
    random = np.random.default_rng(seed)
    faces = random.integers(2, SIDE - 2, count) * SIDE + random.integers(2, SIDE - 2, count)
    return 4 * faces + random.integers(0, 4, count), random.uniform(0.01, 0.99, (count, 2))


@pytest.mark.parametrize("a, b, c", [(0.1, 0.0, 0.0), (0.1, 0.0, 0.1), (-0.2, 0.1, 0.15)])
def test_curvature_of_quadratics(a, b, c):
    """Cubic B-splines reproduce a x^2 + b x y + c y^2 but for a constant (do Carmo 1976, 3-3)."""
    surface = hn.LimitSurface(grid(lambda x, y: a * x * x + b * x * y + c * y * y))
    cells, uv = inner_places(200, seed=1)
    x, y, _ = surface.positions(cells, uv).T
    fx, fy = 2 * a * x + b * y, b * x + 2 * c * y
    w = 1 + fx * fx + fy * fy
    gaussian = (4 * a * c - b * b) / w**2
    # Normals point up, away from where a bowl is hollow.
    mean = -((1 + fy * fy) * a - fx * fy * b + (1 + fx * fx) * c) / w**1.5
    curvature = surface.curvature(cells, uv)
    np.testing.assert_allclose(curvature.gaussian, gaussian, atol=1e-13)
    np.testing.assert_allclose(curvature.mean, mean, atol=1e-13)
    np.testing.assert_allclose(curvature.maximum + curvature.minimum, 2 * mean, atol=1e-13)
    assert (curvature.maximum >= curvature.minimum).all()
    assert curvature.defined.all() and not curvature.at_irregular_knot.any()
    normals = surface.normals(cells, uv)
    for directions in (curvature.maximum_directions, curvature.minimum_directions):
        assert directions.shape == (200, 3)
        np.testing.assert_allclose(np.linalg.norm(directions, axis=1), 1, atol=1e-14)
        np.testing.assert_allclose((directions * normals).sum(axis=1), 0, atol=1e-13)


def test_a_cylinder_is_curved_along_its_section_only():
    surface = hn.LimitSurface(grid(lambda x, y: -0.1 * x * x))
    curvature = surface.curvature(*inner_places(50, seed=2))
    np.testing.assert_allclose(curvature.minimum, 0, atol=1e-14)
    assert (curvature.maximum > 0.1).all()
    np.testing.assert_allclose(np.abs(curvature.minimum_directions[:, 1]), 1, atol=1e-12)


def test_curvature_is_how_normals_turn():
    """dn/ds = k T along a line of curvature (Rodrigues), by central differences of normals."""
    surface = hn.LimitSurface(grid(lambda x, y: np.sin(0.7 * x) * np.cos(0.5 * y) + 0.1 * x * y))
    cells, uv = inner_places(100, seed=3)
    uv = 0.1 + 0.8 * uv
    curvature = surface.curvature(cells, uv)
    _, du, dv = surface.evaluate(cells, uv, 1)
    step = 1e-5
    for k, directions in (
        (curvature.maximum, curvature.maximum_directions),
        (curvature.minimum, curvature.minimum_directions),
    ):
        for cell, place, a, b, value, direction in zip(cells, uv, du, dv, k, directions):
            along = np.linalg.lstsq(np.stack([a, b], axis=1), direction, rcond=None)[0]
            after, before = surface.normals(
                [cell, cell], [place + step * along, place - step * along]
            )
            np.testing.assert_allclose((after - before) / (2 * step), value * direction, atol=1e-7)


def test_curvature_at_irregular_knots_is_flagged():
    points = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    faces = [0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3]
    surface = hn.LimitSurface(hn.ControlMesh(points, np.full(6, 4), faces))
    curvature = surface.curvature([0, 0, 0], [[0, 0], [2.0**-20, 2.0**-20], [1, 1]])
    np.testing.assert_array_equal(curvature.at_irregular_knot, [True, False, False])
    assert curvature.at_irregular_knot.dtype == bool
    assert curvature.maximum[0] == curvature.maximum[1]
    assert surface.curvature(np.zeros(0, int), np.zeros((0, 2))).mean.shape == (0,)
    with pytest.raises(ValueError, match="24"):
        surface.curvature([24], [[0, 0]])


def height(x, y):
    return 0.05 * x * x - 0.1 * np.cos(x + 2 * y)


def cox_de_boor(knots, points, t):
    """The B-spline's points at t, each basis function by its recursion (de Boor 1978)."""
    n = len(points)
    basis = np.array([(knots[i] <= t) & (t < knots[i + 1]) for i in range(n + 3)], dtype=float)
    with np.errstate(divide="ignore", invalid="ignore"):
        for degree in (1, 2, 3):
            left = (t - knots[:, None]) / (np.roll(knots, -degree) - knots)[:, None]
            left = np.nan_to_num(left[: n + 4 - degree], posinf=0, neginf=0)
            basis = left[:-1] * basis[:-1] + (1 - left[1:]) * basis[1:]
    return basis.T @ points


def test_crease_curves_lie_in_the_surface():
    row = 3 * (SIDE + 1)
    creases = [[row + 1, row + 2], [row + 2, row + 3], [row + 3, row + 4]]
    surface = hn.LimitSurface(grid(height, creases=creases))
    curves = hn.crease_curves(surface)
    assert [curve.kind for curve in curves].count("border") == 4
    (crease,) = [curve for curve in curves if curve.kind == "crease"]
    np.testing.assert_array_equal(np.sort(crease.vertices), row + np.arange(1, 5))
    assert 0 < crease.dart_error < 1e-12
    for curve in curves:
        assert curve.edge_count == len(curve.vertices) - 1
        assert len(curve.knots) == len(curve.control_points) + 4
        t = np.linspace(0, curve.edge_count, 101)
        points, d1, d2 = curve.evaluate(t, 2)
        sides = [curve.left(t), curve.right(t)]
        assert sum((cells >= 0).all() for cells, _ in sides) == (1 if curve.kind == "border" else 2)
        for cells, uv in sides:
            if cells[0] >= 0:
                np.testing.assert_allclose(surface.positions(cells, uv), points, atol=1e-13)
        inner = slice(1, -1)
        again = cox_de_boor(curve.knots, curve.control_points, t[inner])
        np.testing.assert_allclose(again, points[inner], atol=1e-13)
        assert d1.shape == d2.shape == (101, 3)
    border = curves[0]
    np.testing.assert_array_equal(border.knots, np.arange(-3, SIDE + 4))
    np.testing.assert_array_equal(border.control_points[1:-1], surface.mesh.points[border.vertices])


def test_places_beyond_a_curve_are_named():
    curve = hn.crease_curves(hn.LimitSurface(grid(height)))[0]
    with pytest.raises(ValueError, match=r"t\[1\] is outside of \[0, 7\]"):
        curve.evaluate([0, 7.5])
    with pytest.raises(ValueError, match="derivatives"):
        curve.evaluate([0], 3)
