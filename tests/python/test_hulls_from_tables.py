# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls of tables of offsets and of lines plans: lines between few points, the profile, the fit."""

import os
from unittest import mock

import hull_io
import hull_native as hn
import numpy as np
import pytest
from hull_fitting import hull_from_geometry
from hull_fitting.conic_pieces import between
from hull_fitting.lofting import lofted
from hull_fitting.smooth_lines import line_through, runs
from hull_fitting.table_curves import table_curves
from hull_io.geometry import Geometry, guess_hull, oriented, placed_views, read_geometry
from hull_io.geometry.values import polyline
from hull_io.triangles import spread_points
from test_hulls_from_geometry import sample, triangles_of

ALL = os.environ.get("HULL_LONG_TESTS") == "1"
LONG = pytest.mark.skipif(not ALL, reason="HULL_LONG_TESTS=1")
LONG_TABLES = [("barge", 4e-4, 1.5), ("naval_vessel", 4e-4, 1.5)]


def test_a_line_through_few_points_is_straight_where_they_are_and_does_not_bulge():
    """A bilge of 2 m between a flat bottom and a flat side, by its waterlines."""
    angles = np.radians([0.0, 45.0, 90.0])
    bilge = np.stack([5.0 + 2.0 * np.sin(angles), 2.0 - 2.0 * np.cos(angles)], axis=1)
    line = np.array([(0, 0), *bilge.tolist(), (7, 3), (7, 4), (7, 8)], dtype=float)
    line = np.insert(line, 0, 0.0, axis=1)
    at = np.arange(len(line), dtype=float)
    flats = [*runs(np.diff(line[:, 2]) == 0.0), *runs(np.diff(line[:, 1]) == 0.0)]
    assert flats == [(0, 1), (3, 6)]
    _, y, z = line_through(line, at, 16, flats=flats).T
    assert np.abs(z[:17]).max() < 1e-12 and np.abs(y[48:] - 7.0).max() < 1e-12
    off = np.hypot(y[16:49] - 5.0, z[16:49] - 2.0) - 2.0
    assert np.abs(off).max() < 0.01 * 2.0
    # Along the flats at their ends: the next place is off by a square.
    assert z[17] < 0.1 * (y[17] - 5.0) and 7.0 - y[47] < 0.1 * (2.0 - z[47])


def table_of(name, path, stations=21, waterlines=11):
    """Writes the offsets of a sample by its stations, waterlines and heights of the keel; returns
    its surface."""
    surface, _ = sample(name)
    places = np.asarray(surface.tessellate(6).points)
    low, high = places.min(axis=0), places.max(axis=0)
    xs, zs = np.linspace(low[0], high[0], stations), np.linspace(0.0, high[2], waterlines)
    table = hn.offset_table(surface, stations=xs, waterlines=zs, buttocks=[0.0])
    (deck,) = (one for one in table.features if "eck" in one.name)
    lines = [["x", *(f"WL {z:.6g}" for z in zs), "Profile", "Deck half-breadth", "Deck height"]]
    for i, x in enumerate(xs):
        values = [*table.half_breadths[i], table.heights[i][0]]
        values += [deck.half_breadths[i], deck.heights[i]]
        lines.append([f"{x:.4f}", *("" if np.isnan(v) else f"{v:.4f}" for v in values)])
    path.write_text("\n".join(",".join(line) for line in lines) + "\n")
    return surface


def test_the_surface_through_a_table_does_not_bulge_below_the_base_line(tmp_path):
    surface = table_of("coaster", tmp_path / "coaster.csv")
    found = read_geometry(tmp_path / "coaster.csv")
    loft = lofted(oriented(found, guess_hull(found)))
    points = np.concatenate([loft.shell.mesh.points, loft.targets.points])
    apart = np.asarray(hn.SurfaceTree(surface).closest_points(points).distances)
    # Between waterlines of 0.9 m, and ends between stations of 4.4 m, the table tells no more.
    length = np.ptp(points[:, 0])
    assert np.median(apart) < 2e-4 * length and np.sqrt(np.mean(apart**2)) < 2e-3 * length
    assert points[:, 2].min() > -4e-3 * length
    rows = [line.split(",") for line in (tmp_path / "coaster.csv").read_text().splitlines()]
    rows = [",".join(row[:-3] + row[-2:]) for row in rows]  # without the keel
    (tmp_path / "keelless.csv").write_text("\n".join(rows))
    found = read_geometry(tmp_path / "keelless.csv")
    with pytest.raises(ValueError, match="do not begin at the centre plane"):
        lofted(oriented(found, guess_hull(found)))


