# SPDX-License-Identifier: GPL-3.0-or-later
"""Stations as files of other programs, read back by readers made from the formats' descriptions."""

from pathlib import Path
from types import SimpleNamespace

import hull_io
import numpy as np
import pytest
from hull_io import section_files
from section_file_readers import read_archimedes, read_ghs, read_michlet, read_section_text

SAMPLES = sorted((Path(__file__).parents[3] / "samples").glob("*.hull.json"))
PRINTED = 0.5e-5 + 1e-9  # five decimals


def branch(*points, knuckles=()):
    return SimpleNamespace(points=np.array([(0.0, *p) for p in points]), knuckles=knuckles)


def lines(*branches):
    return section_files.station_lines([3.0], [branches], 10.0)


def ship(found, name="Ship"):
    return section_files.Stations(name, tuple(found), 10.0, 4.0, 1.0, 1.025)


def test_a_line_runs_from_the_keel_up():
    (line,) = lines(branch((2.0, 3.0), (2.0, 1.0), (0.0, 0.0), knuckles=[1]))
    assert line.points.tolist() == [[0.0, 0.0], [2.0, 1.0], [2.0, 3.0]]
    assert line.knuckles.tolist() == [False, True, False]
    closed, knuckles = line.closed
    assert closed[-1].tolist() == [0.0, 3.0] and knuckles.tolist() == [False, True, True, True]


def test_of_a_whole_hull_the_port_side_is_taken():
    whole = branch((2.0, 3.0), (2.0, 0.5), (-2.0, 0.5), (-2.0, 3.0), knuckles=[1, 2])
    (line,) = lines(whole)
    assert line.points.tolist() == [[0.0, 0.5], [2.0, 0.5], [2.0, 3.0]]
    assert line.knuckles.tolist() == [False, True, False]


def test_a_bulb_and_what_is_above_it_are_one_line():
    bulb = branch((0.0, 1.0), (0.5, 0.5), (0.0, 0.0))
    (line,) = lines(branch((1.0, 5.0), (0.0, 3.0)), bulb)
    assert line.points.tolist() == [[0, 0], [0.5, 0.5], [0, 1], [0, 3], [1, 5]]
    assert line.knuckles.tolist() == [False, False, True, True, False]


@pytest.mark.parametrize("start", range(4))
def test_the_border_of_a_flat_is_a_line(start):
    """A transom in the station's plane, closed along the centre plane, from wherever it begins."""
    corners = [(0.0, 0.0), (2.0, 1.0), (2.0, 3.0), (0.0, 3.0)]
    around = corners[start:] + corners[: start + 1]
    (line,) = lines(branch(*around, knuckles=[0, 1, 2, 3, 4]))
    assert line.points.tolist() == [list(corner) for corner in corners]
    assert line.knuckles.tolist() == [False, True, True, False]


def test_parts_that_meet_are_one_line():
    (line,) = lines(branch((0.0, 0.0), (2.0, 1.0)), branch((2.0, 3.0), (2.0, 1.0)))
    assert line.points.tolist() == [[0, 0], [2, 1], [2, 3]]


def test_a_bar_keel_is_closed_to_the_centre_plane():
    (line,) = lines(branch((0.1, 0.0), (2.0, 1.0)))
    assert line.points.tolist() == [[0, 0], [0.1, 0], [2, 1]]


def test_two_hulls_are_refused():
    demi = branch((1.0, 3.0), (1.0, 1.0), (2.0, 0.0), (3.0, 1.0), (3.0, 3.0))
    both = [branch((1.0, 3.0), (1.5, 1.0)), branch((3.0, 3.0), (3.5, 1.0))]
    for branches in ([demi], both):
        with pytest.raises(hull_io.HullFileError, match="x = 3 m has parts beside one another"):
            lines(*branches)


def test_a_fin_that_goes_into_the_hull_ends_at_it():
    fin = branch((0.0, -2.0), (0.2, -1.5), (0.2, 0.5))
    (line,) = lines(branch((0.0, 0.0), (2.0, 1.0), (2.0, 3.0)), fin)
    np.testing.assert_allclose(line.points, [[0, -2], [0.2, -1.5], [0.2, 0.1], [2, 1], [2, 3]])
    assert line.knuckles.tolist() == [False, False, True, False, False]


