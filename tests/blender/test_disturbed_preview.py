# SPDX-License-Identifier: GPL-3.0-or-later
"""The preview of shape fields when something else happens to the hull, its mesh or the curves of
its fields meanwhile: where the points were is never lost, and no handler fails."""

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, make_active, part, state_of
from edited_hulls import edit
from test_field_preview import changed, previewed, shown
from test_fields import add, points_of, sample, side_point


@pytest.fixture(autouse=True)
def no_tracebacks(capfd):
    yield
    assert "Traceback" not in capfd.readouterr().err


def linked_copy(hull):
    make_active(hull)
    bpy.ops.object.duplicate(linked=True)
    changed()
    copy = bpy.context.view_layer.objects.active
    assert copy.data is hull.data
    return copy


def based_on_a_curve():
    """(hull, its points before, the curve), previewed."""
    hull = sample()
    before, place = points_of(hull), side_point(hull)
    line = [(place[0] + x, place[1], place[2]) for x in (-8.0, 0.0, 8.0)]
    curve = part("bridge.objects.curve_lines").made("Line", line, False, hull)
    add(hull, place, base="CURVE", extent=12.0, shift=(0.0, 0.2, 0.0)).curve = curve
    bpy.ops.hull.preview_fields()
    return hull, before, curve


def test_a_mesh_is_previewed_for_one_hull_at_a_time():
    hull, field, before = previewed()
    hull.hull.fields.is_previewed = False  # the copy is not previewed
    copy = linked_copy(hull)
    hull.hull.fields.is_previewed = True
    with pytest.raises(RuntimeError, match='Fields of "Coaster" are previewed too'):
        bpy.ops.hull.preview_fields()
    assert not copy.hull.fields.is_previewed
    make_active(hull)
    assert bpy.ops.hull.cancel_fields() == {"FINISHED"}
    assert np.array_equal(points_of(hull), before)


def test_a_copy_that_shares_the_mesh_waits_until_it_has_its_own():
    hull, field, before = previewed()
    moved, copy = points_of(hull), linked_copy(hull)
    copy.hull.fields.fields[0].shift = (0.0, 0.6, 0.0)
    changed()
    assert "previewed too" in shown(hull).problem and "previewed too" in shown(copy).problem
    assert np.array_equal(points_of(hull), moved)
    copy.data = copy.data.copy()
    changed()
    assert shown(hull).problem == shown(copy).problem == ""
    assert not np.array_equal(points_of(copy), moved)
    for one in (hull, copy):
        make_active(one)
        assert bpy.ops.hull.cancel_fields() == {"FINISHED"}
        assert np.array_equal(points_of(one), before)


@pytest.mark.parametrize("is_first", [True, False])
def test_what_is_kept_for_another_hull_of_the_mesh_is_told(is_first, monkeypatch):
    """A whole hull is previewed on the mesh of a half one, whose centre line stays where it is.
    Which of them follows first is otherwise by chance."""
    half = add_hull("box")
    whole = linked_copy(half)
    whole.hull.half = False
    edit(whole)
    add(whole, (0.0, 2.0, 3.0), base="CREASE", extent=2.5, shift=(0.3, -0.4, -0.5))
    follow, context = part("handlers.follow"), bpy.context
    monkeypatch.setattr(follow, "_is_following", True)
    bpy.ops.hull.preview_fields()
    changed()
    assert np.sum(points_of(half)[:, 1] == 0.0) < 4 and shown(whole).problem == ""
    monkeypatch.setattr(follow, "_is_following", False)
    hulls = [whole, half] if is_first else [half, whole]
    follow._follow(hulls, context.scene, context.view_layer)
    assert np.sum(points_of(half)[:, 1] == 0.0) == 4
    assert "Points or faces were changed" in shown(whole).problem


def test_apply_ends_the_preview_of_all_that_share_the_mesh():
    hull, _, _ = previewed()
    moved, copy = points_of(hull), linked_copy(hull)
    assert "previewed too" in shown(copy).problem
    # Blender does not always tell of a mesh that stays as it is.
    part("features.fields.preview").end(hull, bpy.context.scene, is_kept=True)
    assert np.array_equal(points_of(hull), moved)
    for one in (hull, copy):
        assert not one.hull.fields.is_previewed and shown(one) is None