# Of the length: RMS of the sample's surface from the hull of its table; of the hull's control
# points the share of the sample's.
@pytest.mark.parametrize(
    "name, rms, most",
    [
        ("coaster", 4e-4, 1.5),
        *(pytest.param(*case, marks=LONG) for case in LONG_TABLES),
    ],
)
def test_hulls_of_tables(name, rms, most, tmp_path):
    surface = table_of(name, tmp_path / "hull.csv")
    made = hull_from_geometry(
        read_geometry(tmp_path / "hull.csv"), budget=int(most * len(surface.mesh.points))
    )
    places, _ = spread_points(*triangles_of(surface), 5000)
    shift = [made.guess.origin[0], 0.0, made.guess.origin[2]]
    apart = np.asarray(hn.SurfaceTree(made.fitted.surface).closest_points(places - shift).distances)
    assert np.sqrt(np.mean(apart**2)) < rms * np.ptp(places[:, 0])
    assert made.fitted.surface.mesh.warnings == []
    assert made.report["points_in_rows_of_one_x"] >= 0.65 * made.report["points"]


def test_a_table_tells_the_stem_by_its_waterlines(tmp_path):
    """Of stations and heights of the keel alone the profile before the last station is drawn on."""
    surface = table_of("coaster", tmp_path / "coaster.csv")
    found = read_geometry(tmp_path / "coaster.csv")
    guess = guess_hull(found)
    curves = table_curves(oriented(found, guess))
    places = curves.profile + np.asarray(guess.origin)
    apart = np.asarray(hn.SurfaceTree(surface).closest_points(places).distances)
    # Of the length: between stations 5 % apart; more where the last one is at the stem's very head.
    assert not curves.is_told
    assert (
        np.sqrt(np.mean(apart**2)) < 2e-3 * curves.length and apart.max() < 1e-2 * curves.length
    )


def test_a_bulb_drawn_apart_at_the_last_station():
    """Two pieces at one x, of more points than a table has; the stem is drawn on from the upper."""
    t = np.linspace(0.0, 1.0, 80)

    def hull(with_bulb):
        curves = [
            polyline(np.stack([0 * t + x, (6.0 - 0.1 * x) * np.sqrt(t), 2.0 + 8.0 * t], axis=1),
                     kind="station")
            for x in range(0, 55, 10)
        ]  # fmt: skip
        bulb = np.stack([0 * t + 50.0, np.sin(np.pi * t), 0.5 - 0.5 * np.cos(np.pi * t)], axis=1)
        curves += [polyline(bulb, kind="station")] if with_bulb else []
        return Geometry("bulb", "DXF", "m", tuple(curves), is_half=True, on_ship_axes=True)

    alone, found = table_curves(hull(False)), table_curves(hull(True))
    assert [station.x for station in found.stations].count(50.0) == 2
    np.testing.assert_array_equal(found.profile[-1], alone.profile[-1])
    assert found.profile[-1, 0] > 50.0


@pytest.mark.parametrize(
    "rest, is_smooth",
    [
        # A flat bottom's rim whose knuckle is a tag alone: the bilge begins there as an arc.
        ([(25.1, 3.4), (25.5, 6.1), (25.5, 10.0)], True),
        # A chine.
        ([(18.5, 3.4), (19.8, 6.1), (21.5, 10.0)], False),
    ],
)
def test_rims_of_flats_are_no_knuckles(rest, is_smooth):
    points = np.insert(np.array([(0.0, 0.0), (8.0, 0.0), (17.1, 0.0), *rest]), 0, 0.0, axis=1)
    is_sharp = np.arange(len(points)) == 2
    line = line_through(points, np.arange(len(points), dtype=float), 12, is_sharp, [(0, 2)])
    way = np.diff(line[24:26], axis=0)[0]
    angle = np.degrees(np.arctan2(way[2], way[1]))
    assert (angle < 8.0) == is_smooth
    assert line[:, 2].min() > -1e-9


def test_a_conic_has_the_curvature_with_which_a_line_goes_on():
    """A quarter of a circle of 2 m: weight cos 45° of a rational quadratic."""
    a, b = np.array([0.0, 0.0, 0.0]), np.array([0.0, 2.0, 2.0])
    along, up = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])
    with mock.patch("hull_fitting.conic_pieces._LEAST", 0.1):
        arc = between(a, b, along, up, np.linspace(0.0, 1.0, 21), (0.5, 0.5))
    np.testing.assert_allclose(np.hypot(arc[:, 1], arc[:, 2] - 2.0), 2.0, atol=1e-12)


