# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell's plates written in Blender."""

import csv
import resource
import signal

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, make_active, part, sample

pytestmark = pytest.mark.once


@pytest.mark.parametrize(
    "ending, name, length, strake",
    [("pdf", "planing_boat", 5.0, 1.0), ("dxf", "planing_boat", 10.0, 2.0)],
)
def test_drawings_of_plates(tmp_path, ending, name, length, strake):
    sample(name)
    path = tmp_path / f"plates.{ending}"
    arguments = {"plate_length": length, "strake": strake, "frame_spacing": 2.4}
    assert bpy.ops.hull.export_plates(filepath=str(path), **arguments) == {"FINISHED"}
    assert path.stat().st_size > 10000


def with_thruster(z):
    """(a hull, the tunnel through it)."""
    hull = sample("planing_boat")
    values = {"x": 8.0, "z": z, "radius": 0.12}
    assert bpy.ops.hull.add_appendage(kind="TUNNEL", **values) == {"FINISHED"}
    tunnel = bpy.context.view_layer.objects.active
    tunnel.name = "Thruster"
    make_active(hull)
    return hull, tunnel


def test_a_tunnel_s_opening_is_drawn(tmp_path):
    """By its name, on the plates that it goes through."""
    with_thruster(0.7)
    path = tmp_path / "plates.dxf"
    arguments = {"plate_length": 10.0, "strake": 2.0, "frame_spacing": 0.0}
    assert bpy.ops.hull.export_plates(filepath=str(path), **arguments) == {"FINISHED"}
    assert path.read_text().count("Thruster") >= 1


def test_a_plate_is_let_in_around_a_tunnel(tmp_path):
    hull, tunnel = with_thruster(1.3)
    for kind, value in (("station", 8.0), ("openings", 0.1)):
        bpy.ops.hull.change_plate_list(action="ADD_RULE")
        hull.hull.plates.rules[-1].kind, hull.hull.plates.rules[-1].value = kind, value
    assert bpy.ops.hull.lay_out_plates() == {"FINISHED"}
    report, is_current = part("features.production.plate_files").last_plates(hull)
    assert is_current
    (let_in,) = (row for row in report.rows if abs(row["x_from_m"] - 7.78) < 0.01)
    assert let_in["x_to_m"] == pytest.approx(8.22, abs=0.01)
    path = tmp_path / "boat.hull.json"
    assert bpy.ops.hull.export_hull(filepath=str(path)) == {"FINISHED"}
    assert '"openings"' in path.read_text()
    tunnel.location.x -= 1.0
    bpy.context.view_layer.update()
    assert bpy.ops.hull.lay_out_plates() == {"FINISHED"}
    rows = part("features.production.plate_files").last_plates(hull)[0].rows
    assert any(abs(row["x_from_m"] - 6.78) < 0.01 for row in rows)


def test_the_list_has_the_hull_s_area(tmp_path):
    hull = sample("planing_boat")
    path = tmp_path / "plates.csv"
    sizes = {"plate_length": 5.0, "strake": 1.0}
    assert bpy.ops.hull.export_plates(filepath=str(path), **sizes) == {"FINISHED"}
    rows = list(csv.DictReader(path.open()))
    surface = part("features.hull.hull_state").state_of(hull).ship.surface
    hull_native = part("bridge.native").require()
    whole = hull_native.surface_areas(surface).areas.sum()
    # Seven digits of each.
    both = sum(float(row["area_m2"]) * int(row["pieces"]) for row in rows)
    assert both == pytest.approx(2.0 * whole, rel=1e-6)
    assert {row["pieces"] for row in rows} == {"1", "2"}


def test_what_ends_within_a_plate_is_left_out_and_told(tmp_path):
    hull = sample("naval_vessel")
    assert bpy.ops.hull.suggest_seams() == {"FINISHED"}
    rules = hull.hull.plates.rules
    rules[0].value, rules[1].value = 5.13, 25.0
    assert bpy.ops.hull.lay_out_plates() == {"FINISHED"}
    report, _ = part("features.production.plate_files").last_plates(hull)
    ((name, length, _),) = report.left_out
    assert f"; left out for ending within a plate: {length:.2f} m of {name}" in report.text
    assert name.startswith("Seam") and 0.0 < length < 10.0
    # Nor is it shown over the hull, or marked on frames.
    shown = part("features.production.seam_lines").shown(hull).polylines
    native, rules = part("bridge.native").require(), part("features.production.plate_rules")
    layout = (
        part("features.hull.hull_state")
        .state_of(hull)
        .of(part("features.production.plate_files").KeptPlates)
        .layout
    )
    _, whole = native.seams_by_rules(
        layout.surface, rules.seam_rules(hull, bpy.context.scene), knuckles=True
    )
    lengths = [
        sum(np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in lines)
        for lines in (shown, [curve.points for curve in whole])
    ]
    assert lengths[1] - lengths[0] == pytest.approx(length, abs=0.01)


