# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines plan and the table of offsets, as Object.hull.lines and plan ask for them."""

import csv
from itertools import combinations

import bpy
import pytest
from addon_under_test import DEPTH, HALF_BREADTH, LENGTH, add_hull, part


def plan_hull():
    """A box with stations every metre and two waterlines."""
    hull = add_hull()
    hull.hull.length_pp = LENGTH
    hull.hull.draft = 2.0
    hull.hull.lines.station_count = 10
    hull.hull.lines.waterline_spacing = 1.0
    hull.hull.lines.buttock_spacing = 0.5
    return hull


def export(path):
    assert bpy.ops.hull.export_lines(filepath=str(path)) == {"FINISHED"}
    return path


def test_every_kind_of_file(tmp_path):
    plan_hull()
    for ending, magic in ((".pdf", b"%PDF"), (".svg", b"<?xml"), (".png", b"\x89PNG")):
        assert export(tmp_path / f"box{ending}").read_bytes().startswith(magic)
    dxf = export(tmp_path / "box.dxf").read_text()
    assert "AC1015" in dxf and dxf.rstrip().endswith("EOF")


def test_options_reach_the_drawing(tmp_path):
    hull = plan_hull()
    plan = hull.hull.plan
    hull.hull.lines.diagonals = "2.5/30 1,5/45"
    hull.hull.lines.frame_spacing = 0.25
    plan.drawn, plan.number = "N. N.", "4711"
    plan.dxf_unit = "mm"
    words = export(tmp_path / "box.dxf").read_text().splitlines()
    for word in ("D1", "D2", "N. N.", "4711", "Fr.", "DIAGONALS", "FRAME_SPACING"):
        assert word in words
    assert "Date" not in words  # not given
    assert words[words.index("$INSUNITS") + 2].strip() == "4"
    assert "Table of offsets, moulded, mm" in words
    plan.offsets = False
    assert "Table of offsets, moulded, mm" not in export(tmp_path / "box.dxf").read_text()


VIEW_NAMES = {
    "profile": "Profile",
    "half_breadth": "Half-breadth plan, diagonals expanded",
    "body_plan": "Body plan",
}
LAYERS_OF_VIEWS = {"profile": "BUTTOCKS", "half_breadth": "WATERLINES", "body_plan": "STATIONS"}


@pytest.mark.parametrize("views", [v for n in (1, 2) for v in combinations(VIEW_NAMES, n)])
def test_the_panel_s_switches_choose_views(tmp_path, views):
    """Names and lines of those views alone."""
    hull = plan_hull()
    hull.hull.lines.diagonals = "2.5/30"
    for view in VIEW_NAMES:
        setattr(hull.hull.plan, view, view in views)
    words = export(tmp_path / "box.dxf").read_text().splitlines()
    # Each entity has its layer after a group code of 8.
    layers = {value for code, value in zip(words[::2], words[1::2]) if code.strip() == "8"}
    for view, name in VIEW_NAMES.items():
        assert (name in words) == (view in views)
        assert (LAYERS_OF_VIEWS[view] in layers) == (view in views)


def test_a_plan_of_no_view_is_refused(tmp_path):
    hull = plan_hull()
    for view in VIEW_NAMES:
        setattr(hull.hull.plan, view, False)
    with pytest.raises(RuntimeError, match="view at least"):
        export(tmp_path / "box.pdf")
    assert not list(tmp_path.iterdir())


def test_feet_where_the_scene_has_them(tmp_path):
    plan_hull()
    bpy.context.scene.unit_settings.system = "IMPERIAL"
    words = export(tmp_path / "box.dxf").read_text().splitlines()
    assert "Lengths in feet" in words and "Table of offsets, moulded, feet-inches-eighths" in words
    assert f"{LENGTH / 0.3048:.2f} ft" in words and "6.562 ft" not in words
    assert "DWL 6.562 ft" in words  # 2 m
    assert any(word.endswith(" LT") for word in words)
    assert any(word.endswith((" ft³", " ft\\U+00B3")) for word in words)
    metric = [word for word in words if word.endswith((" m", " mm", " t")) or "metre" in word]
    assert not metric


