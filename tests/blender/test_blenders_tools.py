# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender's own tools do to a hull: duplicate, delete, join, separate, apply, hide, move to
collections, and the scene's units. What shows the hull keeps in step."""

from math import radians

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import (
    DEPTH,
    LENGTH,
    add_box,
    add_hull,
    make_active,
    mesh_points,
    part,
    state_of,
)


def surface(hull):
    return part("bridge.objects.shown_objects").surface_of(hull)


def scene_objects():
    return set(bpy.context.scene.objects.keys())


def assert_shows(hull, extent):
    """The surface stands where the hull stands, and is as large in all axes."""
    bpy.context.view_layer.update()
    shown = surface(hull)
    assert shown.name in bpy.context.scene.objects
    assert np.allclose(shown.matrix_world, hull.matrix_world)
    assert np.ptp(mesh_points(shown), axis=0) == pytest.approx(extent, rel=1e-6)


BOX = (LENGTH, 4.0, DEPTH)


@pytest.mark.parametrize("linked", [False, True])
def test_a_duplicate_gets_a_surface_of_its_own(linked):
    hull = add_hull()
    bpy.ops.object.duplicate(linked=linked)
    bpy.context.view_layer.update()
    copy = bpy.context.object
    assert copy is not hull and surface(copy) is not surface(hull)
    for each in (hull, copy):
        assert_shows(each, BOX)
        assert state_of(each).hydrostatics.values == state_of(hull).hydrostatics.values


def test_a_duplicate_with_its_surface_gets_no_third():
    hull = add_hull()
    surface(hull).hide_select = False
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.duplicate()
    bpy.context.view_layer.update()
    assert scene_objects() == {"box", "box surface", "box.001", "box surface.001"}
    assert surface(bpy.data.objects["box.001"]).name == "box surface.001"


def test_undo_of_a_duplicate_and_redo():
    add_hull()
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="hull")
    bpy.ops.object.duplicate()
    bpy.ops.ed.undo_push(message="duplicate")
    bpy.context.view_layer.update()
    bpy.ops.ed.undo()
    assert scene_objects() == {"box", "box surface"}
    bpy.ops.ed.redo()
    bpy.context.view_layer.update()
    assert len(scene_objects()) == 4
    assert_shows(bpy.data.objects["box.001"], BOX)


def test_a_deleted_hull_takes_its_surface_along():
    hull = add_hull()
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="hull")
    bpy.ops.object.delete()
    bpy.ops.ed.undo_push(message="deleted")
    bpy.context.view_layer.update()
    assert not scene_objects()
    bpy.ops.ed.undo()
    hull = bpy.data.objects["box"]
    assert scene_objects() == {"box", "box surface"}
    assert_shows(hull, BOX)
    bpy.ops.ed.redo()
    bpy.context.view_layer.update()
    assert not scene_objects()


def test_a_surface_made_one_s_own_stays():
    hull = add_hull()
    bpy.context.view_layer.update()
    shown = surface(hull)
    shown.hide_select = False
    shown.parent = None
    bpy.context.view_layer.update()
    assert surface(hull) is not shown
    make_active(hull)
    bpy.ops.object.delete()
    bpy.context.view_layer.update()
    assert scene_objects() == {shown.name}


def test_a_deleted_surface_stays_deleted_until_it_is_asked_for():
    hull = add_hull()
    bpy.context.view_layer.update()
    surface(hull).hide_select = False
    make_active(surface(hull))
    bpy.ops.object.delete()
    bpy.context.view_layer.update()
    assert scene_objects() == {"box"} and hull.hull.surface_object is None
    hull.data.vertices[0].co.x -= 1.0
    hull.data.update()
    bpy.context.view_layer.update()
    assert scene_objects() == {"box"}
    make_active(hull)
    assert bpy.ops.hull.update() == {"FINISHED"}
    assert_shows(hull, (LENGTH + 1.0, 4.0, DEPTH))


