# SPDX-License-Identifier: GPL-3.0-or-later
"""STEP files of whole ships, read back by Open CASCADE."""

from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest
from reference_data import foreign_ships, hull_path

ROOT = Path(__file__).resolve().parents[2]

NAMES = ["barge.hull.json", "coaster.hull.json", *foreign_ships()]


def surface_of(name):
    data = hull_io.read_hull(hull_path(name))
    shell = hull_io.shell_arrays(data)
    mesh = hn.ControlMesh(*shell.arguments())
    return data, hn.LimitSurface(mesh)


def real_border_length(surface):
    """Of both sides: all borders but those in the centre plane, where the sides are joined."""
    total = 0.0
    for curve in hn.feature_curves(surface, 256):
        if curve.kind != "border":
            continue
        ends = np.abs(curve.points[:, 1]) < 1e-7 * surface.mesh.size
        lengths = np.linalg.norm(np.diff(curve.points, axis=0), axis=1)
        total += lengths[~(ends[1:] & ends[:-1])].sum()
    return 2.0 * total


def largest_distance(patches, surface, samples=4, grid=32):
    """From patch points to the exact surface, m: along the normal of the nearest grid point.

    Independent of the parameters the patches were fitted in; the error is of the order of the
    surface's curvature times the square of the grid's mesh.
    """
    t = np.linspace(0.0, 1.0, samples)
    uv = np.stack(np.meshgrid(t, t, indexing="ij"), axis=-1).reshape(-1, 2)
    assert patches.patch_count == surface.cell_count
    exact, du, dv = (
        array.reshape(surface.cell_count, -1, 3)
        for array in surface.evaluate_grid(grid, derivatives=1)
    )
    normals = np.cross(du, dv)
    normals /= np.maximum(np.linalg.norm(normals, axis=-1, keepdims=True), 1e-300)
    worst = 0.0
    for cell in range(surface.cell_count):
        points = patches.positions(np.full(len(uv), cell), uv)
        away = points[:, None, :] - exact[cell][None, :, :]
        nearest = np.argmin((away**2).sum(axis=-1), axis=1)
        rows = np.arange(len(uv))
        heights = (away[rows, nearest] * normals[cell][nearest]).sum(axis=-1)
        worst = max(worst, np.abs(heights).max())
    return worst


@pytest.mark.one_in(3)
@pytest.mark.parametrize("name", NAMES)
def test_step_of_a_ship(name, tmp_path):
    data, surface = surface_of(name)
    patches = hn.fit_per_cell(surface)
    length = np.ptp(surface.mesh.points[:, 0])
    assert hn.measure_quality(surface, patches).largest_distance <= 1e-3 * length
    assert largest_distance(patches, surface) <= 1e-3 * length
    path = tmp_path / "hull.step"
    hn.write_step(patches, path, name=data.name, mirrored=data.half)
    report = hn.read_cad_report(path)
    assert report["valid"]
    assert report["shells"] == 1
    # No gaps: what is free is the hull's own border.
    assert report["free_edge_length"] == pytest.approx(real_border_length(surface), rel=2e-3)


@pytest.mark.parametrize("name", NAMES)
def test_exact_patches_of_a_ship(name, tmp_path):
    data, surface = surface_of(name)
    patches = hn.exact_patches(surface)
    length = np.ptp(surface.mesh.points[:, 0])
    assert patches.patch_count <= surface.cell_count / 6
    assert patches.largest_gap <= 1e-13 * surface.mesh.size
    # Closest points of the whole surface, crowded towards the patches' corners.
    t = np.concatenate([[0.0, 1.0], 0.5 ** np.arange(1, 12), 1.0 - 0.5 ** np.arange(2, 12)])
    uv = np.stack(np.meshgrid(t, t, indexing="ij"), axis=-1).reshape(-1, 2)
    chosen = np.repeat(np.arange(patches.patch_count), 100)
    random = np.random.default_rng(101)
    points = patches.positions(chosen, uv[random.integers(len(uv), size=len(chosen))])
    found = hn.SurfaceTree(surface).closest_points(points)
    assert found.distances.max() <= 1e-6 * length
    path = tmp_path / "hull.step"
    hn.write_step(surface, path, name=data.name, mirrored=data.half)
    report = hn.read_cad_report(path)
    assert report["valid"]
    assert report["shells"] == 1
    assert report["free_edge_length"] == pytest.approx(real_border_length(surface), rel=2e-3)


def test_bodies_are_solids_of_one_product(tmp_path):
    _, surface = surface_of("sailing_yacht.hull.json")
    path = tmp_path / "yacht.step"
    hn.write_step(surface, path, mirrored=True, solid=True)
    report = hn.read_cad_report(path)
    assert (report["solids"], report["closed"], report["valid"]) == (3, True, True)
    sunk = hn.upright_hydrostatics(surface, draft=10.0, mirrored=True)
    assert report["volume"] == pytest.approx(sunk.displaced_volume, rel=1e-6)
    # Each body's faces are found again by their regions.
    assert sum(region["area"] for region in report["regions"]) == pytest.approx(report["area"])
    assert path.read_text().count("PRODUCT('") == 1


def test_conversion_must_be_known(tmp_path):
    _, surface = surface_of(NAMES[0])
    with pytest.raises(ValueError, match="per_cell"):
        hn.write_step(surface, tmp_path / "hull.step", conversion="other")
