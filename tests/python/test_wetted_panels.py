# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels of the wetted hull: closed with the water's surface, at second order the exact volume,
exactly at the waterline, as WAMIT and Nemoh describe their files."""

import math

import hull_io
import hull_native as hn
import numpy as np
import pytest
from production_hulls import SAMPLES, body_of, hemisphere, odd_sides

# Trim and heel in degrees.
POSITIONS = [(0.0, 0.0), (0.5, 0.0), (-0.4, 12.0)]


def panels_at(name, trim_deg, heel_deg, parts, **options):
    sample, body = body_of(name)
    length = sample.ship.length_pp
    mesh = hn.wetted_panels(
        body,
        length / parts,
        draft=sample.ship.draft,
        trim=math.radians(trim_deg),
        heel=math.radians(heel_deg),
        draft_at=length / 2,
        origin_x=length / 2,
        **options,
    )
    return sample, body, mesh


@pytest.mark.parametrize("trim_deg, heel_deg", POSITIONS)
@pytest.mark.parametrize("name", SAMPLES)
def test_closed_with_the_water(name, trim_deg, heel_deg):
    _, _, mesh = panels_at(name, trim_deg, heel_deg, 40)
    points, at_water = mesh.points, mesh.at_water
    assert mesh.half == (heel_deg == 0.0)
    # Rounding of sums of thousands of panels.
    assert np.ptp(mesh.volumes) < 1e-12 * mesh.displaced_volume
    odd, place = odd_sides(points, mesh.panels)
    wet, centre = (set(place[mask]) for mask in (at_water, points[:, 1] == 0.0))
    rest = [
        side
        for side in odd.tolist()
        if not (wet.issuperset(side) or (mesh.half and centre.issuperset(side)))
    ]
    # Longer sides beside shorter ones, where what lies between has no area: run through in both
    # directions as often. So an integral along all of them vanishes, whatever its integrand.
    where = np.zeros((place.max() + 1, 3))
    where[place] = points
    begin, end = where[np.array(rest, dtype=int).reshape(-1, 2)].transpose(1, 0, 2)
    nodes, weights = np.polynomial.legendre.leggauss(12)
    at = begin[:, None] + 0.5 * (nodes[:, None] + 1.0) * (end - begin)[:, None]
    waves = np.sin(at @ np.array([[0.31, 0.17, 0.11], [0.23, 0.41, 0.07], [0.13, 0.05, 0.37]]))
    sums = np.einsum("n,skn,sk->s", 0.5 * weights, np.swapaxes(waves, 1, 2), end - begin)
    assert len(rest) < 0.01 * len(mesh.panels) + 10
    assert abs(sums.sum()) < 1e-9


@pytest.mark.parametrize("trim_deg, heel_deg", POSITIONS)
@pytest.mark.parametrize("name", SAMPLES)
def test_ends_in_the_water_plane(name, trim_deg, heel_deg):
    sample, _, mesh = panels_at(name, trim_deg, heel_deg, 40)
    z, panels = mesh.points[:, 2], mesh.panels
    assert (z[mesh.at_water] == 0.0).all() and (z[~mesh.at_water] < 0.0).all()
    assert mesh.at_water.any()
    # WAMIT stops at panels with three corners in the water's surface, and warns of four.
    level = [{c for c in panel if mesh.at_water[c]} for panel in panels.tolist()]
    assert max(map(len, level)) <= 2
    # In the ship's axes points are on the exact surface, those on closings aside.
    ship = mesh.origin + mesh.points @ mesh.axes
    ship[:, 1] = np.abs(ship[:, 1])
    tree = hn.SurfaceTree(sample.surface)
    distance = np.linalg.norm(
        tree.closest_points(ship[mesh.at_water]).points - ship[mesh.at_water], axis=1
    )
    assert np.median(distance) < 1e-9 * sample.ship.length_pp
    near = distance < 1e-9 * sample.ship.length_pp
    assert near.mean() > 0.5


@pytest.mark.parametrize("trim_deg, heel_deg", POSITIONS)
@pytest.mark.parametrize("name", SAMPLES)
def test_second_order(name, trim_deg, heel_deg):
    """Errors go with the mean area of panels, once all strips have more panels than one: the
    orders measured are 1.87 to 2.1."""
    errors, counts = [], []
    for parts in (480, 720):
        _, _, mesh = panels_at(name, trim_deg, heel_deg, parts, grading=1.0)
        errors.append(abs(mesh.volumes.mean() / mesh.displaced_volume - 1.0))
        counts.append(len(mesh.panels))
    order = 2.0 * math.log(errors[0] / errors[1]) / math.log(counts[1] / counts[0])
    assert 1.85 < order < 2.15
    assert errors[1] < 6e-5


@pytest.mark.one_in(3)
@pytest.mark.parametrize("trim_deg, heel_deg", POSITIONS)
@pytest.mark.parametrize("name", SAMPLES)
def test_second_order_of_graded_panels(name, trim_deg, heel_deg):
    """With half the size at the water and the ends, as is usual: orders of 1.85 to 2.19."""
    errors, counts = [], []
    for parts in (240, 480):
        _, _, mesh = panels_at(name, trim_deg, heel_deg, parts)
        errors.append(abs(mesh.volumes.mean() / mesh.displaced_volume - 1.0))
        counts.append(len(mesh.panels))
    order = 2.0 * math.log(errors[0] / errors[1]) / math.log(counts[1] / counts[0])
    assert 1.8 < order < 2.25
    assert errors[1] < 1e-4


@pytest.mark.one_in(2)
@pytest.mark.parametrize("name", SAMPLES)
def test_sizes_are_graded_to_the_water_and_to_the_ends(name):
    """No side is longer than what is asked for at the panel's place, afloat and, where ends alone
    count, as deep as the ship is long; there panels at the ends have about half the size of those
    amidships, and about all of it with a grading of 1."""
    sample, body = body_of(name)
    size = sample.ship.length_pp / 40
    longest = {}
    for draft, grading in (
        (sample.ship.draft, 0.5),
        (sample.ship.length_pp, 0.5),
        (sample.ship.length_pp, 1.0),
    ):
        mesh = hn.wetted_panels(body, size, draft=draft, grading=grading)
        corners, x = mesh.points[mesh.panels], mesh.points[:, 0]
        middle = corners[..., 0].mean(axis=1)
        from_ends = np.minimum(middle - x.min(), x.max() - middle)
        sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
        distance = np.minimum(from_ends, -corners[..., 2].mean(axis=1))
        asked = np.minimum(size, grading * size + 0.3 * distance)
        # Between the sides of cells lines may spread a little; at the water points move.
        assert (sides < (1.6 if draft < sample.ship.length_pp else 1.02) * asked).all()
        at_ends, amidships = from_ends < 0.5 * size, from_ends > 0.3 * np.ptp(x)
        longest[grading] = [np.percentile(sides[one], 90) / size for one in (at_ends, amidships)]
    assert 0.3 < longest[0.5][0] < 0.55 and longest[0.5][1] > 0.7
    assert 0.7 < longest[1.0][0] and longest[1.0][1] > 0.7


def test_heel_to_both_sides_mirrors():
    _, _, one = panels_at("coaster", 0.0, 9.0, 30)
    _, _, other = panels_at("coaster", 0.0, -9.0, 30)
    assert one.volumes == pytest.approx(other.volumes, rel=1e-6)
    assert one.area == pytest.approx(other.area, rel=1e-6)


def test_axes_and_origin():
    sample, body, mesh = panels_at("roro", 0.5, 0.0, 30)
    x = sample.ship.length_pp / 2
    assert mesh.axes @ mesh.axes.T == pytest.approx(np.eye(3), abs=1e-14)
    assert np.linalg.det(mesh.axes) == pytest.approx(1.0)
    # The nearest point of the water to (x, 0, 0), along the water's normal.
    assert np.cross(mesh.origin - [x, 0.0, 0.0], mesh.axes[2]) == pytest.approx(np.zeros(3))
    exact = hn.hydrostatics(
        body, draft=sample.ship.draft, trim=math.radians(0.5), draft_at=x
    ).displaced_volume
    assert mesh.displaced_volume == pytest.approx(exact, rel=1e-12)


def test_panels_are_no_larger_than_asked():
    _, _, mesh = panels_at("bulk_carrier", 0.0, 0.0, 40)
    corners = mesh.points[mesh.panels]
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    # Between the sides of cells lines may spread a little, and points move by 0.3 of a side.
    assert sides.max() < 1.6 * 320.0 / 40
    _, _, even = panels_at("bulk_carrier", 0.0, 0.0, 40, grading=1.0)
    areas = [
        hull_io.panel_areas(m.points, m.panels)[m.at_water[m.panels].any(axis=1)].mean()
        for m in (mesh, even)
    ]
    # Cells shorter than a panel have one in any case.
    assert areas[0] < 0.7 * areas[1]


@pytest.fixture(scope="module")
def ball():
    surface = hemisphere(5.0)
    return surface, hn.HullBody(surface, mirrored=False)


def test_hemisphere(ball, tmp_path):
    """2/3 π r³, 2 π r², the centre of buoyancy 3/8 r down, by the panels of a .gdf file."""
    _, body = ball
    mesh = hn.wetted_panels(body, 0.25, draft=0.0, grading=1.0)
    volume = 2 / 3 * math.pi * 5.0**3
    assert mesh.displaced_volume == pytest.approx(volume, rel=1e-4)
    assert mesh.volumes == pytest.approx(np.full(3, volume), rel=2e-3)
    assert mesh.area == pytest.approx(2 * math.pi * 25.0, rel=2e-3)
    path = tmp_path / "ball.gdf"
    hull_io.write_gdf(path, mesh.points, mesh.panels, half=mesh.half, ulen=5.0, title="Hemisphere")
    title, ulen, symmetry, count, *rows = path.read_text().splitlines()
    assert title == "Hemisphere" and len(title) <= 72
    assert [float(word) for word in ulen.split()[:2]] == [5.0, 9.80665]
    assert symmetry.split()[:2] == ["0", "0"]
    panels = np.array([row.split() for row in rows], dtype=float)
    assert int(count) == len(rows) and panels.shape[1] == 12
    corners = panels.reshape(-1, 4, 3)
    assert (corners[..., 2] <= 0.0).all()
    assert np.linalg.norm(corners, axis=-1) == pytest.approx(5.0, rel=3e-4)
    # Seen from the water they run counter-clockwise: their normals point outwards.
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    assert (np.sum(normals * corners.mean(axis=1), axis=1) > 0.0).all()
    # ∫ z² n_z / 2 over the panels is ∫ z dV; the product of the diagonals is twice the area.
    moment = np.sum((corners[..., 2] ** 2).mean(axis=1) * normals[:, 2]) / 4
    assert moment / volume == pytest.approx(-3 / 8 * 5.0, rel=5e-3)


def test_nemoh(ball, tmp_path):
    mesh = hn.wetted_panels(ball[1], 1.0, draft=0.0)
    path = tmp_path / "ball.dat"
    hull_io.write_nemoh(path, mesh.points, mesh.panels, half=mesh.half)
    rows = [row.split() for row in path.read_text().splitlines()]
    assert rows[0] == ["2", "0"]
    end = rows.index(["0", "0.0", "0.0", "0.0"])
    points = np.array(rows[1:end], dtype=float)
    assert (points[:, 0] == np.arange(1, len(points) + 1)).all()
    assert points[:, 1:] == pytest.approx(mesh.points, abs=1e-8)
    panels = np.array(rows[end + 1 : -1], dtype=int)
    assert (panels - 1 == mesh.panels).all() and rows[-1] == ["0"] * 4


def test_obj_is_read_again(ball, tmp_path):
    mesh = hn.wetted_panels(ball[1], 1.0, draft=0.0)
    path = tmp_path / "ball.obj"
    hull_io.write_obj(path, mesh.points, mesh.panels)
    text = path.read_text().splitlines()
    faces = [row.split()[1:] for row in text if row.startswith("f ")]
    assert len(faces) == len(mesh.panels)
    assert {len(face) for face in faces} <= {3, 4}
    points = np.array([row.split()[1:] for row in text if row.startswith("v ")], dtype=float)
    assert points == pytest.approx(mesh.points, abs=1e-8)


@pytest.mark.parametrize(
    "options, words",
    [
        ({"size": 0.0}, "positive length, not 0"),
        ({"size": math.nan}, "positive length"),
        ({"size": 1e-4}, "m would do"),
        ({"grading": 0.0}, "above 0 and at most 1"),
        ({"draft": -1.0}, "out of the water"),
        ({"origin_x": math.inf}, "finite"),
    ],
)
def test_refused(options, words):
    _, body = body_of("coaster")
    with pytest.raises(ValueError, match=words):
        hn.wetted_panels(body, **{"size": 3.0, "draft": 5.2, **options})


def test_water_over_the_deck_edge_floods():
    sample = body_of("coaster")[0]
    body = hn.HullBody(sample.surface, mirrored=True, openings="open")
    with pytest.raises(ValueError, match="floods at"):
        hn.wetted_panels(body, 3.0, draft=9.0)


def test_a_size_that_is_named_does():
    _, body = body_of("coaster")
    with pytest.raises(ValueError) as told:
        hn.wetted_panels(body, 0.02, draft=5.2)
    size = float(str(told.value).split(" m would do")[0].split()[-1])
    assert len(hn.wetted_panels(body, size, draft=5.2).panels) < 1.2 * 2**20


def test_files_refuse(ball, tmp_path):
    mesh = hn.wetted_panels(ball[1], 1.0, draft=0.0)
    path = tmp_path / "ball.gdf"
    with pytest.raises(ValueError, match="less area than WAMIT takes"):
        hull_io.write_gdf(path, mesh.points * 1e-5, mesh.panels, half=True)
    with pytest.raises(ValueError, match="at most 72 letters"):
        hull_io.write_gdf(path, mesh.points, mesh.panels, half=True, title="x" * 73)
    with pytest.raises(ValueError, match="other corners"):
        hull_io.write_nemoh(path, mesh.points, mesh.panels + len(mesh.points), half=True)
    assert not path.exists()
    with pytest.raises(hull_io.HullFileError, match="can't be written"):
        hull_io.write_gdf(tmp_path / "none" / "a.gdf", mesh.points, mesh.panels, half=True)
    assert not list(tmp_path.iterdir())
