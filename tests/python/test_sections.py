# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane sections: of the samples, of the reference hulls, and against FREE!ship's own stations."""

import struct
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest
from hull_io.freeship import read_stored_sections
from reference_data import FREESHIP, foreign_ships, hull_path

ROOT = Path(__file__).resolve().parents[2]

SAMPLES = sorted((ROOT / "samples").glob("*.hull.json"))


def surface_of(path, scheme="biermann"):
    data = hull_io.read_hull(path)
    shell = hull_io.shell_arrays(data)
    mesh = hn.ControlMesh(*shell.arguments())
    return data, shell, hn.LimitSurface(mesh, scheme)


def length_of(curve):
    return np.linalg.norm(np.diff(curve.points, axis=0), axis=1).sum()


def planes_through(surface, random, count):
    """Across the axes, through control points and at the ends, diagonals, and any."""
    points = surface.mesh.points
    low, high = points.min(axis=0), points.max(axis=0)
    planes = [
        hn.plane_across(name, position)
        for k, name in enumerate("xyz")
        for position in (*np.linspace(low[k], high[k], 12), *random.choice(points[:, k], 6), 0.0)
    ]
    for angle in np.linspace(0.0, 0.5 * np.pi, 7):
        planes.append(hn.diagonal_plane(0.5 * (low[2] + high[2]), angle))
    for _ in range(count):
        normal = random.normal(size=3)
        normal /= np.linalg.norm(normal)
        planes.append([*normal, normal @ surface.positions([0], random.random((1, 2)))[0]])
    return np.array(planes)


@pytest.mark.parametrize("name", [*(path.name for path in SAMPLES), *foreign_ships()])
def test_points_lie_on_surface_and_plane(name):
    seed = 9
    surface = surface_of(hull_path(name))[2]
    planes = planes_through(surface, np.random.default_rng(seed), 40)
    tolerance = 1e-10 * surface.mesh.size
    found = 0
    for plane, curves in zip(planes, hn.sections(surface, planes, 1e-4 * surface.mesh.size)):
        for curve in curves:
            found += 1
            assert np.abs(curve.points @ plane[:3] - plane[3]).max() <= tolerance
            there = surface.positions(curve.cells, curve.uv)
            assert np.abs(there - curve.points).max() <= tolerance
            assert np.linalg.norm(curve.tangents, axis=1) == pytest.approx(1.0, abs=1e-9)
            assert np.abs(curve.tangents @ plane[:3]).max() < 1e-6
            assert np.isfinite(curve.curvatures).all()
    assert found > len(planes) / 2


@pytest.mark.parametrize("path", SAMPLES, ids=lambda path: path.name)
def test_areas_within_stations_are_sectional_areas(path):
    data, _, surface = surface_of(path)
    body = hn.HullBody(surface, mirrored=True)
    x = np.linspace(0.05, 0.93, 17) * data.particulars.length_pp
    # Wholly immersed: decks and transoms close along athwartships lines, which have no part in
    # the integral of y dz.
    areas = hn.section_areas(body, x, draft=100.0).areas
    planes = np.array([hn.plane_across("x", position) for position in x])
    nodes, weights = np.polynomial.legendre.leggauss(6)
    for branches, area in zip(hn.section_splines(surface, planes, 1e-7), areas):
        found = 0.0
        for branch in branches:
            for spline in branch.splines:
                knots = spline.knots[3:-3]
                half = 0.5 * np.diff(knots)
                t = (0.5 * (knots[1:] + knots[:-1]))[:, None] + half[:, None] * nodes
                p = spline.evaluate(t.ravel())
                step = 1e-3 * half[:, None] * np.ones(6)
                ahead, behind = spline.evaluate((t + step).ravel()), spline.evaluate(
                    (t - step).ravel()
                )
                slope = (ahead[:, 2] - behind[:, 2]) / (2.0 * step.ravel())
                found += 2.0 * np.sum(p[:, 1] * slope * (half[:, None] * weights).ravel())
        assert found == pytest.approx(area, rel=1e-6)


