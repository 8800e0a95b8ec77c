# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of networks as B-spline patches: samples by their lines and back, and CAD files."""

import os

import hull_native as hn
import numpy as np
import pytest
from test_curve_networks import lines_of, sample_surface, square_net


def points_of(patches, count=8):
    at = (np.arange(count) + 0.5) / count
    uv = np.stack(np.meshgrid(at, at, indexing="ij"), axis=-1).reshape(-1, 2)
    numbers = np.repeat(np.arange(patches.patch_count), len(uv))
    return patches.positions(numbers, np.tile(uv, (patches.patch_count, 1)))


def rms_off(surface, patches):
    """m: of places within patches, between their curves, from the surface."""
    distances = np.asarray(hn.SurfaceTree(surface).closest_points(points_of(patches)).distances)
    return np.sqrt(np.mean(distances**2))


def at_held_out_stations(surface, patches, stations):
    """m: RMS from the surface of the patches' sections midway between evenly spread stations, over
    their length."""
    x = np.asarray(surface.mesh.points)[:, 0]
    edges = np.linspace(x.min(), x.max(), stations + 2)
    planes = [hn.plane_across("x", position) for position in 0.5 * (edges[1:] + edges[:-1])]
    tree = hn.SurfaceTree(surface)
    total = length = 0.0
    for curves, plane in zip(hn.patch_sections(patches, planes), planes):
        assert curves
        for curve in curves:
            points = curve.points
            assert np.abs(points[:, 0] - plane[3]).max() < 1e-9 * surface.mesh.size
            steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
            squares = np.asarray(tree.closest_points(points).distances) ** 2
            total += 0.5 * steps @ (squares[1:] + squares[:-1])
            length += steps.sum()
    return np.sqrt(total / length)


def assert_free_at_borders(network, made):
    """Edges of one patch are on the network's border alone."""
    uses = np.zeros(made.patches.edge_count, int)
    for four in made.patches.sides:
        for side in four:
            for edge, _, _ in side:
                uses[edge] += 1
    regions = np.zeros(len(network.edges), int)
    for region in range(network.region_count):
        for side in network.sides(region):
            for edge, _ in side:
                regions[edge] += 1
    edges = np.asarray(made.edges)
    assert (uses[edges < 0] == 2).all()
    assert (uses[edges >= 0] == regions[edges[edges >= 0]]).all()
    return int((uses == 1).sum())


@pytest.mark.parametrize("name", ["coaster", "container_ship", "bulk_carrier"])
def test_patches_of_a_samples_lines_give_it_back(name):
    surface = sample_surface(name)
    before = {}
    for stations, waterlines in ((9, 4), (19, 9)):
        network, length = lines_of(surface, stations, waterlines, has_flats=True, joined=2e-5)
        made = hn.network_patches(network)
        assert made.largest_curve_error < 1e-5 * length
        assert made.spoke_error < 1e-5 * length
        assert made.patches.largest_gap <= 1e-13 * surface.mesh.size
        assert not [p for p in made.problems if p.kind in ("open_region", "missed_curve")]
        assert_free_at_borders(network, made)
        found = {
            "all over": rms_off(surface, made.patches) / length,
            "held out": at_held_out_stations(surface, made.patches, stations) / length,
        }
        for where, off in found.items():
            less = before[where] / off if before else np.nan
            print(f"{name}, {stations} stations: {where} RMS {off:.2e} L, {less:.1f} times less")
            if before:
                assert off < 5e-5 and before[where] > 4.0 * off
        before = found


# Stations and waterlines. Three ships take a minute.
_SPREAD = {"coaster": (9, 4), "container_ship": (19, 9), "bulk_carrier": (19, 9)}
_WRITTEN = ["coaster"] + ["container_ship", "bulk_carrier"] * ("HULL_LONG_NETWORKS" in os.environ)


@pytest.mark.parametrize("name", _WRITTEN)
def test_step_files_of_a_network_are_valid(tmp_path, name):
    surface = sample_surface(name)
    network, _ = lines_of(surface, *_SPREAD[name], has_flats=True, joined=2e-5)
    made = hn.network_patches(network)
    path = str(tmp_path / "lines.step")
    hn.write_step(made.patches, path)
    report = hn.read_cad_report(path)
    assert report["valid"] and report["shells"] == 1
    assert report["faces"] == made.patches.patch_count
    # Edges of one patch, but for those of no length and those that go on in one another.
    assert 0 < report["free_edges"] <= assert_free_at_borders(network, made)
    border = set(np.flatnonzero(np.bincount(_region_edges(network), minlength=1) == 1).tolist())
    lengths = [
        np.linalg.norm(np.diff(network.edge_points(edge, 64), axis=0), axis=1).sum()
        for edge in border
    ]
    assert report["free_edge_length"] == pytest.approx(sum(lengths), rel=1e-4)


