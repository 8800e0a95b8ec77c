# SPDX-License-Identifier: GPL-3.0-or-later
"""Wanted shifts of the exact surface: affine ones are met on all meshes, the optimum is that of a
dense solution with NumPy, and limits hold on all samples."""

from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest
from reference_data import MESHES, reference_mesh

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = sorted(path.name.split(".")[0] for path in (ROOT / "samples").glob("*.hull.json"))
SEED = 20261123


def surface_of(name):
    shell = hull_io.shell_arrays(hull_io.read_hull(ROOT / "samples" / f"{name}.hull.json"))
    return hn.LimitSurface(
        hn.ControlMesh(
            shell.points, shell.face_sizes, shell.face_vertices, shell.creases, shell.corners
        )
    )


def size_of(surface):
    return np.ptp(surface.mesh.points, axis=0).max()


def moved(surface, reshaped):
    """A surface of its own with the moves in it."""
    return hn.LimitSurface(
        surface.mesh.with_points(surface.mesh.points + reshaped.moves), surface.scheme
    )


def dense_rows(surface, reshape):
    """(places, points): the weights of all control points at the places, which are found anew on
    the surface by their positions."""
    found = hn.SurfaceTree(surface).closest_points(reshape.positions)
    begin, points, weights = hn.point_weights(surface, found.cells, found.uv)
    rows = np.zeros((len(reshape.positions), len(surface.mesh.points)))
    for i, row in enumerate(rows):
        row[points[begin[i] : begin[i + 1]]] = weights[begin[i] : begin[i + 1]]
    return rows


@pytest.mark.parametrize("scheme", ["biermann", "catmull_clark"])
@pytest.mark.parametrize("name", MESHES)
def test_affine_shifts_are_met_exactly(name, scheme):
    surface = hn.LimitSurface(reference_mesh(name), scheme)
    random = np.random.default_rng([SEED, MESHES.index(name)])
    size = size_of(surface)
    reshape = hn.Reshape(surface)
    matrix, shift = random.normal(0, 0.2, (3, 3)), size * random.normal(0, 0.3, 3)
    field = lambda p: p @ matrix.T + shift  # noqa: E731
    result = reshape.solve(field(reshape.positions))
    assert result.largest < 1e-13 * size
    assert result.rms <= result.largest
    cells = random.integers(0, surface.cell_count, 300)
    uv = random.random((300, 2))
    before, after = surface.positions(cells, uv), moved(surface, result).positions(cells, uv)
    assert np.abs(after - before - field(before)).max() < 1e-13 * size


@pytest.mark.parametrize("name", SAMPLES)
def test_optimum_is_that_of_a_dense_solution(name):
    surface = surface_of(name)
    points = surface.mesh.points
    size = size_of(surface)
    random = np.random.default_rng([SEED, SAMPLES.index(name)])
    locked = np.flatnonzero(points[:, 0] > np.quantile(points[:, 0], 0.7))
    in_plane = np.flatnonzero(np.abs(points[:, 1]) < 1e-9 * size)
    reshape = hn.Reshape(
        surface,
        locked=locked,
        held_points=in_plane,
        held_normals=np.tile([0.0, 1.0, 0.0], (len(in_plane), 1)),
    )
    x = reshape.positions / size
    shifts = 0.01 * size * np.stack([np.sin(9 * x[:, 2]), np.cos(7 * x[:, 0]), x[:, 0] ** 2], 1)
    shifts += 1e-3 * size * random.normal(size=shifts.shape)
    result = reshape.solve(shifts)
    rows = dense_rows(surface, reshape)
    root = np.sqrt(reshape.areas / reshape.areas.sum())[:, None]
    for axis in range(3):
        free = np.ones(len(points), bool)
        free[locked] = False
        if axis == 1:
            free[in_plane] = False
        best = np.zeros(len(points))
        best[free] = np.linalg.lstsq(root * rows[:, free], root[:, 0] * shifts[:, axis], None)[0]
        assert np.abs(rows @ (best - result.moves[:, axis])).max() < 1e-9 * size
        assert not result.moves[~free, axis].any()
    left = np.linalg.norm(shifts - rows @ result.moves, axis=1)
    assert result.rms == pytest.approx(np.sqrt((root[:, 0] ** 2 * left**2).sum()), rel=1e-9)
    assert result.largest == pytest.approx(left.max(), rel=1e-9)


