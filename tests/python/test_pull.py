# SPDX-License-Identifier: GPL-3.0-or-later
"""Pulling the surface, against basis functions and least-norm solutions had by other means."""

import hull_native as hn
import numpy as np
import pytest

SEED = 20261122


def ring_mesh(valence, random):
    """A point of any valence within two rings, with border; a crease runs out from it in half."""
    n = 2 * valence
    angles = np.pi * np.arange(n) / valence
    ring = np.stack([np.cos(angles), np.sin(angles), np.zeros(n)], axis=1)
    points = np.concatenate([np.zeros((1, 3)), ring, 2 * ring, 3 * ring])
    points += random.normal(0, 0.1, points.shape)
    k = np.arange(valence)
    faces = [np.stack([0 * k, 1 + 2 * k, 2 + 2 * k, 1 + (2 * k + 2) % n], axis=1)]
    k = np.arange(n)
    for r in (1, 1 + n):
        faces.append(np.stack([r + k, r + n + k, r + n + (k + 1) % n, r + (k + 1) % n], axis=1))
    faces = np.concatenate(faces)
    creases = [] if random.random() < 0.5 else [(0, 1), (1, 1 + n)]
    return hn.ControlMesh(points, np.full(len(faces), 4), faces.ravel(), creases=creases)


def basis_columns(surface, cells, uv):
    """(k, n) weights of all control points, from surfaces of unit control points."""
    mesh = surface.mesh
    weights = np.empty((len(cells), mesh.vertex_count))
    for point in range(mesh.vertex_count):
        unit = np.zeros((mesh.vertex_count, 3))
        unit[point, 2] = 1
        weights[:, point] = hn.LimitSurface(mesh.with_points(unit), surface.scheme).positions(
            cells, uv
        )[:, 2]
    return weights


def dense(surface, cells, uv):
    begin, points, weights = hn.point_weights(surface, cells, uv)
    rows = np.zeros((len(cells), surface.mesh.vertex_count))
    for i in range(len(cells)):
        part = slice(begin[i], begin[i + 1])
        rows[i, points[part]] = weights[part]
    return rows


def moves_of(pull, count):
    moves = np.zeros((count, 3))
    moves[pull.points] = pull.moves
    return moves


def least_norm_by_kkt(weights, wanted, locked, held):
    """Moves (n, 3) of least norm from the whole system of Lagrange's conditions."""
    n = weights.shape[1]
    rows, right = [], []
    for row, pull in zip(weights, wanted):
        for axis in range(3):
            condition = np.zeros((n, 3))
            condition[:, axis] = row
            rows.append(condition.ravel())
            right.append(pull[axis])
    for point in locked:
        for axis in range(3):
            condition = np.zeros((n, 3))
            condition[point, axis] = 1
            rows.append(condition.ravel())
            right.append(0)
    for point, normal in held:
        condition = np.zeros((n, 3))
        condition[point] = normal
        rows.append(condition.ravel())
        right.append(0)
    conditions, right = np.array(rows), np.array(right)
    m = len(right)
    system = np.block([[np.eye(3 * n), conditions.T], [conditions, np.zeros((m, m))]])
    solution = np.linalg.lstsq(system, np.concatenate([np.zeros(3 * n), right]), rcond=1e-13)[0]
    return solution[: 3 * n].reshape(n, 3)


@pytest.mark.parametrize("scheme", ["biermann", "catmull_clark"])
@pytest.mark.parametrize("valence", [3, 4, 5, 7])
def test_weights_are_the_basis_functions(valence, scheme):
    random = np.random.default_rng(SEED + valence)
    surface = hn.LimitSurface(ring_mesh(valence, random), scheme)
    cells = random.integers(0, surface.cell_count, 60)
    uv = random.choice([0, 1e-7, 0.1, 0.5, 0.83, 1], (60, 2))
    rows = dense(surface, cells, uv)
    np.testing.assert_allclose(rows, basis_columns(surface, cells, uv), atol=1e-14)
    np.testing.assert_allclose(rows @ surface.mesh.points, surface.positions(cells, uv), atol=1e-14)


@pytest.mark.parametrize("trial", range(24))
def test_moves_are_the_least_there_are(trial):
    random = np.random.default_rng(SEED + 100 + trial)
    scheme = ("biermann", "catmull_clark")[trial % 2]
    surface = hn.LimitSurface(ring_mesh(3 + trial % 6, random), scheme)
    n = surface.mesh.vertex_count
    # The first place is the irregular point itself, every fourth time.
    cells = random.integers(0, surface.cell_count, 1 + trial % 3)
    uv = random.uniform(0, 1, (len(cells), 2))
    if trial % 4 == 0:
        cells[0], uv[0] = 0, (0, 0)
    locked = random.choice(n, 5, replace=False)
    held_points = random.choice(n, 8)
    held_normals = random.normal(size=(8, 3))
    wanted = random.normal(0, 0.5, (len(cells), 3))
    before = surface.mesh.points
    targets = surface.positions(cells, uv) + wanted
    pull = hn.pull_surface(
        surface,
        cells,
        uv,
        targets,
        locked=locked,
        held_points=held_points,
        held_normals=held_normals,
    )
    moves = moves_of(pull, n)
    held = list(zip(held_points, held_normals))
    expected = least_norm_by_kkt(basis_columns(surface, cells, uv), wanted, locked, held)
    np.testing.assert_allclose(moves, expected, atol=1e-9 * max(1, pull.reach))
    assert (moves[locked] == 0).all()
    np.testing.assert_allclose((moves[held_points] * held_normals).sum(axis=1), 0, atol=1e-12)
    surface.set_points(before + moves)
    assert np.linalg.norm(surface.positions(cells, uv) - targets, axis=1).max() < 1e-9
    assert pull.miss < 1e-11
    assert pull.reach == pytest.approx(
        np.linalg.norm(moves, axis=1).max() / np.linalg.norm(wanted, axis=1).max()
    )


def test_the_surface_itself_is_left_alone():
    surface = hn.LimitSurface(ring_mesh(5, np.random.default_rng(SEED)))
    before = surface.mesh.points.copy()
    hn.pull_surface(surface, [3], [(0.5, 0.5)], surface.positions([3], [(0.5, 0.5)]) + 1)
    assert (surface.mesh.points == before).all()


def test_errors_name_what_is_wrong():
    surface = hn.LimitSurface(ring_mesh(5, np.random.default_rng(SEED)))
    at = surface.positions([3], [(0.5, 0.5)])
    everything = np.arange(surface.mesh.vertex_count)
    with pytest.raises(ValueError, match="Target 0 cannot be reached"):
        hn.pull_surface(surface, [3], [(0.5, 0.5)], at + 1, locked=everything)
    with pytest.raises(ValueError, match="Target 0 is no place within 1e9 m"):
        hn.pull_surface(surface, [3], [(0.5, 0.5)], at + 2e9)
    with pytest.raises(ValueError, match="as many targets"):
        hn.pull_surface(surface, [3], [(0.5, 0.5)], np.concatenate([at, at]))
    with pytest.raises(ValueError, match="held_points and held_normals"):
        hn.pull_surface(surface, [3], [(0.5, 0.5)], at, held_points=[1])
    with pytest.raises(ValueError, match="locked point is 1000"):
        hn.pull_surface(surface, [3], [(0.5, 0.5)], at, locked=[1000])
