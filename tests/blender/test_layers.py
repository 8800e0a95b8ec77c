# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers made of selected faces, and those without faces removed: surface, numbers and plating know
of it. The box is 10 × 4 × 3 m; its half has side, bottom, aft end, forward end."""

import json

import bpy
import pytest
from addon_under_test import add_hull, part, sample, state_of, values
from edited_hulls import edit, select

SIDE, BOTTOM = 0, 1


def new_layer(hull, face, name):
    edit(hull, (False, False, True))
    select(hull, "face", [face])
    assert bpy.ops.hull.new_layer(name=name) == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")


def slots(hull):
    return [polygon.material_index for polygon in hull.data.polygons]


def names(hull):
    return [layer.name for layer in hull.hull.layers]


def written_names(path):
    """Of the layers in the hull file of the active hull."""
    assert bpy.ops.hull.export_hull(filepath=str(path)) == {"FINISHED"}
    return [layer["name"] for layer in json.loads(path.read_text(encoding="utf-8"))["layers"]]


def is_followed(hull):
    bpy.context.view_layer.update()
    return not state_of(hull).status and values(hull).displaced_volume


@pytest.fixture
def hull():
    box = add_hull()
    box.hull.draft, box.hull.length_pp = 2.0, 10.0
    return box


def test_selected_faces_become_a_layer_of_the_shell(hull):
    volume = is_followed(hull)
    new_layer(hull, BOTTOM, "Bottom")
    assert slots(hull) == [0, 1, 0, 0] and names(hull) == ["Shell", "Bottom"]
    assert is_followed(hull) == pytest.approx(volume, rel=1e-12)
    hull.hull.layers[1].in_hydrostatics = False
    bpy.context.view_layer.update()
    assert state_of(hull).ship.check.face_count == 3


def test_a_layer_has_plating_of_its_own(hull):
    new_layer(hull, BOTTOM, "Bottom")
    hull.hull.layers[1].thickness, hull.hull.layers[1].density = 0.02, 2.7
    weights = part("features.analyses").result_of(hull, bpy.context.scene, "weights")
    (bottom,) = weights.parts
    assert bottom.mass_t == pytest.approx(40.0 * 0.02 * 2.7, rel=1e-9)


def test_layers_without_faces_are_removed_and_others_stay(hull):
    new_layer(hull, BOTTOM, "Bottom")
    new_layer(hull, SIDE, "Side")
    hull.hull.layers[2].thickness = 0.03
    hull.data.polygons[BOTTOM].material_index = 0
    assert bpy.ops.hull.remove_empty_layers() == {"FINISHED"}
    assert names(hull) == ["Shell", "Side"] == [slot.name for slot in hull.material_slots]
    assert slots(hull) == [1, 0, 0, 0]
    assert hull.hull.layers[1].thickness == pytest.approx(0.03)
    assert is_followed(hull)
    with pytest.raises(RuntimeError, match="Every layer has faces"):
        bpy.ops.hull.remove_empty_layers()


def test_faces_of_a_slot_that_is_not_there_are_in_the_last_one(hull):
    new_layer(hull, BOTTOM, "Bottom")
    hull.data.polygons[BOTTOM].material_index = 7
    with pytest.raises(RuntimeError, match="Every layer has faces"):
        bpy.ops.hull.remove_empty_layers()


def test_hulls_with_layers_of_the_same_names_keep_them(tmp_path):
    first = sample("coaster")
    wanted = names(first)
    assert "Transom" in wanted and wanted == written_names(tmp_path / "1.hull.json")
    for _ in range(2):
        hull = sample("coaster")
        assert names(hull) == wanted == written_names(tmp_path / "2.hull.json")
        assert not {slot.name for slot in hull.material_slots} & set(wanted)


def test_a_layer_that_is_renamed_is_called_so_everywhere(hull, tmp_path):
    sample("coaster")
    bpy.context.view_layer.objects.active = hull
    new_layer(hull, BOTTOM, "Bottom")
    shell, bottom = hull.hull.layers
    shell.thickness, shell.density = 0.01, 7.85
    bottom.thickness, bottom.density = 0.02, 2.7
    for name in ("Transom", "Keel plate"):
        bottom.name = name  # the coaster has a layer "Transom"
        assert written_names(tmp_path / "hull.hull.json") == ["Shell", name]
        weights = part("features.analyses").result_of(hull, bpy.context.scene, "weights")
        assert [one.name for one in weights.parts] == ["Shell", name]
        bpy.ops.hull.export_parts(filepath=str(tmp_path / "parts.stl"))
        solids = (tmp_path / "parts.stl").read_text(encoding="utf-8")
        assert f"solid {name.replace(' ', '_')}\n" in solids
    assert bottom.material.name == "Keel plate"
    assert bpy.ops.hull.import_hull(filepath=str(tmp_path / "hull.hull.json")) == {"FINISHED"}
    assert names(bpy.context.object) == ["Shell", "Keel plate"]


def test_a_layer_without_a_name_is_called_as_its_material(hull, tmp_path):
    new_layer(hull, BOTTOM, "Bottom")
    hull.hull.layers[1].name = ""
    assert written_names(tmp_path / "hull.hull.json") == ["Shell", "Bottom"]


def test_new_layers_of_a_hull_have_different_names(hull):
    for _ in range(3):
        new_layer(hull, BOTTOM, "Layer")
    assert names(hull) == ["Shell", "Layer", "Layer 2", "Layer 3"]


def test_a_layer_needs_faces_and_undo_takes_it_back(hull):
    edit(hull)
    with pytest.raises(RuntimeError, match="Select the faces of the layer first"):
        bpy.ops.hull.new_layer()
    select(hull, "face", [BOTTOM])
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.hull.new_layer()
    bpy.ops.ed.undo_push(message="after")
    bpy.ops.ed.undo()
    hull = bpy.context.object
    bpy.ops.object.mode_set(mode="OBJECT")
    assert not hull.hull.layers and set(slots(hull)) == {0}


def test_locks_are_taken_off_all_points_or_the_selected_ones(hull):
    locked_points = part("features.constraints.point_locks").locked_points
    edit(hull)
    select(hull, "vertex", [0, 3, 5])
    bpy.ops.hull.lock_points()
    select(hull, "vertex", [3])
    assert bpy.ops.hull.unlock_points() == {"FINISHED"}
    assert locked_points(hull.data).tolist() == [0, 5]
    select(hull, "vertex", [])
    assert bpy.ops.hull.unlock_points(everything=True) == {"FINISHED"}
    assert not len(locked_points(hull.data))
    bpy.ops.object.mode_set(mode="OBJECT")
    assert not len(locked_points(hull.data))
