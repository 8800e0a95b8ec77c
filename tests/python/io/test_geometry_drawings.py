# SPDX-License-Identifier: GPL-3.0-or-later
"""DXF and OBJ files: what is drawn, against closed forms, and what is wrong with some."""

import hull_io
import numpy as np
import pytest
from hull_io.geometry import Spline, read_geometry


@pytest.fixture
def read(tmp_path):
    def read_text(text, ending="dxf"):
        path = tmp_path / f"lines.{ending}"
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return read_geometry(path)

    return read_text


def dxf(*entities, header=(), blocks=()):
    """The text of a drawing; entities: lists of type and pairs of group code and value."""

    def pairs(records):
        for kind, *values in records:
            yield from (0, kind)
            for pair in values:
                yield from pair

    lines = [0, "SECTION", 2, "HEADER", *header, 0, "ENDSEC"]
    lines += [0, "SECTION", 2, "BLOCKS", *pairs(blocks), 0, "ENDSEC"]
    lines += [0, "SECTION", 2, "ENTITIES", *pairs(entities), 0, "ENDSEC", 0, "EOF"]
    return "".join(f"{value}\n" for value in lines)


def xyz(first, *places):
    return [pair for x, y, z in places for pair in ((first, x), (first + 10, y), (first + 20, z))]


LINE = ["LINE", (8, "STATIONS"), *xyz(10, (1, 2, 3)), *xyz(11, (4, 5, 6))]


def test_lines_have_their_layer_and_unit(read):
    found = read(dxf(LINE, header=(9, "$INSUNITS", 70, 4)))
    (curve,) = found.curves
    assert curve.group == "STATIONS" and found.unit == "mm"
    assert curve.points.tolist() == [[1, 2, 3], [4, 5, 6]]
    assert read(dxf(LINE)).unit is None


@pytest.mark.parametrize("start, end", [(0, 90), (30, 200), (300, 60), (10, 370)])
def test_arcs_are_exact(read, start, end):
    arc = ["ARC", *xyz(10, (1, 2, 3)), (40, 5.0), (50, start), (51, end)]
    (curve,) = read(dxf(arc)).curves
    away = curve.points - (1, 2, 3)
    np.testing.assert_allclose(np.linalg.norm(away, axis=1), 5.0, rtol=1e-14)
    turn = np.radians(start), np.radians(end)
    for point, angle in zip(away[[0, -1]], turn):
        np.testing.assert_allclose(point, [5 * np.cos(angle), 5 * np.sin(angle), 0], atol=1e-13)
    length = np.linalg.norm(np.diff(curve.points, axis=0), axis=1).sum()
    assert length == pytest.approx(5 * np.radians((end - start) % 360 or 360), rel=1e-4)
    assert not curve.knuckles.any()


def test_arcs_have_planes_of_their_own(read):
    """Extruded along x the format's axes of the entity are y and z."""
    (curve,) = read(dxf(["CIRCLE", *xyz(10, (2, 3, 7)), (40, 1), *xyz(210, (1, 0, 0))])).curves
    np.testing.assert_allclose(curve.points[:, 0], 7.0)
    away = curve.points[:, 1:] - (2, 3)
    np.testing.assert_allclose(np.linalg.norm(away, axis=1), 1.0, rtol=1e-14)


def test_ellipses(read):
    ellipse = ["ELLIPSE", *xyz(10, (0, 0, 0)), *xyz(11, (4, 0, 0)), (40, 0.5), (41, 0), (42, np.pi)]
    (curve,) = read(dxf(ellipse)).curves
    x, y, _ = curve.points.T
    np.testing.assert_allclose((x / 4) ** 2 + (y / 2) ** 2, 1.0, rtol=1e-13)
    assert y.min() > -1e-12 and y.max() == pytest.approx(2.0, rel=1e-4)


