# SPDX-License-Identifier: GPL-3.0-or-later
"""New hulls are made without Blender, and hull files keep all of them."""

import re

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


def test_layers_of_a_new_hull_are_its_own():
    each = next(iter(TYPES.values()))
    lengths = [getattr(each.dimensions, name) for name in ("length", "beam", "draft", "depth")]
    first, second = (new_hull(next(iter(TYPES)), *lengths, 10, 8) for _ in range(2))
    assert first.layers == second.layers
    first.layers[0].name = first.layers[1].name = "Plates"
    assert [layer.name for layer in second.layers] == ["Shell", "Transom"]


@pytest.mark.parametrize("kind", TYPES)
def test_dimensions_that_no_hull_has_are_named(kind):
    usual = TYPES[kind].dimensions
    lengths = {name: getattr(usual, name) for name in ("length", "beam", "draft", "depth")}
    for name in lengths:
        for wrong, remedy in ((0.0, "give more than 0"), (1e30, "give at most 10000 m")):
            with pytest.raises(ValueError, match=re.escape(f"The {name} is {wrong:g} m: {remedy}")):
                new_hull(kind, **{**lengths, name: wrong}, sections=10, points=8)


@pytest.mark.parametrize("kind", TYPES)
def test_dimensions_at_their_limits_make_hulls(kind):
    for length in (1e-3, 1e4):
        for beam in (1e-3, 1e4):
            for draft, depth in ((1e-3, 2e-3), (1e-3, 1e4), (9e3, 1e4)):
                hull = new_hull(kind, length, beam, draft, depth, sections=10, points=8)
                assert np.isfinite(hull.points).all()