def test_no_station_is_refused():
    with pytest.raises(hull_io.HullFileError, match="No station cuts"):
        section_files.station_lines([3.0], [[]], 10.0)


@pytest.fixture(scope="module", params=SAMPLES, ids=lambda path: path.name.split(".")[0])
def sample(request):
    """(HullData, its surface, x of stations, tolerance)."""
    hn = pytest.importorskip("hull_native")
    data = hull_io.read_hull(request.param)
    surface = hn.LimitSurface(hn.ControlMesh(*hull_io.shell_arrays(data).arguments()))
    low, high = data.points[:, 0].min(), data.points[:, 0].max()
    stations = low + (high - low) * (np.arange(12) + 0.5) / 12
    return data, surface, stations


def cut(sample, tolerance):
    hn = pytest.importorskip("hull_native")
    data, surface, stations = sample
    planes = np.column_stack([np.ones(12), np.zeros(12), np.zeros(12), stations])
    found = hn.sections(surface, planes, tolerance)
    size = float(np.linalg.norm(np.ptp(data.points, axis=0)))
    return section_files.station_lines(stations, found, size)


def is_catamaran(sample):
    return sample[0].points[:, 1].min() > 0.1


def test_sections_of_samples_have_the_bodys_areas(sample):
    """The closed lines enclose, by the shoelace formula, what the exact body has at the deck."""
    if is_catamaran(sample):
        pytest.skip("two hulls are no single line")
    hn = pytest.importorskip("hull_native")
    data, surface, stations = sample
    chord = 1e-6 * np.ptp(data.points[:, 0])
    found = cut(sample, chord)
    body = hn.HullBody(surface, mirrored=data.half)
    draft = 0.5 * data.points[:, 2].max()
    areas = hn.section_areas(body, np.array([line.x for line in found]), draft=draft).areas
    has_bodies_within = data.name == "Sailing yacht"  # her fin's top is in the hull, counted twice
    for line, exact in zip(found, areas):
        # Chords are within a tolerance of the line, on both sides of the ship.
        off = 2.0 * chord * np.abs(np.diff(line.points, axis=0)).sum()
        off += 0.01 * exact if has_bodies_within else 0.0
        assert area_below(line.points, draft) == pytest.approx(exact, abs=off), line.x


def area_below(points, height):
    """2 ∫ y dz along a line from the keel up, as far as the water; chords are divided at it."""
    (y, z), (next_y, next_z) = points[:-1].T, points[1:].T
    crosses = (z - height) * (next_z - height) < 0.0
    share = np.where(crosses, (height - z) / np.where(crosses, next_z - z, 1.0), 1.0)
    end_y, end_z = y + share * (next_y - y), z + share * (next_z - z)
    below = np.where(z <= height, (y + end_y) * (end_z - z), 0.0)
    above = np.where((z > height) & crosses, (next_y + end_y) * (next_z - end_z), 0.0)
    return float((below * ((next_z <= height) | crosses)).sum() + above.sum())


def test_more_knuckles_than_ghs_takes_are_refused():
    points = np.column_stack([np.linspace(0.0, 4.0, 90), np.linspace(0.0, 3.0, 90)])
    line = section_files.StationLine(5.0, points, np.ones(90, dtype=bool))
    with pytest.raises(hull_io.HullFileError, match="5 m has 9[01] knuckles, and GHS takes 82"):
        section_files.lines_for_ghs(lambda tolerance: [line], 1e-3)


@pytest.mark.parametrize("unit", ["m", "ft"])
def test_ghs_files_of_samples_read_back(sample, unit):
    if is_catamaran(sample):
        pytest.skip("two hulls are no single line")
    size = np.ptp(sample[0].points[:, 0])
    found, tolerance = section_files.lines_for_ghs(lambda t: cut(sample, t), 1e-6 * size)
    assert tolerance <= 1e-3 * size
    header, sections, rest = read_ghs(section_files.ghs_text(ship(found), unit))
    assert header["P"] == {"m": "M", "ft": "F"}[unit] and "1.0250" in rest
    scale = {"m": 1.0, "ft": 0.3048}[unit]
    assert [x for x, _ in sections] == sorted((x for x, _ in sections), reverse=True)
    for (x, points), line in zip(sections, sorted(found, key=lambda line: -line.x)):
        assert x == pytest.approx(line.x, abs=PRINTED)
        distinct = points[np.append(True, (np.diff(points, axis=0) != 0.0).any(axis=1))]
        wanted, _ = line.closed
        rounded = np.round(wanted / scale, 5)
        wanted = wanted[np.append(True, (np.diff(rounded, axis=0) != 0.0).any(axis=1))]
        np.testing.assert_allclose(distinct, wanted, atol=PRINTED)
        assert len(points) <= 164


