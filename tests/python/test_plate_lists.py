# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves on the hull by plane, girth and projection; frames, lists, templates, drawings."""

import math
import os

import hull_native as hn
import numpy as np
import pytest
from dxf_audit import assert_audited
from hull_io.plating_data import FrameRange, Plating
from plate_hulls import cylinder, one
from production_hulls import hemisphere
from transformation_hulls import Sample


def curves_of(surface, tolerance=1e-4):
    return hn.HullCurves(surface, tolerance)


def listed_plates(surface, seams=(), thickness=0.01):
    return hn.plate_list(hn.plates(surface, list(seams)), thickness=thickness)


def test_steps_of_curves_lie_on_the_surface():
    surface = cylinder()
    (curve,) = curves_of(surface).in_plane([1.0, 0.3, 0.1, 2.5], "slanted")
    begin = surface.evaluate(curve.cells, curve.starts)[0]
    end = surface.evaluate(curve.cells, curve.ends)[0]
    np.testing.assert_allclose(begin, curve.points[:-1], atol=1e-12)
    np.testing.assert_allclose(end, curve.points[1:], atol=1e-12)
    normal = np.array([1.0, 0.3, 0.1]) / math.sqrt(1.1)
    np.testing.assert_allclose(curve.points @ normal, 2.5 / math.sqrt(1.1), atol=1e-9)


def test_girth_by_the_development():
    """Of a cylinder: girths across it are distances on the flat plate, to the chords' fourth
    order."""
    surface = cylinder()
    curves = curves_of(surface)
    base = one(curves.in_plane(hn.plane_across("y", 1.0), "base"))
    curve = one(curves.at_girth(base, 2.0, towards=(0, 1, 0), name="seam"))
    (plate,) = hn.plates(surface, [])
    flat = plate.flat()
    ((line, _),) = flat.marks(curve)
    ((start, _),) = flat.marks(base)
    way = (start[-1] - start[0]) / np.linalg.norm(start[-1] - start[0])
    off = line - start[0]
    distance = np.abs(off[:, 0] * way[1] - off[:, 1] * way[0])
    np.testing.assert_allclose(distance, 2.0, atol=1e-6)
    assert np.ptp(curve.points[:, 0]) == pytest.approx(6.0, abs=1e-9)


def test_a_girth_beyond_the_hull_is_refused():
    curves = curves_of(cylinder())
    base = one(curves.in_plane(hn.plane_across("y", 1.0), "base"))
    with pytest.raises(ValueError, match="off the hull"):
        curves.at_girth(base, 50.0, towards=(0, 1, 0))
    across = one(curves.in_plane(hn.plane_across("x", 2.0), "frame"))
    with pytest.raises(ValueError, match="runs in the planes"):
        curves.at_girth(across, 1.0, towards=(0, 1, 0))


def test_projected_lines():
    curves = curves_of(cylinder())
    line = np.array([[-1.0, 1.0, 20.0], [7.0, 3.0, 20.0]])
    curve = one(curves.projected(line, direction=(0, 0, -1), name="line"))
    # It begins and ends at the borders, x = 0 and 6.
    assert (curve.points[0, 0], curve.points[-1, 0]) == pytest.approx((0.0, 6.0), abs=1e-9)
    np.testing.assert_allclose(curve.points[:, 1], 1.25 + curve.points[:, 0] / 4, atol=1e-7)
    centre = np.array([3.0, 2.0, 20.0])
    other = one(curves.projected_from([[1.0, 1.0, 5.0], [5.0, 1.0, 5.0]], centre=centre))
    rays = other.points - centre
    # All in the plane of the centre and the line.
    normal = np.cross([4.0, 0.0, 0.0], [1.0, 1.0, 5.0] - centre)
    assert np.abs(rays @ normal).max() < 1e-4 * np.linalg.norm(normal)
    with pytest.raises(ValueError, match="misses the hull"):
        curves.projected(line, direction=(0, 0, 1), name="up")


def test_frames_by_ranges():
    table = hn.frame_table([(-2, 3, 0.5), (3, 6, 0.6)])
    assert table.position(-2) == -1.0 and table.position(3) == 1.5
    assert table.position(6) == pytest.approx(3.3)
    assert table.names[:2] == ("−2", "−1")
    back = hn.frame_table([(0, 4, 0.5)], numbered_from="FP", length=20.0, in_roman=True)
    assert back.position(4) == 18.0 and back.names == ("0", "I", "II", "III", "IV")
    assert hn.roman(1994) == "MCMXCIV"
    for ranges, words in (
        ([], "needs a range"),
        ([(0, 4, 0.0)], "is none"),
        ([(0, 10.7, 0.6)], "whole numbers, not 10.7"),
        ([(0, math.inf, 0.6)], "whole numbers, not inf"),
        ([(0, 4, 0.5), (5, 8, 0.5)], "let them meet"),
        ([(2, 4, 0.5)], "leave out frame 0"),
    ):
        with pytest.raises(ValueError, match=words):
            hn.frame_table(ranges)
    rows = hn.frame_rows(hn.frame_table([(0, 4, 1.0)]), cylinder())
    assert rows[2]["half_breadth_m"] == pytest.approx(5.0)
    assert "girth_m" in hn.rows_csv(rows).splitlines()[0]


