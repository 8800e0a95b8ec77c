# SPDX-License-Identifier: GPL-3.0-or-later
"""Control curves in hull files, and what becomes of them when hulls are mirrored and mended."""

import json

import hull_io
import pytest
from hull_io.hull_curves import ControlCurve
from hull_io.mirror import mirror_faces

POINTS = [[0, 1, 0], [4, 1, 0], [4, 2, 3], [0, 2, 3], [8, 1, 0], [8, 2, 3]]
FACES = [[0, 1, 2, 3], [1, 4, 5, 2]]


def content(curves):
    return {"format": "hull", "version": 1, "units": "m", "half": True, "points": POINTS,
            "faces": FACES, "curves": curves}  # fmt: skip


def read(tmp_path, curves):
    path = tmp_path / "curves.hull.json"
    path.write_text(json.dumps(content(curves)), encoding="utf-8")
    return hull_io.read_hull_file(path)


def test_curves_are_read_and_written(tmp_path):
    hull = read(tmp_path, [{"name": "chine", "edges": [[1, 0], [1, 4]]},
                           {"name": "", "shown": False, "edges": [[2, 3]]}])  # fmt: skip
    assert hull.curves == [
        ControlCurve("chine", [(0, 1), (1, 4)], True),
        ControlCurve("", [(2, 3)], False),
    ]
    path = tmp_path / "again.hull.json"
    hull_io.write_hull_file(hull, path)
    assert hull_io.read_hull_file(path).curves == hull.curves


def test_files_without_curves_do_not_name_them(tmp_path):
    hull = read(tmp_path, [])
    assert hull.curves == []
    path = tmp_path / "again.hull.json"
    hull_io.write_hull_file(hull, path)
    assert "curves" not in json.loads(path.read_text(encoding="utf-8"))


@pytest.mark.parametrize("curves, said", [
    ([{"name": "a"}], r"curves\[0\].edges: it is missing"),
    ([{"edges": [[0, 2]]}], r"curves\[0\].edges\[0\]: \[0, 2\] is no edge of a face"),
    ([{"edges": [[0, 9]]}], r"curves\[0\].edges\[0\]\[1\]: 9 is no index"),
    ([{"edges": [[0, 1]]}, {"edges": [[1, 0]]}], r"curves\[1\].edges\[0\]: it is named twice"),
    ([{"edges": [], "colour": 1}], 'the key "colour" is unknown'),
])  # fmt: skip
def test_mistakes_are_told(tmp_path, curves, said):
    with pytest.raises(ValueError, match=said):
        read(tmp_path, curves)


def test_a_mirrored_hull_has_curves_on_both_sides(tmp_path):
    hull = read(tmp_path, [{"name": "chine", "edges": [[0, 1], [1, 4]]}])
    mirror_faces(hull, [0, 1])
    (curve,) = hull.curves
    assert len(curve.edges) == 4
    own = sorted(
        map(tuple, hull.points[sorted({p for edge in curve.edges for p in edge})].tolist())
    )
    assert own == sorted([(x, y, 0.0) for x in (0.0, 4.0, 8.0) for y in (-1.0, 1.0)])
