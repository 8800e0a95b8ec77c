# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders, bodies and lines of meshes in many pieces: against a search through all pairs, and that
their cost does not grow with the square of the pieces."""

import numpy as np
import pytest
from hull_fitting import half_meshes
from hull_fitting.borders import _beside, _near_pairs, bodies, joined
from hull_fitting.half_meshes import half_mesh
from hull_fitting.shells import hull_shell
from hull_fitting.triangle_edges import edge_table, members
from hull_io.geometry.values import Geometry, GeometryMesh

SEED = 29112026


def loose(count, size, random):
    """(points, triangles) of triangles without common points, in a box of 100 x 20 x 10 m."""
    places = random.uniform(size=(count, 1, 3)) + size * random.normal(size=(count, 3, 3))
    return (places * (100.0, 20.0, 10.0)).reshape(-1, 3), np.arange(3 * count).reshape(-1, 3)


def strips(random):
    """Patches side by side without common points, divided in another way each."""
    points, triangles = [], []
    for k in range(8):
        x, y = np.meshgrid(np.linspace(0, 9, 4 + 3 * k), [k, k + 1.0 + 1e-4 * (k % 2)])
        numbers = np.arange(x.size).reshape(x.shape) + sum(map(len, points))
        a, b, c, d = (numbers[i, j].ravel() for i in (np.s_[:-1], np.s_[1:])
                      for j in (np.s_[:-1], np.s_[1:]))  # fmt: skip
        points.append(np.stack([x, y, 0.01 * np.sin(x)], axis=-1).reshape(-1, 3))
        triangles += [np.stack([a, b, d], axis=1), np.stack([a, d, c], axis=1)]
    return np.concatenate(points), np.concatenate(triangles)


def on_a_lattice(random):
    triangles = random.integers(0, 100, size=(150, 3))
    is_whole = (triangles != np.roll(triangles, -1, axis=1)).all(axis=1)
    return random.integers(0, 4, size=(100, 3)).astype(float), triangles[is_whole]


def beside_by_all_pairs(points, edges, tolerance):
    found = np.full(len(edges), -1)
    ways = points[edges[:, 1]] - points[edges[:, 0]]
    lengths = np.linalg.norm(ways, axis=1)
    units = ways / np.maximum(lengths, 1e-300)[:, None]
    for i, (a, b) in enumerate(edges):
        middle = points[a] + 0.5 * ways[i]
        for k, (c, d) in enumerate(edges):
            along = (middle - points[c]) @ units[k]
            off = np.linalg.norm(middle - points[c] - along * units[k])
            cosine = units[i] @ units[k]
            goes_on = (a == c or b == d) and cosine < 0.0 or (a == d or b == c) and cosine > 0.0
            if (a, b) == (c, d) or goes_on or abs(cosine) <= 0.8:
                continue
            if off < tolerance and 0.0 < along < lengths[k]:
                found[i] = k
                break
    return found


@pytest.mark.parametrize(
    "make",
    [strips, on_a_lattice, lambda r: loose(60, 0.05, r), lambda r: loose(60, 0.5, r)],
    ids=["strips", "lattice", "small", "large"],
)
def test_edges_beside_one_another(make):
    print("seed", SEED)
    points, triangles = make(np.random.default_rng(SEED))
    table = edge_table(triangles)
    edges = table.ends[table.is_border]
    found = _beside(points, edges, 0.03)
    np.testing.assert_array_equal(found, beside_by_all_pairs(points, edges, 0.03))
    if make is strips:
        assert (found >= 0).sum() > 50 and bodies(points, triangles, 0.03).max() == 0


def test_edges_far_apart_are_not_compared():
    """Of twice as many triangles in twice the room, twice as many pairs of edges."""
    counts = []
    for count in (200, 400):
        points, triangles = loose(count, 0.02, np.random.default_rng(SEED))
        points *= (count, 1.0, 1.0)
        points[:, 0] *= 0.01
        a, b = points[triangles[:, :2]].transpose(1, 0, 2)
        counts.append(sum(len(k) for k, _ in _near_pairs(0.5 * (a + b), a, b - a, 0.03)))
    assert counts[1] < 3.0 * counts[0] < 0.1 * 200**2


def joined_by_all_pairs(lines, reach):
    lines = list(lines)
    while len(lines) > 1:
        flat = np.array([[line[0], line[-1]] for line in lines]).reshape(-1, 3)
        apart = np.linalg.norm(flat[:, None] - flat[None], axis=2)
        owner = np.arange(len(flat)) // 2
        apart[owner[:, None] == owner[None]] = np.inf
        i, k = np.unravel_index(np.argmin(apart), apart.shape)
        if apart[i, k] > reach:
            break
        first = lines[owner[i]][::-1] if i % 2 == 0 else lines[owner[i]]
        second = lines[owner[k]] if k % 2 == 0 else lines[owner[k]][::-1]
        both = np.concatenate([first, second[1:] if apart[i, k] == 0.0 else second])
        lines = [line for n, line in enumerate(lines) if n not in (owner[i], owner[k])] + [both]
    return lines


@pytest.mark.parametrize("decimals", [0, 1, 15], ids=["many at one place", "some", "none"])
@pytest.mark.parametrize("reach", [0.0, 0.3, 50.0])
def test_lines_are_joined_the_nearest_first(decimals, reach):
    print("seed", SEED)
    random = np.random.default_rng(SEED)
    for count in (0, 1, 2, 9, 40):
        steps = [random.normal(size=(random.integers(1, 6), 3)) for _ in range(count)]
        lines = [np.cumsum(0.3 * step, axis=0) + 4.0 * random.uniform(size=3) for step in steps]
        lines = [np.round(line, decimals) for line in lines]
        found, wanted = joined(lines, reach), joined_by_all_pairs(lines, reach)
        assert len(found) == len(wanted)
        for line, other in zip(found, wanted):
            np.testing.assert_array_equal(line, other)


def test_joining_looks_at_near_ends_alone(monkeypatch):
    """Of 400 and of 800 lines, twice as many distances at the most, for ends lie as densely."""
    random, norm, counted = np.random.default_rng(SEED), np.linalg.norm, [0]

    def counting(values, **axis):
        counted[0] += len(values)
        return norm(values, **axis)

    monkeypatch.setattr(np.linalg, "norm", counting)
    counts = []
    for count in (400, 800):
        starts = random.uniform(size=(count, 3)) * (count, 1.0, 1.0)
        counted[0] = 0
        joined([np.stack([start, start + 0.1]) for start in starts], 0.5)
        counts.append(counted[0])
    assert counts[1] < 2.5 * counts[0]


def test_members_are_those_of_a_search():
    numbers = np.random.default_rng(SEED).permutation(np.repeat(np.arange(9), 5))
    for number, found in enumerate(members(numbers)):
        assert found.tolist() == np.flatnonzero(numbers == number).tolist()


def geometry(points, triangles):
    return Geometry("scan.stl", "STL", None, meshes=(GeometryMesh(points, triangles),))


def test_soups_are_refused(monkeypatch):
    points, triangles = loose(60, 0.05, np.random.default_rng(SEED))
    mesh = half_mesh(geometry(points, triangles))
    assert len(hull_shell(mesh).mesh.triangles)
    monkeypatch.setattr(half_meshes, "_MOST_PIECES", 20)
    with pytest.raises(ValueError, match=r"^scan.stl: its surface is in \d+ pieces .*\.$"):
        half_mesh(geometry(points, triangles))


@pytest.mark.parametrize(
    "points, words",
    [
        ([(0, 1, 0), (5, 1, 0), (9, 1, 0)], "none of its triangles has an area"),
        ([(0, 0, 0), (5, 0, 0), (9, 0, 3)], "none of its triangles has an area"),
        ([(5, 1, 0), (5, 2, 0), (5, 1, 3)], "its surface has no length"),
    ],
)
def test_triangles_without_area_are_refused(points, words):
    with pytest.raises(ValueError, match=f"^scan.stl: {words}"):
        half_mesh(geometry(np.array(points, dtype=float), np.array([(0, 1, 2)])))
