# SPDX-License-Identifier: GPL-3.0-or-later
"""A subdivided control mesh taken back to the one that it came from."""

from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest

SAMPLES = Path(__file__).resolve().parents[2] / "samples"
NAMES = sorted(path.name[: -len(".hull.json")] for path in SAMPLES.glob("*.hull.json"))
SCHEMES = ["biermann", "catmull_clark"]

# Of the size: rounding of some sums; and where points of three faces alternate, as of a cube, of
# which there are many with one subdivision.
ROUNDED, ALTERNATING = 1e-14, 1e-12


def sample(name):
    shell = hull_io.shell_arrays(hull_io.read_hull(SAMPLES / f"{name}.hull.json"))
    return shell.arguments()


def pairs(mesh):
    return sorted(tuple(sorted(edge)) for edge in mesh.creases.tolist())


def assert_same(found, mesh, rounded=ROUNDED):
    assert np.abs(found.points - mesh.points).max() < rounded * mesh.size
    assert np.array_equal(found.face_sizes, mesh.face_sizes)
    assert np.array_equal(found.face_vertices, mesh.face_vertices)
    assert np.array_equal(found.vertex_kinds, mesh.vertex_kinds)
    assert pairs(found) == pairs(mesh)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("name", NAMES)
def test_samples_are_what_they_were(name, scheme):
    """After one and two subdivisions."""
    mesh = hn.ControlMesh(*sample(name))
    finer = hn.LimitSurface(mesh, scheme).refined_mesh()
    finest = hn.LimitSurface(finer, scheme).refined_mesh()
    between = hn.LimitSurface(finest, scheme).coarsened_mesh()
    assert_same(between.mesh, finer)
    found = hn.LimitSurface(between.mesh, scheme).coarsened_mesh()
    assert_same(found.mesh, mesh)
    assert 0.0 <= found.rms <= found.largest < ROUNDED * mesh.size
    assert np.array_equal(found.points, np.arange(len(mesh.points)))
    assert np.array_equal(found.faces, np.arange(finer.face_count))


@pytest.mark.parametrize("name", ["coaster", "catamaran", "sailing_yacht"])
def test_numbers_of_points_and_faces_do_not_matter(name):
    mesh = hn.ControlMesh(*sample(name))
    finer = hn.LimitSurface(mesh).refined_mesh()
    random = np.random.default_rng(31)
    new = random.permutation(len(finer.points))
    faces = new[finer.face_vertices.reshape(-1, 4)]
    faces = np.stack(
        [np.roll(face, turn) for face, turn in zip(faces, random.integers(4, size=len(faces)))]
    )
    faces = random.permutation(faces)
    points = np.empty_like(finer.points)
    points[new] = finer.points
    corners = np.flatnonzero(np.isin(finer.vertex_kinds, (3, 4)))
    shuffled = hn.ControlMesh(
        points, finer.face_sizes, faces.reshape(-1), new[finer.creases], new[corners]
    )
    found = hn.LimitSurface(shuffled).coarsened_mesh()
    assert np.array_equal(found.points, np.sort(new[: len(mesh.points)]))
    original = np.argsort(new)[found.points]
    assert np.abs(found.mesh.points - mesh.points[original]).max() < ROUNDED * mesh.size
    ends = np.cumsum(found.mesh.face_sizes)[:-1]
    there = [original[face] for face in np.split(found.mesh.face_vertices, ends)]
    here = np.split(mesh.face_vertices, np.cumsum(mesh.face_sizes)[:-1])
    assert sorted(map(cycle, there)) == sorted(map(cycle, here))
    assert np.array_equal(found.mesh.vertex_kinds, mesh.vertex_kinds[original])
    first = finer.face_vertices.reshape(-1, 4)[0]
    assert new[first[0]] in shuffled.face_vertices.reshape(-1, 4)[found.faces].ravel()


def cycle(face):
    """A face from its lowest point on."""
    return tuple(np.roll(face, -int(np.argmin(face))).tolist())


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("name", ["research_vessel", "naval_vessel"])
def test_of_moved_points_the_nearest_is_found(name, scheme):
    """By dense least squares, whose columns are subdivided meshes of single points."""
    points, *faces = sample(name)
    surface = hn.LimitSurface(hn.ControlMesh(points, *faces), scheme)
    finer = surface.refined_mesh()
    columns = []
    for index in range(len(points)):
        unit = np.zeros_like(points)
        unit[index, 0] = 1.0
        surface.set_points(unit)
        columns.append(surface.refined_mesh().points[:, 0])
    matrix = np.stack(columns, axis=1)
    moved = finer.points + np.random.default_rng(32).normal(0.0, 0.05, finer.points.shape)
    wanted = np.linalg.lstsq(matrix, moved, rcond=None)[0]
    off = np.linalg.norm(moved - matrix @ wanted, axis=1)
    found = hn.LimitSurface(finer.with_points(moved), scheme).coarsened_mesh()
    assert np.abs(found.mesh.points - wanted).max() < 1e-13 * finer.size
    assert found.rms == pytest.approx(np.sqrt(np.mean(off**2)), rel=1e-10)
    assert found.largest == pytest.approx(off.max(), rel=1e-10)
    assert found.largest_point == np.argmax(off)


CUBE = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
CUBE_FACES = [0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5]


