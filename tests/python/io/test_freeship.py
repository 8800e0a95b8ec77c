# SPDX-License-Identifier: GPL-3.0-or-later
"""FREE!ship files made here, of every version and both encodings, and what is refused."""

import math
import struct

import hull_io
import numpy as np
import pytest
from freeship_writer import VERSIONS, binary_file, box_model, text_file

ENCODINGS = {
    "binary": (".fbm", binary_file),
    "text": (".ftm", text_file),
    "text, decimal commas": (".ftm", lambda m, v: text_file(m, v, comma=True)),
    "text, words, CR LF": (".ftm", lambda m, v: text_file(m, v, words=True, line_end="\r\n")),
}


@pytest.fixture(params=ENCODINGS)
def encoding(request):
    return ENCODINGS[request.param]


@pytest.fixture
def read(tmp_path):
    """Reads a model (or bytes) through a file."""

    def read_model(model, version=335, encoding=ENCODINGS["binary"]):
        suffix, write = encoding
        path = tmp_path / f"box{suffix}"
        path.write_bytes(model if isinstance(model, bytes) else write(model, version))
        return hull_io.read_hull(path)

    return read_model


def face_normal(hull, face):
    a, b, c = hull.points[hull.faces[face][:3]]
    normal = np.cross(b - a, c - b)
    return normal / np.linalg.norm(normal)


@pytest.mark.parametrize("version", VERSIONS)
def test_every_version_reads_alike(read, encoding, version):
    model = box_model()
    hull = read(model, version, encoding)
    assert hull.name == "Ящик"
    assert hull.source == f"FREE!ship {version / 100:.2f}"
    assert hull.units == "m"
    assert hull.half
    np.testing.assert_array_equal(hull.points, [point[:3] for point in model["points"]])
    assert [set(face) for face in hull.faces] == [set(face) for face, _ in model["faces"]]
    assert hull.face_layers == [0, 0, 0, 0, 1]
    assert hull.creases == [(2, 6), (4, 6)]
    assert hull.corners == [6]
    assert [(layer.name, layer.colour) for layer in hull.layers] == [
        ("Shell", (1.0, 0.0, 0.0)),
        ("Deck", (0.0, 1.0, 0.0)),
    ]
    assert [layer.in_hydrostatics for layer in hull.layers] == [True, version < 180]
    assert hull.particulars == hull_io.Particulars(10.0, 4.1, 1.3, 0.0, 1.025)


@pytest.mark.parametrize("version", VERSIONS)
def test_every_version_ends_where_the_sections_end(tmp_path, encoding, version):
    suffix, write = encoding
    model = box_model()
    path = tmp_path / f"box{suffix}"
    path.write_bytes(write(model, version))
    families = ["stations", "buttocks", "waterlines"] + ["diagonals"] * (version >= 180)
    wanted = [section for family in families for section in model[family]]
    found = hull_io.stored_sections(path)
    kinds = ["free", "station", "buttock", "waterline", "diagonal"]
    assert [section.kind for section in found] == [kinds[kind] for kind, _, _ in wanted]
    for section, (_, plane, curves) in zip(found, wanted):
        assert section.plane == plane
        assert len(section.curves) == len(curves)
        for (points, knuckles), rows in zip(section.curves, curves):
            np.testing.assert_array_equal(
                points, np.array([row[:3] for row in rows]).reshape(-1, 3)
            )
            assert knuckles.tolist() == [bool(row[3]) for row in rows]


def test_faces_are_turned_outwards(read):
    hull = read(box_model())
    normals = [face_normal(hull, face) for face in range(5)]
    outwards = [(0, 1, 0), (0, 0, -1), (-1, 0, 0), (1, 0, 0), (0, 0, 1)]
    np.testing.assert_allclose(normals, outwards, atol=1e-12)


