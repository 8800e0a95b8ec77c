# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of sectional areas: what people and programs write, and what is wrong with some."""

import random

import hull_io
import numpy as np
import pytest
from hull_io import area_tables

SEED = 23112026
X, AREAS = [0.0, 10.5, 20.0, 42.25], [1.5, 20.25, 60.0, 0.0]
HEADING = "x from AP [m],area [m2],centroid y [m]\n"


def parsed(text):
    x, areas = area_tables.parse_area_table(text, "areas.csv")
    return x.tolist(), areas.tolist()


@pytest.mark.parametrize(
    "text",
    [
        "0,1.5\n10.5,20.25\n20,60\n42.25,0\n",
        "0, 1.5\n10.5, 20.25\n20, 60\n42.25, 0\n",
        "0;1,5\n10,5;20,25\n20;60\n42,25;0\n",
        "0\t1,5\r\n10,5\t20,25\r\n20\t60\r\n42,25\t0\r\n",
        "0 1,5\n10,5 20,25\n20 60\n42,25 0",
        "  0   1.5\n\n10.5 20.25  # midship\n20 60\n42.25 0\n",
        "42.25 0\n20 60\n10.5 20.25\n0 1.5\n",
        "Area curve of hull 7\nstation;area\n0;1.5\n10.5;20.25\n20;60\n42.25;0\n",
        "no,area [m2],x [m]\n1,1.5,0\n2,20.25,10.5\n3,60,20\n4,0,42.25\n",
        HEADING + "0,1.5,0\n10.5,20.25,0\n20,60,0\n42.25,0,0\n",
        '"x","area"\n"0","1.5"\n"10.5","20.25"\n"20","60"\n"42.25","0"\n',
    ],
)
def test_what_people_write_is_read(text):
    assert parsed(text) == (X, AREAS)


@pytest.mark.parametrize(
    "heading, x_size, area_size",
    [
        ("x from AP [m],area [m2]", 1.0, 1.0),
        ("x from AP [ft],area [ft2],centroid y [ft]", 0.3048, 0.3048**2),
        ("x (mm),area (m²)", 1e-3, 1.0),
        ("Place [ft],Spantfläche [ft2]", 0.3048, 0.3048**2),
        ("x (from AP),area (immersed)", 1.0, 1.0),
        ("x (AP),area", 1.0, 1.0),
    ],
)
def test_units_of_headings(heading, x_size, area_size):
    rows = "".join(f"{x},{a},0\n" for x, a in zip(X, AREAS))
    x, areas = parsed(f"{heading}\n{rows}")
    assert x == [value * x_size for value in X]
    assert areas == [value * area_size for value in AREAS]


@pytest.mark.parametrize(
    "text, message",
    [
        ("", "0 lines with a place and an area"),
        ("x,area\n0,1\n1,2\n", "2 lines"),
        ("0,1\n1,two\n2,3\n", "line 2, column 2: an area"),
        ("0,1\n,2\n2,3\n", "line 2, column 1: x in metres"),
        ("0,1\n1\n2,3\n", "line 2, column 2"),
        ("0,1\n1,nan\n2,3\n", "line 2, column 2"),
        ("0,1\n1e9,2\n2,3\n", "line 2: x is 1e"),
        ("0,1\n1,-2\n2,3\n", "line 2: the area is -2"),
        ("0,1\n1,1e30\n2,3\n", "line 2: the area is 1e"),
        ("x [in],area [m2]\n0,1\n1,2\n2,1\n", r"line 1: 'x \[in\]' has a unit"),
        ("x,area (cm2)\n0,1\n1,2\n2,1\n", r"line 1: 'area \(cm2\)' has a unit"),
        ("0,1\n2,2\n1,3\n3,1\n", "line 3: x is 1 m beside 2 m"),
        ("0,1\n1,2\n1,3\n", "line 3: x is 1 m beside 1 m"),
        ("0,0\n1,0\n2,0\n", "all areas are 0"),
        ("".join(f"{k},1\n" for k in range(501)), "more than 500"),
    ],
)
def test_what_is_wrong_is_told_with_its_line(text, message):
    with pytest.raises(hull_io.HullFileError, match=message) as refused:
        parsed(text)
    assert str(refused.value).startswith("areas.csv: ") and str(refused.value).endswith(".")


def test_files(tmp_path):
    path = tmp_path / "areas.csv"
    path.write_bytes("\ufeffx;area m²\n0;1\n1;2\n2;1\n".encode())
    assert hull_io.read_area_table(path)[1].tolist() == [1.0, 2.0, 1.0]
    path.write_bytes("Spantflächen\n0;1\n1;2\n2;1\n".encode("latin-1"))
    assert hull_io.read_area_table(str(path))[0].tolist() == [0.0, 1.0, 2.0]
    path.write_bytes(bytes(2**20 + 1))
    with pytest.raises(hull_io.HullFileError, match="no hull file has more"):
        hull_io.read_area_table(path)
    with pytest.raises(hull_io.HullFileError, match="can't be opened"):
        hull_io.read_area_table(tmp_path / "none.csv")


def test_spoilt_tables_are_read_or_refused():
    print("seed", SEED)
    chance = random.Random(SEED)
    text = HEADING + "".join(f"{x},{a},0\n" for x, a in zip(X, AREAS))
    for _ in range(300):
        letters = list(text)
        for _ in range(chance.randrange(1, 6)):
            place = chance.randrange(len(letters))
            letters[place] = chance.choice('0123456789.,;-e# \t\n\0"xäN')
        try:
            x, areas = area_tables.parse_area_table("".join(letters), "areas.csv")
        except hull_io.HullFileError:
            continue
        assert (np.diff(x) > 0.0).all() and np.isfinite(areas).all() and areas.max() > 0.0
