# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines that are shown: where the settings say, exactly on the surface, and kept in files."""

from math import radians

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import DEPTH, HALF_BREADTH, LENGTH, add_hull, lined_hull, part, state_of

SWITCHES = (
    "show_stations",
    "show_waterlines",
    "show_buttocks",
    "show_diagonals",
    "show_planes",
    "show_design_waterline",
    "show_flats",
    "show_features",
)


def lines_of(hull):
    return state_of(hull).lines.groups


def test_each_kind_lies_in_its_planes():
    found = lines_of(lined_hull())
    assert {kind: group.cut_count for kind, group in found.items()} == {
        "station": 5, "waterline": 2, "buttock": 2, "diagonal": 1, "plane": 1, "draft": 1,
        "flat": 0, "feature": 0,
    }  # fmt: skip
    assert sorted({float(line[0, 0]) for line in found["station"].polylines}) == pytest.approx(
        [0.0, 2.5, 5.0, 7.5, 10.0], abs=1e-6
    )
    for kind, axis, wanted in (("waterline", 2, (1.0, 2.0)), ("buttock", 1, (0.75, 1.5))):
        heights = [line[:, axis] for line in found[kind].polylines]
        for height in heights:
            assert np.ptp(height) < 1e-9
        assert sorted({round(float(h[0]), 9) for h in heights}) == pytest.approx(wanted)
    for line in found["diagonal"].polylines:
        assert line[:, 1] + line[:, 2] == pytest.approx(2.5)
    port, starboard = found["plane"].polylines
    assert port[:, 0] + port[:, 1] == pytest.approx(5.0)
    # The other side of the ship is cut by the same plane.
    assert starboard[:, 0] + starboard[:, 1] == pytest.approx(5.0)
    assert port[:, 1].min() >= -1e-9 and starboard[:, 1].max() <= 1e-9
    assert not found["plane"].is_mirrored and found["station"].is_mirrored


def test_lines_are_those_of_the_native_module():
    hull = lined_hull()
    surface = state_of(hull).ship.surface
    native, lines = part("bridge.native").require(), part("features.lines.lines")
    size = lines.steady_size(surface)
    assert lines.size_of(surface) == LENGTH and 0.8 * LENGTH < size <= LENGTH
    for x, section in zip((0.0, 2.5, 5.0), lines_of(hull)["station"].sections):
        wanted = native.section(surface, "x", x, 1e-5 * size, flat_tolerance=2e-7 * size)
        assert len(wanted) == len(section.curves)
        for ours, theirs in zip(section.curves, wanted):
            assert np.array_equal(ours.points, theirs.points)


def test_a_whole_hull_has_both_sides():
    hull = lined_hull()
    bm = bmesh.new()
    bm.from_mesh(hull.data)
    bmesh.ops.mirror(bm, geom=bm.verts[:] + bm.edges[:] + bm.faces[:], axis="Y", merge_dist=1e-6)
    bmesh.ops.recalc_face_normals(bm, faces=bm.faces)
    bm.to_mesh(hull.data)
    bm.free()
    hull.hull.half = False
    hull.data.update_tag()
    bpy.context.view_layer.update()
    assert not state_of(hull).status
    found = lines_of(hull)
    assert not any(group.is_mirrored for group in found.values())
    assert found["buttock"].cut_count == 2 and len(found["buttock"].sections) == 4
    for kind in ("buttock", "diagonal", "plane", "station"):
        y = np.concatenate(found[kind].polylines)[:, 1]
        assert y.min() == pytest.approx(-y.max())
    for line in found["diagonal"].polylines:
        assert np.abs(line[:, 1]) + line[:, 2] == pytest.approx(2.5)


