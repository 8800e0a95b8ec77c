# SPDX-License-Identifier: GPL-3.0-or-later
"""New hulls are made without Blender, and hull files keep all of them."""

import numpy as np
import pytest
from hull_io import read_hull_file, write_hull_file
from hull_io.new_hulls import TYPES, new_hull


@pytest.mark.parametrize("kind", TYPES)
def test_hull_files_keep_new_hulls(kind, tmp_path):
    each = TYPES[kind]
    lengths = (getattr(each.dimensions, name) for name in ("length", "beam", "draft", "depth"))
    hull = new_hull(kind, *lengths, each.sections, each.points)
    path = tmp_path / "new.hull.json"
    write_hull_file(hull, path)
    read = read_hull_file(path)
    assert not read.notes
    assert np.array_equal(read.points, hull.points)
    assert [list(face) for face in read.faces] == hull.faces
    for name in ("name", "creases", "corners", "half", "face_layers", "particulars", "flats"):
        assert getattr(read, name) == getattr(hull, name), name
    assert sorted(map(tuple, read.deck_edge)) == sorted(hull.deck_edge)
