# SPDX-License-Identifier: GPL-3.0-or-later
"""What a family keeps when it is undone, saved, copied or changed by hand, and when parents are
deleted or changed."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import LENGTH, add_hull, make_active, mesh_points, part
from edited_hulls import edit
from expect_morph import assert_is_member, boxes, morph_of, select, set_weight


def test_each_step_is_undone():
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    select(first, second)
    bpy.ops.ed.undo_push(message="begin")
    name = morph_of(first, second).name
    bpy.ops.ed.undo_push(message="morph")
    made = bpy.data.objects[name]
    points = mesh_points(made).tobytes()
    set_weight(made, 0, 0.2)
    bpy.ops.ed.undo_push(message="weight")
    moved = mesh_points(made).tobytes()
    bpy.ops.hull.leave_family()
    bpy.ops.ed.undo_push(message="own")
    bpy.ops.ed.undo()
    made = bpy.data.objects[name]
    assert len(made.hull.morph.parents) == 2 and mesh_points(made).tobytes() == moved
    assert_is_member(made)
    bpy.ops.ed.undo()
    made = bpy.data.objects[name]
    assert mesh_points(made).tobytes() == points and made.hull.morph.parents[0].weight == 0.5
    assert_is_member(made)
    bpy.ops.ed.redo()
    made = bpy.data.objects[name]
    assert mesh_points(made).tobytes() == moved
    assert made.hull.morph.parents[0].weight == np.float32(0.2)
    assert_is_member(made)
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    assert name not in bpy.data.objects


def test_a_family_is_saved_with_the_file(tmp_path):
    made = morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9)))
    set_weight(made, 0, 0.3)
    name, points = made.name, mesh_points(made).tobytes()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "family.blend"))
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "family.blend"))
    made = bpy.data.objects[name]
    make_active(made)
    bpy.context.view_layer.update()
    assert mesh_points(made).tobytes() == points
    assert_is_member(made)
    set_weight(made, 0, 0.6)
    assert_is_member(made)


def test_deleted_parents_stay_as_they_were_fitted(tmp_path):
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    made = morph_of(first, second)
    bpy.data.objects.remove(second)
    bpy.context.view_layer.update()
    parents = part("features.morphing.parents")
    assert parents.gone(made.hull.morph) == [made.hull.morph.parents[1].name]
    set_weight(made, 0, 0.1)
    assert_is_member(made)
    with pytest.raises(RuntimeError, match="was deleted"):
        bpy.ops.hull.pair_again()
    make_active(first)
    bpy.ops.object.delete()
    assert len(parents.gone(made.hull.morph)) == 2
    make_active(made)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "alone.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "alone.blend"))
    made = next(obj for obj in bpy.data.objects if len(obj.hull.morph.parents))
    make_active(made)
    set_weight(made, 0, 0.7)
    assert_is_member(made)


def test_a_duplicate_is_a_member_of_its_own():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9)))
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    assert copy != made and copy.hull.morph.parents[0].mesh == made.hull.morph.parents[0].mesh
    bpy.context.view_layer.update()
    points = mesh_points(made).tobytes()
    set_weight(copy, 0, 0.8)
    assert mesh_points(made).tobytes() == points
    assert_is_member(copy)
    assert_is_member(made)
    set_weight(made, 0, 0.1)
    assert_is_member(copy)
    assert_is_member(made)


def test_hulls_that_share_a_mesh_are_refused():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9)))
    bpy.ops.object.duplicate(linked=True)
    bpy.context.view_layer.update()
    set_weight(made, 0, 0.8)
    assert "share the mesh" in part("features.morphing.members").told(made).problem
    assert made.hull.morph.parents[0].weight == 0.5


def moved_by_hand(hull):
    bm = edit(hull)
    bm.verts.ensure_lookup_table()
    bm.verts[0].co.z -= 0.25
    bmesh.update_edit_mesh(hull.data)
    bpy.ops.object.mode_set(mode="OBJECT")


def extruded(hull):
    bm = edit(hull)
    bmesh.ops.subdivide_edges(bm, edges=bm.edges[:], cuts=1, use_grid_fill=True)
    bmesh.update_edit_mesh(hull.data)
    bpy.ops.object.mode_set(mode="OBJECT")


def joined(hull):
    other = add_hull("other")
    select(hull, other)
    bpy.ops.object.join()


def with_shape_keys(hull):
    hull.shape_key_add(name="Basis")
    hull.shape_key_add(name="Key")
    hull.data.shape_keys.key_blocks[1].data[0].co.x += 1.0
    hull.data.vertices[0].co.x += 1.0


def creased(hull):
    part("bridge.blender.blender_versions").set_creases(hull.data, [0], [0, 1, 2])


@pytest.mark.parametrize("change", (moved_by_hand, extruded, joined, with_shape_keys, creased))
def test_a_mesh_changed_by_hand_goes_back_or_becomes_its_own(change):
    made = morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9)))
    set_weight(made, 0, 0.3)
    members = part("features.morphing.members")
    before = part("bridge.objects.hull_mesh").read(made)
    change(made)
    make_active(made)
    bpy.context.view_layer.update()
    members.follow(made, bpy.context.scene)
    points = mesh_points(made).tobytes()
    assert not members.told(made).is_of_family
    set_weight(made, 0, 0.9)
    assert mesh_points(made).tobytes() == points
    assert made.hull.morph.parents[0].weight == np.float32(0.3)
    assert bpy.ops.hull.back_to_family() == {"FINISHED"}
    after = part("bridge.objects.hull_mesh").read(made)
    assert (before.topology, before.points_digest) == (after.topology, after.points_digest)
    bpy.context.view_layer.update()
    assert_is_member(made)
    set_weight(made, 0, 0.9)
    assert_is_member(made)
    change(made)
    made_points = mesh_points(made).tobytes()
    if change is not with_shape_keys:
        assert bpy.ops.hull.leave_family() == {"FINISHED"}
        assert mesh_points(made).tobytes() == made_points


def test_back_to_family_waits_for_the_end_of_edit_mode():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9)))
    edit(made)
    assert not bpy.ops.hull.back_to_family.poll()
    set_weight(made, 0, 0.3)  # by a script
    assert_is_member(made)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    assert_is_member(made)


def test_animated_weights_are_followed():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (2.0, 1.0, 1.0)))
    parents = made.hull.morph.parents
    for number, values in enumerate(((1.0, 0.0), (0.0, 1.0))):
        for frame, value in zip((1, 11), values):
            with part("features.morphing.weights").writing():
                parents[number].weight = value
            path = f"hull.morph.parents[{number}].weight"
            made.keyframe_insert(path, frame=frame)
    for curve in made.animation_data.action.fcurves:
        for point in curve.keyframe_points:
            point.interpolation = "LINEAR"
    for frame, length in ((1, 1.0), (6, 1.5), (11, 2.0)):
        bpy.context.scene.frame_set(frame)
        assert np.ptp(mesh_points(made)[:, 0]) == pytest.approx(length * LENGTH)


def test_a_changed_parent_is_told_and_fitted_again():
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    made = morph_of(first, second)
    set_weight(made, 0, 0.25)
    parents = part("features.morphing.parents")
    second.data.vertices[0].co.z = -0.5
    second.data.update()
    second.update_tag(refresh={"DATA"})
    bpy.context.view_layer.update()
    assert parents.changed(made.hull.morph) == [second.name]
    assert bpy.ops.hull.pair_again() == {"FINISHED"}
    assert parents.changed(made.hull.morph) == []
    assert made.hull.morph.parents[0].weight == 0.25
    assert_is_member(made)
    set_weight(made, 1, 1.0)
    assert mesh_points(made).tobytes() == mesh_points(second).tobytes()
    first.hull.draft *= 0.5
    bpy.context.view_layer.update()
    assert parents.changed(made.hull.morph) == [first.name]