@pytest.mark.parametrize("switch", SWITCHES)
def test_what_is_off_is_not_computed(switch, monkeypatch):
    hull, lines = lined_hull(), part("features.lines.lines")
    cuts_asked, curves = [], lines._curves
    monkeypatch.setattr(
        lines,
        "_curves",
        lambda surface, cuts, moved: cuts_asked.append(cuts) or curves(surface, cuts, moved),
    )
    other = lines._other_curves

    def other_curves(kind, surface):
        if kind in ("flat", "feature"):
            cuts_asked.append("features")
        return other(kind, surface)

    monkeypatch.setattr(lines, "_other_curves", other_curves)

    def asked_by_a_move():
        cuts_asked.clear()
        hull.data.vertices[0].co.x -= 0.1
        hull.data.update_tag()
        bpy.context.view_layer.update()
        return [one for cuts in cuts_asked for one in ([cuts] if cuts == "features" else cuts)]

    for name in SWITCHES:
        setattr(hull.hull.lines, name, False)
    bpy.context.view_layer.update()
    assert not asked_by_a_move() and not lines_of(hull)
    setattr(hull.hull.lines, switch, True)
    (group,) = state_after_update(hull).lines.groups.values()
    assert lines.SWITCHES[group.kind] == switch
    wanted = [section.cut for section in group.sections] or ["features"]
    if switch != "show_stations":  # which go on beyond the end that moves
        assert asked_by_a_move() == wanted


def state_after_update(hull):
    bpy.context.view_layer.update()
    return state_of(hull)


def test_nothing_is_computed_again_when_nothing_changed():
    hull = lined_hull()
    before = dict(lines_of(hull))
    hull.data.update_tag()
    bpy.context.view_layer.update()
    assert lines_of(hull) == before
    hull.hull.lines.waterlines = "0.5"
    bpy.context.view_layer.update()
    after = lines_of(hull)
    assert [kind for kind in after if after[kind] is not before[kind]] == ["waterline"]


def test_lines_follow_the_points_in_edit_mode():
    hull = lined_hull()
    bpy.ops.object.mode_set(mode="EDIT")
    bm = bmesh.from_edit_mesh(hull.data)
    for vertex in bm.verts:
        vertex.co.y *= 1.5
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()
    found = lines_of(hull)
    assert max(line[:, 1].max() for line in found["station"].polylines) == pytest.approx(3.0)
    assert found["buttock"].cut_count == 3


def test_undo_brings_the_lines_back():
    hull = lined_hull()
    bpy.ops.ed.undo_push(message="before")
    hull.hull.lines.station_count = 2
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="after")
    assert lines_of(hull)["station"].cut_count == 3
    bpy.ops.ed.undo()
    assert lines_of(bpy.data.objects["box"])["station"].cut_count == 5


def test_lists_and_ranges():
    hull = lined_hull()
    settings = hull.hull.lines
    settings.stations, settings.waterlines = "1 2,5 4:8:2", "0.5:2.5:0.5"
    bpy.context.view_layer.update()
    found = lines_of(hull)
    stations = [section.cut.plane[3] for section in found["station"].sections]
    assert stations == pytest.approx([1.0, 2.5, 4.0, 6.0, 8.0])
    assert found["waterline"].cut_count == 5
    settings.frame_spacing, settings.stations_in = 0.5, "FRAMES"
    bpy.context.view_layer.update()
    stations = [section.cut.plane[3] for section in lines_of(hull)["station"].sections]
    assert stations == pytest.approx([0.5, 1.25, 2.0, 3.0, 4.0])


@pytest.mark.parametrize("text", ("1 two", "1:2", "3:1:1", "0:9:0", "0:1:1e-9", "nan", "1:inf:1"))
def test_a_list_that_is_wrong_is_told_of_and_leaves_the_lines(text):
    hull = lined_hull()
    hull.hull.lines.stations = text
    bpy.context.view_layer.update()
    state = state_of(hull)
    assert "Stations" in state.lines.status and not state.status
    assert state.lines.groups["station"].cut_count == 5
    assert state.hydrostatics.values is not None


def test_a_scene_in_other_units():
    hull = lined_hull()
    bpy.context.scene.unit_settings.scale_length = 0.1
    hull.hull.lines.station_count = 5
    bpy.context.view_layer.update()
    found = lines_of(hull)  # in m: a box of 1 m
    assert max(line[:, 0].max() for line in found["station"].polylines) == pytest.approx(1.0)
    assert found["plane"].cut_count == 1
    assert np.concatenate(found["plane"].polylines)[:, 0].max() == pytest.approx(0.7)