def test_bulges_are_arcs(read):
    """Half circle from (0, 0) to (2, 0) below the chord, then a line."""
    line = ["LWPOLYLINE", (90, 3), (70, 0), (38, 5), (10, 0), (20, 0), (42, 1), (10, 2), (20, 0)]
    (curve,) = read(dxf([*line, (10, 4), (20, 0)])).curves
    arc = curve.points[curve.points[:, 0] <= 2]
    np.testing.assert_allclose(np.hypot(arc[:, 0] - 1, arc[:, 1]), 1.0, rtol=1e-14)
    assert arc[:, 1].min() == pytest.approx(-1.0, rel=1e-4)
    assert (curve.points[:, 2] == 5).all() and curve.points[-1].tolist() == [4, 0, 5]


def test_old_polylines_in_space_are_closed(read):
    corners = [(0, 0, 0), (1, 0, 1), (1, 1, 2)]
    vertices = [["VERTEX", *xyz(10, corner), (70, 32)] for corner in corners]
    (curve,) = read(dxf(["POLYLINE", (66, 1), (70, 9)], *vertices, ["SEQEND"])).curves
    assert curve.points.tolist() == [[0, 0, 0], [1, 0, 1], [1, 1, 2], [0, 0, 0]]


def test_splines_are_kept_exactly(read):
    points = np.array([(0, 0, 0), (1, 2, 0), (3, 3, 1), (4, 0, 0), (5, 1, 2)], float)
    knots = [0, 0, 0, 0, 0.5, 1, 1, 1, 1]
    entity = ["SPLINE", (70, 8), (71, 3), *[(40, k) for k in knots], *xyz(10, *points)]
    (curve,) = read(dxf(entity)).curves
    assert np.array_equal(curve.spline.points, points) and curve.spline.knots.tolist() == knots
    # The middle of this one by hand: (P1 + 2 P2 + P3) / 4, blossoming at the knot.
    place = 0.25 * points[1] + 0.5 * points[2] + 0.25 * points[3]
    np.testing.assert_allclose(curve.spline.evaluate([0.5])[0], place, rtol=1e-15)
    assert curve.points[0].tolist() == [0, 0, 0] and curve.points[-1].tolist() == [5, 1, 2]


def test_knuckles_of_splines():
    knots = np.array([0, 0, 0, 1, 1, 2, 2, 2], float)
    points = np.array([(0, 0, 0), (1, 0, 0), (2, 0, 0), (2, 1, 0), (2, 2, 0)], float)
    places, knuckles = Spline(2, knots, points, np.ones(5)).sampled(1e-5)
    assert places[knuckles].tolist() == [[2, 0, 0]]
    points[3:, 1], points[3:, 0] = 0, (3, 4)
    assert not Spline(2, knots, points, np.ones(5)).sampled(1e-5)[1].any()


def test_blocks_are_inserted(read):
    block = ["BLOCK", (2, "frame"), *xyz(10, (1, 0, 0))]
    blocks = [block, ["LINE", (8, "0"), *xyz(10, (1, 0, 0)), *xyz(11, (2, 0, 0))], ["ENDBLK"]]
    insert = ["INSERT", (8, "hull"), (2, "frame"), *xyz(10, (5, 5, 5)), (41, 2), (50, 90)]
    (curve,) = read(dxf(insert, blocks=blocks)).curves
    np.testing.assert_allclose(curve.points, [(5, 5, 5), (5, 7, 5)], atol=1e-15)
    assert curve.group == "hull"


def test_faces_and_points(read):
    face = [
        "3DFACE",
        *xyz(10, (0, 0, 0)),
        *xyz(11, (1, 0, 0)),
        *xyz(12, (1, 1, 0)),
        *xyz(13, (0, 1, 0)),
    ]
    found = read(dxf(face, ["POINT", *xyz(10, (7, 8, 9))]))
    assert len(found.meshes[0].triangles) == 2 and found.points.tolist() == [[7, 8, 9]]