def test_too_many_plates_are_one_sentence(tmp_path, monkeypatch):
    sample("coaster")
    monkeypatch.setattr(part("bridge.limits"), "MOST_PLATES", 3)
    with pytest.raises(RuntimeError, match="ask for larger ones"):
        bpy.ops.hull.export_plates(filepath=str(tmp_path / "plates.csv"))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["plates.svg", "plates"])
def test_an_ending_is_refused_before_the_work(tmp_path, monkeypatch, name):
    sample("coaster")
    hull_native = part("bridge.native").require()
    monkeypatch.setattr(hull_native, "seams_by_rules", lambda *a, **k: pytest.fail("begun"))
    with pytest.raises(RuntimeError, match=f'"{name}" does not say.*.pdf, .dxf or .csv'):
        bpy.ops.hull.export_plates(filepath=str(tmp_path / name))
    assert not list(tmp_path.iterdir())


def test_plates_by_the_panel_s_rules(tmp_path):
    hull = sample("planing_boat")
    assert bpy.ops.hull.suggest_seams() == {"FINISHED"}
    rules = hull.hull.plates.rules
    rules[0].value, rules[1].value = 1.0, 5.0
    bpy.ops.hull.change_plate_list(action="ADD_RULE")
    rules[2].kind, rules[2].value = "station", 3.0
    hull.hull.plates.thickness = 12.0
    assert bpy.ops.hull.lay_out_plates() == {"FINISHED"}
    report, is_current = part("features.production.plate_files").last_plates(hull)
    assert is_current
    surface = part("features.hull.hull_state").state_of(hull).ship.surface
    whole = 2.0 * part("bridge.native").require().surface_areas(surface).areas.sum()
    assert report.mass_t == pytest.approx(whole * 0.012 * 7.85, rel=1e-9)
    assert not any(row["x_from_m"] < 2.99 and row["x_to_m"] > 3.01 for row in report.rows)
    bpy.ops.hull.change_plate_list(action="REMOVE_RULE", index=2)
    assert len(rules) == 2
    # The hull changes: the list says that it is of the one before.
    hull.data.vertices[0].co.x += 0.01
    hull.data.update()
    bpy.context.view_layer.update()
    assert not part("features.production.plate_files").last_plates(hull)[1]


def test_frames_by_ranges_from_fp():
    hull = sample("coaster")
    settings = hull.hull.plates
    settings.first_frame, settings.numbered_from, settings.in_roman = -3, "FP", True
    for last, spacing in ((10, 0.5), (100, 0.6)):
        bpy.ops.hull.change_plate_list(action="ADD_RANGE")
        settings.ranges[-1].last, settings.ranges[-1].spacing = last, spacing
    rules = part("features.production.plate_rules")
    table = rules.frame_table(hull, bpy.context.scene)
    assert table.position(0) == pytest.approx(hull.hull.length_pp)
    assert table.position(11) == pytest.approx(hull.hull.length_pp - 10 * 0.5 - 0.6, abs=1e-5)
    assert table.names[3 + 9] == "IX"


@pytest.mark.parametrize(
    "kind, value, told",
    [("waterline", 500.0, "Nothing of the hull is met by the rule"),
     ("strakes", 500.0, "narrower than"),
     ("strakes", 0.0, "above 0 m"),
     ("projected", 0.0, "has no line")],
)  # fmt: skip
def test_rules_that_make_no_seam_are_one_sentence(kind, value, told):
    hull = sample("coaster")
    bpy.ops.hull.change_plate_list(action="ADD_RULE")
    hull.hull.plates.rules[0].kind, hull.hull.plates.rules[0].value = kind, value
    with pytest.raises(RuntimeError, match=told):
        bpy.ops.hull.lay_out_plates()
    assert part("features.production.plate_files").last_plates(hull)[0] is None