def test_a_plane_at_the_cursor():
    hull = add_hull()
    hull.location = (100.0, 0.0, 10.0)
    bpy.context.view_layer.update()
    cursor = bpy.context.scene.cursor
    cursor.location, cursor.rotation_euler = (103.0, 1.0, 12.0), (radians(90.0), 0.0, 0.0)
    wanted = {"X": (0, 3.0), "Y": (1, 1.0), "Z": (2, 2.0), "CURSOR": (1, 1.0)}
    for number, (direction, (axis, place)) in enumerate(wanted.items()):
        assert bpy.ops.hull.add_plane(direction=direction) == {"FINISHED"}
        group = lines_of(hull)["plane"]
        assert group.cut_count == number + 1
        line = np.concatenate(group.sections[-2].polylines)
        assert line[:, axis] == pytest.approx(place, abs=1e-6)
    assert [plane.name for plane in hull.hull.lines.planes[:3]] == ["x = 3", "y = 1", "z = 2"]
    assert bpy.ops.hull.remove_plane() == {"FINISHED"}
    assert len(hull.hull.lines.planes) == 3 and lines_of(hull)["plane"].cut_count == 3


def test_lines_are_kept_in_files(tmp_path):
    hull = lined_hull()
    settings = hull.hull.lines
    settings.show_buttocks, settings.waterline_spacing = False, 0.0
    settings.stations, settings.stations_in, settings.frame_spacing = "0:6:3", "FRAMES", 0.7
    settings.planes[0].name, settings.planes[0].is_shown = "Schnitt „A“", False
    take = part("features.lines.line_data").take_lines
    wanted = take(settings, 1.0)
    assert bpy.ops.hull.export_hull(filepath=str(tmp_path / "box.hull.json")) == {"FINISHED"}
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "box.blend"))
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "box.blend"))
    assert take(bpy.data.objects["box"].hull.lines, 1.0) == wanted
    assert lines_of(bpy.data.objects["box"])["station"].cut_count == 3
    assert bpy.ops.hull.import_hull(filepath=str(tmp_path / "box.hull.json")) == {"FINISHED"}
    assert take(bpy.context.object.hull.lines, 1.0) == wanted


def curves_of(hull):
    return {obj.name: obj for obj in hull.hull.lines.curves.objects}


@pytest.mark.parametrize("form", ("POLY", "BEZIER"))
def test_lines_as_curves(form):
    hull = lined_hull()
    assert bpy.ops.hull.lines_as_curves(form=form) == {"FINISHED"}
    made = curves_of(hull)
    assert len(made) == 8
    stations = made["box stations"]
    assert stations.parent == hull and stations.data.bevel_depth > 0.0
    assert stations.data.materials[0].name == "Hull station"
    for spline in stations.data.splines:
        points = spline.points if form == "POLY" else spline.bezier_points
        x = [point.co[0] for point in points]
        assert max(x) - min(x) < 1e-5
    corners = np.array(stations.bound_box)
    assert corners[:, 1].max() == pytest.approx(HALF_BREADTH, abs=0.02)
    assert corners[:, 1].min() == pytest.approx(-HALF_BREADTH, abs=0.02)
    assert corners[:, 2].max() == pytest.approx(DEPTH, abs=0.02)


def test_curves_are_replaced_and_undone():
    hull = lined_hull()
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.hull.lines_as_curves()
    count = len(bpy.data.curves)
    hull.hull.lines.show_buttocks = False
    bpy.ops.hull.lines_as_curves()
    assert len(curves_of(hull)) == 7 and len(bpy.data.curves) == count - 1
    assert len(bpy.data.collections) == 1
    bpy.context.view_layer.objects.active = next(iter(curves_of(hull).values()))
    assert bpy.ops.hull.lines_as_curves() == {"FINISHED"}
    assert bpy.context.view_layer.objects.active == hull
    for name in SWITCHES:
        setattr(hull.hull.lines, name, False)
    with pytest.raises(RuntimeError, match="switch some on"):
        bpy.ops.hull.lines_as_curves()


