# SPDX-License-Identifier: GPL-3.0-or-later
"""The once-subdivided control mesh: the same surface, to rounding, with the same tags."""

from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest

SAMPLES = Path(__file__).resolve().parents[2] / "samples"
NAMES = sorted(path.name[: -len(".hull.json")] for path in SAMPLES.glob("*.hull.json"))

# Of the size; what the surface promises of positions, twice.
ROUNDED = 1e-13
# Of the four quarters of a cell: their corner (0, 0), and the axes of their own (u, v).
QUARTERS = (
    ((0, 0), (1, 0), (0, 1)),
    ((1, 0), (0, 1), (-1, 0)),
    ((1, 1), (-1, 0), (0, -1)),
    ((0, 1), (0, -1), (1, 0)),
)


@pytest.mark.parametrize("scheme", ["biermann", "catmull_clark"])
@pytest.mark.parametrize("name", NAMES)
def test_the_surface_is_the_same(name, scheme):
    shell = hull_io.shell_arrays(hull_io.read_hull(SAMPLES / f"{name}.hull.json"))
    arrays = shell.arguments()
    surface = hn.LimitSurface(hn.ControlMesh(*arrays), scheme)
    mesh = surface.refined_mesh()
    finer = hn.LimitSurface(mesh, scheme)
    assert (mesh.face_sizes == 4).all() and mesh.face_count == surface.cell_count
    places = np.random.default_rng(21).random((200, 2))
    for quarter, (origin, u, v) in enumerate(QUARTERS):
        cells = np.arange(200) * 7919 % surface.cell_count
        there = np.array(origin) + 0.5 * (places[:, :1] * u + places[:, 1:] * v)
        apart = surface.positions(cells, there) - finer.positions(4 * cells + quarter, places)
        assert np.abs(apart).max() < ROUNDED * surface.mesh.size
    for kind in (1, 3, 4):
        before = np.flatnonzero(surface.mesh.vertex_kinds == kind)
        assert np.array_equal(np.flatnonzero(mesh.vertex_kinds == kind), before)


@pytest.mark.parametrize("round_border_corners", [False, True])
def test_corners_of_the_border_stay_what_they_are(round_border_corners):
    points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (9, 9, 9)]
    mesh = hn.ControlMesh(points, [4], [0, 1, 2, 3], round_border_corners=round_border_corners)
    finer = hn.LimitSurface(mesh).refined_mesh()
    assert finer.vertex_kinds[:4].tolist() == [2 if round_border_corners else 3] * 4
    assert np.array_equal(finer.points[4], points[4])  # of no face