def drawn(name, path):
    """Writes the lines plan of a sample; returns its surface."""
    surface, data = sample(name)
    low, high = surface.mesh.points.min(axis=0), surface.mesh.points.max(axis=0)
    given = data.particulars
    hn.write_lines_drawing(
        surface,
        path,
        mirrored=True,
        stations=given.length_pp / 20,
        waterlines=(high[2] - low[2]) / 10,
        buttocks=high[1] / 5,
        draft=given.draft,
        length=given.length_pp,
    )
    return surface


@pytest.mark.parametrize("name", ["coaster", "barge", "bulk_carrier", "roro"])
def test_views_of_a_lines_plan_are_put_together(name, tmp_path):
    surface = drawn(name, tmp_path / "lines.dxf")
    found = read_geometry(tmp_path / "lines.dxf")
    placed = placed_views(found)
    assert placed.on_ship_axes and placed.is_half
    kinds = [curve.kind for curve in placed.curves]
    assert {"station", "waterline", "profile", "deck_edge"} <= set(kinds)
    length = np.ptp(surface.mesh.points[:, 0])
    tree = hn.SurfaceTree(surface)
    for curve in placed.curves:
        apart = np.asarray(tree.closest_points(curve.points).distances)
        # Pieces of stations that no waterline crosses are told by their ends alone.
        assert apart.max() < (4e-4 if curve.kind == "station" else 2e-6) * length, curve.name
    xs = {round(float(curve.points[0, 0]), 3) for curve in placed.curves if curve.kind == "station"}
    spacing = sample(name)[1].particulars.length_pp / 20
    assert {round(k * spacing, 3) for k in range(1, 20)} <= xs


def test_what_is_no_lines_plan_stays(tmp_path):
    drawn("coaster", tmp_path / "lines.dxf")
    text = (tmp_path / "lines.dxf").read_text().replace("CENTRE_LINE", "SOMETHING")
    (tmp_path / "other.dxf").write_text(text)
    found = read_geometry(tmp_path / "other.dxf")
    assert placed_views(found) is found
    with pytest.raises(ValueError, match="in one plane"):
        hull_from_geometry(found)


def test_a_lines_plan_becomes_a_hull(tmp_path):
    surface = drawn("coaster", tmp_path / "lines.dxf")
    made = hull_from_geometry(read_geometry(tmp_path / "lines.dxf"), budget=140)
    places = np.asarray(surface.tessellate(4).points) - np.asarray(made.guess.origin)
    apart = np.asarray(hn.SurfaceTree(made.fitted.surface).closest_points(places).distances)
    assert np.sqrt(np.mean(apart**2)) < 1e-4 * np.ptp(places[:, 0])


COPIES = int(os.environ.get("HULL_CORRUPTIONS", 24))


def damaged(data, copy, random):
    """Bytes with some signs changed, a part or every third line taken out, or cut short."""
    bad, how = bytearray(data), copy % 4
    if how == 0:
        for at in random.integers(0, len(bad), 20):
            bad[at] = int(random.choice(np.frombuffer(b"0123456789.-,;x", dtype=np.uint8)))
    elif how == 1:
        begin = int(random.integers(len(bad)))
        del bad[begin : begin + int(random.integers(1, len(bad) // 4))]
    elif how == 2:
        bad = bad[: int(random.integers(10, len(bad)))]
    else:
        lines = bytes(bad).split(b"\n")
        del lines[int(random.integers(1, len(lines))) :: 3]
        bad = bytearray(b"\n".join(lines))
    return bytes(bad)


@pytest.mark.parametrize("write, ending", [(table_of, "csv"), (drawn, "dxf")])
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_damaged_tables_and_plans_are_refused_in_a_sentence(write, ending, tmp_path):
    write("coaster", tmp_path / f"whole.{ending}")
    data = (tmp_path / f"whole.{ending}").read_bytes()
    random = np.random.default_rng(22)
    refused = 0
    for copy in range(COPIES):
        path = tmp_path / f"copy{copy}.{ending}"
        path.write_bytes(damaged(data, copy, random))
        try:
            placed = placed_views(read_geometry(path))
            lofted(oriented(placed, guess_hull(placed)))
        except (ValueError, hull_io.HullFileError) as error:
            refused += 1
            assert str(error).endswith(".") and len(str(error)) > 30, (copy, str(error))
    assert refused > 0