def test_shell_arrays_hold_the_shell_alone(read):
    model = box_model()
    model["points"].insert(0, (5.0, 1.0, 9.0, 3))
    model["edges"] = [(a + 1, b + 1, crease) for a, b, crease in model["edges"]]
    model["faces"] = [([point + 1 for point in face], layer) for face, layer in model["faces"]]
    model["curves"] = []
    hull = read(model)
    shell = hull_io.shell_arrays(hull)
    assert shell.point_indices.tolist() == [1, 2, 3, 4, 5, 6, 7, 8]
    assert shell.face_indices.tolist() == [0, 1, 2, 3]
    assert shell.face_sizes.tolist() == [4, 4, 4, 4]
    np.testing.assert_array_equal(shell.points, hull.points[1:])
    vertices = np.split(shell.face_vertices, 4)
    for face, back in zip(vertices, shell.face_indices):
        assert shell.point_indices[face].tolist() == hull.faces[back]
    assert shell.creases.tolist() == [[2, 6], [4, 6]]
    assert shell.corners.tolist() == [6]
    assert shell.points.dtype == np.float64
    for array in (shell.face_sizes, shell.face_vertices, shell.creases, shell.corners):
        assert array.dtype == np.int32


def test_feet_become_metres(read, encoding):
    model = box_model()
    model.update(units=1, density=64.0)
    hull = read(model, 335, encoding)
    assert hull.units == "ft"
    np.testing.assert_allclose(hull.points[7], [3.048, 0.6096, 0.9144], rtol=1e-12)
    assert hull.particulars.length_pp == pytest.approx(3.048, rel=1e-12)
    # FREE!ship's pounds: 2240 of them to the tonne; 0.028316846592 m3 to the cubic foot.
    assert hull.particulars.water_density == pytest.approx(64 / 2240 / 0.028316846592, rel=1e-12)


@pytest.mark.parametrize(
    "units, stored, density",
    [
        (0, 1.025, 1.025),
        (0, 64.0, 0.0),
        (0, math.nan, 0.0),
        (1, 1.025, 1.025),
        (1, 65.0155, 1.025),  # as FREE!ship stores 1.025 t/m3 when it goes over to feet
        (1, 1 / 35, 2240 * 0.45359237 / 0.028316846592 / 35 / 1000),
        (1, 0.0, 0.0),
    ],
)
def test_water_density_of_any_unit(read, units, stored, density):
    model = box_model()
    model.update(units=units, density=stored)
    hull = read(model)
    assert hull.particulars.water_density == pytest.approx(density, rel=1e-6)
    assert any("water density" in note for note in hull.notes) == (density == 0.0)


@pytest.mark.parametrize("value", [math.nan, math.inf, -3.0, 1e30])
def test_a_dimension_that_is_none_is_not_given(read, value):
    model = box_model()
    model["beam"] = value
    hull = read(model)
    assert hull.particulars.beam == 0.0
    assert any("beam" in note for note in hull.notes)


def test_a_file_without_a_name_is_called_as_the_file(read):
    model = box_model()
    model["name"] = " "
    assert read(model).name == "box"


def test_an_edge_may_start_at_minus_one(read):
    model = box_model()
    model["edges"].append((-1, 4, True))
    assert (0, 4) in read(model).creases


def test_any_byte_is_a_letter(read):
    content = binary_file(box_model(), 335)
    assert read(content.replace("Ящик".encode("cp1251"), b"\x98\x00\xff\x07")).name == "\ufffd я"


def test_degenerate_and_double_faces_are_mended_and_noted(read):
    model = box_model()
    model["faces"] += [
        ([0, 0, 1, 5, 5, 4, 0], 0),  # runs of one point, also around the end: a quadrilateral
        ([0, 1, 1, 0], 0),  # two points
        ([1, 3, 1, 5], 0),  # touches point 1 twice
        ([7, 3, 2, 6], 0),  # the side again
        ([3, 7, 5, 1], 0),  # the deck again, now in the shell
    ]
    hull = read(model)
    assert [set(face) for face in hull.faces[4:]] == [{0, 1, 5, 4}, {3, 7, 5, 1}]
    assert hull.face_layers == [0, 0, 0, 0, 0, 0]
    assert hull.notes[:4] == [
        "Repeated points were taken out: face 5 of the file.",
        "Left out for having fewer than 3 different points: face 6 of the file.",
        "Left out for touching a point twice: face 7 of the file.",
        "Left out for having the points of another face: face 8, 4 of the file.",
    ]


