# SPDX-License-Identifier: GPL-3.0-or-later
"""Locked and kept points in hull files, and when hulls are split and mirrored."""

import json

import hull_io
import pytest
from hull_file_content import content
from hull_io import mirror


def test_locked_and_kept_points_are_written_and_read(read, tmp_path):
    kept = {"stations": [1, 4], "waterlines": [2]}
    data = read(content(locked=[5, 0, 5], kept=kept))
    assert data.locked == [0, 5]
    assert data.kept == hull_io.Kept(stations=[1, 4], waterlines=[2])
    hull_io.write_hull_file(data, tmp_path / "again.hull.json")
    again = hull_io.read_hull_file(tmp_path / "again.hull.json")
    assert (again.locked, again.kept) == (data.locked, data.kept)
    # Files of hulls without any are as they were.
    data.locked, data.kept = [], hull_io.Kept()
    hull_io.write_hull_file(data, tmp_path / "none.hull.json")
    assert not {"locked", "kept"} & set(json.loads((tmp_path / "none.hull.json").read_text()))
    assert hull_io.read_hull_file(tmp_path / "none.hull.json").kept == hull_io.Kept()


@pytest.mark.parametrize(
    "changes, where",
    [({"locked": [6]}, "locked[0]"), ({"locked": 1}, "locked"), ({"kept": {"x": [1]}}, "kept"),
     ({"kept": {"stations": [1, -1]}}, "kept.stations[1]"), ({"kept": []}, "kept")],
)  # fmt: skip
def test_wrong_locked_and_kept_points_are_named(read, changes, where):
    with pytest.raises(hull_io.HullFileError) as caught:
        read(content(**changes))
    assert where in str(caught.value)


def test_split_and_mirrored_points_keep_what_they_are(read):
    """Two boxes' sides that meet in a point part there; the mirror image has the same."""
    data = read(content(locked=[3, 5], kept={"stations": [3], "buttocks": [4]}))
    mirror.mirror_faces(data, range(len(data.faces)))
    points = data.points.tolist()
    assert [points[i] for i in data.locked] == [
        [0, 2, 0], [10, 2, 3], [0, -2, 0], [10, -2, 3]
    ]  # fmt: skip
    assert [points[i] for i in data.kept.stations] == [[0, 2, 0], [0, -2, 0]]
    assert [points[i] for i in data.kept.buttocks] == [[0, 2, 3], [0, -2, 3]]