def test_joined_hulls_are_one():
    first, second = add_hull("first"), add_hull("second")
    for vertex in first.data.vertices:
        vertex.co.x += 2.0 * LENGTH
    first.data.update()
    bpy.context.view_layer.update()
    first.select_set(True)
    assert bpy.context.object == second
    bpy.ops.object.join()
    bpy.context.view_layer.update()
    assert scene_objects() == {"second", "second surface"}
    second = bpy.data.objects["second"]
    assert_shows(second, (3.0 * LENGTH, 4.0, DEPTH))
    second.hull.draft = 1.0
    bpy.context.view_layer.update()
    assert state_of(second).hydrostatics.values.displaced_volume == pytest.approx(80.0)


def test_joining_keeps_tags():
    first, second = add_hull("first"), add_box("second")
    creases = part("bridge.blender.blender_versions").edge_creases
    make_active(first)
    second.select_set(True)
    bpy.ops.object.join()
    assert len(first.data.edges) == 22 and (creases(first.data) == 1.0).all()


def separate_bottom(hull):
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="DESELECT")
    bm = bmesh.from_edit_mesh(hull.data)
    bm.faces.ensure_lookup_table()
    bm.faces[1].select_set(True)
    bmesh.update_edit_mesh(hull.data)
    bpy.ops.mesh.separate()
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()


def test_a_separated_part_is_a_hull_of_its_own():
    hull = add_hull()
    separate_bottom(hull)
    part_of_it = bpy.data.objects["box.001"]
    assert part_of_it.hull.is_hull and not state_of(part_of_it).status
    assert_shows(part_of_it, (LENGTH, 4.0, 0.0))
    assert_shows(hull, BOX)
    assert state_of(hull).ship.check.face_count == 3


@pytest.mark.parametrize("scale, turn", [((2.0, 2.0, 2.0), 0.0), ((1.0, -1.0, 1.0), 180.0)])
def test_applied_scale_and_rotation_are_in_the_hull_once(scale, turn):
    hull = add_hull()
    hull.scale, hull.rotation_euler = scale, (0.0, 0.0, radians(turn))
    hull.location = (3.0, 4.0, 5.0)
    bpy.context.view_layer.update()
    assert "Ctrl A" in state_of(hull).status
    bpy.ops.object.transform_apply(location=False)
    bpy.context.view_layer.update()
    assert_shows(hull, np.abs(scale) * BOX)


def test_applied_location_moves_the_ship_s_origin():
    hull = add_hull()
    hull.location = (0.0, 0.0, -1.0)
    bpy.context.view_layer.update()
    before = state_of(hull).hydrostatics.values
    bpy.ops.object.transform_apply()
    hull.hull.draft -= 1.0
    assert_shows(hull, BOX)
    assert state_of(hull).hydrostatics.values.displaced_volume == pytest.approx(
        before.displaced_volume
    )


def test_shape_keys_are_refused():
    hull = add_hull()
    hull.shape_key_add(name="Basis")
    bpy.context.view_layer.update()
    assert not state_of(hull).status
    hull.shape_key_add(name="fuller")
    hull.data.update_tag()
    bpy.context.view_layer.update()
    assert "shape keys" in state_of(hull).status
    assert not bpy.ops.hull.update.poll()


def test_points_that_are_moved_are_so_in_the_basis_of_shape_keys():
    hull = add_hull()
    hull.shape_key_add(name="Basis")
    before = mesh_points(hull)
    assert bpy.ops.hull.set_dimensions(length=2.0 * LENGTH) == {"FINISHED"}
    moved = mesh_points(hull)
    assert np.ptp(moved[:, 0]) == pytest.approx(2.0 * np.ptp(before[:, 0]))
    bpy.ops.object.mode_set(mode="EDIT")
    edited = [vertex.co[:] for vertex in bmesh.from_edit_mesh(hull.data).verts]
    assert (np.array(edited, dtype=np.float32) == moved).all()
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    assert (mesh_points(hull) == moved).all()


def with_shape_keys(obj):
    obj.shape_key_add(name="Basis")
    obj.shape_key_add(name="other")
    bpy.context.view_layer.update()
    return obj


def test_shape_keys_that_come_by_joining_are_refused():
    """Of which Blender says nothing but that there are some."""
    other, hull = add_hull("other"), add_hull()
    other.select_set(True)
    bpy.context.view_layer.update()
    assert bpy.ops.object.join_shapes() == {"FINISHED"}
    bpy.context.view_layer.update()
    assert "shape keys" in state_of(hull).status
    hull.shape_key_clear()
    bpy.context.view_layer.update()
    assert not state_of(hull).status


