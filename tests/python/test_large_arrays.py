# SPDX-License-Identifier: GPL-3.0-or-later
"""Large arrays of places are shared out among threads: the results are those of small ones."""

import hull_native as hn
import numpy as np
import pytest

SEED = 5
COUNT = 60_000


@pytest.fixture(scope="module")
def surface():
    corners = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    mesh = hn.ControlMesh(np.array(corners, float), np.full(6, 4), np.array(faces).ravel())
    return hn.LimitSurface(mesh)


@pytest.fixture(scope="module")
def places(surface):
    draw = np.random.default_rng(SEED)
    return draw.integers(0, surface.cell_count, COUNT), draw.random((COUNT, 2))


def in_parts(function, places):
    """Results of one call for all, and of calls too small to be shared out, joined."""
    cells, uv = places
    parts = [function(cells[i : i + 1000], uv[i : i + 1000]) for i in range(0, COUNT, 1000)]
    return function(cells, uv), np.concatenate(parts)


def test_positions_and_normals(surface, places):
    for function in (surface.positions, surface.normals):
        np.testing.assert_array_equal(*in_parts(function, places))


def test_derivatives(surface, places):
    for k in range(6):
        np.testing.assert_array_equal(
            *in_parts(lambda cells, uv: surface.evaluate(cells, uv, derivatives=2)[k], places)
        )


def test_curvature(surface, places):
    np.testing.assert_array_equal(
        *in_parts(lambda cells, uv: surface.curvature(cells, uv).gaussian, places)
    )


def test_grids(surface):
    n = 100
    grid = surface.evaluate_grid(n, derivatives=1)
    cell, i, j = 17, 31, 64
    single = surface.evaluate([cell], [[i / n, j / n]], derivatives=1)
    for of_grid, of_place in zip(grid, single, strict=True):
        np.testing.assert_allclose(of_grid[cell, i, j], of_place[0], atol=1e-12)
