# SPDX-License-Identifier: GPL-3.0-or-later
"""Many drawings in a file or a file each, pieces of both sides on plates of the mill, marks by
planes, cells of plates."""

import os
import resource
import signal

import hull_native as hn
import numpy as np
import pytest
from dxf_audit import assert_audited
from plate_hulls import cylinder, one


def square(side, title="square"):
    drawing = hn.ShopDrawing(title)
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]) * side + [100.0, -300.0]
    drawing.add_line("OUTLINE", corners)
    return drawing


def dxf_points(path):
    rows = [row.strip() for row in path.read_text().splitlines()]
    pairs = list(zip(rows[::2], rows[1::2]))
    return np.array(
        [
            (float(x), float(pairs[i + 1][1]))
            for i, (code, x) in enumerate(pairs[:-1])
            if code == "10" and pairs[i + 1][0] == "20"
        ]
    )


def test_all_in_one_file(tmp_path):
    drawings = [square(500.0), square(2000.0), square(1000.0)]
    (path,) = hn.write_shop_drawings(drawings, tmp_path / "all.pdf")
    assert path == tmp_path / "all.pdf" and path.stat().st_size > 1000
    hn.write_shop_drawings(drawings, tmp_path / "all.dxf")
    assert_audited(tmp_path / "all.dxf")
    points = dxf_points(tmp_path / "all.dxf")
    points = points[(np.abs(points) > 0.0).any(axis=1)]
    # Two above one another, the third in a column of its own, with half a metre between them.
    assert points.max(axis=0) == pytest.approx([2500.0 + 1000.0, 1000.0 + 2000.0])
    assert points.min() >= -1e-9


def test_lines_of_files_are_dashed_as_on_paper(tmp_path):
    drawing = square(500.0)
    for layer in ("HIDDEN", "ROLLING"):
        drawing.add_line(layer, [[0.0, 0.0], [500.0, 0.0]])
    hn.write_shop_drawings([drawing], tmp_path / "all.dxf")
    rows = [row.strip() for row in (tmp_path / "all.dxf").read_text().splitlines()]
    pairs = list(zip(rows[::2], rows[1::2]))
    types = {}
    for k in [k for k, pair in enumerate(pairs) if pair == ("0", "LAYER")]:
        layer = {}
        for code, value in pairs[k + 1 :]:
            if code == "0":
                break
            layer[code] = value
        types[layer["2"]] = layer["6"]
    assert [types[name] for name in ("OUTLINE", "HIDDEN", "ROLLING")] == [
        "CONTINUOUS",
        "DASHED",
        "CENTER",
    ]


def test_a_file_each_at_true_size(tmp_path):
    names, drawings = ["P1", "P2 P/S", "−3"], [square(500.0), square(700.0), square(300.0)]
    for ending in ("pdf", "svg", "dxf"):
        paths = hn.write_shop_drawings(drawings, tmp_path / f"shell.{ending}", names=names)
        assert [p.name for p in paths] == [
            f"shell-{word}.{ending}" for word in ("P1", "P2-P-S", "-3")
        ]
    for side, word in ((500.0, "P1"), (700.0, "P2-P-S")):
        assert_audited(tmp_path / f"shell-{word}.dxf")
        points = dxf_points(tmp_path / f"shell-{word}.dxf")
        assert points[:, 0].max() - 100.0 == pytest.approx(side)
    assert len(os.listdir(tmp_path)) == 9


def test_all_files_or_none(tmp_path):
    (tmp_path / "shell-a.pdf").write_text("as it was")
    drawings = [square(500.0), hn.ShopDrawing("empty")]
    with pytest.raises(ValueError, match="has no lines"):
        hn.write_shop_drawings(drawings, tmp_path / "shell.pdf", names=["a", "b"])

    def stop(share):
        if share > 0.4:
            raise RuntimeError("stopped")

    drawings[1] = square(600.0)
    with pytest.raises(RuntimeError, match="stopped"):
        hn.write_shop_drawings(drawings, tmp_path / "shell.pdf", names=["a", "b"], progress=stop)
    assert os.listdir(tmp_path) == ["shell-a.pdf"]
    assert (tmp_path / "shell-a.pdf").read_text() == "as it was"


def test_a_full_disk_leaves_all_as_it_was(tmp_path):
    """No more than 2,000 bytes can be written."""
    (tmp_path / "shell-a.dxf").write_text("as it was")
    limit = resource.getrlimit(resource.RLIMIT_FSIZE)
    before = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2000, limit[1]))
    try:
        with pytest.raises(OSError, match=str(tmp_path / "shell-a.dxf")):
            hn.write_shop_drawings([square(500.0)] * 2, tmp_path / "shell.dxf", names=["a", "b"])
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limit)
        signal.signal(signal.SIGXFSZ, before)
    assert os.listdir(tmp_path) == ["shell-a.dxf"]
    assert (tmp_path / "shell-a.dxf").read_text() == "as it was"