def test_a_shape_key_that_joins_others_is_refused():
    """Of which Blender says nothing but that the scene has changed."""
    other, hull = add_hull("other"), add_hull()
    hull.shape_key_add(name="Basis")
    other.select_set(True)
    bpy.context.view_layer.update()
    assert not state_of(hull).status
    assert bpy.ops.object.join_shapes() == {"FINISHED"}
    bpy.context.view_layer.update()
    assert "shape keys" in state_of(hull).status


@pytest.fixture
def refreshed(monkeypatch):
    """The names of the hulls that are brought up to date."""
    hull_state, names = part("features.hull.hull_state"), []
    original = hull_state.follow_edit
    monkeypatch.setattr(
        hull_state,
        "follow_edit",
        lambda obj, *how: (names.append(obj.name), original(obj, *how))[1],
    )
    return names


def test_shape_keys_of_others_are_no_matter(refreshed, monkeypatch):
    hulls = [add_hull(), add_hull("second")]
    bpy.ops.mesh.primitive_cube_add()
    cube = with_shape_keys(bpy.context.object)
    digests, surface_mesh = [], part("features.surface.surface_mesh")
    original = surface_mesh.faces_digest
    monkeypatch.setattr(
        surface_mesh, "faces_digest", lambda mesh: (digests.append(mesh.name), original(mesh))[1]
    )
    refreshed.clear()
    for value in (0.25, 0.5, 0.75):
        cube.data.shape_keys.key_blocks["other"].value = value
        bpy.context.view_layer.update()
    assert not refreshed and not digests
    with_shape_keys(hulls[0])
    refreshed.clear()
    cube.data.shape_keys.key_blocks["other"].value = 0.5
    bpy.context.view_layer.update()
    assert refreshed == ["box"] and "shape keys" in state_of(hulls[0]).status


def test_a_hull_that_changes_with_its_surface_is_brought_up_to_date_once(refreshed):
    hull = add_hull()
    bpy.context.view_layer.update()
    refreshed.clear()
    surface(hull).data.vertices[0].co.x -= 1.0
    surface(hull).data.update_tag()
    hull.data.vertices[0].co.x -= 1.0
    hull.data.update_tag()
    bpy.context.view_layer.update()
    assert refreshed == ["box"]
    assert np.array_equal(mesh_points(surface(hull)), state_of(hull).shown.points.coordinates)


def test_the_surface_moves_to_other_collections_with_its_hull():
    hull = add_hull()
    bpy.context.view_layer.update()
    bpy.ops.object.move_to_collection(collection_index=0, is_new=True, new_collection_name="Ships")
    bpy.context.view_layer.update()
    assert [c.name for c in surface(hull).users_collection] == ["Ships"]
    # One that the user keeps elsewhere stays there.
    other = bpy.data.collections.new("Renders")
    bpy.context.scene.collection.children.link(other)
    bpy.data.collections["Ships"].objects.unlink(surface(hull))
    other.objects.link(surface(hull))
    bpy.context.view_layer.update()
    bpy.ops.object.move_to_collection(collection_index=0)
    bpy.context.view_layer.update()
    assert [c.name for c in surface(hull).users_collection] == ["Renders"]
    assert_shows(hull, BOX)


def test_an_excluded_collection_does_no_harm():
    hull = add_hull()
    bpy.context.view_layer.update()
    bpy.ops.object.move_to_collection(collection_index=0, is_new=True, new_collection_name="Ships")
    layer = bpy.context.view_layer.layer_collection.children["Ships"]
    layer.exclude = True
    bpy.context.view_layer.update()
    hull.data.vertices[0].co.x -= 1.0
    hull.data.update()
    bpy.context.view_layer.update()
    layer.exclude = False
    bpy.context.view_layer.update()
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    assert_shows(hull, (LENGTH + 1.0, 4.0, DEPTH))


