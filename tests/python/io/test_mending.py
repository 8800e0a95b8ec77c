# SPDX-License-Identifier: GPL-3.0-or-later
"""Half hulls to starboard come to port, and what is done is told."""

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


@pytest.mark.parametrize("across, expected", [(1e-5, True), (0.1, False)])
def test_noise_across_the_centre_plane_makes_no_port_side(across, expected):
    points = [(0, across, 0), (5, across, 0), (5, -2, 0), (0, -2, 1)]
    hull = hull_io.HullData("plate", points, [[0, 1, 2, 3]], half=True)
    assert mending.lies_to_starboard(hull) is expected
    hull.half = False
    assert not mending.lies_to_starboard(hull)


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
