# SPDX-License-Identifier: GPL-3.0-or-later
"""What drawings of templates, frames, nestings and stretch show, by closed forms, and that files
have it at true size."""

import math
import re
import zlib

import hull_native as hn
import numpy as np
import pytest
from dxf_audit import assert_audited
from plate_hulls import cylinder, grid_surface, one, sphere, through

RADIUS, LENGTH = 2.0, 6.0


def lengths(line):
    return np.linalg.norm(np.diff(line, axis=0), axis=1)


def on_layer(drawing, layer):
    """Lines in m."""
    return [line / 1000.0 for name, line in drawing.lines if name == layer]


def round_bilge(parts=48, rows=4):
    """A circular cylinder of RADIUS about the line y = 0, z = RADIUS, from 15° beyond the keel to
    15° above the level of the axis: as round as cubic B-splines through its points are, but for
    the ends, where these have no curvature."""
    a = np.radians(np.linspace(-15.0, 105.0, parts + 1))
    x = np.linspace(0.0, LENGTH, rows + 1)
    y, z = np.sin(a), 1.0 - np.cos(a)
    points = np.stack(np.broadcast_arrays(x[:, None], RADIUS * y, RADIUS * z), axis=-1)
    return grid_surface(through(points.swapaxes(0, 1)).swapaxes(0, 1)[:, ::-1])


def off_circle(line, radius):
    """Largest distance from the circle about (0, RADIUS), of points between keel and axis."""
    side = np.sign(line[line[:, 1].argmax(), 0])
    inside = line[(side * line[:, 0] > 0.03) & (line[:, 1] < RADIUS)]
    return np.abs(np.linalg.norm(inside - [0.0, RADIUS], axis=1) - radius).max()


def frame_of(surface, x, tolerance=1e-6, name="Fr 4"):
    curves = hn.HullCurves(surface, tolerance)
    return curves, curves.in_plane(hn.plane_across("x", x), name)


def listed_of(surface, seams=()):
    return hn.plate_list(hn.plates(surface, list(seams)), thickness=0.01)


def assert_dxf_audited(drawing, folder):
    drawing.write(folder / "audited.dxf")
    assert_audited(folder / "audited.dxf")


def test_a_template_is_as_long_as_the_section(tmp_path):
    """To 1e-9, and as the circle's arc R 2π/3; the bow of the arc above its chord is R (1 - cos
    60°), but for the ends."""
    surface = round_bilge()
    curves, marks = frame_of(surface, 1.7, 1e-8)
    (listed,) = listed_of(surface)
    templates = hn.plate_templates(listed, curves, marks, height=0.3)
    drawing = hn.template_drawing(listed, templates)
    assert_dxf_audited(drawing, tmp_path)
    (outline,) = on_layer(drawing, "OUTLINE")
    # Base line, two upright ends, and the plate between them.
    edge = outline[1:-2]
    girth = lengths(one(marks).points).sum()
    assert lengths(edge).sum() == pytest.approx(girth, rel=1e-9)
    assert girth == pytest.approx(RADIUS * math.pi / 1.5, rel=1e-4)
    assert np.ptp(edge[:, 1]) == pytest.approx(RADIUS * (1.0 - math.cos(math.pi / 3)), abs=1e-6)
    assert np.ptp(edge[:, 0]) == pytest.approx(RADIUS * math.sqrt(3.0), abs=1e-6)
    assert edge[:, 1].min() == pytest.approx(0.3, abs=1e-9)
    assert outline[0] == pytest.approx([edge[0, 0], 0.0]) and (outline[0] == outline[-1]).all()
    assert outline[-2] == pytest.approx([edge[-1, 0], 0.0])
    # The sight line goes from the base to the top.
    (sight,) = on_layer(drawing, "BASE")
    assert sight[:, 0] == pytest.approx([0.0, 0.0]) and sight[1, 1] == edge[:, 1].max()