def test_faces_of_three_corners(read):
    face = ["3DFACE", *(p for k in range(3) for p in xyz(10 + k, (1 + k % 2, 2 + k // 2, 3)))]
    (mesh,) = read(dxf(face)).meshes
    assert mesh.points.tolist() == [[1, 2, 3], [1, 3, 3], [2, 2, 3]]
    assert len(mesh.triangles) == 1


def test_what_is_left_out_is_told(read):
    found = read(dxf(LINE, ["TEXT", (1, "a")], ["REGION"], ["LINE", (67, 1), *LINE[2:]]))
    assert len(found.curves) == 1
    assert found.left_out == (
        "1 of REGION is left out.",
        "1 of in paper space is left out.",
        "Texts, dimensions and hatches (1) are left out.",
    )


def test_texts_of_blocks_count(read, monkeypatch):
    monkeypatch.setattr("hull_io.geometry.dxf.MAX_GEOMETRY_POINTS", 5000)
    with pytest.raises(hull_io.HullFileError, match="there is more than is read"):
        read(texts_of_blocks(100))


def endless():
    blocks = [["BLOCK", (2, "a")], ["INSERT", (2, "a")], ["INSERT", (2, "a")], ["ENDBLK"]]
    return dxf(["INSERT", (2, "a")], blocks=blocks)


def texts_of_blocks(count):
    """A block of texts, inserted a thousandfold by a block that is itself inserted so."""
    blocks = [["BLOCK", (2, "a")], *[["TEXT", (1, "frame")]] * count, ["ENDBLK"]]
    for outer, inner in ("ba", "cb"):
        blocks += [["BLOCK", (2, outer)], ["INSERT", (2, inner), (70, 1000)], ["ENDBLK"]]
    return dxf(LINE, ["INSERT", (2, "c"), (70, 1000)], blocks=blocks)


@pytest.mark.parametrize(
    "text, message",
    [
        (b"AutoCAD Binary DXF\r\n\x1a\0" + bytes(100), "binary DXF"),
        ("", "nothing is drawn"),
        ("0\nSECTION\n2\nENTITIES\n0\nLINE\n", "cut short"),
        ("zero\nSECTION\n", "line 1: a group code"),
        (dxf(["LINE", (10, "left")]), "LINE: 'left' .group 10. is no number"),
        (dxf(["LINE", *xyz(10, (0, 0, 0)), *xyz(11, (1e9, 0, 0))]), "further than"),
        (dxf(["CIRCLE", (40, -1)]), "its radius is -1"),
        (dxf(["SPLINE", (71, 3), (40, 0), *xyz(10, (0, 0, 0))]), "1 knots for 1 points"),
        (dxf(["SPLINE", (71, 3)]), "no points"),
        (dxf(["TEXT", (1, "a")]), "no line, polyline"),
        (endless(), "without end"),
        (texts_of_blocks(1), "blocks are inserted more than 100000 times"),
        (dxf(["INSERT", (2, "a"), (70, 5000)], blocks=[["BLOCK", (2, "a")]]), "repeats"),
    ],
)
def test_what_is_wrong_is_told(read, text, message):
    with pytest.raises(hull_io.HullFileError, match=message) as refused:
        read(text)
    assert str(refused.value).startswith("lines.dxf: ") and str(refused.value).endswith(".")


OBJ = "o hull\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1 2/2 3/3 4/4\no keel\nv 9 9 9\nl 1 2 -1\n"


def test_objects(read):
    found = read(OBJ, "obj")
    (mesh,), (curve,) = found.meshes, found.curves
    assert mesh.name == "hull" and mesh.triangles.tolist() == [[0, 1, 2], [0, 2, 3]]
    assert curve.group == "keel" and curve.points[-1].tolist() == [9, 9, 9]


@pytest.mark.parametrize(
    "text, message",
    [
        ("v 1 2\n", "line 1: three numbers"),
        ("v 1 2 1e9\n", "line 1: three numbers"),
        ("v 1 2 3\nf 1 2 3\n", "line 2: '2' is no point"),
        ("v 1 2 3\nf 1 1\n", "fewer than three"),
        ("v 1 2 3\nf a b c\n", "no number of a point"),
        ("# nothing\n", "no face"),
    ],
)
def test_what_is_wrong_with_objects(read, text, message):
    with pytest.raises(hull_io.HullFileError, match=message):
        read(text, "obj")