@pytest.mark.parametrize("ending", ["pdf", "dxf", "csv"])
def test_plates_over_knuckles_are_not_written(ending, tmp_path):
    """Without seams along the planing boat's knuckles: where, in one sentence, and no file."""
    hull = sample("planing_boat")
    hull.hull.plates.along_knuckles = False
    path = tmp_path / f"plates.{ending}"
    with pytest.raises(RuntimeError, match="A plate goes over a knuckle of .*put a seam along"):
        bpy.ops.hull.export_plates(filepath=str(path), plate_length=5.0, strake=1.0)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("ending", ["pdf", "dxf", "csv"])
def test_a_full_disk_leaves_nothing(ending, tmp_path):
    """No more than 1,000 bytes can be written: that is told, and the file is as it was."""
    add_hull()
    path = tmp_path / f"plates.{ending}"
    path.write_text("as it was")
    limit = resource.getrlimit(resource.RLIMIT_FSIZE)
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limit[1]))
    try:
        with pytest.raises(RuntimeError, match="plates"):
            bpy.ops.hull.export_plates(filepath=str(path), plate_length=5.0, strake=1.0)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limit)
    assert path.read_text() == "as it was"
    assert [each.name for each in tmp_path.iterdir()] == [path.name]


def test_rules_are_kept_in_the_hull_file(tmp_path):
    """Rules, the line of a projected one, thickness and frames come back; places follow the hull
    when it is scaled, girths do not."""
    hull = sample("coaster")
    assert bpy.ops.hull.suggest_seams() == {"FINISHED"}
    plates = hull.hull.plates
    line = bpy.data.objects.new("Line", bpy.data.meshes.new("Line"))
    line.data.from_pydata([(10.0, 9.0, 4.0), (70.0, 9.0, 5.0)], [(0, 1)], [])
    bpy.context.scene.collection.objects.link(line)
    for kind, value in (("projected", 0.0), ("station", 30.0)):
        rule = plates.rules.add()
        rule.kind, rule.value = kind, value
    plates.rules[2].line, plates.rules[1].on = line, False
    plates.thickness, plates.numbered_from, plates.in_roman = 12.5, "FP", True
    made = plates.ranges.add()
    made.last, made.spacing = 40, 0.65
    rules = part("features.production.plate_rules")
    before = rules.seam_rules(hull, bpy.context.scene)
    path = tmp_path / "coaster.hull.json"
    assert bpy.ops.hull.export_hull(filepath=str(path)) == {"FINISHED"}
    bpy.ops.wm.read_homefile(use_empty=True)
    assert bpy.ops.hull.import_hull(filepath=str(path)) == {"FINISHED"}
    hull = bpy.context.object
    plates = hull.hull.plates
    after = rules.seam_rules(hull, bpy.context.scene)
    assert [(one.kind, one.value) for one in after] == [(one.kind, one.value) for one in before]
    assert after[1].line == pytest.approx(before[1].line, abs=1e-5)
    assert [rule.on for rule in plates.rules] == [True, False, True, True]
    assert (plates.thickness, plates.numbered_from, plates.in_roman) == (12.5, "FP", True)
    assert [(one.last, one.spacing) for one in plates.ranges] == [(40, pytest.approx(0.65))]
    strake = plates.rules[0].value
    assert bpy.ops.hull.set_dimensions(length=2.0 * hull.hull.length_pp) == {"FINISHED"}
    assert plates.rules[0].value == strake
    assert plates.rules[3].value == pytest.approx(60.0)


def test_a_hull_without_rules_says_nothing_of_plates(tmp_path):
    sample("coaster")
    path = tmp_path / "coaster.hull.json"
    assert bpy.ops.hull.export_hull(filepath=str(path)) == {"FINISHED"}
    assert "plating" not in path.read_text()