def test_stations_in_frames(tmp_path):
    lines = plan_hull().hull.lines
    lines.frame_spacing = 0.5
    lines.stations, lines.stations_in = "3 7.5 16", "FRAMES"
    wanted = part("features.lines.line_places").line_places(bpy.context.object.hull, 1.0)
    assert wanted.stations == pytest.approx((1.5, 3.75, 8.0))
    words = export(tmp_path / "box.dxf").read_text().splitlines()
    assert {"3", "7.5", "16"} <= set(words)


@pytest.mark.parametrize(
    "name, value, said",
    [
        ("scale", 1.0, "does not fit"),
        ("diagonals", "3", "slash"),
        ("diagonals", "3/100", "angle"),
        ("stations", "1 two", "blanks between"),
        ("buttocks", "-1", "buttock"),
    ],
)
def test_what_is_wrong_is_one_message(tmp_path, name, value, said):
    settings = plan_hull().hull
    setattr(settings.plan if name == "scale" else settings.lines, name, value)
    with pytest.raises(RuntimeError, match=said) as caught:
        bpy.ops.hull.export_lines(filepath=str(tmp_path / "box.pdf"))
    assert "Traceback" not in str(caught.value)
    assert not list(tmp_path.iterdir())


def test_table_of_offsets(tmp_path):
    plan_hull()
    path = tmp_path / "offsets.csv"
    assert bpy.ops.hull.export_table(filepath=str(path), analysis="offset_table") == {"FINISHED"}
    with open(path, newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [float(row["x from AP [m]"]) for row in rows] == pytest.approx(range(11))
    for row in rows:
        for height in (1, 2):
            half_breadth = float(row[f"half-breadth at WL {height} m [mm]"])
            assert half_breadth == pytest.approx(1000.0 * HALF_BREADTH, abs=0.1)
        for offset in ("0", "0.5", "1", "1.5"):
            assert float(row[f"height at buttock {offset} m [mm]"]) == pytest.approx(0.0, abs=0.1)
        assert float(row["Deck edge: height [mm]"]) == pytest.approx(1000.0 * DEPTH, abs=0.1)


def test_plan_is_kept_in_the_file(tmp_path):
    hull = plan_hull()
    hull.hull.lines.diagonals, hull.hull.plan.paper = "2/30", "A1"
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "plan.blend"))
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "plan.blend"))
    settings = bpy.data.objects["box"].hull
    assert (settings.lines.diagonals, settings.plan.paper) == ("2/30", "A1")


def test_stations_in_frames_of_ranges(tmp_path):
    """By the ranges of Plates, which go before an even spacing; lines follow them."""
    hull = plan_hull()
    lines, plates = hull.hull.lines, hull.hull.plates
    lines.stations, lines.stations_in = "-1 2 6.5", "FRAMES"
    plates.first_frame = -2
    for last, spacing in ((4, 0.5), (14, 0.8)):
        bpy.ops.hull.change_plate_list(action="ADD_RANGE")
        plates.ranges[-1].last, plates.ranges[-1].spacing = last, spacing

    def shown():
        bpy.context.view_layer.update()
        groups = part("features.hull.hull_state").state_of(hull).lines.groups
        return [section.cut.plane[3] for section in groups["station"].sections]

    assert shown() == pytest.approx([-0.5, 1.0, 2.0 + 2.5 * 0.8])
    words = export(tmp_path / "box.dxf").read_text().splitlines()
    assert {"2", "6.5"} <= set(words)
    plates.ranges[1].spacing = 1.0
    assert shown()[-1] == pytest.approx(4.5)
    plates.numbered_from = "FP"
    assert shown() == pytest.approx([10.5, 9.0, 5.5])
    lines.stations = "15"
    bpy.context.view_layer.update()
    assert "Frame 15 is beyond" in part("features.hull.hull_state").state_of(hull).lines.status
    plates.ranges.clear()
    bpy.ops.hull.update()
    assert "ranges of frames under Plates" in (
        part("features.hull.hull_state").state_of(hull).lines.status
    )
