# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls from other .blend files: older versions', linked, appended, pasted; saving in edit mode."""

from pathlib import Path

import bpy
import numpy as np
import pytest
from addon_under_test import DEPTH, LENGTH, add_hull, make_active, mesh_points, part, state_of
from edited_hulls import edit_to_twice_the_depth

FILES = Path(__file__).resolve().parent / "files"


def surface(hull):
    return part("bridge.objects.shown_objects").surface_of(hull)


@pytest.fixture
def library(tmp_path):
    """A file with a hull of draft 1."""
    add_hull("kept").hull.draft = 1.0
    bpy.context.view_layer.update()
    path = str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True)
    return path


def bring(path, link):
    with bpy.data.libraries.load(path, link=link) as (_, wanted):
        wanted.objects = ["kept"]
    hull = wanted.objects[0]
    bpy.context.collection.objects.link(hull)
    make_active(hull)
    bpy.context.view_layer.update()
    return hull


def test_a_hull_of_an_old_file_is_brought_up_to_date():
    bpy.ops.wm.open_mainfile(filepath=str(FILES / "format_0.blend"))
    hull, second = bpy.data.objects["old box"], bpy.data.objects["second"]
    lines = hull.hull.lines
    assert hull.hull.format == second.hull.format == part("bridge.objects.migration").FORMAT
    assert (lines.station_count, lines.stations, lines.stations_in) == (8, "0 2.5 7.5", "FRAMES")
    assert lines.waterline_spacing == pytest.approx(0.6)
    assert lines.buttock_spacing == pytest.approx(0.4)
    assert (lines.waterlines, lines.diagonals) == ("0.5 1", "2.5/45")
    assert (lines.frame_spacing, hull.hull.plan.paper, hull.hull.draft) == (0.5, "A1", 1.25)
    # What showed lines then is gone, what shows the surface is there.
    assert set(bpy.context.scene.objects.keys()) == {
        "old box", "old box surface", "second", "second surface"
    }  # fmt: skip
    assert state_of(hull).lines.groups["station"].cut_count == 3
    assert state_of(hull).lines.groups["waterline"].cut_count == 2
    assert state_of(hull).hydrostatics.values.displaced_volume == pytest.approx(50.0)
    leftover = {*hull.hull.keys(), *hull.hull.plan.keys()}
    assert not leftover & {"station_count", "waterline_spacing", "lines_object", "diagonals"}


def test_what_was_brought_up_to_date_is_left_alone(tmp_path):
    bpy.ops.wm.open_mainfile(filepath=str(FILES / "format_0.blend"))
    bpy.data.objects["old box"].hull.lines.stations = "1 2"
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "new.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "new.blend"))
    hull = bpy.data.objects["old box"]
    assert hull.hull.lines.stations == "1 2" and not state_of(hull).remarks


def test_a_hull_appended_from_an_old_file_is_brought_up_to_date():
    with bpy.data.libraries.load(str(FILES / "format_0.blend")) as (_, wanted):
        wanted.objects = ["old box"]
    hull = wanted.objects[0]
    bpy.context.collection.objects.link(hull)
    bpy.context.view_layer.update()
    assert hull.hull.lines.stations == "0 2.5 7.5"
    assert hull.hull.format == part("bridge.objects.migration").FORMAT


def test_downflooding_points_of_before_they_were_called_so_stay(tmp_path):
    loading = add_hull().hull.loading
    loading.downflooding_points.add().name = "new"
    loading.id_data.hull.format = 2
    loading["flooding_points"] = [{"name": "hatch", "position": (3.0, 1.0, 4.0)}]
    loading["active_flooding_point"] = 1
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "old.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "old.blend"))
    loading = bpy.context.view_layer.objects.active.hull.loading
    assert [point.name for point in loading.downflooding_points] == ["new", "hatch"]
    assert tuple(loading.downflooding_points[1].position) == (3.0, 1.0, 4.0)
    assert loading.active_downflooding_point == 1
    assert not {"flooding_points", "active_flooding_point"} & set(loading.keys())