def test_a_plate_on_the_shell_is_split_from_it(read):
    model = box_model()
    model["points"].append((5.0, 1.0, -1.0, 0))
    model["faces"].append(([2, 6, 8], 0))
    hull = read(model)
    assert sum({2, 6} <= set(face) for face in hull.faces) == 2
    plate = hull.faces[5]
    np.testing.assert_array_equal(
        sorted(hull.points[plate].tolist()), [[0, 2, 0], [5, 1, -1], [10, 2, 0]]
    )
    note = next(note for note in hull.notes if "split" in note)
    assert "edge 2–6 of the file" in note and "1 faces stand on others (layer Shell)" in note


def test_a_hull_without_symmetric_layers_is_whole(read):
    model = box_model()
    model["layers"] = [("Shell", 0, False, True), ("Deck", 0, True, False)]
    assert not read(model).half


def test_where_symmetry_is_mixed_both_sides_are_made(read):
    model = box_model()
    model["layers"].append(("Fin", 0, False, True))
    model["points"] += [(4.0, 0.0, -1.0, 0), (6.0, 0.0, -1.0, 0)]
    model["faces"].append(([0, 8, 9, 4], 2))
    hull = read(model)
    assert not hull.half
    assert len(hull.faces) == 6 + 5
    # Points 0, 1, 4, 5, 8 and 9 lie on the centre plane; 2, 3, 6 and 7 have an image. The fin
    # stands on the edge of two others and is split from them.
    assert len(hull.points) == 10 + 4 + 2
    np.testing.assert_array_equal(hull.points[10:14], hull.points[[2, 3, 6, 7]] * [1, -1, 1])
    assert hull.face_layers[6:] == [0, 0, 0, 0, 1]
    assert {(2, 6), (4, 6), (10, 12), (4, 12)} <= set(hull.creases)
    assert (0, 4) in hull.creases, "the keel was a border of the half, thus a crease"
    assert hull.corners == [6, 12]
    assert any("Fin" in note for note in hull.notes)
    for face in range(4):
        mirrored = face_normal(hull, 6 + face)
        np.testing.assert_allclose(mirrored, face_normal(hull, face) * [1, -1, 1], atol=1e-12)


def spoilt(**changes):
    model = box_model()
    for key, value in changes.items():
        place, entry = value
        model[key][place] = entry
    return model