def test_the_centre_plane_and_the_flats_of_a_half_hull():
    barge = surface_of(ROOT / "samples" / "barge.hull.json")[2]
    (profile,) = hn.section(barge, "y", 0.0)
    assert not profile.closed
    assert np.ptp(profile.points, axis=0) == pytest.approx([76.5, 0.0, 4.5], abs=1e-9)
    (bottom,) = hn.section(barge, "z", 0.0)
    assert bottom.closed and len(bottom.knuckles) == 4
    assert bottom.points.max(axis=0) == pytest.approx([51.5, 3.795, 0.0], abs=0.01)
    (side,) = hn.section(barge, "y", 5.7)
    assert side.closed


def test_a_panel_in_single_precision_has_its_outline():
    path = FREESHIP / "pdock+weght_symm.fbm"
    if not path.exists():
        pytest.skip(f"no {path}")
    surface = surface_of(path)[2]
    (panel,) = hn.section(surface, "x", 2.0, flat_tolerance=1e-6)
    assert panel.closed and len(panel.knuckles) == 4
    assert length_of(panel) == pytest.approx(4.0, abs=1e-6)


def facet_errors(surface, precision):
    """(cells,) how far FREE!ship's facets may be from the surface within each cell.

    It shows the mesh subdivided precision + 1 times: facets of h = 2^-precision of a cell, with
    their corners on the control points. Those are off by the second differences' sixth, and the
    facets' middles by another eighth; the twist is halved by the facets' diagonals.
    """
    h = 0.5**precision
    jet = surface.evaluate_grid(8, 2)
    size = [np.linalg.norm(part.reshape(surface.cell_count, -1, 3), axis=2) for part in jet[3:]]
    bend = (1.0 / 6.0 + 1.0 / 8.0) * (size[0] + size[2]) + 0.25 * size[1]
    return h * h * bend.max(axis=1)


def distances(points, polyline):
    a, d = polyline[:-1], np.diff(polyline, axis=0)
    r = points[:, None] - a
    length2 = np.maximum((d * d).sum(axis=1), 1e-300)
    t = np.clip((r * d).sum(axis=2) / length2, 0.0, 1.0)
    return np.linalg.norm(r - t[..., None] * d, axis=2).min(axis=1)


# Root mean square and largest distance in m, as measured.
@pytest.mark.parametrize(
    "name, usual, most",
    [
        ("FREE!ship demo 3", 0.006, 0.03),
        ("FREE!ship demo 4", 0.003, 0.035),
        ("Parent 22_Oort", 0.003, 0.02),
    ],
)
def test_stations_that_freeship_stored(name, usual, most):
    path = FREESHIP / f"{name}.fbm"
    if not path.exists():
        pytest.skip(f"no {path}")
    data = path.read_bytes()
    (precision,) = struct.unpack_from("<i", data, 14)
    surface = surface_of(path, "catmull_clark")[2]
    errors = facet_errors(surface, precision)
    off = []
    for station in read_stored_sections(data, path.name):
        if station.kind != "station" or not station.curves:
            continue
        normal = np.array(station.plane[:3])
        position = -station.plane[3] / np.linalg.norm(normal)
        curves = hn.section(surface, normal, position, 1e-5, flat_tolerance=1e-6)
        if not curves:
            continue
        points = np.concatenate([curve.points for curve in curves])
        cells = np.concatenate([curve.cells for curve in curves])
        uv = np.concatenate([curve.uv for curve in curves])
        cosine = surface.normals(cells, uv) @ (normal / np.linalg.norm(normal))
        sine = np.sqrt(np.maximum(1.0 - cosine**2, 0.05**2))
        for stored, _ in station.curves:
            found = np.min([distances(stored, curve.points) for curve in curves], axis=0)
            apart = np.linalg.norm(stored[:, None] - points, axis=2)
            near = apart <= apart.min(axis=1)[:, None] + 2.0 * found[:, None] + 0.05
            # Coordinates of single precision are off by 1e-5 m.
            allowed = np.where(near, errors[cells] / sine, 0.0).max(axis=1) + 1e-5
            assert (found <= allowed).all(), f"station {station.plane}"
            off.append(found)
    off = np.concatenate(off)
    assert len(off) > 1000
    assert np.sqrt(np.mean(off**2)) < usual and off.max() < most