def test_the_surface_hides_with_its_hull():
    hull = add_hull()
    bpy.context.view_layer.update()
    hull.hide_set(True)
    bpy.context.view_layer.update()
    assert surface(hull).hide_get()
    hull.hide_set(False)
    bpy.context.view_layer.update()
    assert not surface(hull).hide_get()
    hull.hide_viewport = True
    bpy.context.view_layer.update()
    assert not surface(hull).visible_get()
    hull.hide_viewport = False
    bpy.context.view_layer.update()
    assert surface(hull).visible_get()
    surface(hull).hide_set(True)
    bpy.context.view_layer.update()
    bpy.context.view_layer.update()
    assert surface(hull).hide_get() and not hull.hide_get()


def test_objects_that_share_a_mesh_are_hulls_of_their_own():
    first = add_hull("first")
    second = bpy.data.objects.new("second", first.data)
    bpy.context.collection.objects.link(second)
    make_active(second)
    assert bpy.ops.hull.make_hull(half=True) == {"FINISHED"}
    second.hull.draft = 0.5
    make_active(first)
    bpy.ops.object.mode_set(mode="EDIT")
    bm = bmesh.from_edit_mesh(first.data)
    for vertex in bm.verts:
        vertex.co.x *= 2.0
    bmesh.update_edit_mesh(first.data)
    for hull in (first, second):
        assert_shows(hull, (2.0 * LENGTH, 4.0, DEPTH))
    bpy.ops.object.mode_set(mode="OBJECT")
    assert state_of(second).hydrostatics.values.displaced_volume == pytest.approx(40.0)
    assert state_of(first).hydrostatics.values.draft != state_of(second).hydrostatics.values.draft


def test_several_hulls_are_edited_at_once():
    first, second = add_hull("first"), add_hull("second")
    first.select_set(True)
    bpy.ops.object.mode_set(mode="EDIT")
    for hull, factor in ((first, 2.0), (second, 3.0)):
        bm = bmesh.from_edit_mesh(hull.data)
        for vertex in bm.verts:
            vertex.co.z *= factor
        bmesh.update_edit_mesh(hull.data)
    assert_shows(first, (LENGTH, 4.0, 2.0 * DEPTH))
    assert_shows(second, (LENGTH, 4.0, 3.0 * DEPTH))


def test_what_is_selected_is_so_of_all_that_are_edited_at_once():
    """Or what moves next would take points of another hull along."""
    first, second = add_hull("first"), add_hull("second")
    first.select_set(True)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    selection = part("bridge.mesh.selection")
    assert bpy.context.object == second
    selection.select(bpy.context, second, "vertex", [2], extend=True)
    assert len(selection.selected(first, "vertex")) == 8
    selection.select(bpy.context, second, "vertex", [1])
    assert selection.selected(second, "vertex") == [1]
    assert selection.selected(first, "vertex") == []


def test_a_change_of_the_scene_s_scale_is_followed():
    hull = add_hull()
    hull.hull.draft = 1.0
    bpy.context.view_layer.update()
    assert state_of(hull).hydrostatics.values.displaced_volume == pytest.approx(40.0)
    bpy.context.scene.unit_settings.scale_length = 0.5
    bpy.context.view_layer.update()
    assert state_of(hull).hydrostatics.values.displaced_volume == pytest.approx(5.0)
    bpy.context.scene.unit_settings.system = "NONE"
    bpy.context.view_layer.update()
    assert state_of(hull).hydrostatics.values.displaced_volume == pytest.approx(40.0)
    assert_shows(hull, BOX)


def test_modifiers_are_told_of_where_they_mislead():
    hull = add_hull()
    remarks = lambda: (bpy.context.view_layer.update(), state_of(hull).remarks)[1]  # noqa: E731
    mirror = hull.modifiers.new("Mirror", "MIRROR")
    mirror.use_axis = (False, True, False)
    assert remarks() == []
    mirror.use_axis = (True, True, False)
    assert "only these count" in remarks()[0]
    mirror.use_axis = (False, True, False)
    hull.hull.half = False
    assert "Half hull" in remarks()[0]
    mirror.show_viewport = False
    assert remarks() == []
    hull.modifiers.new("Subdivision", "SUBSURF")
    hull.modifiers.new("Array", "ARRAY")
    assert "exact" in remarks()[0] and "apply it" in remarks()[1]
    hull.hull.half = True
    assert_shows(hull, BOX)