REFUSED = {
    "not a number": (spoilt(points=(3, (0.0, math.nan, 1.0, 0))), "point 3", "can't be a ship's"),
    "infinite": (spoilt(points=(5, (math.inf, 0.0, 1.0, 0))), "point 5", "can't be a ship's"),
    "far": (spoilt(points=(5, (0.0, 0.0, 1e7, 0))), "point 5", "can't be a ship's"),
    "edge": (spoilt(edges=(1, (2, 8, True))), "edge 1", "it uses point 8"),
    "edge below": (spoilt(edges=(1, (-2, 3, True))), "edge 1", "it uses point -2"),
    "face": (spoilt(faces=(2, ([0, 1, 99], 0))), "face 2", "it uses point 99"),
    "layer": (spoilt(faces=(2, ([0, 1, 3], 2))), "face 2", "it is in layer 2"),
    "no faces": ({**box_model(), "faces": []}, "the number of faces", "no faces"),
    "no points": (
        {**box_model(), "points": [], "edges": [], "curves": []},
        "the number of points",
        "no points",
    ),
    "units": ({**box_model(), "units": 2}, "the project settings", "number 2"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_wrong_is_named(read, encoding, case):
    model, element, problem = REFUSED[case]
    with pytest.raises(hull_io.HullFileError) as caught:
        read(model, 335, encoding)
    message = str(caught.value)
    assert message.startswith("box.f")
    assert element in message and problem in message
    assert ("byte " if encoding[0] == ".fbm" else "line ") in message
    assert message.endswith(".") and "; " in message and "\n" not in message


@pytest.mark.parametrize("word", ["nan", "-INF", "1e999", "1_0", "x", "1.000,5", "0" * 50])
def test_a_word_that_is_no_coordinate_is_refused_with_its_line(read, word):
    content = text_file(spoilt(points=(3, (12.25, 1.0, 1.0, 0))), 335)
    line = content.split(b"\n").index(b"12.25 1 1") + 1
    with pytest.raises(hull_io.HullFileError, match=f"point 3, line {line}: "):
        read(content.replace(b"12.25", word.encode()), 335, ENCODINGS["text"])


def test_a_missing_word_does_not_shift_the_rest(read):
    content = text_file(box_model(), 335)
    with pytest.raises(hull_io.HullFileError, match="point 7, line"):
        read(content.replace(b"10 2 3\n", b"10 2\n"), 335, ENCODINGS["text"])


@pytest.mark.parametrize("count", [-1, -(2**31), 2**31 - 1, 300_000, 2000])
def test_an_absurd_count_is_refused_before_it_is_believed(read, encoding, count):
    model = box_model()
    suffix, write = encoding
    content = write(model, 335)
    if suffix == ".fbm":
        at = content.index(struct.pack("<i", 8) + struct.pack("<fff", 0, 0, 0))
        content = content[:at] + struct.pack("<i", count) + content[at + 4 :]
    else:
        end = b"\r\n" if b"\r\n" in content else b"\n"
        content = content.replace(end + b"8" + end + b"0 0 0" + end, end + b"%d" % count + end, 1)
    with pytest.raises(hull_io.HullFileError, match=f"number of points, .*it is {count}"):
        read(content, 335, encoding)


def test_every_truncation_is_refused(read, encoding):
    """Up to the end of the faces nothing may be missing."""
    content = encoding[1](box_model(), 335)
    families = ("stations", "buttocks", "waterlines", "diagonals")
    tail = encoding[1]({**box_model(), **{family: [] for family in families}}, 335)
    ending = 5 * (4 if encoding[0] == ".fbm" else 3 if b"\r\n" in content else 2)
    # The last value before is a boolean of one byte or one line; its line end may be missing.
    needed = len(tail) - ending - (0 if encoding[0] == ".fbm" else 2)
    for length in range(0, needed, 7 if len(content) > 2000 else 1):
        with pytest.raises(hull_io.HullFileError):
            read(content[:length], 335, encoding)


def test_what_follows_the_faces_is_not_needed(read):
    content = binary_file(box_model(), 335)
    # Before the plane's -2.5: the number of stations, a type, a boolean and three reals.
    after_faces = content.index(struct.pack("<f", -2.5)) - (4 + 4 + 1 + 12)
    assert len(read(content[:after_faces]).faces) == 5
    with pytest.raises(hull_io.HullFileError):
        read(content[: after_faces - 1])


@pytest.mark.parametrize("start", [b"\x09\x00\x00\x00FREE!ship\x2d", b"FREE!ship\n5.1\n"])
def test_an_unknown_version_is_refused(read, start):
    suffix = "text" if start[0] == ord("F") else "binary"
    with pytest.raises(hull_io.HullFileError, match="version.*unknown"):
        read(start + bytes(100), 335, ENCODINGS[suffix])


@pytest.mark.parametrize("text, version", [("2.6", 260), ("3.02+", 302), ("4,3", 430), ("1", 100)])
def test_the_version_of_a_text_file(read, text, version):
    content = text_file(box_model(), version)
    old = f"{version / 100:g}".encode()
    hull = read(
        content.replace(b"\n" + old + b"\n", b"\n" + text.encode() + b"\n", 1), 0, (".ftm", None)
    )
    assert hull.source == f"FREE!ship {version / 100:.2f}"