def test_templates_stand_above_one_another():
    surface = round_bilge()
    (listed,) = listed_of(surface)
    curves = hn.HullCurves(surface, 1e-5)
    marks = [one(curves.in_plane(hn.plane_across("x", x), f"Fr {x:g}")) for x in (1.0, 2.0, 4.0)]
    templates = hn.plate_templates(listed, curves, marks)
    outlines = on_layer(hn.template_drawing(listed, templates), "OUTLINE")
    assert len(outlines) == 3
    for lower, upper in zip(outlines[:-1], outlines[1:]):
        assert upper[:, 1].min() == pytest.approx(lower[:, 1].max() + 0.1)


@pytest.mark.parametrize("thickness", [0.0, 0.02])
def test_a_frame_s_drawing(thickness, tmp_path):
    """Circles of R and R - t about (0, R), on both sides."""
    surface = round_bilge()
    drawing = hn.frame_drawing(
        surface, 2.3, name="4", mirrored=True, thickness=thickness, waterlines=(1.0,),
        marks=hn.HullCurves(surface, 1e-5).in_plane(hn.plane_across("z", 0.5), "Seam"),
        tolerance=1e-6,
    )  # fmt: skip
    assert_dxf_audited(drawing, tmp_path)
    outlines = on_layer(drawing, "OUTLINE")
    assert len(outlines) == 2
    for line in outlines:
        assert off_circle(line, RADIUS - thickness) < 1e-6
        girth = (RADIUS - thickness) * math.pi / 1.5
        assert lengths(line).sum() == pytest.approx(girth, rel=2e-4)
    assert (outlines[0] * [-1.0, 1.0] == outlines[1]).all()
    if thickness:
        assert off_circle(on_layer(drawing, "BASE")[0], RADIUS) < 1e-6
    (level,) = on_layer(drawing, "WATERLINES")
    assert level[:, 1] == pytest.approx([1.0, 1.0])
    # Crosses at the seam, y² + (z - R)² = R² at z = 0.5.
    crosses = np.array([line.mean(axis=0) for line in on_layer(drawing, "SEAMS")])
    y = math.sqrt(RADIUS**2 - (0.5 - RADIUS) ** 2)
    assert np.abs(crosses[:, 0]) == pytest.approx(np.full(4, y), abs=1e-4)
    assert crosses[:, 1] == pytest.approx(np.full(4, 0.5), abs=1e-4)


def test_nested_plates_lie_apart_on_their_sheet(tmp_path):
    surface = cylinder()
    curves = hn.HullCurves(surface, 1e-4)
    butts = [one(curves.in_plane(hn.plane_across("x", x), f"B{x:g}")) for x in (1.0, 2.5, 4.5)]
    butts += [one(curves.in_plane(hn.plane_across("y", y), f"S{y:g}")) for y in (1.5, 3.5)]
    listed = listed_of(surface, butts)
    margin, drawn = 0.03, []
    used = hn.nesting(listed, [(6.0, 3.0)], margin=margin)
    for k, stock in enumerate(used):
        drawing = hn.nesting_drawing(stock, f"S{k + 1}")
        assert_dxf_audited(drawing, tmp_path)
        (sheet,) = on_layer(drawing, "BASE")
        assert np.ptp(sheet, axis=0) == pytest.approx([stock.length, stock.breadth])
        lines, boxes = iter(on_layer(drawing, "OUTLINE")), []
        for one_plate, _, _ in stock.laid:
            outline = np.concatenate([next(lines) for _ in one_plate.flat.sides])
            boxes.append((outline.min(axis=0), outline.max(axis=0)))
            drawn.append(one_plate.name)
        for low, high in boxes:
            assert (low >= margin - 1e-9).all()
            assert (high <= np.array([stock.length, stock.breadth]) - margin + 1e-9).all()
        for i, (low, high) in enumerate(boxes):
            for other_low, other_high in boxes[:i]:
                gaps = np.maximum(low - other_high, other_low - high)
                assert gaps.max() >= 2.0 * margin - 1e-9
    assert sorted(drawn) == sorted(p.name for p in listed)
    # What is used of the sheets is the hull's own area, as these plates are developed.
    area = sum(stock.used * stock.length * stock.breadth for stock in used)
    assert area == pytest.approx(sum(p.plate.area for p in listed), rel=1e-9)