def test_archimedes_files_of_samples_read_back(sample):
    if is_catamaran(sample):
        pytest.skip("two hulls are no single line")
    found = cut(sample, 1e-4 * np.ptp(sample[0].points[:, 0]))
    root, sections = read_archimedes(section_files.archimedes_text(ship(found, "A & <B>")))
    assert root.find("HULL_NAME").text.strip() == "A & <B>"
    assert float(root.find("MID_DRAUGHT_MARK").text) == 1.0
    for (x, points), line in zip(sections, found):
        assert x == pytest.approx(line.x, abs=PRINTED)
        count = len(line.points)
        np.testing.assert_allclose(points[-count:], line.points, atol=PRINTED)
        np.testing.assert_array_equal(points[:, 0], -points[::-1, 0])
        np.testing.assert_array_equal(points[:, 1], points[::-1, 1])


def test_texts_of_samples_read_back(sample):
    if is_catamaran(sample):
        pytest.skip("two hulls are no single line")
    found = cut(sample, 1e-4 * np.ptp(sample[0].points[:, 0]))
    header, sections = read_section_text(section_files.section_text(ship(found, "Καΐκι")))
    assert header == ["?????", "10.00000 4.00000 1.00000"]
    for (x, rows), line in zip(sections, found):
        np.testing.assert_allclose(rows[:, :2], line.points, atol=PRINTED)
        np.testing.assert_array_equal(rows[:, 2] == 1.0, line.knuckles)


def wigley(shape=(41, 21)):
    x, z = np.linspace(-1, 1, shape[0])[:, None], np.linspace(0, 1, shape[1])
    return 5.0 * (1 - x**2) * (1 - (1 - z) ** 2)


def michlet(**changes):
    given = {
        "length": 100.0,
        "draft": 6.25,
        "volume": 2777.8,
        "speeds": section_files.MichletSpeeds(2.0, 15.0, 40),
        **changes,
    }
    table = given.pop("half_breadths", wigley())
    return section_files.michlet_text("Wigley", table, **given)


def test_michlet_files_read_back():
    head, offsets, hull = read_michlet(michlet())
    # Bow first, keel first: rows of the table turned round.
    np.testing.assert_allclose(offsets, wigley()[::-1], atol=PRINTED)
    assert head[5:8] == ["1", "9.80665", "1025.00"] and head[8] == "1.18831"
    assert head[15:18] == ["2.000", "15.000", "40"] and head[24:26] == ["41", "21"]
    assert [float(value) for value in hull[:3]] == [2777.8, 100.0, 6.25]
    assert len(head) == 28 + 19 and hull[-2:] == ["0", "0"]


@pytest.mark.parametrize(
    "changes, words",
    [
        ({"half_breadths": wigley((40, 21))}, "odd numbers"),
        ({"half_breadths": wigley((41, 83))}, "odd numbers"),
        ({"half_breadths": -wigley()}, "negative"),
        ({"half_breadths": wigley() * np.nan}, "no number"),
        ({"speeds": section_files.MichletSpeeds(2.0, 50.0)}, "speeds"),
        ({"speeds": section_files.MichletSpeeds(2.0, 5.0, 51)}, "speeds"),
        ({"water_density": 1.2}, "t/m³"),
    ],
)
def test_what_michlet_does_not_take_is_refused(changes, words):
    with pytest.raises(hull_io.HullFileError, match=words):
        michlet(**changes)


def test_too_many_sections_or_points_for_ghs_are_refused():
    (line,) = lines(branch(*[(2.0 * k / 200, 3.0 * k / 200) for k in range(200)]))
    with pytest.raises(hull_io.HullFileError, match="GHS takes 164"):
        section_files.ghs_text(ship([line]))
    (line,) = lines(branch((0.0, 0.0), (2.0, 1.0)))
    with pytest.raises(hull_io.HullFileError, match="GHS takes 149"):
        section_files.ghs_text(ship([line] * 150))