def test_plates_are_told_of_as_they_were_once_something_else_is_asked_for():
    hull = sample("planing_boat")
    for kind, value in (("strakes", 2.0), ("butts", 10.0)):
        bpy.ops.hull.change_plate_list(action="ADD_RULE")
        hull.hull.plates.rules[-1].kind, hull.hull.plates.rules[-1].value = kind, value
    assert bpy.ops.hull.lay_out_plates() == {"FINISHED"}

    def is_current():
        return part("features.production.plate_files").last_plates(hull)[1]

    settings, layer = hull.hull.plates, hull.hull.layers[0]
    for group, name, other in (
        (settings.rules[1], "value", 5.0), (settings.rules[0], "on", False),
        (settings, "along_knuckles", not settings.along_knuckles), (layer, "thickness", 0.02),
    ):  # fmt: skip
        assert is_current()
        before = getattr(group, name)
        setattr(group, name, other)
        assert not is_current(), name
        setattr(group, name, before)
    assert is_current()


def line_of(points, edges):
    mesh = bpy.data.meshes.new("Line")
    mesh.from_pydata(points, edges, [])
    line = bpy.data.objects.new("Line", mesh)
    bpy.context.scene.collection.objects.link(line)
    return line


@pytest.mark.parametrize("is_curve", (False, True))
def test_plates_are_told_of_as_they_were_once_a_line_has_changed(is_curve):
    hull = sample("planing_boat")
    hull.data.update()
    low, high = (function(v.co.z for v in hull.data.vertices) for function in (min, max))
    points = [(-100.0, 9.0, 0.5 * (low + high)), (100.0, 9.0, 0.5 * (low + high))]
    if is_curve:
        line = part("bridge.objects.curve_lines").made("Line", points, False, hull)
        own = line.data.splines[0].points
    else:
        line = line_of(points, [(0, 1)])
        own = line.data.vertices
    bpy.ops.hull.change_plate_list(action="ADD_RULE")
    hull.hull.plates.rules[0].kind, hull.hull.plates.rules[0].line = "projected", line
    assert bpy.ops.hull.lay_out_plates() == {"FINISHED"}
    last = part("features.production.plate_files").last_plates
    assert last(hull)[1]
    before = own[0].co.copy()
    own[0].co.z += 0.05
    assert not last(hull)[1]
    own[0].co = before
    assert last(hull)[1]
    hull.location.x += 1.0
    bpy.context.view_layer.update()
    assert not last(hull)[1]
    line.location.x += 1.0
    bpy.context.view_layer.update()
    assert last(hull)[1]


@pytest.mark.parametrize("edges, order", [
    ([(0, 3), (3, 2), (2, 1)], [0, 3, 2, 1]),
    ([(2, 0), (0, 1), (1, 3)], [2, 0, 1, 3]),
    ([(0, 1), (1, 2), (2, 3)], [0, 1, 2, 3]),
    ([(0, 1), (1, 2), (2, 3), (3, 0)], [0, 1, 2, 3]),
    ([], [0, 1, 2, 3]),
])  # fmt: skip
def test_seams_are_projected_along_edges(edges, order):
    hull = add_hull()
    points = np.array([(1.0, 3.0, 1.0), (4.0, 3.0, 1.5), (3.0, 3.0, 1.2), (2.0, 3.0, 1.1)])
    found = part("features.hull.plating_data").points_of(line_of(points.tolist(), edges), hull)
    assert np.allclose(found, points[order])


@pytest.mark.parametrize("edges, told", [
    ([(0, 1), (2, 3)], "no single line"),
    ([(0, 1), (0, 2), (0, 3)], "no single line"),
    ([(0, 1), (1, 2), (2, 0)], "no single line"),
    (None, "no mesh or curve object"),
])  # fmt: skip
def test_what_is_no_line_to_be_projected_is_told(edges, told, tmp_path):
    hull = add_hull()
    bpy.ops.hull.change_plate_list(action="ADD_RULE")
    rule = hull.hull.plates.rules[0]
    rule.kind = "projected"
    if edges is None:
        rule.line = bpy.data.objects.new("Light", bpy.data.lights.new("Light", "SUN"))
    else:
        points = [(1.0, 3.0, 1.0), (4.0, 3.0, 1.5), (3.0, 3.0, 1.2), (2.0, 3.0, 1.1)]
        rule.line = line_of(points, edges)
    with pytest.raises(RuntimeError, match=told):
        bpy.ops.hull.lay_out_plates()
    with pytest.raises(RuntimeError, match=told):
        bpy.ops.hull.export_hull(filepath=str(tmp_path / "a.hull.json"))
    assert not list(tmp_path.iterdir())