def test_layers_of_before_they_had_names_are_called_as_their_materials(tmp_path):
    hull = add_hull()
    named = (("Shell", "Shell.002"), ("Shell", "Bottom"), ("Shell", "Deck.001"), ("Z.100", "Z.100"),
             ("L" * 70, "L" * 59 + ".003"))  # fmt: skip
    for name, material in named:
        layer = hull.hull.layers.add()
        layer.name, layer.material = name, bpy.data.materials.new(material)
        hull.data.materials.append(layer.material)
    assert [layer.material.name for layer in hull.hull.layers] == [other for _, other in named]
    hull.hull.layers.add().name = "no material"
    assert bpy.ops.hull.keep_variant() == {"FINISHED"}
    hull.hull.format = 3
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "old.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "old.blend"))
    settings = bpy.context.view_layer.objects.active.hull
    for ship in (settings, settings.variants.kept[0]):
        assert [layer.name for layer in ship.layers] == [
            "Shell", "Bottom", "Deck", "Z.100", "L" * 70, "no material"
        ]  # fmt: skip


def test_trims_of_before_their_unit_was_named_stay(tmp_path):
    """Those of the hull, of kept variants and of parents; and what moves with the time."""
    hull = add_hull()
    settings, kept = hull.hull, hull.hull.variants.kept.add()
    settings.morph.parents.add()["trim"] = 0.75
    settings["trim"], kept["trim"] = 0.5, -0.25
    kept.loading["flooding_points"] = [{"name": "hatch", "position": (3.0, 1.0, 4.0)}]
    settings.format = 2
    hull.animation_data_create().action = bpy.data.actions.new("trims")
    hull.animation_data.action.fcurves.new("hull.trim").keyframe_points.insert(1.0, 0.5)
    hull.animation_data.action.fcurves.new("hull.draft").keyframe_points.insert(1.0, 1.0)
    driver = hull.animation_data.drivers.new("hull.heel").driver
    driver.type, variable = "AVERAGE", driver.variables.new()
    variable.targets[0].id, variable.targets[0].data_path = hull, "hull.trim"
    for _ in range(2):  # what was brought up to date stays as it is, too
        bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "old.blend"))
        bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "old.blend"))
        hull = bpy.context.view_layer.objects.active
        settings = hull.hull
        assert settings.format == part("bridge.objects.migration").FORMAT
        assert (settings.trim_m, settings.variants.kept[0].trim_m) == (0.5, -0.25)
        assert settings.morph.parents[0].trim_m == 0.75
        assert not {"trim"} & {*settings.keys(), *settings.variants.kept[0].keys()}
        (point,) = settings.variants.kept[0].loading.downflooding_points
        assert (point.name, tuple(point.position)) == ("hatch", (3.0, 1.0, 4.0))
        paths = [curve.data_path for curve in hull.animation_data.action.fcurves]
        assert paths == ["hull.trim_m", "hull.draft"]
        (driven,) = hull.animation_data.drivers
        assert driven.driver.variables[0].targets[0].data_path == "hull.trim_m"
        assert settings.heel == pytest.approx(0.5)


def test_new_hulls_have_the_stamp_and_newer_ones_are_told_of():
    hull = add_hull()
    assert hull.hull.format == part("bridge.objects.migration").FORMAT
    hull.hull.format = 99
    hull.data.update_tag()
    bpy.context.view_layer.update()
    assert "newer version" in state_of(hull).remarks[0]
    assert hull.hull.format == 99


def test_a_linked_hull_is_measured_and_not_changed(library, tmp_path):
    hull = bring(library, link=True)
    assert hull.library is not None
    found = state_of(hull)
    assert not found.status and found.hydrostatics.values.displaced_volume == pytest.approx(40.0)
    assert found.lines.groups["station"].polylines
    assert "linked from another file" in found.remarks[0]
    # Its surface is shown, as it was saved.
    assert hull.hull.surface_object.name in bpy.context.scene.objects
    for operator in (bpy.ops.hull.update, bpy.ops.hull.turn_outwards, bpy.ops.hull.add_plane):
        assert not operator.poll()
    assert bpy.ops.hull.check_mesh() == {"FINISHED"}
    path = tmp_path / "kept.hull.json"
    assert bpy.ops.hull.export_hull(filepath=str(path)) == {"FINISHED"} and path.exists()
    assert bpy.ops.hull.export_step(filepath=str(tmp_path / "kept.step")) == {"FINISHED"}


def test_a_linked_hull_survives_saving_and_is_changed_once_local(library, tmp_path):
    bring(library, link=True)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "user.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "user.blend"))
    hull = bpy.data.objects["kept"]
    assert state_of(hull).hydrostatics.values.displaced_volume == pytest.approx(40.0)
    make_active(hull)
    bpy.ops.object.make_local(type="ALL")
    hull = bpy.data.objects["kept"]
    hull.hull.draft = 2.0
    bpy.context.view_layer.update()
    assert state_of(hull).hydrostatics.values.displaced_volume == pytest.approx(80.0)
    assert not state_of(hull).remarks
    make_active(hull)
    assert bpy.ops.hull.update() == {"FINISHED"}
    assert surface(hull).name in bpy.context.scene.objects