def _region_edges(network):
    return [
        edge
        for region in range(network.region_count)
        for side in network.sides(region)
        for edge, _ in side
    ]


def test_the_report_tells_what_patches_are():
    surface = sample_surface("coaster")
    network, length = lines_of(surface, 9, 4, has_flats=True, joined=2e-5)
    made = hn.network_patches(network)
    report = hn.network_report(network, made)
    assert report.patches == made.patches.patch_count
    assert report.curve_errors[0][1] == made.largest_curve_error == made.curve_errors.max()
    # The worst is found again at its place by those of all edges: no more than at sharp corners.
    assert 0.0 < report.seam_angle < 20.0
    assert np.abs(points_of(made.patches) - report.seam_place).sum(axis=1).min() < 0.1 * length
    assert report.gap <= 1e-13 * surface.mesh.size
    # Above one degree, the largest first, by the names of curves that go through the places.
    angles = [angle for _, angle, _ in report.rough_seams]
    assert angles[0] == report.seam_angle > angles[-1] > 1.0
    assert angles == sorted(angles, reverse=True)
    curves = {curve.name: np.asarray(curve.points) for curve in network.curves}
    named = [seam for seam in report.rough_seams if seam[0] is not None]
    assert named
    for name, _, place in named:
        low, high = curves[name].min(axis=0) - 0.5, curves[name].max(axis=0) + 0.5
        assert (low <= place).all() and (place <= high).all()
    told = [line for line in report.lines() if line.startswith("Not smooth along ")]
    assert len(told) == 1 and f" by {angles[0]:.2g}° at " in told[0]
    assert report.lines()[0] == f"{report.patches} patches"


def box_patches(height=3.0):
    """The port half of a box, 10 x 2 x height m, by its bottom and side."""
    lines = [
        ("keel", [(0, 0, 0), (10, 0, 0)]),
        ("chine", [(0, 2, 0), (10, 2, 0)]),
        ("deck", [(0, 2, height), (10, 2, height)]),
        ("aft bottom", [(0, 0, 0), (0, 2, 0)]),
        ("aft side", [(0, 2, 0), (0, 2, height)]),
        ("fore bottom", [(10, 0, 0), (10, 2, 0)]),
        ("fore side", [(10, 2, 0), (10, 2, height)]),
    ]
    curves = [hn.NetworkCurve(name, points, shape="line") for name, points in lines]
    return hn.network_patches(hn.CurveNetwork(curves, 1e-3)).patches


def test_a_box_floats_as_a_box_does():
    patches = box_patches()
    assert patches.patch_count == 2
    body = hn.PatchBody(patches, mirrored=True)
    afloat = body.immersion((0, 0, 1), 1.5)
    assert afloat.volume == pytest.approx(60.0, rel=1e-13)
    assert np.abs(afloat.centre_of_buoyancy - (5.0, 0.0, 0.75)).max() < 1e-12
    assert afloat.waterplane_area == pytest.approx(40.0, rel=1e-13)
    assert np.abs(afloat.waterplane_second.diagonal() - (4000 / 12, 640 / 12, 0)).max() < 1e-10
    # Without the ends, which closings are.
    assert afloat.wetted_surface == pytest.approx(40.0 + 30.0, rel=1e-12)
    # Heeled until the deck edge is under: by the volumes of prisms.
    angle = np.radians(30.0)
    heeled = body.immersion((0.0, -np.sin(angle), np.cos(angle)), 1.5 * np.cos(angle))
    y = np.linspace(-2.0, 2.0, 400001)
    wet = np.clip(1.5 + y * np.tan(angle), 0.0, 3.0)
    area = np.diff(y) @ (0.5 * (wet[1:] + wet[:-1]))
    assert heeled.volume == pytest.approx(10.0 * area, rel=1e-9)
    with pytest.raises(ValueError, match="The surface is open at"):
        hn.PatchBody(patches, mirrored=False)
    (station,), (in_bottom,) = hn.patch_sections(patches, [(1, 0, 0, 4.0), (0, 0, 1, 0.0)])
    assert np.linalg.norm(np.diff(station.points, axis=0), axis=1).sum() == pytest.approx(5.0)
    assert len(station.knuckles) == 1
    assert np.abs(station.points[station.knuckles[0]] - (4, 2, 0)).max() < 1e-12
    # The bottom lies in the plane: its border is the section, but for what is a border itself.
    assert np.ptp(in_bottom.points, axis=0) == pytest.approx((10, 2, 0))
    with pytest.raises(ValueError, match="chord tolerance"):
        hn.patch_sections(patches, [(1, 0, 0, 4.0)], 0.0)