def texts_of(path):
    """{text: (place (2,), height)} of a DXF file, mm."""
    rows, found = [row.strip() for row in path.read_text().splitlines()], {}
    for k in range(rows.index("ENTITIES"), len(rows) - 1):
        if rows[k] == "0" and rows[k + 1] in ("TEXT", "MTEXT"):
            codes = dict(zip(rows[k + 2 : k + 40 : 2], rows[k + 3 : k + 41 : 2]))
            place = np.array([float(codes["10"]), float(codes["20"])])
            found[codes["1"]] = place, float(codes["40"])
    return found


def test_all_plates_in_one_file(tmp_path):
    """In columns, none on another, with words that can be read with a plate on the screen."""
    surface = cylinder()
    curves = hn.HullCurves(surface, 1e-4)
    listed = listed_of(
        surface, [one(curves.in_plane(hn.plane_across("x", x), f"B{x:g}")) for x in (1, 2, 3, 4, 5)]
    )
    hn.write_plates(listed, tmp_path / "all.dxf")
    assert_audited(tmp_path / "all.dxf")
    found = texts_of(tmp_path / "all.dxf")
    places = np.array([found[p.name][0] for p in listed])
    columns = np.unique(np.round(places[:, 0] / 1000.0))
    assert len(columns) >= 2
    for k, (plate, place) in enumerate(zip(listed, places)):
        apart = np.abs(places - place) / 1000.0 - np.array(plate.extents)
        assert (np.delete(apart, k, axis=0).max(axis=1) > 0.3).all()
        height = found[plate.name][1] / 1000.0
        assert plate.extents[1] / 60.0 < height < plate.extents[1] / 8.0
    with pytest.raises(ValueError, match="words must be above 0"):
        hn.plate_drawing(listed[0], words=math.nan)


def test_lines_of_equal_stretch_of_a_cap_are_circles(tmp_path):
    """About its middle, where the flat disc is as the sphere is symmetric."""
    surface = sphere(parts=16)
    seam = hn.HullCurves(surface, 1e-5).in_plane(
        hn.plane_across("z", 10.0 * math.cos(0.35)), "edge"
    )
    cap = min(hn.plates(surface, seam, size=0.3), key=lambda p: p.area)
    (listed,) = hn.plate_list([cap], thickness=0.01)
    drawing = hn.stretch_drawing(listed)
    assert_dxf_audited(drawing, tmp_path)
    rim = np.concatenate(on_layer(drawing, "OUTLINE"))
    middle = 0.5 * (rim.min(axis=0) + rim.max(axis=0))
    radius = np.linalg.norm(rim - middle, axis=1).mean()
    closed, seen = 0, set()
    for line in on_layer(drawing, "STRETCH"):
        off = np.linalg.norm(line - middle, axis=1)
        if off.mean() > 0.8 * radius or len(line) < 12:
            continue  # where triangles of the rim are cut
        assert np.ptp(off) < 0.12 * radius
        closed += 1
        seen.add(round(float(off.mean() / radius), 1))
    assert closed >= 3 and len(seen) >= 3


TRIANGLE = np.array([[0.0, 0.0], [100.0, 20.0], [30.0, 80.0], [0.0, 0.0]])


def triangle_drawing():
    drawing = hn.ShopDrawing("Triangle")
    drawing.add_line("OUTLINE", TRIANGLE)
    return drawing


def points_in(text, scale):
    """Of the path with three corners, in mm; y up."""
    for path in re.findall(r"((?:[-\d.]+ [-\d.]+ [ml] ?\n?){3,4}h?)", text):
        values = np.array(re.findall(r"[-\d.]+", path), dtype=float).reshape(-1, 2)
        return values[:3] * scale * [1.0, -1.0]
    raise AssertionError("no triangle")


