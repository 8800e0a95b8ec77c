# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact patches against the surface: equal outside the corner squares, and within what is asked."""

from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest
from reference_data import MESHES, foreign_ships, hull_path, reference_mesh

pytestmark = pytest.mark.one_in(3)

ROOT = Path(__file__).resolve().parents[2]

SAMPLES = sorted(path.name for path in (ROOT / "samples").glob("*.hull.json"))
SHIPS = foreign_ships()
ALL = SAMPLES + SHIPS + MESHES
FEW_PATCHES = [*SAMPLES, *foreign_ships(*(f"FREE!ship demo {number}.fbm" for number in (3, 4, 6)))]
SCHEMES = ["biermann", "catmull_clark"]
SEED = 601


def control_mesh(name):
    if name not in MESHES:
        return hn.ControlMesh(*shell_of(name))
    return reference_mesh(name)


def shell_of(name):
    """Arguments of ControlMesh."""
    shell = hull_io.shell_arrays(hull_io.read_hull(hull_path(name)))
    return shell.arguments()


_surfaces = {}


def surface_of(name, scheme="biermann"):
    if (name, scheme) not in _surfaces:
        _surfaces[name, scheme] = hn.LimitSurface(control_mesh(name), scheme)
    return _surfaces[name, scheme]


# Per side that a cell has as its v = 0: the place (a, b) in the block's direction is
# origin + a * along + b * across in the cell's (u, v).
ORIGIN = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
ALONG = np.array([[1, 0], [0, 1], [-1, 0], [0, -1]], float)
ACROSS = np.array([[0, 1], [-1, 0], [0, -1], [1, 0]], float)


def random_places(patches, grading, count, random):
    """Places outside the squares of 2^-grading at the corners of patches, crowding towards those.

    Returns patch (k,), uv (k, 2) of the patch, and of the same places cell (k,), uv (k, 2), side
    (k,) and counts (k, 2) of the patch's cells.
    """
    found = [[] for _ in range(6)]
    for patch in random.integers(patches.patch_count, size=count):
        half_edges = patches.half_edges(patch)
        counts = np.array(half_edges.shape)
        # From a corner: geometric in one direction, in the other one as well or anywhere.
        steps = 0.5 ** random.uniform(0.0, grading, 2)
        steps[random.integers(2)] = random.random()
        if np.max(steps) < 0.5**grading:
            continue
        cell = np.where(random.random(2) < 0.5, [0, 0], counts - 1)
        inner = np.where(random.random(2) < 0.3, random.integers(counts), cell)
        local = np.where(random.random(2) < 0.5, steps, 1.0 - steps)
        local = np.where(cell == 0, np.minimum(local, 1.0), local)
        corner = np.minimum(inner + local, counts - inner - local)
        if np.max(corner) <= 0.5**grading:
            continue
        side = half_edges[tuple(inner)] % 4
        place = ORIGIN[side] + local[0] * ALONG[side] + local[1] * ACROSS[side]
        values = patch, (inner + local) / counts, half_edges[tuple(inner)] // 4, place, side, counts
        for column, value in zip(found, values):
            column.append(value)
    return tuple(np.array(column) for column in found)


def differences(surface, patches, grading, random, count=4000):
    """The largest difference of points, first and second derivatives, with respect to the cell's
    (u, v) as the patch turns it."""
    patch, patch_uv, cell, cell_uv, side, counts = random_places(patches, grading, count, random)
    mine = patches.evaluate(patch, patch_uv)
    point, du, dv, duu, duv, dvv = surface.evaluate(cell, np.clip(cell_uv, 0.0, 1.0), derivatives=2)
    # Along a = x u + y v with (x, y) = ALONG; and b likewise.
    ax, ay, bx, by = (c[:, None] for c in (*ALONG[side].T, *ACROSS[side].T))
    theirs = (
        point,
        ax * du + ay * dv,
        bx * du + by * dv,
        ax * ax * duu + 2 * ax * ay * duv + ay * ay * dvv,
        ax * bx * duu + (ax * by + ay * bx) * duv + ay * by * dvv,
        bx * bx * duu + 2 * bx * by * duv + by * by * dvv,
    )
    nu, nv = (c[:, None] for c in counts.T)
    scales = 1.0, nu, nv, nu * nu, nu * nv, nv * nv
    off = [np.linalg.norm(m / scale - t, axis=1).max() for m, scale, t in zip(mine, scales, theirs)]
    return off[0], max(off[1:3]), max(off[3:])