def test_patches_of_lines_float_as_the_hull_does():
    """Against the exact surface, which the patches are near, and its own sections and closings."""
    surface = sample_surface("coaster")
    network, length = lines_of(surface, has_flats=True, joined=2e-5)
    made = hn.network_patches(network)
    exact = hn.exact_patches(surface)
    draft = 4.0
    wanted = hn.HullBody(surface, mirrored=True).immersion((0, 0, 1), draft)
    same = hn.PatchBody(exact, mirrored=True).immersion((0, 0, 1), draft)
    near = hn.network_immersion(network, made, draft)
    for afloat, share in ((same, 1e-6), (near, 1e-4)):
        assert afloat.volume == pytest.approx(wanted.volume, rel=share)
        assert afloat.waterplane_area == pytest.approx(wanted.waterplane_area, rel=share)
        assert afloat.wetted_surface == pytest.approx(wanted.wetted_surface, rel=10 * share)
        off = np.abs(afloat.centre_of_buoyancy - wanted.centre_of_buoyancy).max()
        assert off < share * length
    planes = [hn.plane_across("x", x) for x in (10.0, 33.3, 70.0)]
    for ours, own in zip(hn.patch_sections(exact, planes), hn.sections(surface, planes)):
        assert len(ours) == len(own)
        lengths = [
            sum(np.linalg.norm(np.diff(c.points, axis=0), axis=1).sum() for c in curves)
            for curves in (ours, own)
        ]
        assert lengths[0] == pytest.approx(lengths[1], rel=1e-5)


def nearest_on(patches, point, start):
    """(place on one of the patches, distance) by Gauss and Newton from sampled places."""
    best = np.inf
    for patch in range(patches.patch_count):
        uv = start.copy()
        places = patches.positions(np.full(len(uv), patch), uv)
        place = uv[np.argmin(np.linalg.norm(places - point, axis=1))]
        for _ in range(12):
            found, by_u, by_v, *_ = (a[0] for a in patches.evaluate([patch], place[None]))
            slopes = np.stack([by_u, by_v], axis=1)
            move = np.linalg.lstsq(slopes, point - found, rcond=None)[0]
            place = np.clip(place + move, 0.0, 1.0)
        best = min(best, np.linalg.norm(patches.positions([patch], place[None])[0] - point))
    return best


def test_references_are_passed_through():
    height = lambda x, y: 2e-3 * x * y * (10 - x)  # noqa: E731
    curves = square_net(height)
    curves[1] = hn.NetworkCurve("B", curves[1].points, kind="station", role="reference")
    assert curves[1].role == "reference"
    network = hn.CurveNetwork(curves, 1e-3)
    made = hn.network_patches(network)
    assert made.patches.patch_count == 2 and made.problems == []
    assert made.largest_curve_error <= 1e-4
    # All along the curve, by ourselves.
    at = np.linspace(0.0, 1.0, 9)
    start = np.stack(np.meshgrid(at, at, indexing="ij"), axis=-1).reshape(-1, 2)
    edges = np.flatnonzero(np.asarray(network.edge_curves) == 1)
    points = np.concatenate([network.edge_points(int(edge), 23) for edge in edges])
    assert max(nearest_on(made.patches, point, start) for point in points) < 1e-4
    # Between them the surface is that which the curves are of.
    found = points_of(made.patches)
    assert np.abs(found[:, 2] - height(found[:, 0], found[:, 1])).max() < 5e-4


def test_what_is_no_option_is_refused():
    network = hn.CurveNetwork(square_net(), 1e-3)
    with pytest.raises(ValueError, match="spans must be from 1 to 64"):
        hn.network_patches(network, spans=0)
    with pytest.raises(ValueError, match="tolerance must not be below zero"):
        hn.network_patches(network, tolerance=-1.0)
    with pytest.raises(ValueError, match="role is one of 'boundary', 'reference'"):
        hn.NetworkCurve("A", [(0, 0, 0), (1, 0, 0)], role="main")
