# SPDX-License-Identifier: GPL-3.0-or-later
"""What the yard gets of plates in Blender: sheets at true size, nesting, templates, maps of
stretch, frames and their table; what is marked on plates; thickness by layers."""

import csv

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, part, sample

pytestmark = pytest.mark.once


def plated(name=None, strake=1.5, butts=4.0):
    """The hull of a box, or a sample, with rules of seams, and frames."""
    hull = sample(name) if name else add_hull()
    hull.hull.length_pp = hull.hull.length_pp or 10.0
    for kind, value in (("strakes", strake), ("butts", butts)):
        rule = hull.hull.plates.rules.add()
        rule.kind, rule.value = kind, value
    made = hull.hull.plates.ranges.add()
    made.last, made.spacing = 40, 0.5
    hull.hull.plates.first_frame = -2
    return hull


def report_of(hull):
    return part("features.production.plate_files").last_plates(hull)[0]


def layout_of(hull):
    state = part("features.hull.hull_state").state_of(hull)
    return state.of(part("features.production.plate_files").KeptPlates).layout


def listed(path):
    return list(csv.DictReader(path.open()))


def test_plates_at_true_size_a_file_each(tmp_path):
    hull = plated()
    options = {"in_sheets": True, "plates": "P2 p1"}
    for ending in ("pdf", "svg", "dxf"):
        path = str(tmp_path / f"boat.{ending}")
        assert bpy.ops.hull.export_plates(filepath=path, paper="A0", **options) == {"FINISHED"}
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(
        f"boat-P{k}.{ending}" for ending in ("pdf", "svg", "dxf") for k in (1, 2)
    )
    (one,) = (row for row in report_of(hull).rows if row["plate"].split()[0] == "P1")
    x = outline_places(tmp_path / "boat-P1.dxf")
    assert max(x) - min(x) == pytest.approx(1000.0 * one["length_m"], abs=1.0)


def outline_places(path):
    """All x of a DXF's outlines: texts stand beside them."""
    lines, layer, found = path.read_text().splitlines(), "", []
    for code, value in zip(lines[::2], lines[1::2]):
        layer = value if code.strip() == "8" else layer
        if code.strip() == "10" and layer == "OUTLINE":
            found.append(float(value))
    return found


def test_what_was_laid_out_is_written_without_doing_it_again(tmp_path, monkeypatch):
    hull = plated("planing_boat", 2.0, 10.0)
    assert bpy.ops.hull.lay_out_plates() == {"FINISHED"}
    native, made = part("bridge.native").require(), []
    whole = native.plates
    monkeypatch.setattr(native, "plates", lambda *a, **k: made.append(1) or whole(*a, **k))
    first = layout_of(hull)
    for name in ("plates", "stretch", "nesting"):
        path = str(tmp_path / f"{name}.pdf")
        stock = {"stock_length": 20.0, "stock_breadth": 5.0} if name == "nesting" else {}
        assert getattr(bpy.ops.hull, f"export_{name}")(filepath=path, **stock) == {"FINISHED"}
    assert not made and layout_of(hull) is first
    # Another thickness is none of the layout's.
    hull.hull.plates.thickness = 20.0
    assert bpy.ops.hull.lay_out_plates() == {"FINISHED"} and not made
    assert {round(row["thickness_mm"], 6) for row in report_of(hull).rows} == {20.0}
    hull.hull.plates.rules[0].value = 1.9
    assert bpy.ops.hull.lay_out_plates() == {"FINISHED"} and made


def test_both_sides_are_nested(tmp_path):
    hull = plated()
    path = tmp_path / "boat.csv"
    stock = {"stock_length": 20.0, "stock_breadth": 5.0}
    assert bpy.ops.hull.export_nesting(filepath=str(path), **stock) == {"FINISHED"}
    rows, plates = listed(path), report_of(hull).rows
    assert len(rows) == sum(row["pieces"] for row in plates)
    assert len({row["plate"] for row in rows}) == len(rows)
    area = sum(row["flat_area_m2"] * row["pieces"] for row in plates)
    used = {row["stock"]: float(row["used"]) for row in rows}
    assert 100.0 * sum(used.values()) == pytest.approx(area, rel=1e-6)
    with pytest.raises(RuntimeError, match="no stock plate is so large"):
        bpy.ops.hull.export_nesting(filepath=str(tmp_path / "small.csv"), stock_length=0.5)
    assert [one.name for one in tmp_path.iterdir()] == ["boat.csv"]


def test_templates_at_frames(tmp_path):
    hull = plated()
    path = str(tmp_path / "boat.pdf")
    options = {"in_sheets": True, "plates": "P2", "paper": "A0"}
    assert bpy.ops.hull.export_templates(filepath=path, **options) == {"FINISHED"}
    assert [one.name for one in tmp_path.iterdir()] == ["boat-P2.pdf"]
    assert bpy.ops.hull.export_templates(filepath=path) == {"FINISHED"}
    hull.hull.plates.ranges.clear()
    hull.hull.plates.rules.clear()
    with pytest.raises(RuntimeError, match="add a range under Frames"):
        bpy.ops.hull.export_templates(filepath=str(tmp_path / "no.pdf"), frame_spacing=0.0)
    assert not (tmp_path / "no.pdf").exists()


