# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of offsets and lists of points: the layouts people use, and what is wrong with some."""

import re

import hull_io
import numpy as np
import pytest
from hull_io.geometry import offset_tables, read_geometry
from hull_io.geometry.lengths import length_in

# A hull of three stations, at x = 0, 10, 20, waterlines at z = 1, 2 and a buttock at y = 0.5.
STATIONS = {
    0.0: [(0.0, 0.6), (0.25, 1.0), (0.5, 1.5), (0.75, 2.0)],
    10.0: [(0.0, 0.0), (0.5, 0.125), (2.0, 1.0), (2.25, 2.0)],
    20.0: [(0.0, 0.0), (0.5, 0.25), (1.0, 1.0), (1.25, 2.0)],
}
BY_ROWS = """x,WL 1,WL 2,Buttock 0.5,Profile
0,0.25,0.75,1.5,0.6
10,2,2.25,0.125,0
20,1,1.25,0.25,0
"""
BY_COLUMNS = """WL/Station;0;1;2
x;0;10;20
WL 1;0,25;2;1
WL 2;0,75;2,25;1,25
Buttock 0,5;1,5;0,125;0,25
Keel;0,6;0;0
"""
IN_BLOCKS = """station spacing: 10
Half-breadths
Station   0     1     2
1         0.25  2     1
2         0.75  2.25  1.25
Heights above base
Station   0     1      2
Keel      0.6   0      0
0.5       1.5   0.125  0.25
"""
NUMBERED = """Lpp: 20
Station	WL 1	WL 2	Buttock 0.5	CL
0	0.25	0.75	1.5	0.6
1	2	2.25	0.125	0.0
2	1	1.25	0.25	0.0
"""
IN_MM = """x from AP [m],half-breadth at WL 1 m [mm],half-breadth at WL 2 m [mm],\
height at buttock 0 m [mm],height at buttock 0.5 m [mm],on a knuckle
0.0,250.0,750.0,600.0,1500.0,
10.0,2000.0,2250.0,0.0,125.0,WL 1 m
20.0,1000.0,1250.0,0.0,250.0,
"""


@pytest.fixture
def read(tmp_path):
    def read_text(text, ending="csv"):
        path = tmp_path / f"hull.{ending}"
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return read_geometry(path)

    return read_text


def stations_of(geometry):
    return {c.points[0, 0]: c for c in geometry.curves if c.kind == "station"}


IN_CELLS = re.sub("  +", ";", IN_BLOCKS).replace("Keel ", "Keel;")
TITLES = (
    "Heights above BL;Heights above B.L.;Heights on buttocks;Heights above WL 0;Buttock heights;"
    "Heights of buttocks above the base line"
).split(";")


@pytest.mark.parametrize(
    "text",
    [BY_ROWS, BY_COLUMNS, IN_BLOCKS, NUMBERED, IN_MM]
    + [IN_BLOCKS.replace("Heights above base", title) for title in TITLES]
    + [IN_CELLS.replace("Heights above base", title) for title in TITLES],
)
def test_layouts(read, text):
    found = read(text)
    stations = stations_of(found)
    assert list(stations) == list(STATIONS)
    for x, places in STATIONS.items():
        np.testing.assert_allclose(stations[x].points[:, 1:], places, rtol=1e-12)
    by_kind = {
        kind: [c for c in found.curves if c.kind == kind] for kind in ("waterline", "buttock")
    }
    assert [len(by_kind[kind]) for kind in by_kind] == [2, 1]
    (profile,) = (c for c in found.curves if c.kind == "profile")
    np.testing.assert_allclose(profile.points, [(0, 0, 0.6), (10, 0, 0), (20, 0, 0)])
    assert found.is_half and found.on_ship_axes


def test_what_is_told_of_units(read):
    assert read(BY_ROWS).unit is None
    assert read(IN_MM).unit == "m"
    assert read("unit: mm\n" + BY_ROWS).unit == "mm"
    assert read(BY_ROWS.replace("x,", "x [ft],")).unit == "ft"


def test_knuckles_are_marked(read):
    station = stations_of(read(IN_MM))[10.0]
    assert station.points[station.knuckles].tolist() == [[10.0, 2.0, 1.0]]
    station = stations_of(read(BY_ROWS.replace("10,2,", "10,2K,")))[10.0]
    assert station.points[station.knuckles].tolist() == [[10.0, 2.0, 1.0]]


@pytest.mark.parametrize(
    "cell, sixteenths",
    [
        ("5-3-4", 16 * (5 * 12 + 3) + 8),
        ("5-3-4+", 16 * (5 * 12 + 3) + 9),
        ("5-3-4-", 16 * (5 * 12 + 3) + 7),
        ("0-0-0", 0),
        ("-1-11-7", -(16 * 23 + 14)),
        ("12-0", 16 * 144),
        ("5' 3\"", 16 * 63),
        ("5' 3 1/2\"", 16 * 63 + 8),
        ("5'-3 1/2\"", 16 * 63 + 8),
        ("7'", 16 * 84),
        ('3 1/4"', 52),
    ],
)
def test_feet_inches_and_eighths(cell, sixteenths):
    length = length_in(cell)
    assert length.unit == "ft"
    assert length.value == pytest.approx(sixteenths / 192.0, rel=1e-15, abs=1e-15)


