# SPDX-License-Identifier: GPL-3.0-or-later
"""New hulls are made without Blender, and hull files keep all of them."""

import json
import re
from dataclasses import fields

import numpy as np
import pytest
from hull_file_content import content, variant
from hull_io import HullData, hull_file, read_hull_file, write_hull_file
from hull_io.new_hulls import TYPES, new_hull
from hull_io.new_hulls.type_ships import as_new

# What is of the control mesh, in a HullData.
MESH = """points faces creases corners half layers face_layers particulars scheme deck_edge
    shown_rows curves flats developables locked kept ties groups units""".split()


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


@pytest.mark.parametrize("kind", TYPES)
def test_layers_of_a_new_hull_are_its_own(kind):
    lengths = (10.0, 3.0, 0.5, 1.5)
    first = new_hull(kind, *lengths, sections=10, points=8)
    for layer in first.layers:
        layer.name, layer.thickness = "Plates", 0.02
    layers = new_hull(kind, *lengths, 10, 8).layers
    assert [(layer.name, layer.thickness) for layer in layers] == [("Shell", 0.0), ("Transom", 0.0)]


def test_a_hull_after_a_type_ship_has_her_mesh_alone():
    described = content(
        particulars={"length_pp": 10.0, "beam": 4, "draft": 1.5, "depth": 3},
        plating={"thickness": 0.02},
        appendages=[
            {"shape": "cylinder", "start": [0, 0, 0], "end": [1, 0, 0], "sizes": [0.2, 0.2]}
        ],
        ties=[{"kind": "level", "point": 0, "to": [1]}],
        groups=[{"name": "Side", "points": [5, 3]}],
        variants=[variant()],
    )
    ship = hull_file.parse_hull_file(json.dumps(described).encode(), "ship.hull.json")
    made = as_new(ship, "New", 20.0, 8.0, 3.0, 6.0)
    plain = HullData("New", made.points, made.faces)
    rest = [one.name for one in fields(HullData) if one.name not in ("name", *MESH)]
    kept = [name for name in rest if getattr(made, name) != getattr(plain, name)]
    assert kept == [] and made.name == "New"
    assert [name for name in rest if getattr(ship, name) == getattr(plain, name)] == ["notes"]
    for name in ("layers", "ties", "groups", "creases", "faces"):
        assert getattr(made, name) == getattr(ship, name)