def octahedron():
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    up = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4)]
    down = [(b, a, 5) for a, b, _ in up]
    return hn.ControlMesh(points, [3] * 8, np.ravel(up + down))


def torus(rows, columns):
    u, v = np.meshgrid(
        2 * np.pi * np.arange(rows) / rows, 2 * np.pi * np.arange(columns) / columns, indexing="ij"
    )
    ring = 3.0 + np.cos(v) + 0.2 * np.sin(u)
    points = np.stack([ring * np.cos(u), ring * np.sin(u), np.sin(v)], axis=-1).reshape(-1, 3)
    i, j = (
        index.ravel() for index in np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    )
    corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
    faces = np.stack([a % rows * columns + b % columns for a, b in corners], axis=1)
    return hn.ControlMesh(points, [4] * len(faces), faces.ravel())


@pytest.mark.parametrize(
    "mesh", [hn.ControlMesh(CUBE, [4] * 6, CUBE_FACES), octahedron(), torus(4, 6)]
)
def test_of_several_ways_the_nearest_counts(mesh):
    """A cube once subdivided has the faces of an octahedron that was; a torus shifts by a row."""
    found = hn.LimitSurface(hn.LimitSurface(mesh).refined_mesh()).coarsened_mesh()
    assert_same(found.mesh, mesh, ALTERNATING)


def test_each_part_is_taken_back_by_itself():
    """Two of them, their faces by turns, and a point without faces."""
    cube, other = hn.ControlMesh(CUBE, [4] * 6, CUBE_FACES), octahedron()
    ends = np.split(np.asarray(CUBE_FACES), 6), np.split(other.face_vertices + 8, 8)
    faces = [face for both in zip(*ends) for face in both] + ends[1][6:]
    points = np.concatenate([cube.points, other.points + [9.0, 0.0, 0.0], [[20.0, 0.0, 0.0]]])
    mesh = hn.ControlMesh(points, [len(face) for face in faces], np.concatenate(faces))
    found = hn.LimitSurface(hn.LimitSurface(mesh).refined_mesh()).coarsened_mesh()
    assert_same(found.mesh, mesh, ALTERNATING)


def grid(rows, columns, creases=(), corners=(), without=()):
    points = [(x, y, 0.0) for y in range(rows + 1) for x in range(columns + 1)]
    low = [y * (columns + 1) + x for y in range(rows) for x in range(columns)]
    low = np.delete(low, without).tolist()
    faces = [(a, a + 1, a + columns + 2, a + columns + 1) for a in low]
    return hn.ControlMesh(points, [4] * len(faces), np.ravel(faces), creases, corners)


@pytest.mark.parametrize(
    "mesh, said",
    [
        (octahedron(), "a face at point 0 has 3 corners instead of four"),
        (hn.ControlMesh(CUBE, [4] * 6, CUBE_FACES), r"faces around point \d do not alternate"),
        (grid(3, 2), r"a border would run into a face at point \d+"),
        (
            grid(5, 2, without=[4]),
            "point 7 needs 2 faces around it to be the middle of an edge, and has 3",
        ),
        (grid(4, 4, corners=[1]), "point 1 would be the middle of an edge, and is a corner"),
        (grid(4, 4, corners=[6]), "point 6 would be the middle of a face, and is tagged"),
        (grid(4, 4, creases=[(1, 6)]), r"a crease would run into a face at point [16]\b"),
        (
            grid(4, 4, creases=[(11, 12)]),
            "point 11 would be the middle of an edge, and is a corner or",
        ),
    ],
)
def test_what_is_no_subdivided_mesh_is_told(mesh, said):
    with pytest.raises(ValueError, match=said) as caught:
        hn.LimitSurface(mesh).coarsened_mesh()
    assert str(caught.value).endswith("there.")


def test_what_would_be_no_mesh_is_told():
    """Triangles on three lunes of a sphere: poles 0 and 1 would have three edges between them."""
    faces = []
    for i in range(3):
        x, to_a, to_b = 2 + i, 8 + i, 11 + i
        for corners, along, other in ((0, 1), i, (to_a, to_b)), ((1, 0), (i + 1) % 3, (to_b, to_a)):
            (p, q), middle, (xp, qx) = corners, 5 + along, other
            centre = 14 + 2 * i + p
            faces += [(p, middle, centre, xp), (q, qx, centre, middle), (x, xp, centre, qx)]
    turns = np.radians([0, 0, 60, 180, 300, 0, 120, 240, 60, 180, 300, 60, 180, 300, 30, 90, 150,
                        210, 270, 330])  # fmt: skip
    heights = np.array([1, -1] + 6 * [0] + 3 * [0.5] + 3 * [-0.5] + 6 * [0])
    breadths = np.sqrt(1 - heights**2)
    points = np.stack([breadths * np.cos(turns), breadths * np.sin(turns), heights], axis=1)
    mesh = hn.ControlMesh(points, np.full(18, 4), np.ravel(faces))
    with pytest.raises(ValueError, match="would make no valid mesh, as at point 0. Take back"):
        hn.LimitSurface(mesh).coarsened_mesh()


@pytest.mark.parametrize("name", NAMES)
def test_samples_themselves_are_none(name):
    with pytest.raises(ValueError, match="The mesh is no subdivided one"):
        hn.LimitSurface(hn.ControlMesh(*sample(name))).coarsened_mesh()