# At most how often a corner's knots are halved here: a second derivative is told by positions that
# are 2^-K apart, so rounding of 1e-16 grows to 4^K times that.
GRADING = 7


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("name", ALL)
def test_exact_outside_the_corner_squares(name, scheme):
    surface = surface_of(name, scheme)
    patches = hn.exact_patches(surface, grading=GRADING)
    random = np.random.default_rng(SEED)
    position, first, second = differences(surface, patches, GRADING, random)
    length = np.ptp(surface.mesh.points, axis=0).max()
    assert position <= 1e-12 * length
    assert first <= 1e-9 * length
    assert second <= 1e-9 * length


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("name", ALL)
def test_deep_knots_lose_no_more_than_rounding(name, scheme):
    grading = 16
    surface = surface_of(name, scheme)
    patches = hn.exact_patches(surface, grading=grading)
    random = np.random.default_rng(SEED + 1)
    position, first, second = differences(surface, patches, grading, random)
    length = np.ptp(surface.mesh.points, axis=0).max()
    assert position <= 1e-12 * length
    assert first <= 1e-9 * length
    assert second <= 1e-14 * 4.0**grading * length


def degrees(report):
    return np.degrees(report.largest_seam_angle)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("name", ALL)
def test_default_tolerance_is_kept(name, scheme):
    surface = surface_of(name, scheme)
    report = hn.measure_quality(surface, hn.exact_patches(surface))
    assert report.largest_distance_per_length <= 1e-6
    assert degrees(report) <= 0.02
    assert report.largest_gap <= 1e-13 * report.length


# With Catmull-Clark's rules angles at some corners do not shrink with the squares: see
# docs/conversion.md.
ANGLES_NOT_KEPT = {
    ("FREE!ship demo 6.fbm", "catmull_clark"),
    ("Parent 22_Oort.fbm", "catmull_clark"),
}


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("name", ALL)
def test_more_can_be_asked_for_with_as_many_patches(name, scheme):
    surface = surface_of(name, scheme)
    patches = hn.exact_patches(surface, tolerance=1e-8, seam_angle=np.radians(0.002))
    report = hn.measure_quality(surface, patches)
    assert report.largest_distance_per_length <= 1e-8
    assert degrees(report) <= 0.002 or (name, scheme) in ANGLES_NOT_KEPT
    assert report.largest_gap <= 1e-13 * report.length
    assert patches.patch_count == hn.exact_patches(surface, grading=2).patch_count


@pytest.mark.parametrize("name", FEW_PATCHES)
def test_a_sixth_of_the_patches_of_one_a_cell(name):
    surface = surface_of(name)
    report = hn.measure_quality(surface, hn.exact_patches(surface))
    assert report.patch_count <= surface.cell_count / 6
    assert report.patch_count <= 1.5 * report.theoretical_patch_count


def grid(m, n, shape, wrap_u=False, wrap_v=False, creases=()):
    """m x n quadrilaterals at shape(i / m, j / n); creases: (i, j, i, j) of edges."""
    columns, rows = m + (not wrap_u), n + (not wrap_v)
    number = lambda i, j: (i % columns) * rows + j % rows  # noqa: E731
    points = [shape(i / m, j / n) for i in range(columns) for j in range(rows)]
    faces = [
        [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)]
        for i in range(m)
        for j in range(n)
    ]
    edges = [(number(a, b), number(c, d)) for a, b, c, d in creases]
    return hn.ControlMesh(
        np.array(points, float),
        np.full(len(faces), 4),
        np.concatenate(faces),
        np.array(edges, int).reshape(-1, 2),
    )


def sheet(s, t):
    return 4 * s, 3 * t, np.sin(4 * s) * np.cos(3 * t) + s * t


def tube(s, t):
    angle = 2 * np.pi * s
    return 5 * t, (1 + t) * np.cos(angle), 1.3 * np.sin(angle) + t * t


def torus(s, t):
    a, b = 2 * np.pi * s, 2 * np.pi * t
    return (3 + np.cos(b)) * np.cos(a), (3.5 + np.cos(b)) * np.sin(a), np.sin(b)


def box(creased):
    points = np.array([(x, y, z) for z in (0, 1) for y in (0, 1.5) for x in (0, 4)], float)
    faces = [0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5]
    corners = np.reshape(faces, (6, 4))
    edges = {tuple(sorted(pair)) for c in corners for pair in zip(c, np.roll(c, -1))}
    return hn.ControlMesh(points, np.full(6, 4), np.array(faces), sorted(edges) if creased else [])


def along(j, columns):
    return [(i, j, i + 1, j) for i in range(columns)]