def test_frames_inside_the_shell():
    """Points of the inner side are so far from the hull, and in the frame's plane."""
    surface = cylinder()
    outer, inner = hn.frame_lines(surface, 2.0, thickness=0.03)
    points = np.concatenate([np.insert(line, 0, 2.0, axis=1) for line in inner])
    found = hn.SurfaceTree(surface).closest_points(points)
    np.testing.assert_allclose(found.distances, 0.03, atol=1e-9)
    assert len(outer) == len(inner)
    with pytest.raises(ValueError, match="off the hull"):
        hn.frame_lines(surface, 70.0)
    with pytest.raises(ValueError, match="0 m or more"):
        hn.frame_lines(surface, 2.0, thickness=-1.0)
    with pytest.raises(ValueError, match="heights of waterlines .* finite"):
        hn.frame_drawing(surface, 2.0, name="4", mirrored=True, waterlines=[1.0, math.nan])


def test_lists_and_nesting():
    surface = cylinder()
    seams = [one(curves_of(surface).in_plane(hn.plane_across("x", 2.0), "butt"))]
    listed = listed_plates(surface, seams)
    rows = hn.plate_rows(listed)
    assert rows[0]["length_m"] * rows[0]["breadth_m"] == pytest.approx(rows[0]["area_m2"])
    assert rows[1]["mass_kg"] == pytest.approx(rows[1]["area_m2"] * 0.01 * 7850)
    used = hn.nesting(listed, [(12.5, 7.0)], margin=0.05)
    assert sum(len(stock.laid) for stock in used) == 2
    assert len(hn.nesting_rows(used)) == 2
    for stock in used:
        for plate, x, y in stock.laid:
            length, breadth = plate.extents
            assert x >= 0.05 and y >= 0.05
            assert x + length <= stock.length - 0.05 + 1e-12
            assert y + breadth <= stock.breadth - 0.05 + 1e-12
    with pytest.raises(ValueError, match="no stock plate is so large"):
        hn.nesting(listed, [(2.0, 1.0)])
    with pytest.raises(ValueError, match="thickness .* above 0"):
        listed_plates(surface, thickness=0.0)


def test_templates_lie_on_the_plate():
    surface = cylinder()
    curves = curves_of(surface)
    (listed,) = listed_plates(surface)
    marks = curves.in_plane(hn.plane_across("x", 1.5), "Fr 3")
    (template,) = hn.plate_templates(listed, curves, marks, height=0.2)
    assert template.line[:, 1].min() == pytest.approx(0.2, abs=1e-9)
    lengths = [
        np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
        for points in (template.line, template.on_hull)
    ]
    assert lengths[0] == pytest.approx(lengths[1], rel=1e-9)
    with pytest.raises(ValueError, match="above 0 m"):
        hn.plate_templates(listed, curves, marks, height=0.0)


def test_drawings_are_written_whole_or_not_at_all(tmp_path):
    surface = cylinder()
    curves = curves_of(surface)
    (listed,) = listed_plates(surface)
    marks = [("FRAMES", m) for m in curves.in_plane(hn.plane_across("x", 1.5), "Fr 3")]
    drawing = hn.plate_drawing(listed, marks=marks)
    for ending in ("pdf", "svg", "dxf"):
        path = tmp_path / f"plate.{ending}"
        drawing.write(path, paper="A0")
        assert path.stat().st_size > 1000
    assert_audited(tmp_path / "plate.dxf")
    # At true size, in mm.
    numbers = (tmp_path / "plate.dxf").read_text().splitlines()
    x = [float(numbers[i + 1]) for i in range(len(numbers) - 1) if numbers[i].strip() == "10"]
    assert max(x) == pytest.approx(1000.0 * listed.extents[0], abs=1.0)
    # The plate is about 6 m by 6 m, the sheets of an A0 some 1.16 m by 0.8 m.
    pages = (tmp_path / "plate.pdf").read_bytes().count(b"/Type /Page\n")
    assert pages == 0 or pages > 40
    for name, words in (("plate.png", "must end in"), ("plate.txt", "must end in")):
        with pytest.raises(ValueError, match=words):
            drawing.write(tmp_path / name)
        assert not (tmp_path / name).exists()
    with pytest.raises(ValueError, match="more than 400 sheets"):
        drawing.write(tmp_path / "small.pdf", paper="A4")
    with pytest.raises(ValueError, match="has no lines"):
        hn.ShopDrawing("none").write(tmp_path / "none.pdf")
    hn.write_plates([listed], tmp_path / "all.pdf", marks=marks)
    hn.write_plates([listed], tmp_path / "all.dxf")
    assert_audited(tmp_path / "all.dxf")
    with pytest.raises(ValueError, match="developed"):
        hn.stretch_drawing(listed)
    assert sorted(os.listdir(tmp_path)) == [
        "all.dxf", "all.pdf", "plate.dxf", "plate.pdf", "plate.svg"
    ]  # fmt: skip


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="there is no full device")
def test_a_folder_that_takes_no_file_is_told(tmp_path):
    (listed,) = listed_plates(cylinder())
    with pytest.raises(OSError):
        hn.plate_drawing(listed).write(tmp_path / "missing" / "plate.pdf", paper="A0")
    assert not os.listdir(tmp_path)


