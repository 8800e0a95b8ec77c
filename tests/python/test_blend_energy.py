# SPDX-License-Identifier: GPL-3.0-or-later
"""FairRegion's energy "blend": what of a surface is not blended from its rows along and across."""

import hull_native as hn
import numpy as np
import pytest
from test_fairing import SEED, bulging_sheet, with_moves

# Of a cubic, from four places at even distances on [0, 1]: the third derivative.
THIRD = 27.0 * np.array([-1.0, 3.0, -3.0, 1.0])


def grid(points):
    """The surface of a grid of control points (columns, rows, 3)."""
    columns, rows = points.shape[:2]
    a = (np.arange(columns - 1)[:, None] * rows + np.arange(rows - 1)).ravel()
    faces = np.stack([a, a + rows, a + rows + 1, a + 1], axis=1)
    return hn.LimitSurface(
        hn.ControlMesh(points.reshape(-1, 3), np.full(len(faces), 4), faces.ravel())
    )


def blended(most, columns=12, rows=11):
    """Control points Σ iᵏ f_k(j) + jᵏ g_k(i), k up to `most`, with random f and g."""
    random = np.random.default_rng(SEED)
    i, j = np.meshgrid(np.arange(columns) - 5.0, np.arange(rows) - 5.0, indexing="ij")
    z = np.zeros_like(i)
    for k in range(most + 1):
        z += i**k * random.normal(size=rows) + j**k * random.normal(size=(columns, 1))
    return np.stack([i, j, 0.1 * z], axis=2)


def test_it_is_the_integral_of_the_sixth_derivatives():
    """Told by positions alone, of cells that are one bicubic piece each."""
    surface, _ = bulging_sheet()
    u = np.arange(4) / 3.0
    uv = np.stack(np.meshgrid(u, u, indexing="ij"), axis=2).reshape(-1, 2)
    count = surface.cell_count
    places = surface.evaluate(np.repeat(np.arange(count), 16), np.tile(uv, (count, 1)), 0)[0]
    sixth = np.einsum("a,b,kabc->kc", THIRD, THIRD, places.reshape(count, 4, 4, 3))
    # Six differences of coordinates up to 10 lose some of their 16 digits.
    assert hn.fair_energy(surface, "blend") == pytest.approx((sixth**2).sum(), rel=1e-9)


def test_it_is_the_same_whichever_corner_of_a_face_is_the_first():
    surface, _ = bulging_sheet()
    mesh = surface.mesh
    faces = np.asarray(mesh.face_vertices).reshape(-1, 4)
    turned = [np.roll(face, k) for k, face in enumerate(faces)]
    other = hn.ControlMesh(mesh.points, mesh.face_sizes, np.concatenate(turned))
    energy = hn.fair_energy(hn.LimitSurface(other), "blend")
    assert energy == pytest.approx(hn.fair_energy(surface, "blend"), rel=1e-12)


def test_what_is_blended_has_none():
    """However much it bends; borders, at which rows go on straight, as far as k = 1."""
    points = blended(1)
    wild = points + 1e-3 * np.random.default_rng(SEED).normal(size=points.shape)
    # The form's terms are of order 1e3, which rounding leaves 1e-13 of.
    assert abs(hn.fair_energy(grid(points), "blend")) < 1e-12
    assert hn.fair_energy(grid(wild), "blend") > 1e-5


@pytest.mark.parametrize("count", (1, 6))
def test_a_dent_in_a_blended_surface_goes_to_the_last_digit(count):
    """Where the shift is as large as it needs to be, and no farther with more."""
    surface = grid(blended(2))
    chosen = 11 * (3 + np.arange(count)) + 5
    moves = np.zeros_like(surface.mesh.points)
    moves[chosen, 2] = 0.01 * np.cos(np.arange(count))
    dented = with_moves(surface, moves)
    faired = hn.FairRegion(dented, chosen, energy="blend", along_normals=False).solve(1.0)
    assert faired.bound == "nothing"
    np.testing.assert_allclose(faired.moves, -moves, atol=1e-9)


def test_where_irregular_points_are_all_around_it_is_refused():
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    cube = hn.LimitSurface(hn.ControlMesh(corners, [4] * 6, np.ravel(faces)))
    with pytest.raises(ValueError, match="irregular points are all around"):
        hn.FairRegion(cube, [0], energy="blend", along_normals=False)