# Name: mesh, rectangles.
REGULAR = {
    "sheet": (grid(5, 4, sheet), 1),
    "one face": (grid(1, 1, sheet), 1),
    "sheet with a crease": (grid(5, 4, sheet, creases=along(1, 5)), 2),
    "sheet with three creases": (
        grid(6, 5, sheet, creases=along(1, 6) + along(2, 6) + along(4, 6)),
        4,
    ),
    "tube": (grid(7, 4, tube, wrap_u=True), 1),
    "prism": (grid(6, 3, tube, wrap_u=True, creases=[(0, j, 0, j + 1) for j in range(3)]), 1),
    "prism with two creases": (
        grid(6, 3, tube, wrap_u=True, creases=[(i, j, i, j + 1) for i in (1, 4) for j in range(3)]),
        2,
    ),
    "prism with every edge creased": (
        grid(
            6, 3, tube, wrap_u=True, creases=[(i, j, i, j + 1) for i in range(6) for j in range(3)]
        ),
        6,
    ),
    "tube with creased rings": (
        grid(7, 4, tube, wrap_u=True, creases=along(1, 7) + along(3, 7)),
        3,
    ),
    "torus": (grid(8, 6, torus, wrap_u=True, wrap_v=True), 1),
    "torus with a crease": (grid(8, 6, torus, wrap_u=True, wrap_v=True, creases=along(2, 8)), 1),
    "creased box": (box(True), 6),
}
# How many patches a rectangle becomes: one beside itself is halved, for CAD systems read closed
# patches otherwise.
HALVED = {"tube": 2, "prism": 2, "tube with creased rings": 2, "torus": 4, "torus with a crease": 4}


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("name", REGULAR)
def test_regular_meshes_are_exact_with_a_patch_for_each_rectangle(name, scheme):
    mesh, rectangles = REGULAR[name]
    surface = hn.LimitSurface(mesh, scheme)
    patches = hn.exact_patches(surface)
    report = hn.measure_quality(surface, patches, samples=5)
    assert patches.patch_count == rectangles * HALVED.get(name, 1)
    assert report.theoretical_patch_count == rectangles
    assert report.largest_distance <= 1e-12 * report.length
    assert report.exact_share == pytest.approx(1.0, abs=1e-14)
    assert report.largest_gap <= 1e-13 * report.length
    assert degrees(report) <= 1e-9
    assert report.largest_curvature_jump <= 1e-9
    # Uniform knots where there is nothing to grade: one a face at most.
    assert report.control_point_count <= 4 * surface.cell_count + 12 * patches.patch_count + 40
    random = np.random.default_rng(SEED + 2)
    position, first, second = differences(surface, patches, 60, random, count=1000)
    assert position <= 1e-12 * report.length
    assert first <= 1e-11 * report.length
    assert second <= 1e-9 * report.length


def subdivided(points, face_sizes, face_vertices, creases, corners):
    """Arguments of ControlMesh with new points at the middles of edges and faces, as Blender's
    Subdivide makes them: the surface has large parts that are plane or ruled."""
    places, middles = list(points), {}

    def middle(*ends):
        if ends not in middles:
            middles[ends] = len(places)
            places.append(points[list(ends)].mean(axis=0))
        return middles[ends]

    faces = []
    for face in np.split(face_vertices, np.cumsum(face_sizes)[:-1]):
        ring = [middle(*sorted((a, b))) for a, b in zip(face, np.roll(face, -1))]
        centre = len(places)
        places.append(points[face].mean(axis=0))
        faces += [(face[i], ring[i], centre, ring[i - 1]) for i in range(len(face))]
    halves = [(end, middle(*sorted(edge))) for edge in creases for end in edge]
    return np.array(places), np.full(len(faces), 4), np.ravel(faces), np.array(halves), corners


@pytest.mark.parametrize("name", SAMPLES)
def test_meshes_subdivided_without_smoothing_are_converted_to_the_last_digits(name, tmp_path):
    shell = shell_of(name)
    for _ in range(3):
        shell = subdivided(*shell)
    surface = hn.LimitSurface(hn.ControlMesh(*shell))
    patches = hn.exact_patches(surface)
    report = hn.measure_quality(surface, patches)
    assert report.largest_gap <= 1e-13 * report.length
    assert hn.write_step(patches, str(tmp_path / "hull.step"))["valid"]


def test_a_tolerance_that_is_refused_is_told_as_given():
    surface = hn.LimitSurface(hn.ControlMesh(np.eye(4, 3), [4], [3, 0, 1, 2]))
    with pytest.raises(ValueError, match="tolerance of patches must be .*, not 1e-11"):
        hn.exact_patches(surface, tolerance=1e-11)
