# SPDX-License-Identifier: GPL-3.0-or-later
"""All that belongs to a hull follows when it is brought to length, beam, depth and draft: each
setting that is to follow by what it is, and all that a hull file holds as hull_io has it follow."""

import dataclasses

import bpy
import numpy as np
import pytest
from addon_under_test import hull_io, mesh_points, part, sample, state_of

# Of length, breadth and heights; the draft is given besides.
GROWN = np.array([1.08, 0.93, 1.11])
DRAFT = 5.5
# How numbers grow that are told by a word, see hull_io.scaling.
X, Y, Z = GROWN
FACTORS = {
    "x": X, "at x": X, "y": Y, "at y": Y, "z": Z, "at z": Z, "at z, or 0": Z,
    "volume": X * Y * Z, "profile": X * Z, "section": Y * Z, "point": GROWN, "vector": GROWN,
}  # fmt: skip
# Texts of places, and where they are then.
TEXTS = {
    "lines.stations": ("10 20:60:20", [10 * X, 20 * X, 60 * X, 20 * X]),
    "lines.waterlines": ("1.5;4", [1.5 * Z, 4 * Z]),
    "lines.buttocks": ("2 3", [2 * Y, 3 * Y]),
}
OF_PLACES = ("stations", "waterlines", "buttocks", "diagonals")
SINGLE = 3e-7  # a few roundings of single precision


def entries(group, names):
    """The entries that a place of settings is of, where lists on the way get one if need be."""
    *above, name = names
    for part_name in above:
        rna = group.bl_rna.properties[part_name]
        group = getattr(group, part_name)
        if rna.type == "COLLECTION":
            group = group[0] if len(group) else group.add()
    return group, name


def read(hull, place):
    group, name = entries(hull.hull, place.split("."))
    value = getattr(group, name)
    return value if isinstance(value, str) else np.array(value, dtype=np.float64)


def fill(hull, following):
    """Gives all settings that follow a value of their own."""
    for number, (place, change) in enumerate(following.items()):
        group, name = entries(hull.hull, place.split("."))
        if place in TEXTS:
            setattr(group, name, TEXTS[place][0])
        elif change == "diagonals":
            setattr(group, name, "4/45 5/90")
        elif change in ("point", "vector", "normal"):
            setattr(group, name, (1.0 + 0.1 * number, 2.0, 3.0))
        elif place not in ("length_pp", "beam", "draft", "depth"):
            setattr(group, name, 1.5 + 0.01 * number)


def numbers_in(text):
    return [float(word) for part in text.split() for word in part.split(":")]


def filled_coaster():
    """The coaster with all that can belong to a hull, what is wanted and a variant among it."""
    hull = sample("coaster")
    fill(hull, part("features.dimensions.following").FOLLOWING)
    settings = hull.hull
    settings.wind.source = "GIVEN"
    settings.loading.use_displacement = settings.loading.use_lcb = False
    settings.table.draft_to = 6.0
    part("features.constraints.kept_points").set_axes(hull.data, range(20), (0, 2), True)
    bpy.context.view_layer.update()
    assert bpy.ops.hull.keep_variant(name="As built") == {"FINISHED"}
    return hull


def written(path):
    assert bpy.ops.hull.export_hull(filepath=str(path)) == {"FINISHED"}
    return hull_io().read_hull(path)


def assert_same(found, wanted, within=SINGLE, place=""):
    """What hull files hold, to a part of what is largest; texts of places by their numbers."""
    if dataclasses.is_dataclass(wanted):
        for field in dataclasses.fields(wanted):
            pair = (getattr(one, field.name) for one in (found, wanted))
            assert_same(*pair, within, f"{place}.{field.name}")
    elif isinstance(wanted, (list, tuple)) and not _are_numbers(wanted):
        assert len(found) == len(wanted), place
        for number, pair in enumerate(zip(found, wanted)):
            assert_same(*pair, within, f"{place}[{number}]")
    elif isinstance(wanted, str) and place.split(".")[-1] in OF_PLACES:
        split = [one.replace("/", ":").replace(";", " ") for one in (found, wanted)]
        assert numbers_in(split[0]) == pytest.approx(numbers_in(split[1]), rel=within), place
    elif wanted is None or isinstance(wanted, (str, bool)):
        assert found == wanted, place
    else:
        most = within * max(1.0, float(np.abs(wanted).max(initial=0.0)))
        assert np.asarray(found) == pytest.approx(np.asarray(wanted), rel=0.0, abs=most), place


def _are_numbers(value):
    return bool(len(value)) and all(isinstance(one, (int, float, np.number)) for one in value)


def test_all_that_belongs_to_a_hull_follows_and_comes_back_from_its_file(tmp_path):
    hull = filled_coaster()
    following = part("features.dimensions.following").FOLLOWING
    before = {place: read(hull, place) for place in following}
    as_it_was = written(tmp_path / "before.hull.json")
    settings = hull.hull
    wanted = {
        "length": X * settings.length_pp, "beam": Y * settings.beam, "depth": Z * settings.depth,
        "draft": DRAFT,
    }  # fmt: skip
    assert bpy.ops.hull.set_dimensions(**wanted) == {"FINISHED"}
    hull = bpy.context.object
    assert state_of(hull).status == "" and hull.hull.draft == pytest.approx(DRAFT, rel=SINGLE)
    for place, change in following.items():
        now = read(hull, place)
        if place in TEXTS:
            assert numbers_in(now) == pytest.approx(TEXTS[place][1], rel=SINGLE), place
        elif change in FACTORS and place != "draft":
            assert np.all(before[place] != 0.0), place  # else it would prove nothing
            assert now == pytest.approx(before[place] * FACTORS[change], rel=SINGLE), place
    # By hull_io, which has its own way of telling what follows.
    found = written(tmp_path / "after.hull.json")
    named = {"length_pp": wanted.pop("length"), **wanted}
    assert_same(found, hull_io().to_dimensions(as_it_was, **named))
    assert not np.array_equal(found.points, as_it_was.points) and len(found.variants) == 1
    assert np.array_equal(found.variants[0].hull.points, as_it_was.points)
    for flat in part("features.constraints.flats").regions(hull):
        off = mesh_points(hull)[flat.points].astype(np.float64) @ flat.plane[:3] - flat.plane[3]
        assert np.abs(off).max() < 1e-6 * named["length_pp"]
    # The file brings back what was written, to the last digit.
    assert bpy.ops.hull.import_hull(filepath=str(tmp_path / "after.hull.json")) == {"FINISHED"}
    again = written(tmp_path / "again.hull.json")
    # Names of the object and of its materials are taken already.
    again.name, again.notes, again.layers = found.name, found.notes, found.layers
    again.variants[0].hull.layers = found.variants[0].hull.layers
    assert_same(again, found, within=0.0)