def flat_box(name="box"):
    """A box whose bottom and side are kept flat."""
    hull = add_hull(name)
    flats = part("features.constraints.flats")
    for index in (0, 1):
        normal = (0.0, 1.0, 0.0) if index == 0 else (0.0, 0.0, -1.0)
        reach = 2.0 if index == 0 else 0.0
        flats.mark(hull, [index], np.array([*normal, reach]))
    bpy.context.view_layer.update()
    return hull


def flat_kinds(hull):
    return sorted(region.kind for region in part("features.constraints.flats").regions(hull))


def test_flats_go_with_applied_scale():
    hull = flat_box()
    kinds = flat_kinds(hull)
    assert len(kinds) == 2
    hull.scale, hull.rotation_euler.z = (2.0, 3.0, 0.5), radians(30.0)
    bpy.ops.object.transform_apply()
    bpy.context.view_layer.update()
    wanted = mesh_points(hull)
    assert np.ptp(wanted, axis=0)[2] == pytest.approx(0.5 * DEPTH)
    regions = part("features.constraints.flats").regions(hull)
    assert len(regions) == 2
    for region in regions:
        heights = wanted[region.points] @ region.plane[:3] - region.plane[3]
        assert np.abs(heights).max() < 1e-5
    hull.data.update_tag()
    bpy.context.view_layer.update()
    assert np.array_equal(mesh_points(hull), wanted)


def test_joined_hulls_keep_their_flats_apart():
    first = flat_box("first")
    bpy.ops.object.duplicate()
    second = bpy.context.object
    for vertex in second.data.vertices:
        vertex.co.y += 10.0
        vertex.co.z += 1.0
    second.data.update()
    bpy.context.view_layer.update()
    wanted = np.concatenate([mesh_points(second), mesh_points(first)])
    first.select_set(True)
    bpy.ops.object.join()
    bpy.context.view_layer.update()
    assert np.array_equal(mesh_points(bpy.data.objects[second.name]), wanted)


def test_a_separated_part_keeps_its_own_flats():
    hull = flat_box()
    separate_bottom(hull)
    assert len(flat_kinds(hull)) == len(flat_kinds(bpy.data.objects["box.001"])) == 1
    assert flat_kinds(hull) != flat_kinds(bpy.data.objects["box.001"])


def test_what_is_animated_is_followed():
    hull = add_hull()
    for frame, draft in ((1, 1.0), (11, 2.0)):
        hull.hull.draft = draft
        hull.hull.keyframe_insert("draft", frame=frame)
    for frame in (1, 6, 11):
        bpy.context.scene.frame_set(frame)
        found = state_of(hull).hydrostatics.values
        assert found.draft == pytest.approx(hull.hull.draft)
        assert found.displaced_volume == pytest.approx(40.0 * hull.hull.draft, rel=1e-6)
    assert hull.hull.draft == 2.0
    hull.keyframe_insert("rotation_euler", frame=11)
    hull.rotation_euler.z = 1.0
    hull.keyframe_insert("rotation_euler", frame=20)
    bpy.context.scene.frame_set(20)
    assert "rotation" in state_of(hull).status
    bpy.context.scene.frame_set(11)
    assert not state_of(hull).status


@pytest.mark.parametrize("kind, count", [("LINK_COPY", 1), ("FULL_COPY", 2)])
def test_hulls_of_another_scene(kind, count):
    hull = add_hull()
    bpy.context.view_layer.update()
    bpy.ops.scene.new(type=kind)
    bpy.context.view_layer.update()
    hulls = part("bridge.objects.hull_objects").hulls(bpy.data.objects)
    assert len(hulls) == count
    (here,) = part("bridge.objects.hull_objects").hulls(bpy.context.scene.objects)
    assert (here == hull) == (count == 1)
    here.data.vertices[0].co.x -= 1.0
    here.data.update()
    assert_shows(here, (LENGTH + 1.0, 4.0, DEPTH))
    assert np.ptp(mesh_points(surface(hull))[:, 0]) == pytest.approx(LENGTH + (count == 1))


def test_a_mesh_put_in_place_of_the_hull_s():
    hull = add_hull()
    mesh = hull.data.copy()
    for vertex in mesh.vertices:
        vertex.co.x *= 2.0
    hull.data = mesh
    assert_shows(hull, (2.0 * LENGTH, 4.0, DEPTH))
