# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature, crease curves and tessellation, against closed forms and differences."""

import json
from pathlib import Path

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


def test_tessellation_keeps_to_a_tolerance():
    """A parabolic cylinder departs from chords by its second derivative times h^2 / 8."""
    surface = hn.LimitSurface(grid(lambda x, y: -0.1 * x * x))
    tolerance = 1e-4
    tessellation = surface.tessellate(chord_tolerance=tolerance)
    corners = tessellation.points[tessellation.quads]
    assert len(corners) < len(surface.tessellate(16).quads)
    # Every quadrilateral has two sides along the generators; the middles of the others sag.
    middles = corners.mean(axis=1)
    x = middles[:, 0]
    inner = np.abs(x) < 1.5  # beyond, the border's spans end the parabola
    control_height = -0.1 * (x * x + 1 / 3)  # what cubic B-splines make of the control heights
    sag = np.abs(middles[:, 2] - control_height)[inner].max()
    assert 0.2 * tolerance < sag <= tolerance


def distance_to_triangles(p, a, b, c):
    """Of points (m, n, 3) to n triangles, their corners (n, 3) each."""
    normal = np.cross(b - a, c - a)
    nearest, inside = np.inf, True
    for start, end in ((a, b), (b, c), (c, a)):
        along = end - start
        length = np.maximum((along * along).sum(axis=-1), 1e-300)
        s = np.clip(((p - start) * along).sum(axis=-1) / length, 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(p - start - s[..., None] * along, axis=-1))
        inside &= (np.cross(along, p - start) * normal).sum(axis=-1) >= 0
    area = np.maximum(np.linalg.norm(normal, axis=-1), 1e-300)
    return np.where(inside, np.abs(((p - a) * normal).sum(axis=-1)) / area, nearest)


def distances_from_quads(surface, tessellation, samples):
    """Of sampled points of the surface from their own quadrilaterals, the farther cut of two."""
    points, quads = tessellation.points, tessellation.quads
    every = np.arange(surface.cell_count)
    right = surface.positions(every, np.tile([1.0, 0.0], (len(every), 1)))
    above = surface.positions(every, np.tile([0.0, 1.0], (len(every), 1)))
    grid_u, grid_v = (g.ravel() for g in np.meshgrid(*[np.linspace(0, 1, samples + 1)] * 2))
    same = 1e-12 * surface.mesh.size
    begin, largest = 0, 0.0
    for cell in every:
        nu = nv = 1
        while np.linalg.norm(points[quads[begin + nu - 1, 1]] - right[cell]) > same:
            nu += 1
        while np.linalg.norm(points[quads[begin + nu * (nv - 1), 3]] - above[cell]) > same:
            nv += 1
        j, i = np.divmod(np.arange(nu * nv), nu)
        uv = np.stack([(i + grid_u[:, None]) / nu, (j + grid_v[:, None]) / nv], axis=-1)
        uv = np.minimum(uv, 1.0).reshape(-1, 2)
        p = surface.positions(np.full(len(uv), cell), uv).reshape(-1, nu * nv, 3)
        a, b, c, d = points[quads[begin : begin + nu * nv]].transpose(1, 0, 2)
        one = np.minimum(distance_to_triangles(p, a, b, c), distance_to_triangles(p, a, c, d))
        other = np.minimum(distance_to_triangles(p, a, b, d), distance_to_triangles(p, b, c, d))
        largest = max(largest, one.max(), other.max())
        begin += nu * nv
    assert begin == len(quads)
    return largest


@pytest.mark.parametrize(
    "path, names, tolerance",
    [
        (
            "tests/reference/meshes/hull_half.json",
            ("vertices", "crease_edges", "corner_vertices"),
            3e-3,
        ),
        ("samples/coaster.hull.json", ("points", "creases", "corners"), 1e-2),
    ],
)
def test_hulls_keep_to_their_tolerance(path, names, tolerance):
    arrays = json.loads((Path(__file__).parents[2] / path).read_text())
    points, creases, corners = (arrays[name] for name in names)
    faces = arrays["faces"]
    mesh = hn.ControlMesh(
        np.array(points, dtype=float),
        [len(face) for face in faces],
        [vertex for face in faces for vertex in face],
        np.array(creases, dtype=int).reshape(-1, 2),
        np.array(corners, dtype=int),
    )
    for scheme in ("biermann", "catmull_clark"):
        surface = hn.LimitSurface(mesh, scheme)
        tessellation = surface.tessellate(chord_tolerance=tolerance)
        largest = distances_from_quads(surface, tessellation, 4)
        assert 0.25 * tolerance < largest <= tolerance


def test_normals_are_shared_where_the_surface_is_smooth():
    row = 3 * (SIDE + 1)
    creases = np.stack([row + np.arange(SIDE), row + np.arange(SIDE) + 1], axis=1)
    surface = hn.LimitSurface(grid(lambda x, y: height(x, y) - np.abs(y + 0.5), creases=creases))
    tessellation = surface.tessellate(4)
    indices, quads = tessellation.normal_indices, tessellation.quads
    assert indices.shape == quads.shape
    np.testing.assert_array_equal(
        tessellation.normals[indices], tessellation.corner_normals, strict=True
    )
    # One for each point, two for each point of the crease: 7 edges of 2 cells with 4 parts.
    crease_points = 7 * 2 * 4 + 1
    assert len(tessellation.normals) == len(tessellation.points) + crease_points
    np.testing.assert_allclose(np.linalg.norm(tessellation.normals, axis=1), 1, atol=1e-14)


def test_tessellation_takes_one_measure():
    surface = hn.LimitSurface(grid(height))
    for arguments in ({}, {"n": 3, "chord_tolerance": 0.1}):
        with pytest.raises(ValueError, match="either n or chord_tolerance"):
            surface.tessellate(**arguments)
    for tolerance in (0.0, -1.0, np.nan, np.inf):
        with pytest.raises(ValueError, match="positive length"):
            surface.tessellate(chord_tolerance=tolerance)
    with pytest.raises(ValueError, match=r"\d m would do"):
        surface.tessellate(chord_tolerance=1e-13)