def test_conditions_and_prescribed_moves_hold():
    surface = surface_of("coaster")
    points = surface.mesh.points
    random = np.random.default_rng(SEED)
    slopes = random.normal(size=(3, 3))
    reshape = hn.Reshape(
        surface,
        prescribed=[5, 7],
        tied=[(8, 5)],
        tied_directions=[(0, 0, 1)],
        conditions=[([20, 21, 22], slopes)],
        stiffness=1e-3,
    )
    told = [(0.1, 0.0, 0.2), (0.0, 0.0, -0.1)]
    result = reshape.solve(np.zeros((len(reshape.positions), 3)), prescribed=told, values=[0.3])
    assert (result.moves[[5, 7]] == told).all()
    assert result.moves[8, 2] == pytest.approx(0.2, abs=1e-15)
    assert (slopes * result.moves[[20, 21, 22]]).sum() == pytest.approx(0.3, abs=1e-13)
    assert len(points) == len(result.moves)


def lean_along_keel(surface):
    """Largest y of the normals along edges in the centre plane, away from the edges' ends."""
    largest = 0.0
    for curve in hn.crease_curves(surface):
        t = np.linspace(0, curve.edge_count, 7 * curve.edge_count + 1)
        points = curve.evaluate(t)[0]
        if np.abs(points[:, 1]).max() > 1e-9 * size_of(surface):
            continue
        found = hn.SurfaceTree(surface).closest_points(points)
        largest = max(largest, np.abs(surface.normals(found.cells, found.uv)[:, 1]).max())
    return largest


def test_a_smooth_keel_stays_smooth():
    """A tube's half, square to the plane along its border below."""
    x, angle = np.meshgrid(np.linspace(0, 10, 9), np.linspace(0, np.pi / 2, 6), indexing="ij")
    y, z = np.sin(angle), -np.cos(angle)
    z[:, 1] = z[:, 0]
    points = np.stack([x, y, z], -1).reshape(-1, 3)
    a = (np.arange(8)[:, None] * 6 + np.arange(5)).ravel()
    faces = np.stack([a, a + 6, a + 7, a + 1], 1)
    surface = hn.LimitSurface(hn.ControlMesh(points, [4] * len(faces), faces.ravel()))
    tied, directions = hn.square_ties(surface)
    assert len(tied) == len(directions) == 2 * 7
    keel = np.flatnonzero(points[:, 1] == 0.0)
    limits = {
        "held_points": keel,
        "held_normals": np.tile([0.0, 1.0, 0.0], (len(keel), 1)),
        "locked": np.flatnonzero((points[:, 0] < 1) | (points[:, 0] > 9)),
    }
    lean = []
    for with_ties in ({"tied": tied, "tied_directions": directions}, {}):
        reshape = hn.Reshape(surface, **limits, **with_ties)
        p = reshape.positions
        shifts = 0.2 * np.stack([np.sin(p[:, 1]), np.cos(p[:, 2]), np.sin(2 * p[:, 1])], 1)
        lean.append(lean_along_keel(moved(surface, reshape.solve(shifts))))
    assert lean_along_keel(surface) < 1e-12 and lean[0] < 1e-12 < 1e-2 < lean[1]


def test_what_is_wrong_is_said():
    surface = surface_of("coaster")
    count = len(surface.mesh.points)
    with pytest.raises(ValueError, match="as many tied_directions"):
        hn.Reshape(surface, tied=[(0, 1)])
    with pytest.raises(ValueError, match=rf"locked point is {count}"):
        hn.Reshape(surface, locked=[count])
    with pytest.raises(ValueError, match=r"conditions\[0\] must be"):
        hn.Reshape(surface, conditions=[3])
    with pytest.raises(ValueError, match="stiffness"):
        hn.Reshape(surface, stiffness=float("nan"))
    with pytest.raises(ValueError, match="No control point may move"):
        hn.Reshape(surface, locked=range(count), conditions=[([0], [(1, 0, 0)])])
    reshape = hn.Reshape(surface, locked=[3], prescribed=[3])
    none = np.zeros((len(reshape.positions), 3))
    with pytest.raises(ValueError, match="wanted shifts"):
        reshape.solve(none[1:], prescribed=[(0, 0, 0)])
    with pytest.raises(ValueError, match="Point 3 cannot move as prescribed"):
        reshape.solve(none, prescribed=[(1, 0, 0)])
    with pytest.raises(ValueError, match="no number"):
        reshape.solve(none + np.nan, prescribed=[(0, 0, 0)])
