# SPDX-License-Identifier: GPL-3.0-or-later
"""STL files, binary and text, and what is wrong with them; shapes of triangles."""

import random
import struct

import hull_io
import numpy as np
import pytest
from hull_io import triangles as shapes

SEED = 22112026
# A tetrahedron, turned outwards.
POINTS = np.array([(0.0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
TRIANGLES = np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])


def binary(corners, header=b"solid by name only"):
    records = b"".join(
        bytes(12) + np.asarray(three, dtype="<f4").tobytes() + bytes(2) for three in corners
    )
    return header.ljust(80, b"\0") + struct.pack("<I", len(corners)) + records


def text(corners):
    facets = "".join(
        "facet normal 0 0 0\n outer loop\n"
        + "".join("  vertex {:.9g} {:.9g} {:.9g}\n".format(*corner) for corner in three)
        + " endloop\nendfacet\n"
        for three in corners
    )
    return f"solid tetrahedron\n{facets}endsolid\n".encode()


@pytest.fixture
def read(tmp_path):
    def read_bytes(data):
        path = tmp_path / "shape.stl"
        path.write_bytes(data)
        return hull_io.read_stl(path)

    return read_bytes


@pytest.mark.parametrize("write", [binary, text])
def test_corners_at_one_place_are_one_point(read, write):
    points, triangles = read(write(POINTS[TRIANGLES]))
    assert points.shape == (4, 3) and triangles.shape == (4, 3)
    np.testing.assert_array_equal(points[triangles], POINTS[TRIANGLES])


def test_what_is_written_is_read(tmp_path):
    path = tmp_path / "shape.stl"
    moved = 100 / 3 + POINTS
    hull_io.write_stl(path, moved, TRIANGLES)
    points, triangles = hull_io.read_stl(path)
    assert np.array_equal(points[triangles], moved.astype(np.float32)[TRIANGLES])
    normals = [struct.unpack_from("<3f", path.read_bytes(), 84 + 50 * k) for k in range(4)]
    wanted = [(0, 0, -1), (0, -1, 0), 3 * [3**-0.5], (-1, 0, 0)]
    assert np.abs(np.subtract(normals, wanted)).max() < 1e-5


@pytest.mark.parametrize(
    "points, triangles, words",
    [
        (POINTS * np.nan, TRIANGLES, "no place"),
        (POINTS * 1e7, TRIANGLES, "no place"),
        (POINTS, TRIANGLES + 1, "points 0 to 3"),
        (POINTS, TRIANGLES - 1, "points 0 to 3"),
    ],
)
def test_what_can_t_be_written_is_refused(tmp_path, points, triangles, words):
    with pytest.raises(ValueError, match=words):
        hull_io.write_stl(tmp_path / "shape.stl", points, triangles)
    assert not list(tmp_path.iterdir())


def test_triangles_without_area_are_left_out(read):
    flat = np.array([POINTS[[0, 1, 1]]])
    points, triangles = read(binary(np.concatenate([flat, POINTS[TRIANGLES]])))
    assert len(triangles) == 4
    with pytest.raises(hull_io.HullFileError, match="no triangle"):
        read(binary(flat))


@pytest.mark.parametrize(
    "data, message",
    [
        (b"", "neither"),
        (b"\x89PNG" * 40, "neither"),
        (binary(POINTS[TRIANGLES], b"by me")[:-1], "neither"),
        (binary([]), "no triangle"),
        (b"solid\nvertex 1 2\n", "line 2"),
        (b"solid\nvertex 1 2 three\n", "line 2"),
        (b"solid\nvertex 1 2 3\n", "cut short"),
        (binary(POINTS[TRIANGLES] * np.nan), "no place"),
        (binary(POINTS[TRIANGLES] * 1e7), "no place"),
        (text(POINTS[TRIANGLES]).replace(b"1 0 0", b"inf 0 0"), "no place"),
    ],
)
def test_what_is_wrong_is_said(read, data, message):
    with pytest.raises(hull_io.HullFileError, match=message) as caught:
        read(data)
    assert str(caught.value).startswith("shape.stl: ")


def test_a_text_too_long_is_refused(read, monkeypatch):
    from hull_io import stl

    monkeypatch.setattr(stl, "MAX_STL_TEXT_BYTES", 100)
    with pytest.raises(hull_io.HullFileError, match="binary STL"):
        read(text(POINTS[TRIANGLES]))


@pytest.mark.parametrize("write", [binary, text])
def test_damaged_copies_are_read_or_refused(read, write):
    choice = random.Random(SEED)
    data = write(POINTS[TRIANGLES])
    refused = 0
    for _ in range(300):
        copy = bytearray(data[: choice.randrange(len(data))] if choice.random() < 0.3 else data)
        for _ in range(choice.choice((1, 3, 20))):
            if copy:
                copy[choice.randrange(len(copy))] = choice.randrange(256)
        try:
            points, triangles = read(bytes(copy))
            assert np.isfinite(points).all() and triangles.max() < len(points)
        except hull_io.HullFileError as error:
            assert str(error).startswith("shape.stl: ") and str(error).endswith(".")
            refused += 1
    assert 20 < refused < 300


def test_points_are_spread_by_area():
    # A unit square, and one of four times the area beside it.
    points = np.array([(0.0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])
    points = np.concatenate([points, 2 * points + [3.0, 0, 0]])
    square = np.array([(0, 1, 2), (0, 2, 3)])
    places, normals = shapes.spread_points(points, np.concatenate([square, square + 4]), 1000)
    assert len(places) == 1000 and (normals == [0, 0, 1]).all()
    assert np.count_nonzero(places[:, 0] <= 1) == 200
    counts, _, _ = np.histogram2d(*(places[200:, :2] - [3, 0]).T, bins=4, range=[(0, 2), (0, 2)])
    assert counts.min() >= 35 and counts.max() <= 65


def test_edges_that_turn_and_borders_are_features():
    edges = shapes.feature_edges(POINTS, TRIANGLES, np.radians(30.0))
    assert edges.shape == (6, 2, 3)
    # Without a face three edges are borders; at 100° only those at which it turns by 125° stay.
    assert len(shapes.feature_edges(POINTS, TRIANGLES[:3], np.radians(179.0))) == 3
    assert len(shapes.feature_edges(POINTS, TRIANGLES, np.radians(100.0))) == 3


def test_the_cut_by_the_centre_plane():
    cut = shapes.centre_cut(POINTS - [0.0, 0.25, 0.0], TRIANGLES)
    assert cut.shape == (3, 2, 3) and (cut[:, :, 1] == 0.0).all()
    corners = np.unique(np.round(cut.reshape(-1, 3), 12), axis=0)
    np.testing.assert_allclose(corners, [(0, 0, 0), (0, 0, 0.75), (0.75, 0, 0)])
    assert shapes.centre_cut(POINTS + 1.0, TRIANGLES).shape == (0, 2, 3)


def test_lines_have_points_close_together():
    (line,) = shapes.divided(np.array([[(0.0, 0, 0), (1, 0, 0)], [(1, 1, 1), (1, 1, 1)]]), 0.3)
    np.testing.assert_allclose(line[:, 0], [0.0, 0.25, 0.5, 0.75, 1.0])