def test_a_linked_hull_and_one_of_the_file_have_one_name(library, monkeypatch):
    own = add_hull("kept")
    own.hull.draft = 2.0
    linked = bring(library, link=True)
    assert linked.name == own.name and linked != own
    known = dict(part("features.hull.hull_state").known_hulls(bpy.context.view_layer))
    assert known == {own: state_of(own), linked: state_of(linked)}
    # What is missed of either is computed, of the one that it was missed of.
    live, worker = part("features.analyses.live_analyses"), part("bridge.background.worker")
    monkeypatch.setattr(live, "_PAUSE_SECONDS", 0.0)
    for hull in (own, linked):
        live.latest(hull, bpy.context.scene, "sectional_areas")
    live.follow_wanted()
    worker.finish()
    live.take_finished()
    for hull, draft in ((own, 2.0), (linked, 1.0)):
        outcome, is_current = live.latest(hull, bpy.context.scene, "sectional_areas")
        assert is_current and outcome.result.areas.areas.max() == pytest.approx(4.0 * draft)


def test_an_override_is_measured_and_not_changed(library):
    linked = bring(library, link=True)
    hull = linked.override_create(remap_local_usages=True)
    make_active(hull)
    bpy.context.view_layer.update()
    hull.location.x = 50.0
    bpy.context.view_layer.update()
    assert state_of(hull).hydrostatics.values.displaced_volume == pytest.approx(40.0)
    assert any("override" in remark or "linked" in remark for remark in state_of(hull).remarks)
    assert not bpy.ops.hull.update.poll() and not bpy.ops.hull.turn_outwards.poll()


def test_an_appended_hull_shows_its_surface(library):
    hull = bring(library, link=False)
    assert surface(hull).name in bpy.context.scene.objects
    hull.data.vertices[0].co.x -= 1.0
    hull.data.update()
    bpy.context.view_layer.update()
    assert np.ptp(mesh_points(surface(hull))[:, 0]) == pytest.approx(LENGTH + 1.0)


def test_copy_and_paste_between_files():
    add_hull().hull.draft = 1.0
    bpy.context.view_layer.update()
    window = bpy.context.window_manager.windows[0]
    with bpy.context.temp_override(window=window):
        assert bpy.ops.view3d.copybuffer() == {"FINISHED"}
    bpy.ops.wm.read_homefile(use_empty=True)
    add_hull()
    window = bpy.context.window_manager.windows[0]
    with bpy.context.temp_override(window=window):
        assert bpy.ops.view3d.pastebuffer() == {"FINISHED"}
    bpy.context.view_layer.update()
    pasted = bpy.data.objects["box.001"]
    assert surface(pasted).parent == pasted and surface(pasted).name in bpy.context.scene.objects
    assert state_of(pasted).hydrostatics.values.displaced_volume == pytest.approx(40.0)
    assert len(bpy.context.scene.objects) == 4


def test_saving_in_edit_mode_keeps_what_is_edited(tmp_path):
    hull = add_hull()
    edit_to_twice_the_depth(hull)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "edited.blend"))
    assert bpy.context.mode == "EDIT_MESH" and not state_of(hull).status
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "edited.blend"))
    hull = bpy.data.objects["box"]
    assert mesh_points(surface(hull))[:, 2].max() == pytest.approx(2.0 * DEPTH)
    assert state_of(hull).ship.check.face_count == 4


def test_a_deleted_surface_is_not_saved(tmp_path):
    hull = add_hull()
    bpy.context.view_layer.update()
    surface(hull).hide_select = False
    make_active(surface(hull))
    bpy.ops.object.delete()
    bpy.context.view_layer.update()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "bare.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "bare.blend"))
    assert list(bpy.data.objects.keys()) == ["box"]


def test_what_changes_a_hull_is_refused_of_a_linked_one(library):
    bring(library, link=True)
    changing = part("operators.shared").HullOperator
    operators = {
        cls.bl_rna.identifier: cls
        for cls in bpy.types.Operator.__subclasses__()
        if issubclass(cls, changing) and hasattr(bpy.types, cls.__name__)
    }
    assert len(operators) > 15
    allowed = [name for name, cls in operators.items() if cls.poll(bpy.context)]
    assert allowed == []