def test_svg_is_at_true_size(tmp_path):
    """Points of 1/72 inch, of the file's own width and its view's."""
    triangle_drawing().write(tmp_path / "t.svg")
    text = (tmp_path / "t.svg").read_text()
    width, height = re.search(r'width="([\d.]+)pt" height="([\d.]+)pt"', text).groups()
    assert re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', text).groups() == (width, height)
    assert float(width) * 25.4 / 72.0 == pytest.approx(120.0, abs=1e-3)
    path, scale = re.search(r' d="(M[^"]*)" transform="matrix\(([\d.]+),0,0,', text).groups()
    corners = np.array(re.findall(r"[-\d.]+", path), dtype=float).reshape(-1, 2)[:3]
    corners *= float(scale) * 25.4 / 72.0
    sides = lengths(np.vstack([corners, corners[:1]]))
    assert sides == pytest.approx(lengths(TRIANGLE), abs=2e-3)
    # y up on paper.
    assert corners[2, 1] < corners[1, 1] < corners[0, 1]


@pytest.mark.parametrize("scale", [1.0, 0.5])
def test_pdf_is_at_true_size(tmp_path, scale):
    triangle_drawing().write(tmp_path / "t.pdf", paper="A3", scale=scale)
    data = (tmp_path / "t.pdf").read_bytes()
    assert b"/MediaBox [ 0 0 1190.55" in data  # 420 mm
    seen = []
    for stream in re.findall(rb"stream\r?\n(.*?)endstream", data, re.S):
        try:
            text = zlib.decompress(stream).decode("latin1")
        except zlib.error:
            continue
        if "100 mm on paper" not in text and not re.search(r" l\s+h", text):
            continue
        corners = points_in(text, 25.4 / 72.0)
        seen.append(lengths(np.vstack([corners, corners[:1]])))
    assert len(seen) == 2  # all of it, and the one sheet
    assert seen[1] == pytest.approx(scale * lengths(TRIANGLE), abs=2e-3)
    assert seen[0] / seen[0][0] == pytest.approx(seen[1] / seen[1][0], rel=1e-4)


def test_sheets_abut(tmp_path):
    """A line across several sheets: what each has of it, cut at the corner marks, is all of it."""
    drawing = hn.ShopDrawing("Long")
    drawing.add_line("OUTLINE", [(0.0, 0.0), (1000.0, 120.0)])
    drawing.write(tmp_path / "long.pdf", paper="A4")
    data = (tmp_path / "long.pdf").read_bytes()
    whole, sheets = math.hypot(1000.0, 120.0), []
    for stream in re.findall(rb"stream\r?\n(.*?)endstream", data, re.S):
        try:
            text = zlib.decompress(stream).decode("latin1")
        except zlib.error:
            continue
        found = re.findall(r"([-\d.]+) ([-\d.]+) m ([-\d.]+) ([-\d.]+) l S", text)
        slanted = [
            r for r in np.array(found, dtype=float) if abs(r[1] - r[3]) > 1.0 < abs(r[0] - r[2])
        ]
        sheets += [math.hypot(r[2] - r[0], r[3] - r[1]) * 25.4 / 72.0 for r in slanted]
    slope = whole / 1000.0
    # The first is all of it, smaller; of the others each goes on 5 mm beyond both ends of a tile.
    tiles = sheets[1:]
    assert len(tiles) == math.ceil(1006.0 / (297.0 - 30.0))
    assert sum(tiles) == pytest.approx(whole + 10.0 * slope * (len(tiles) - 1), abs=0.02)


def test_dxf_is_at_true_size(tmp_path):
    triangle_drawing().write(tmp_path / "t.dxf", scale=0.5)
    assert_audited(tmp_path / "t.dxf")
    rows = [row.strip() for row in (tmp_path / "t.dxf").read_text().splitlines()]
    begin = rows.index("ENTITIES")
    x = [float(rows[k + 1]) for k in range(begin, len(rows) - 1) if rows[k] == "10"]
    y = [float(rows[k + 1]) for k in range(begin, len(rows) - 1) if rows[k] == "20"]
    corners = np.stack([x, y], axis=1)
    for corner in TRIANGLE:
        assert np.abs(corners - corner).sum(axis=1).min() < 1e-9
    unit = rows.index("$INSUNITS")
    assert rows[unit + 2] == "4"  # mm