def test_frames_without_room_for_the_shell():
    """Of half a ball of radius 5 m, 1 m off its middle: inside 3 m is a ball of 2 m, inside 4.5 m
    one that does not reach the frame."""
    surface = hemisphere(5.0)
    _, inner = hn.frame_lines(surface, 1.0, thickness=3.0)
    radii = np.linalg.norm(np.concatenate(inner), axis=1)
    assert radii == pytest.approx(math.sqrt(3.0), abs=0.02)
    for thickness in (4.5, 50.0):
        with pytest.raises(ValueError, match=f"x = 1 m has no room for a shell {thickness:g} m"):
            hn.frame_lines(surface, 1.0, thickness=thickness)
    ship = Sample("coaster").surface
    for thickness in (0.01, 0.5, 2.0):
        assert hn.frame_lines(ship, 42.0, thickness=thickness)[1]
    for call in (hn.frame_lines, lambda *a, **k: hn.frame_drawing(*a, name="", mirrored=True, **k)):
        with pytest.raises(ValueError, match="no room for a shell 50 m thick"):
            call(ship, 42.0, thickness=50.0)
        with pytest.raises(ValueError, match="A frame's x must be a finite number of metres"):
            call(ship, np.nan, thickness=0.01)


def test_places_of_frames():
    """Between two in proportion; by the hull file's ranges alike."""
    ranges = [(-5, 10, 0.55), (10, 130, 0.65)]
    plating = Plating(ranges=[FrameRange(10, 0.55), FrameRange(130, 0.65)], first_frame=-5)
    for begin in ("AP", "FP"):
        table = hn.frame_table(ranges, numbered_from=begin, length=84.0)
        plating.numbered_from = begin
        wanted = np.array([-2.75, 5.5, 5.5 + 0.65 * 2.5])
        found = table.places([-5, 10, 12.5])
        assert found == pytest.approx(wanted if begin == "AP" else 84.0 - wanted, abs=1e-12)
        assert plating.frame_places([-5, 10, 12.5], 84.0) == pytest.approx(found, abs=1e-12)
        assert table.places(table.numbers) == pytest.approx(table.positions, abs=1e-12)
    with pytest.raises(ValueError, match="Frame 131 is beyond the table, which has −5 to 130"):
        table.places([131])
    with pytest.raises(ValueError, match="Frame 131 is beyond the ranges, which have -5 to 130"):
        plating.frame_places([131], 84.0)
    for first, lasts, said in (
        (10, (80,), "frames 10 to 80 leave out frame 0"),
        (-5, (-1,), "frames -5 to -1 leave out frame 0"),
        (-5, (20, 10), r"ranges\[1\].last: frame 10 is not beyond frame 20"),
        (0, (0,), r"ranges\[0\].last: frame 0 is not beyond frame 0"),
    ):
        plating = Plating(ranges=[FrameRange(last, 0.5) for last in lasts], first_frame=first)
        with pytest.raises(ValueError, match=said):
            plating.frame_places([15], 84.0)
        with pytest.raises(ValueError):
            hn.frame_table([(a, b, 0.5) for a, b in zip((first, *lasts), lasts)])


def test_a_template_along_the_hull_s_border():
    """Of the cylinder's end, which is a border: its profile."""
    surface = cylinder()
    curves = curves_of(surface)
    (listed,) = listed_plates(surface)
    marks = hn.plane_marks(curves, "x", [0.0, 6.0], ["aft", "fore"])
    made = hn.plate_templates(listed, curves, marks, height=0.2)
    inside = hn.plate_templates(
        listed, curves, curves.in_plane(hn.plane_across("x", 3.0), "Fr"), height=0.2
    )
    assert [each.name for each in made] == ["aft", "fore"]
    for each in made:
        assert length(each.line) == pytest.approx(length(inside[0].line), rel=1e-4)
        assert each.line[:, 1].max() == pytest.approx(inside[0].line[:, 1].max(), abs=1e-4)


def length(line):
    return np.linalg.norm(np.diff(line, axis=0), axis=1).sum()


def test_places_without_an_inner_side_in_the_frame_are_left_out():
    """Beside the stem one was drawn 0.02 m within the shell: its place lay half a metre abaft."""
    ship = Sample("container_ship").surface
    x = np.asarray(ship.mesh.points)[:, 0]
    at, thickness = x.min() + 0.997 * np.ptp(x), 0.5
    _, inner = hn.frame_lines(ship, at, thickness=thickness)
    places = np.concatenate([np.insert(line, 0, at, axis=1) for line in inner])
    distances = hn.SurfaceTree(ship).closest_points(places).distances
    assert 0.9 * thickness < distances.min() and distances.max() < 1.01 * thickness
