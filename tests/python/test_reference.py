# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface against values from an independent program (repeated subdivision, no eigenbasis)."""

import json

import hull_native as hn
import numpy as np
import pytest
from reference_data import MESHES, REFERENCE, reference_mesh

SCHEMES = ["biermann", "catmull_clark"]


def test_all_meshes_are_there():
    assert len(MESHES) == 22


def grid_places(cell_count):
    """(u, v) = (i/4, j/4) of every cell, first index u."""
    uv = np.stack(np.meshgrid(np.arange(5) / 4, np.arange(5) / 4, indexing="ij"), axis=-1)
    return np.repeat(np.arange(cell_count), 25), np.tile(uv.reshape(25, 2), (cell_count, 1))


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("name", MESHES)
def test_points_and_normals(name, scheme):
    mesh = reference_mesh(name)
    surface = hn.LimitSurface(mesh, scheme)
    expected = np.load(REFERENCE / "points" / f"{name}_{scheme}.npz")
    cells, uv = grid_places(surface.cell_count)
    positions = surface.positions(cells, uv).reshape(expected["P"].shape)
    # The values' own error is below 1e-13 (their README).
    assert np.abs(positions - expected["P"]).max() <= 1e-13 * mesh.size
    normals = surface.normals(cells, uv).reshape(expected["N"].shape)
    compared = expected["normal_defined"] & (np.linalg.norm(normals, axis=-1) > 0.5)
    compared &= ~at_single_sector_creases(mesh, cells, uv).reshape(compared.shape)
    assert np.linalg.norm(normals - expected["N"], axis=-1)[compared].max() <= 1e-11
    assert np.array_equal(np.linalg.norm(normals, axis=-1) > 0.5, expected["normal_defined"])


def at_single_sector_creases(mesh, cells, uv):
    """Places at crease vertices of sector valence 1, where the values' normals are inexact."""
    ends = set(map(tuple, np.sort(mesh.creases, axis=1)))
    corner_of_cell = mesh.face_vertices
    first = np.repeat(np.cumsum(mesh.face_sizes) - mesh.face_sizes, mesh.face_sizes)
    size = np.repeat(mesh.face_sizes, mesh.face_sizes)
    index = np.arange(len(corner_of_cell))
    after = corner_of_cell[first + (index - first + 1) % size]
    before = corner_of_cell[first + (index - first - 1) % size]
    single = np.array(
        [
            tuple(sorted((v, a))) in ends and tuple(sorted((v, b))) in ends
            for v, a, b in zip(corner_of_cell, after, before)
        ]
    )
    single &= mesh.vertex_kinds[corner_of_cell] == 2
    return single[cells] & (uv == 0).all(axis=1)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("name", MESHES)
def test_integrals(name, scheme):
    mesh = reference_mesh(name)
    expected = json.loads((REFERENCE / "integrals.json").read_text())[name][scheme]
    body = hn.HullBody(hn.LimitSurface(mesh, scheme), mirrored=False)
    assert body.shell_area == pytest.approx(expected["area"], rel=1e-10)
    fluxes = [expected["flux_x"], expected["flux_y"], expected["flux_z"]]
    assert body.shell_flux_forms == pytest.approx(fluxes, abs=1e-12 * mesh.size**3)
    if expected["closed"]:
        drowned = body.immersion((0.0, 0.0, 1.0), mesh.points[:, 2].max() + 1.0)
        assert drowned.volume == pytest.approx(expected["volume"], rel=1e-12)
        assert drowned.centre_of_buoyancy == pytest.approx(expected["centroid"], abs=1e-11)
        assert np.abs(body.shell_flux_forms / drowned.volume - 1.0).max() <= 1e-12


def test_grid_equals_single_points():
    surface = hn.LimitSurface(reference_mesh("hull_half"))
    grid = surface.evaluate_grid(4, derivatives=2)
    cells, uv = grid_places(surface.cell_count)
    single = surface.evaluate(cells, uv, derivatives=2)
    assert len(grid) == len(single) == 6
    assert grid[0].shape == (surface.cell_count, 5, 5, 3)
    assert np.abs(grid[0].reshape(-1, 3) - single[0]).max() <= 1e-13 * surface.mesh.size


def test_set_points_equals_a_new_surface():
    mesh = reference_mesh("hull_half")
    surface = hn.LimitSurface(mesh)
    moved = mesh.points * [1.0, 1.2, 0.9]
    surface.set_points(moved)
    anew = hn.LimitSurface(mesh.with_points(moved))
    assert np.array_equal(surface.evaluate_grid(3)[0], anew.evaluate_grid(3)[0])
    with pytest.raises(ValueError, match="points"):
        surface.set_points(moved[:-1])