def test_a_copy_of_a_hull_makes_curves_of_its_own():
    hull = lined_hull()
    bpy.ops.hull.lines_as_curves()
    twin = hull.copy()
    bpy.context.collection.objects.link(twin)
    bpy.context.view_layer.objects.active = twin
    bpy.ops.hull.lines_as_curves()
    assert twin.hull.lines.curves != hull.hull.lines.curves
    assert len(curves_of(hull)) == len(curves_of(twin)) == 8


def test_bezier_curves_are_the_same_as_the_splines():
    hull = add_hull()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.hull.tag_smooth()
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    native, surface = part("bridge.native").require(), state_of(hull).ship.surface
    (branch,) = native.section_splines(surface, np.array([[1.0, 0.0, 0.0, 4.0]]))[0]
    for spline in branch.splines:
        inner = np.unique(spline.knots)
        knots = part("features.lines.line_curves").bezier_knots(spline.knots, spline.control_points)
        assert len(inner) > 3
        for part_of_span in (0.0, 0.3, 0.5, 1.0):
            t = inner[:-1] + part_of_span * np.diff(inner)
            a, b = 1.0 - part_of_span, part_of_span
            bezier = (
                a**3 * knots[:-1, 1]
                + 3 * a * a * b * knots[:-1, 2]
                + 3 * a * b * b * knots[1:, 0]
                + b**3 * knots[1:, 1]
            )
            wanted = spline.evaluate(np.clip(t, inner[0], inner[-1]))
            assert np.abs(bezier - wanted).max() < 1e-12 * LENGTH


def test_strokes_join_the_points_of_each_line_only():
    strokes_of = part("overlays.line_arrays").strokes_of
    assert len(strokes_of([])) == 0
    lines = [np.arange(9.0).reshape(3, 3), np.arange(6.0).reshape(2, 3) + 100.0]
    strokes = strokes_of(lines)
    assert strokes.points.dtype == np.float32 and len(strokes.points) == 5
    assert strokes.segments.tolist() == [[0, 1], [1, 2], [3, 4]]
    found = lines_of(lined_hull())
    for group in found.values():
        strokes = strokes_of(group.polylines)
        assert len(strokes) == sum(len(line) - 1 for line in group.polylines)
        ends = strokes.points[strokes.segments]
        assert np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).max() <= 2 * LENGTH


def test_every_kind_has_its_colours_and_switch():
    lines, palette = part("features.lines.lines"), part("bridge.blender.palette").GROUPS
    kinds = set(lines.KINDS)
    assert set(lines.SWITCHES) == set(part("features.surface.materials").LINE_COLOURS) == kinds
    drawn = kinds | set(part("features.fairness.level_lines").SWITCHES)
    assert set(palette["lines"][1]) == drawn
    on_lines = set(part("features.fairness.combs").SWITCHES)
    assert on_lines <= kinds
    # Rows are of control points, not lines of the surface.
    assert set(palette["combs"][1]) == on_lines | {part("features.fairness.row_combs").KIND}


def test_rims_of_flats():
    assert bpy.ops.hull.load_sample(name="coaster") == {"FINISHED"}
    hull = bpy.context.object
    for name in SWITCHES:
        setattr(hull.hull.lines, name, name == "show_flats")
    (group,) = state_after_update(hull).lines.groups.values()
    # Those of the bottom, the side and the transom.
    assert len(group.features) == 3
    for rim in group.features:
        assert rim[0] == pytest.approx(rim[-1])
        assert np.linalg.svd(rim - rim.mean(axis=0), compute_uv=False)[2] < 1e-4
    assert bpy.ops.hull.lines_as_curves() == {"FINISHED"}
    (curves,) = hull.hull.lines.curves.objects
    assert curves.name.endswith("flats") and len(curves.data.splines) >= 3


def test_curves_are_made_where_they_are_seen():
    """Their collection was unlinked from the scene, which the hull still points to."""
    hull = lined_hull()
    bpy.ops.hull.lines_as_curves()
    collection = hull.hull.lines.curves
    bpy.context.scene.collection.children.unlink(collection)
    assert bpy.ops.hull.lines_as_curves() == {"FINISHED"}
    assert all(one.name in bpy.context.scene.objects for one in collection.objects)