def test_a_table_in_feet(read):
    found = read(
        "Station spacing: 10-0-0\nHalf-breadths\nStation 0 1 2\n2-0-0 0-3-4 1-2-3 5-3-4+\n"
        "4-0-0 0-4-4 1-4-3 5-4-4+\nHeights\nStation 0 1 2\nKeel 0-0-1 0-0-0 0-0-0\n"
    )
    assert found.unit == "ft"
    feet = {c.points[0, 0]: c.points[:, 1:] for c in found.curves if c.kind == "station"}
    wanted = [(0.0, 1 / 96), (3.5 / 12, 2.0), (4.5 / 12, 4.0)]
    np.testing.assert_allclose(feet[0.0], wanted, rtol=1e-15)
    np.testing.assert_allclose(feet[20.0][1], (5 + 3.5625 / 12, 2.0), rtol=1e-15)


@pytest.mark.parametrize("sign", [", ", ";", "\t"])
def test_marks_of_feet_and_inches(read, sign):
    rows = [
        ("x", "'WL 1'", '"WL 2"', "WL 3"),
        ("0", '6"', "5'", "5' 3 1/2\""),
        ("10", '"0.5"', '"5\'"', '"5\' 3 1/2"""'),
    ]
    found = read("unit: ft\n" + "".join(sign.join(row) + "\n" for row in rows))
    assert found.unit == "ft"
    for station in stations_of(found).values():
        np.testing.assert_allclose(station.points[:, 1], [0.5, 5.0, 5.0 + 3.5 / 12], rtol=1e-15)


def test_a_bulb_is_passed_in_order(read):
    """Half-breadths that fall and rise again, with heights of buttocks below and above."""
    found = read(
        "x,WL 1,WL 2,WL 3,WL 4,WL 5,Buttock 0,Buttock 1,Buttock "
        "2\n0,1.6,2.2,0.8,0.5,1.5,0,0.4,5.5\n"
        "1,1.6,2.2,0.8,0.5,1.5,0,0.4,5.5\n"
    )
    places = stations_of(found)[0.0].points[:, 1:]
    order = [(0, 0), (1, 0.4), (1.6, 1), (2.2, 2), (0.8, 3), (0.5, 4), (1.5, 5), (2, 5.5)]
    np.testing.assert_allclose(places, order)


@pytest.mark.parametrize(
    "text, message",
    [
        ("Station,WL 1,WL 2\n0,1,2\n1,1,2\n2,1,2\n", "station spacing"),
        ("Station,WL 1,WL 2\nfirst,1,2\nlast,1,2\n", "where station 'first' is"),
        ("Station,x,WL 0,WL 1\n0,0,1,2\n10,6,1,2\n20,,1,2\n30,18,1,2\n", "station '20' has no x"),
        ("x,WL 1,WL 2\n0,1,two\n", "line 2: 'two' at 'WL 2' is no length"),
        ("x,WL 1,WL 2\n0,1,5-12-0\n", "line 2: '5-12-0' has more than 11 inches"),
        ("x,WL 1,WL 2\n0,1,5-1-8\n", "more than 7 eighths"),
        ("x,WL 1,WL 2\n0,1,1e9\n", "line 2: 1e"),
        ("x,WL 1,WL 2\n", "no offsets are found"),
        (IN_BLOCKS.replace("base", "WL 1"), "line 6: 'Heights above WL 1' are not above the base"),
        (IN_CELLS.replace("base", "WL 1"), "line 6: 'Heights above WL 1' are not above the base"),
        ("x,WL 1\n0,1\n", "no station has two points"),
        ("", "no two points"),
        ("1 2\n3 4\n", "line 1: '1 2' are two numbers"),
        ("1 2 3\n4 5\n6 7 8 9\n", "line 2: '4 5' are two numbers"),
        ("1 2 3\n4 5 nan\n", "line 2: a number is not finite"),
        ("1 2 3\n4 5 1e9\n", "further than 1000000"),
        (b"\0\1\2\3" * 40, "none of the known formats"),
    ],
)
def test_what_is_wrong_is_told(read, text, message):
    with pytest.raises(hull_io.HullFileError, match=message) as refused:
        read(text)
    assert str(refused.value).startswith("hull.csv: ") and str(refused.value).endswith(".")


def test_unknown_lines_are_told(read):
    assert read(BY_ROWS.replace("Profile", "Paint")).left_out == (
        "'Paint' is no line that is known, and is left out.",
    )


def test_lines_without_a_place_are_told(read):
    found = read(BY_ROWS.replace("WL 1,", "Load waterline,").replace("Buttock 0.5", "Buttock"))
    assert found.left_out == (
        "'Load waterline' has no height in its heading, and is left out.",
        "'Buttock' has no distance from the centre line in its heading, and is left out.",
    )