def test_what_can_t_be_written_is_one_sentence(tmp_path):
    drawings = [square(500.0), square(600.0)]
    with pytest.raises(ValueError, match=r"must end in \.pdf or \.dxf; \.svg takes a drawing"):
        hn.write_shop_drawings(drawings, tmp_path / "shell.svg")
    with pytest.raises(ValueError, match=r"must end in \.pdf, \.svg or \.dxf\."):
        hn.write_shop_drawings(drawings, tmp_path / "shell.png", names=["a", "b"])
    with pytest.raises(ValueError, match="2 drawings need as many different names"):
        hn.write_shop_drawings(drawings, tmp_path / "shell.pdf", names=["a/", "a "])
    with pytest.raises(ValueError, match="no drawing"):
        hn.write_shop_drawings([], tmp_path / "shell.pdf")
    with pytest.raises(OSError, match="Nothing can be written"):
        hn.write_shop_drawings(drawings, tmp_path / "no" / "shell.pdf", names=["a", "b"])
    assert not os.listdir(tmp_path)


@pytest.mark.parametrize("ending", [".pdf", ".dxf"])
def test_one_file_tells_progress_and_a_drawing_without_lines_is_refused(ending, tmp_path):
    drawings, told = [square(500.0), square(300.0)], []
    path = tmp_path / f"shell{ending}"
    hn.write_shop_drawings(drawings, path, progress=told.append)
    assert told == [0.0]

    def stop(share):
        raise KeyboardInterrupt

    before = path.read_bytes()
    with pytest.raises(KeyboardInterrupt):
        hn.write_shop_drawings(drawings[:1], path, progress=stop)
    empty = hn.ShopDrawing("Plate P7")
    for names in (None, ["a", "b", "c"]):
        with pytest.raises(ValueError, match='"Plate P7" has no lines: leave it out'):
            hn.write_shop_drawings([*drawings, empty], path, names=names)
    assert path.read_bytes() == before and os.listdir(tmp_path) == [path.name]


def test_pieces_of_both_sides_are_nested():
    surface = cylinder()
    seams = [one(hn.HullCurves(surface, 1e-4).in_plane(hn.plane_across("x", 2.0), "butt"))]
    listed = hn.plate_list(hn.plates(surface, seams), thickness=0.01, mirrored=True)
    pieces = [piece for each in listed for piece in each.pieces]
    assert [piece.name for piece in pieces] == ["P1 P", "P1 S", "P2 P", "P2 S"]
    (single,) = hn.plate_list([listed[0].plate], thickness=0.01)[0].pieces
    assert single.name == "P1"
    port, starboard = (np.concatenate(piece.outline) for piece in pieces[2:])
    assert signed_area(port) == pytest.approx(pieces[2].flat.area, rel=1e-6)
    # Turned over, in the same rectangle.
    assert signed_area(starboard) == pytest.approx(-pieces[2].flat.area, rel=1e-6)
    np.testing.assert_allclose(starboard.min(axis=0), port.min(axis=0), atol=1e-12)
    np.testing.assert_allclose(starboard.max(axis=0), port.max(axis=0), atol=1e-12)
    used = hn.nesting(pieces, [(12.5, 7.0)])
    # Of pairs both pieces are laid, and what a plate is called makes it no pair.
    laid, of_pairs = ([place for s in made for place in s.laid] for made in (
        used, hn.nesting(listed, [(12.5, 7.0)])
    ))  # fmt: skip
    assert of_pairs == laid
    (called,) = hn.plate_list([listed[0].plate], thickness=0.01, names=["Bow P/S"])
    assert not called.is_pair and [piece.name for piece in called.pieces] == ["Bow P/S"]
    assert sum(len(stock.laid) for stock in used) == 4
    drawn = hn.nesting_drawing(used[0], "S1").lines
    places = np.concatenate([line for layer, line in drawn if layer == "OUTLINE"])
    assert places.min() > 0.0 and (places.max(axis=0) < [12500.0, 7000.0]).all()


def signed_area(line):
    x, y = line.T
    return 0.5 * float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum())


def test_cells_of_plates_are_the_hull_s():
    surface = cylinder()
    curves = hn.HullCurves(surface, 1e-4)
    seams = [one(curves.in_plane([1.0, 0.3, 0.0, 2.6], "slanted"))]
    plates = hn.plates(surface, seams, size=0.05)
    whole = hn.surface_areas(surface).areas
    found = np.zeros(surface.cell_count)
    for plate in plates:
        cells, areas = plate.cells
        assert (np.diff(cells) > 0).all() and (areas > 0.0).all()
        # Flat triangles are smaller by the square of their size.
        assert areas.sum() == pytest.approx(plate.area, rel=1e-3)
        found[cells] += areas
    np.testing.assert_allclose(found, whole, rtol=2e-3)
    assert len(plates[0].cells[0]) < surface.cell_count


def test_marks_by_planes():
    surface = cylinder()
    curves = hn.HullCurves(surface, 1e-4)
    marks = hn.plane_marks(curves, "x", [1.0, 50.0, 2.5], ["a", "off the hull", "c"])
    assert [mark.name for mark in marks] == ["a", "c"]
    np.testing.assert_allclose(marks[1].points[:, 0], 2.5, atol=1e-9)
    table = hn.frame_table([(0, 10, 0.5)])
    frames = hn.frame_marks(curves, table, 0.9, 2.1)
    assert [frame.name for frame in frames] == ["Fr 2", "Fr 3", "Fr 4"]