def test_cancel_ends_the_preview_of_all_that_share_the_mesh():
    hull, field, before = previewed()
    copy = linked_copy(hull)
    assert bpy.ops.hull.cancel_fields() == {"FINISHED"}
    changed()
    assert not hull.hull.fields.is_previewed and not copy.hull.fields.is_previewed
    assert np.array_equal(points_of(hull), before)


def in_edit_mode():
    """(hull, its points before), previewed in edit mode, with a step of undo before and after."""
    hull = sample()
    add(hull, side_point(hull), extent=20.0, shift=(0.0, 0.3, 0.0))
    changed()
    before = points_of(hull)
    edit(hull)
    bpy.ops.ed.undo_push(message="edit mode")
    bpy.ops.hull.preview_fields()
    bpy.ops.ed.undo_push(message="previewed")
    return hull, before


def cancelled(hull):
    assert bpy.ops.hull.cancel_fields() == {"FINISHED"}
    points = points_of(hull)
    bpy.ops.object.mode_set(mode="OBJECT")
    return points


def test_undo_and_redo_in_edit_mode_go_through_it():
    hull, before = in_edit_mode()
    moved = points_of(hull)
    bpy.ops.ed.undo()
    assert not hull.hull.fields.is_previewed and np.array_equal(points_of(hull), before)
    bpy.ops.ed.redo()
    assert hull.hull.fields.is_previewed and np.array_equal(points_of(hull), moved)
    assert np.array_equal(cancelled(hull), before)


@pytest.mark.parametrize("end", ["cancel_fields", "apply_fields"])
def test_undo_of_its_end_in_edit_mode_takes_it_up_again(end):
    hull, before = in_edit_mode()
    moved = points_of(hull)
    getattr(bpy.ops.hull, end)()
    bpy.ops.ed.undo_push(message=end)
    bpy.ops.ed.undo()
    assert hull.hull.fields.is_previewed and np.array_equal(points_of(hull), moved)
    assert np.array_equal(cancelled(hull), before)


def test_undo_of_a_change_in_edit_mode_leaves_what_the_fields_say():
    """Blender's undo in edit mode takes back the mesh, not the fields."""
    hull, before = in_edit_mode()
    hull.hull.fields.fields[0].shift = (0.0, 0.6, 0.0)
    changed()
    moved = points_of(hull)
    bpy.ops.ed.undo_push(message="shift")
    bpy.ops.ed.undo()
    assert shown(hull).problem == "" and np.array_equal(points_of(hull), moved)
    assert np.array_equal(cancelled(hull), before)


def test_a_curve_that_was_converted_is_told():
    hull, before, curve = based_on_a_curve()
    make_active(curve)
    bpy.ops.object.convert(target="MESH")
    changed()
    assert "Line is no curve object any longer" in shown(hull).problem
    make_active(hull)
    assert bpy.ops.hull.cancel_fields() == {"FINISHED"}
    assert np.array_equal(points_of(hull), before)
    with pytest.raises(RuntimeError, match="no curve object"):
        bpy.ops.hull.apply_fields()


def test_a_linked_hull_stays_as_its_file_shows_it(tmp_path):
    hull, before, curve = based_on_a_curve()
    path, name, moved = str(tmp_path / "previewed.blend"), hull.name, points_of(hull)
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True)
    with bpy.data.libraries.load(path, link=True) as (_, found):
        found.objects = [name]
    hull = found.objects[0]
    bpy.context.collection.objects.link(hull)
    changed()
    assert state_of(hull).status == "" and np.array_equal(points_of(hull), moved)


def test_hulls_joined_to_it_are_points_that_were_changed():
    hull, field, before = previewed()
    sample("barge")
    hull.select_set(True)
    bpy.context.view_layer.objects.active = hull
    bpy.ops.object.join()
    changed()
    assert "Apply keeps the hull as it is" in shown(hull).problem
    joined = points_of(hull)
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    assert np.array_equal(points_of(hull), joined)


