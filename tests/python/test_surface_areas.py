# SPDX-License-Identifier: GPL-3.0-or-later
"""Areas and centres of surfaces: by closed forms, and against finer and finer meshes."""

import hull_native as hn
import numpy as np
import pytest
from hull_native import cell_areas, surface_areas
from reference_data import MESHES, reference_mesh


class Sphere:
    """Six faces of a cube, projected on a sphere about a centre: what is asked of a surface."""

    cell_count = 6
    radius, centre = 3.0, np.array([5.0, -1.0, 2.0])
    axes = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]

    def evaluate(self, cells, uv, derivatives):
        assert derivatives == 1
        a, b = 2.0 * uv[:, 0] - 1.0, 2.0 * uv[:, 1] - 1.0
        flat, by_a, by_b = (np.zeros((len(cells), 3)) for _ in range(3))
        rows = np.arange(len(cells))
        n, s, t = np.array(self.axes)[cells // 2].T
        flat[rows, n] = np.where(cells % 2, 1.0, -1.0)
        flat[rows, s], flat[rows, t] = a, b
        by_a[rows, s] = by_b[rows, t] = 2.0
        length = np.linalg.norm(flat, axis=1)[:, None]

        def projected(way):
            along = np.einsum("ij,ij->i", flat, way)[:, None]
            return self.radius * (way / length - flat * along / length**3)

        return self.centre + self.radius * flat / length, projected(by_a), projected(by_b)


def test_a_sphere():
    found = surface_areas(Sphere())
    area, centre = found.of(slice(None))
    assert area == pytest.approx(4.0 * np.pi * 9.0, rel=1e-12)
    np.testing.assert_allclose(centre, Sphere.centre, rtol=1e-12)
    np.testing.assert_allclose(found.areas, 6.0 * np.pi, rtol=1e-12)
    # One face: its centre by the flux of the sphere's normal through it.
    _, above = found.of([1])
    solid = 4.0 * np.pi / 6.0
    assert above[0] - 5.0 == pytest.approx(3.0 * _flux_of_a_sixth() / solid, rel=1e-10)


def _flux_of_a_sixth():
    """∫ n_x dΩ over a face's share of the unit sphere, by polar angles about x: of eight triangles,
    where tan θ reaches 1 / cos of the azimuth."""
    nodes, weights = np.polynomial.legendre.leggauss(60)
    azimuth = np.pi / 8 * (nodes + 1)
    theta = np.arctan(1.0 / np.cos(azimuth))
    return 8.0 * np.sum(weights * np.pi / 8 * 0.5 * np.sin(theta) ** 2)


def box(length, breadth, depth):
    """A closed box, creased at every edge."""
    x, y, z = length, breadth, depth
    points = np.array([(a, b, c) for a in (0.0, x) for b in (0.0, y) for c in (0.0, z)])
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    edges = [(a, b) for a in range(8) for b in range(a + 1, 8) if bin(a ^ b).count("1") == 1]
    return hn.LimitSurface(hn.ControlMesh(points, [4] * 6, np.ravel(faces), edges, []))


def test_a_box():
    found = surface_areas(box(10.0, 4.0, 3.0))
    per_face = found.areas.reshape(6, 4).sum(axis=1)
    np.testing.assert_allclose(per_face, [12.0, 12.0, 30.0, 30.0, 40.0, 40.0], rtol=1e-12)
    area, centre = found.of(slice(None))
    assert area == pytest.approx(164.0, rel=1e-13)
    np.testing.assert_allclose(centre, [5.0, 2.0, 1.5], rtol=1e-13)


@pytest.mark.parametrize("name", MESHES[:6])
def test_the_refined_mesh_has_the_same_areas(name):
    """Irregular points are at other places in its cells."""
    surface = hn.LimitSurface(reference_mesh(name))
    coarse = surface_areas(surface)
    fine = surface_areas(hn.LimitSurface(surface.refined_mesh()))
    area, centre = coarse.of(slice(None))
    fine_area, fine_centre = fine.of(slice(None))
    size = np.ptp(np.asarray(surface.mesh.points), axis=0).max()
    assert fine_area == pytest.approx(area, rel=1e-11)
    np.testing.assert_allclose(fine_centre, centre, atol=1e-11 * size)


def test_moving_moves_the_centre_alone():
    mesh = reference_mesh(MESHES[0])
    surface = hn.LimitSurface(mesh)
    area, centre = surface_areas(surface).of(slice(None))
    surface.set_points(np.asarray(mesh.points) + (3.0, -2.0, 1.0))
    moved_area, moved = surface_areas(surface).of(slice(None))
    assert moved_area == pytest.approx(area, rel=1e-12)
    np.testing.assert_allclose(moved - centre, [3.0, -2.0, 1.0], atol=1e-10)


def test_no_cells_are_no_area():
    area, centre = surface_areas(box(1.0, 1.0, 1.0)).of([])
    assert area == 0.0 and (centre == 0.0).all()


def test_a_surface_in_one_line_has_no_area():
    x, y = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
    points = np.stack([x + y, 2.0 * (x + y), 0.0 * x], axis=-1).reshape(-1, 3)
    corners = np.arange(16).reshape(4, 4)
    faces = np.stack([corners[:-1, :-1], corners[1:, :-1], corners[1:, 1:], corners[:-1, 1:]], -1)
    surface = hn.LimitSurface(hn.ControlMesh(points, np.full(9, 4), faces.reshape(-1)))
    found = hn.surface_areas(surface)
    assert len(found.areas) == surface.cell_count
    assert not found.areas.any() and not found.moments.any()


def test_squares_are_evaluated_in_batches(monkeypatch):
    """With the same bits as all at once."""
    surface = hn.LimitSurface(reference_mesh(MESHES[0]))
    whole = hn.surface_areas(surface)
    monkeypatch.setattr(cell_areas, "_BATCH", 5)
    parts = hn.surface_areas(surface)
    assert np.array_equal(parts.areas, whole.areas)
    assert np.array_equal(parts.moments, whole.moments)