def test_curves_from_knuckle_to_knuckle():
    barge = surface_of(ROOT / "samples" / "barge.hull.json")[2]
    for curve in hn.section(barge, "x", 60.0):
        stretches = curve.stretches
        assert len(stretches) == len(curve.knuckles) + (0 if curve.closed else 1)
        joined = np.concatenate([s.points[bool(k) :] for k, s in enumerate(stretches)])
        assert np.array_equal(joined, curve.points)
        for k, stretch in enumerate(stretches[1:]):
            assert np.array_equal(stretch.tangents[0], curve.knuckle_tangents[k])
            assert stretch.curvatures[0] == curve.knuckle_curvatures[k]
        assert len(curve.tangents) == len(curve.curvatures) == len(curve.points)


def test_splines_describe_themselves():
    barge = surface_of(ROOT / "samples" / "barge.hull.json")[2]
    plane = hn.diagonal_plane(4.0, np.radians(35.0))
    for branch in hn.section_splines(barge, [plane], 1e-4)[0]:
        for spline in branch.splines:
            assert spline.degree == 3
            assert len(spline.knots) == len(spline.control_points) + 4
            assert (spline.knots[:4] == spline.knots[0]).all()
            assert np.abs(spline.control_points @ plane[:3] - plane[3]).max() < 1e-12
            assert spline.largest_distance <= 1e-4
            ends = spline.evaluate(spline.knots[[0, -1]])
            assert np.abs(ends - spline.control_points[[0, -1]]).max() < 1e-12


def test_splines_pass_over_edges_without_length():
    """Two corners of the border lie in one place."""
    points = [(0, 2, 0), (0, 0, 0), (3, 2, 0), (3, 0, 0), (3, 4, 0), (3, 0, 0)]
    faces, corners = [1, 0, 2, 3, 3, 2, 4, 5], [3, 4, 5]
    creases = [(2, 3), (3, 1), (4, 5), (5, 3)]
    mesh = hn.ControlMesh(np.array(points, dtype=float), [4, 4], faces, creases, corners)
    surface = hn.LimitSurface(mesh)
    for x in ("x", "y", "z"):
        for at in (0.0, 3.0):
            for branch in hn.section_splines(surface, [hn.plane_across(x, at)], 1e-6)[0]:
                assert all(np.ptp(spline.knots) > 1e-9 for spline in branch.splines)


def test_refusals():
    barge = surface_of(ROOT / "samples" / "barge.hull.json")[2]
    with pytest.raises(ValueError, match="axis"):
        hn.section(barge, "w", 0.0)
    # Half of a pair of UTF-16 is text in Python alone.
    with pytest.raises(ValueError, match="An axis is"):
        hn.section(barge, "\ud800", 0.5)
    with pytest.raises(ValueError, match="axis is no plane"):
        hn.section(barge, [0.0, 0.0, 0.0], 0.0)
    with pytest.raises(ValueError, match=r"\(n, 4\)"):
        hn.sections(barge, [[1.0, 0.0, 0.0]])
    with pytest.raises(ValueError, match=r"planes\[1\]"):
        hn.sections(barge, [[1.0, 0.0, 0.0, 2.0], [0.0, 0.0, 0.0, 1.0]])
    with pytest.raises(ValueError, match="chord tolerance"):
        hn.section(barge, "x", 1.0, -1.0)
    with pytest.raises(ValueError, match="flat tolerance"):
        hn.section(barge, "x", 1.0, flat_tolerance=-1.0)
    with pytest.raises(ValueError, match="tolerance"):
        hn.section_splines(barge, [[1.0, 0.0, 0.0, 2.0]], 0.0)