def test_a_variant_kept_meanwhile_is_the_hull_as_it_is_shown():
    hull, field, before = previewed()
    moved = points_of(hull)
    bpy.ops.hull.keep_variant()
    bpy.ops.hull.cancel_fields()
    bpy.ops.hull.go_back_to_variant()
    assert np.array_equal(points_of(hull), moved)
    assert part("bridge.mesh.start_points").read(hull.data) is None
    bpy.ops.hull.preview_fields()
    bpy.ops.hull.go_back_to_variant()
    changed()
    assert np.array_equal(points_of(hull), moved) and not hull.hull.fields.is_previewed


def test_without_fields_it_ends():
    hull, field, before = previewed()
    bpy.ops.hull.remove_field()
    changed()
    assert np.array_equal(points_of(hull), before) and not hull.hull.fields.is_previewed


def test_a_part_without_faces_says_so():
    hull, field, before = previewed()
    edit(hull)
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.delete(type="ONLY_FACE")
    bpy.ops.object.mode_set(mode="OBJECT")
    changed()
    assert shown(hull).problem == state_of(hull).status != ""
    assert bpy.ops.hull.cancel_fields() == {"FINISHED"}
    assert np.array_equal(points_of(hull), before)


def test_it_is_known_after_all_is_made_anew():
    hull, field, before = previewed()
    field.base = "FACES"
    changed()
    problem = shown(hull).problem
    assert "Take Faces" in problem
    assert bpy.ops.hull.update() == {"FINISHED"}
    changed()
    assert shown(hull).problem == problem


def test_a_mesh_that_was_off_its_hull_still_knows_where_its_points_were():
    hull, field, before = previewed()
    mesh, moved = hull.data, points_of(hull)
    hull.data = bpy.data.meshes.new("Other")
    changed()
    assert not hull.hull.fields.is_previewed
    hull.data = mesh
    changed()
    assert np.array_equal(points_of(hull), moved)
    bpy.ops.hull.preview_fields()
    assert shown(hull).problem == "" and np.array_equal(points_of(hull), moved)
    assert bpy.ops.hull.cancel_fields() == {"FINISHED"}
    assert np.array_equal(points_of(hull), before)


def test_undo_and_redo_in_object_mode_go_through_a_preview():
    bpy.context.preferences.edit.use_global_undo = True
    hull, field, before = previewed()
    bpy.ops.ed.undo_push(message="previewed")
    moved = points_of(hull)
    field.extent *= 0.75
    changed()
    bpy.ops.ed.undo_push(message="extent")
    again, name = points_of(hull), hull.name
    for step, wanted in ((bpy.ops.ed.undo, moved), (bpy.ops.ed.redo, again)) * 2:
        step()
        changed()
        hull = bpy.data.objects[name]
        assert hull.hull.fields.is_previewed and np.array_equal(points_of(hull), wanted)
        assert shown(hull).problem == ""
    make_active(hull)
    assert bpy.ops.hull.cancel_fields() == {"FINISHED"}
    assert np.array_equal(points_of(hull), before)


def test_a_base_curve_that_is_deleted_is_told():
    hull = sample()
    place = side_point(hull)
    row = add(hull, place, base="CURVE", shift=(0.0, 0.2, 0.0), extent=6.0)
    line = np.array([place - (6.0, 0.0, 0.0), place, place + (6.0, 0.0, 0.0)])
    row.curve = part("bridge.objects.curve_lines").made("base", line, False, hull)
    bpy.context.view_layer.update()
    assert bpy.ops.hull.preview_fields() == {"FINISHED"}
    assert not part("features.fields.preview").of_hull(hull).problem
    for collection in row.curve.users_collection:
        collection.objects.unlink(row.curve)
    bpy.context.view_layer.update()
    assert "not in the scene" in part("features.fields.preview").of_hull(hull).problem


def test_a_vertex_group_of_its_name_is_told():
    """Blender's own operators make vertex groups of attributes, under their names."""
    hull = sample()
    before = points_of(hull)
    add(hull, side_point(hull), extent=12.0, shift=(0.0, 0.2, 0.0))
    group = hull.vertex_groups.new(name="hull_start")
    with pytest.raises(RuntimeError, match='named "hull_start".*vertex group'):
        bpy.ops.hull.preview_fields()
    assert not hull.hull.fields.is_previewed
    assert np.array_equal(points_of(hull), before)
    hull.vertex_groups.remove(group)
    assert bpy.ops.hull.preview_fields() == {"FINISHED"}
