# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies joined to a hull, in hull files: written and read, and refused where they are none."""

import json

import hull_io
import pytest
from test_hull_file import content

TUNNEL = {
    "name": "Bow thruster",
    "shape": "cylinder",
    "start": [85.0, -7.0, 2.0],
    "end": [85.0, 7.0, 2.0],
    "sizes": [0.7, 0.7],
    "cut": True,
}
KEEL = {
    "name": "Keel",
    "shape": "foil",
    "start": [9.0, 0, 0.4],
    "end": [8.6, 0.1, -1.6],
    "sizes": [2.4, 1.8],
    "section": "63-012",
    "thicknesses": [0.12, 0.15],
    "on": False,
    "mirrored": True,
}


def test_appendages_are_written_and_read(read, tmp_path):
    data = read(content(appendages=[TUNNEL, KEEL]))
    tunnel, keel = data.appendages
    assert tunnel == hull_io.Appendage(
        "Bow thruster", "cylinder", (85.0, -7.0, 2.0), (85.0, 7.0, 2.0), (0.7, 0.7), cut=True
    )
    assert (keel.section, keel.thicknesses, keel.on, keel.mirrored) == (
        "63-012", (0.12, 0.15), False, True,
    )  # fmt: skip
    assert keel.chord_direction == (-1.0, 0.0, 0.0)
    hull_io.write_hull_file(data, tmp_path / "again.hull.json")
    assert hull_io.read_hull_file(tmp_path / "again.hull.json").appendages == data.appendages
    data.appendages = []
    hull_io.write_hull_file(data, tmp_path / "none.hull.json")
    assert "appendages" not in json.loads((tmp_path / "none.hull.json").read_text())


def test_freeships_files_do_not_have_them(read, tmp_path):
    data = read(content(appendages=[TUNNEL]))
    said = " ".join(hull_io.write_freeship(data, tmp_path / "box.fbm", "m"))
    assert "appendages" in said


@pytest.mark.parametrize(
    "changed, where",
    [
        ({"shape": "sphere"}, "appendages[0].shape"),
        ({"start": [1, 2]}, "appendages[0].start"),
        ({"end": [85.0, -7.0, 2.0]}, "appendages[0].end: it is where the start is"),
        ({"sizes": [-1, 1]}, "appendages[0].sizes[0]"),
        ({"thicknesses": [0.1, 2.0]}, "appendages[0].thicknesses[1]"),
        ({"chord_direction": [0, 0, 0]}, "appendages[0].chord_direction: it has no direction"),
        ({"cut": "yes"}, "appendages[0].cut"),
        ({"radius": 2}, "appendages[0]: the key"),
    ],
)
def test_what_is_none_is_refused(read, changed, where):
    with pytest.raises(hull_io.HullFileError) as error:
        read(content(appendages=[{**TUNNEL, **changed}]))
    assert where in str(error.value)


def test_what_is_missing_is_told(read):
    with pytest.raises(hull_io.HullFileError, match=r"appendages\[0\].sizes: it is missing"):
        read(content(appendages=[{key: TUNNEL[key] for key in ("shape", "start", "end")}]))
