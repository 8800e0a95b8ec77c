# SPDX-License-Identifier: GPL-3.0-or-later
"""Half hulls to starboard come to port, and what is done is told."""

import copy

import hull_io
import numpy as np
import pytest
from freeship_writer import binary_file, box_model
from hull_io import mending


def read(tmp_path, model):
    path = tmp_path / "box.fbm"
    path.write_bytes(binary_file(model, 335))
    return hull_io.read_hull(path)


def to_starboard(model):
    model["points"] = [(x, -y, z, kind) for x, y, z, kind in model["points"]]
    return model


def test_a_half_hull_to_starboard_comes_to_port(tmp_path):
    port = read(tmp_path, box_model())
    hull = read(tmp_path, to_starboard(box_model()))
    np.testing.assert_array_equal(hull.points, port.points)
    assert not np.signbit(hull.points[:, 1]).any()
    turned = [face[face.index(min(face)) :] + face[: face.index(min(face))] for face in hull.faces]
    wanted = [face[face.index(min(face)) :] + face[: face.index(min(face))] for face in port.faces]
    assert turned == wanted
    assert (hull.creases, hull.corners) == (port.creases, port.corners)
    assert "The half hull lay to starboard (y < 0): it was mirrored to port." in hull.notes
    assert not any("starboard" in note for note in port.notes)


def plate(low, high):
    points = [(0, high, 0), (5, high, 0), (5, low, 0), (0, low, 1)]
    return hull_io.HullData("plate", points, [[0, 1, 2, 3]], half=True)


@pytest.mark.parametrize("across, expected", [(1e-5, True), (0.1, True), (0.6, True), (1.1, False)])
def test_a_centre_line_across_the_centre_plane_makes_no_port_side(across, expected):
    hull = plate(-2.0, across)
    assert mending.lies_to_starboard(hull) is expected
    hull.half = False
    assert not mending.lies_to_starboard(hull)


@pytest.mark.parametrize("low, high", [(-0.6, 2.0), (-1.9, 2.0), (-2.0, 2.0), (0.0, 0.0)])
def test_a_port_half_across_the_centre_plane_stays_as_it_is(low, high):
    hull = plate(low, high)
    mending.bring_to_port(hull)
    assert hull.notes == [] and hull.points[:, 1].tolist() == [high, high, low, low]


def test_demihulls_lie_on_the_side_where_they_are():
    assert mending.lies_to_starboard(plate(-8.0, -2.0))
    assert not mending.lies_to_starboard(plate(2.0, 8.0))


def test_flats_are_mirrored_too():
    points = [(0, 0, 0), (5, 0, 0), (5, -2, 0), (0, -2, 1)]
    hull = hull_io.HullData("plate", points, [[0, 1, 2, 3]], half=True)
    hull.flats = [hull_io.hull_data.Flat([0], (0.0, -0.6, 0.8), 1.0)]
    mending.bring_to_port(hull)
    assert hull.flats[0].normal == (0.0, 0.6, 0.8)
    assert hull.points[:, 1].max() == 2.0 and hull.faces == [[3, 2, 1, 0]]


def test_parts_that_touch_in_a_point_are_split_with_their_tags(tmp_path):
    model = box_model()
    model["points"] += [(12.0, 2.0, 0.0, 0), (12.0, 3.0, 0.0, 0)]
    model["faces"].append(([6, 8, 9], 0))
    hull = read(tmp_path, model)
    assert len(hull.points) == 11 and 6 not in hull.faces[5]
    np.testing.assert_array_equal(hull.points[10], hull.points[6])
    assert hull.corners == [6, 10]
    assert any("at point 6 of the file" in note for note in hull.notes)


def starboard_hull_file(tmp_path):
    """A hull file of a half box to starboard, with a wall across it on a third face, and with what
    lies in space."""
    points = [(x, y, z) for x in (0.0, 5.0, 10.0) for y in (0.0, -2.0) for z in (0.0, 3.0)]
    faces = [[2, 6, 7, 3], [6, 10, 11, 7], [0, 4, 6, 2], [4, 8, 10, 6], [4, 5, 7, 6]]
    hull = hull_io.HullData("box", points, faces, half=True)
    hull.downflooding_points = [hull_io.DownfloodingPoint("hatch", (5.0, -1.0, 3.0))]
    hull.load_cases = [hull_io.LoadCase("list", 10.0, 5.0, -0.1, 1.0)]
    hull.fields = [hull_io.ShapeField("bulge", 1.0, place=(5.0, -2.0, 1.0), shift=(0.0, -0.3, 0.0))]
    hull.particulars.beam = 4.0
    path = tmp_path / "box.hull.json"
    hull_io.write_hull_file(hull, path)
    return path


def test_a_hull_file_is_read_as_it_is_or_mended(tmp_path):
    path = starboard_hull_file(tmp_path)
    plain, mended = hull_io.read_hull(path), hull_io.read_mended(path)
    assert plain.notes == [] and plain.points[:, 1].min() == -2.0 and len(plain.points) == 12
    assert any("was mirrored to port" in note for note in mended.notes)
    assert any("were split" in note for note in mended.notes)
    assert mended.points[:, 1].min() == 0.0 and mended.points[:, 1].max() == 2.0
    assert len(mended.points) > 12
    # What lies in space came along; what is the whole ship's did not.
    assert mended.downflooding_points[0].position == (5.0, 1.0, 3.0)
    assert mended.fields[0].place == (5.0, 2.0, 1.0) and mended.fields[0].shift[1] == 0.3
    assert mended.load_cases == plain.load_cases and mended.particulars == plain.particulars
    again = copy.deepcopy(mended)
    mending.mend(again)
    assert again.notes == mended.notes and (again.points == mended.points).all()
    assert again.faces == mended.faces


def test_turned_faces_are_told_however_many_they_are(tmp_path):
    outwards = hull_io.read_hull(starboard_hull_file(tmp_path))
    mending.mend(outwards)
    for turned, said in ((0, None), (1, "1 of 5 faces were"), (5, "All 5 faces were")):
        hull = copy.deepcopy(outwards)
        hull.notes = []
        hull.faces[:turned] = [face[::-1] for face in hull.faces[:turned]]
        mending.turn_faces(hull)
        assert [sorted(face) for face in hull.faces] == [sorted(face) for face in outwards.faces]
        assert hull.notes == ([f"{said} turned to face outwards."] if said else [])