@pytest.mark.parametrize(
    "name, ending, options, told",
    [("plates", "svg", {}, r"ends in \.pdf, \.dxf or \.csv"),
     ("plates", "png", {"in_sheets": True}, r"ends in \.pdf, \.svg, \.dxf or \.csv"),
     ("plates", "csv", {"plates": "P1 P99"}, "no plate P99: they are P1 to P"),
     ("templates", "csv", {}, r"must end in \.pdf or \.dxf"),
     ("stretch", "svg", {}, r"must end in \.pdf or \.dxf"),
     ("nesting", "svg", {}, r"ends in \.pdf, \.dxf or \.csv"),
     ("frames", "csv", {}, r"must end in \.pdf or \.dxf"),
     ("frames", "pdf", {"frames": "10 999"}, "no frame 999"),
     ("frame_table", "pdf", {}, r"ends in \.csv")],
)  # fmt: skip
def test_what_can_t_be_written_is_told_and_leaves_nothing(tmp_path, name, ending, options, told):
    plated()
    with pytest.raises(RuntimeError, match=told):
        getattr(bpy.ops.hull, f"export_{name}")(filepath=str(tmp_path / f"x.{ending}"), **options)
    assert not list(tmp_path.iterdir())


def test_frames_are_drawn_and_listed(tmp_path):
    hull = plated()
    path = str(tmp_path / "boat.dxf")
    options = {"in_sheets": True, "frames": "4:10:2"}
    assert bpy.ops.hull.export_frames(filepath=path, **options) == {"FINISHED"}
    assert {one.name for one in tmp_path.iterdir()} == {f"boat-{n}.dxf" for n in (4, 6, 8, 10)}
    path = tmp_path / "frames.csv"
    assert bpy.ops.hull.export_frame_table(filepath=str(path)) == {"FINISHED"}
    rows = {int(row["frame"]): row for row in listed(path)}
    assert len(rows) == 43 and float(rows[8]["x_m"]) == pytest.approx(4.0)
    # The section's breadth is that of the drawing, whose outline is inside of it.
    numbers = (tmp_path / "boat-8.dxf").read_text()
    assert "OUTLINE" in numbers and "SEAMS" in numbers
    surface = part("features.hull.hull_state").state_of(hull).ship.surface
    (cut,) = part("bridge.native").require().sections(surface, [[1.0, 0.0, 0.0, 4.0]])
    widest = max(np.abs(curve.points[:, 1]).max() for curve in cut)
    assert float(rows[8]["half_breadth_m"]) == pytest.approx(widest, rel=1e-5)
    hull.hull.plates.ranges.clear()
    for name in ("frames.pdf", "frame_table.csv"):
        name, _, ending = name.partition(".")
        with pytest.raises(RuntimeError, match="add a range under Frames"):
            getattr(bpy.ops.hull, f"export_{name}")(filepath=str(tmp_path / f"no.{ending}"))


def test_waterlines_and_buttocks_are_marked_where_that_is_asked_for(tmp_path):
    hull = plated()
    lines, plates = hull.hull.lines, hull.hull.plates
    lines.waterlines, lines.buttocks = "0.4 0.8", "0.5"

    def layers():
        path = tmp_path / "boat.dxf"
        assert bpy.ops.hull.export_plates(filepath=str(path)) == {"FINISHED"}
        rows = [row.strip() for row in path.read_text().splitlines()]
        entities = rows[rows.index("ENTITIES") + 1 :]
        found = zip(entities[::2], entities[1::2])
        return {value for code, value in found if code == "8"} | {
            value for value in rows if value in ("WL 0.4", "WL 0.8", "BL 0.5")
        }

    wanted = {"WATERLINES", "BUTTOCKS", "WL 0.4", "WL 0.8", "BL 0.5"}
    assert not layers() & wanted
    plates.mark_waterlines = plates.mark_buttocks = True
    assert layers() >= {"WATERLINES", "BUTTOCKS", "WL 0.4", "BL 0.5", "FRAMES"}


def test_plates_have_their_layer_s_thickness():
    """Of two layers, fore and aft."""
    hull = plated("planing_boat", 2.0, 10.0)
    surface_of = part("features.hull.hull_state").up_to_date
    middle = 0.5 * hull.hull.length_pp
    material = bpy.data.materials.new("Thick")
    hull.data.materials.append(material)
    for polygon in hull.data.polygons:
        if np.mean([hull.data.vertices[v].co.x for v in polygon.vertices]) > middle:
            polygon.material_index = len(hull.data.materials) - 1
    hull.data.update()
    bpy.context.view_layer.update()
    layer = hull.hull.layers.add()
    layer.material, layer.thickness = material, 0.025
    hull.hull.plates.thickness = 12.0
    assert bpy.ops.hull.lay_out_plates() == {"FINISHED"}
    rows = report_of(hull).rows
    assert {round(row["thickness_mm"], 6) for row in rows} == {12.0, 25.0}
    for row in rows:
        if row["x_from_m"] > middle + 1.0:
            assert row["thickness_mm"] == pytest.approx(25.0)
        if row["x_to_m"] < middle - 1.0:
            assert row["thickness_mm"] == pytest.approx(12.0)
    across = sum(row["x_from_m"] < middle - 1.0 and row["x_to_m"] > middle + 1.0 for row in rows)
    assert report_of(hull).mixed >= across and "different thickness" in report_of(hull).text
    mass = sum(row["area_m2"] * row["thickness_mm"] / 1000.0 * 7.85 * row["pieces"] for row in rows)
    assert report_of(hull).mass_t == pytest.approx(mass, rel=1e-9)
    layer.thickness = 0.0
    assert bpy.ops.hull.lay_out_plates() == {"FINISHED"}
    assert {round(row["thickness_mm"], 6) for row in report_of(hull).rows} == {12.0}
    assert surface_of(hull, bpy.context.scene).status == ""