@pytest.mark.parametrize(
    "above", ["", " above BL", " above B.L.", " above WL 0", " from base line"]
)
def test_lines_that_name_their_datum(read, above):
    found = read(
        f"x,WL 1 from CL,Buttock 0.5{above},Keel height{above},Deck height{above},"
        "Deck half-breadth\n"
        "0,0.25,1.5,0.6,5,2\n10,2,0.125,0,6,3\n"
    )
    lines = {curve.kind: curve.points.tolist() for curve in found.curves}
    assert lines["deck_edge"] == [[0, 2, 5], [10, 3, 6]]
    assert lines["profile"] == [[0, 0, 0.6], [10, 0, 0]]
    assert lines["waterline"] == [[0, 0.25, 1], [10, 2, 1]]
    assert lines["buttock"] == [[0, 0.5, 1.5], [10, 0.5, 0.125]]
    assert not found.left_out


@pytest.mark.parametrize(
    "text",
    [
        "Half-breadths\nStation;0;2;4\nTransom;1;1.5;2\n5;2;3;3.5\n10;1;2;2.5\n",
        "WL;Transom;Station 5;Station 10\n0;1;2;1\n2;1.5;3;2\n4;2;3.5;2.5\n",
    ],
)
def test_a_station_named_as_an_end(read, text):
    """It has no place, and is no line across the stations."""
    with pytest.raises(hull_io.HullFileError, match="where station 'Transom' is"):
        read(text)
    at_an_x = text.replace("Transom", "0")
    found = stations_of(read(at_an_x))
    assert list(found) == [0, 5, 10]
    np.testing.assert_allclose(found[5].points[:, 1:], [(2, 0), (3, 2), (3.5, 4)])


def test_ends_without_x_are_told(read):
    found = read("x,WL 1,WL 2,Stem,Stern height\n0,1,2,3,3\n10,1,2,3,\n")
    assert [told.split("'")[1] for told in found.left_out] == ["Stem", "Stern height"]
    assert {curve.kind for curve in found.curves} == {"station", "waterline"}


def test_units_are_sought_once(read, monkeypatch):
    """And not at each of 200 000 offsets through all of them."""
    calls, sought = [], offset_tables.OffsetTable._told_units
    monkeypatch.setattr(
        offset_tables.OffsetTable, "_told_units", lambda table: calls.append(1) or sought(table)
    )
    read("x [ft],WL 1,WL 2\n" + "".join(f"{x},1,2\n" for x in range(40)))
    assert len(calls) <= 2


@pytest.mark.parametrize("rest", ["", ",1,2", ",,"], ids=["nothing", "values", "empty cells"])
def test_rows_are_counted_in_all_blocks(read, monkeypatch, rest):
    monkeypatch.setattr(offset_tables, "MAX_OFFSETS", 10)
    block = "x,WL 1,WL 2\n" + "".join(f"{x}{rest}\n" for x in range(6))
    with pytest.raises(hull_io.HullFileError, match=r"line \d+: there are more than 10 values"):
        read("x,WL 1\n0,1\n1,1\n" + 2 * block)


def test_points_in_no_order(read):
    found = read("x, y, z\n1, 2, 3\n4, 5, 6\n7.5, 8, 9\n", "txt")
    assert found.points.tolist() == [[1, 2, 3], [4, 5, 6], [7.5, 8, 9]] and not found.curves
    assert read("unit: mm\n1 2 3\n4 5 6\n", "xyz").unit == "mm"
    assert read("1 2 3\n4 5 6\n", "xyz").points.tolist() == [[1, 2, 3], [4, 5, 6]]


@pytest.mark.parametrize(
    "between",
    ["\n", "# next\n", "Frame 2\n", "2\n", "\n2\n"],
    ids=["empty", "remark", "words", "n", "both"],
)
def test_points_with_breaks_are_curves(read, between):
    found = read(f"0 0 0\n0 1 1\n{between}5 0 0\n5 2 1\n5 3 2\n", "txt")
    assert [len(curve.points) for curve in found.curves] == [2, 3]
    assert found.curves[1].name == ("Frame 2" if "Frame" in between else "curve 2")


def test_points_section_by_section_are_curves(read):
    rows = [(x, y, y * y) for x in (0, 1, 2, 4) for y in (0, 1, 2)]
    text = "\n".join("{} {} {}".format(*row) for row in rows)
    assert [curve.points[0, 0] for curve in read(text, "txt").curves] == [0, 1, 2, 4]


def test_points_in_no_order_are_not_split(read, monkeypatch):
    """Of a million points each would become an array of its own, three times."""
    split, parts = np.split, []
    monkeypatch.setattr(np, "split", lambda points, at: parts.extend(at) or split(points, at))
    points = np.random.default_rng(7).uniform(size=(300, 3))
    text = "\n".join("{} {} {}".format(*point) for point in points)
    assert read(text, "xyz").points.tolist() == points.tolist() and not parts
