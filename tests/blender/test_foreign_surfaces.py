# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface object that others have changed is made anew, and what is not its own is left alone."""

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, make_active, mesh_points, part, state_of


def surface(hull):
    return part("bridge.objects.shown_objects").surface_of(hull)


@pytest.fixture
def hull():
    found = add_hull()
    bpy.context.view_layer.update()
    surface(found).hide_select = False
    return found


def assert_shows_the_box(hull, capfd):
    bpy.context.view_layer.update()
    bpy.context.view_layer.update()
    mesh, state = surface(hull).data, state_of(hull)
    assert np.array_equal(mesh_points(surface(hull)), state.shown.points.coordinates)
    quads, _ = part("features.surface.surface_mesh").surface_faces(
        state.ship.surface.tessellate(hull.hull.samples), state.shown.points.shared
    )
    assert [tuple(polygon.vertices) for polygon in mesh.polygons] == list(map(tuple, quads))
    assert mesh.has_custom_normals and all(polygon.use_smooth for polygon in mesh.polygons)
    assert "Traceback" not in capfd.readouterr().err


def in_edit_mode(shown, operator):
    make_active(shown)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    operator()
    bpy.context.view_layer.update()
    bpy.ops.object.mode_set(mode="OBJECT")


@pytest.mark.parametrize(
    "operator",
    [
        lambda: bpy.ops.mesh.subdivide(),
        lambda: bpy.ops.mesh.delete(type="VERT"),
        lambda: bpy.ops.mesh.flip_normals(),
        lambda: bpy.ops.transform.translate(value=(1.0, 0.0, 0.0)),
        lambda: bpy.ops.mesh.sort_elements(type="RANDOMIZE", elements={"FACE"}),
    ],
)
def test_what_was_edited_is_made_anew_when_edit_mode_ends(hull, operator, capfd):
    in_edit_mode(surface(hull), operator)
    assert_shows_the_box(hull, capfd)


def test_what_was_sculpted_is_made_anew_when_that_ends(hull, capfd):
    make_active(surface(hull))
    bpy.ops.object.mode_set(mode="SCULPT")
    bpy.ops.sculpt.dynamic_topology_toggle()
    bpy.context.view_layer.update()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert_shows_the_box(hull, capfd)


def test_a_hull_that_changes_while_its_surface_is_edited(hull, capfd):
    make_active(surface(hull))
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.subdivide()
    hull.hull.samples = 3
    bpy.context.view_layer.update()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert_shows_the_box(hull, capfd)


def test_flat_shading_is_undone(hull, capfd):
    make_active(surface(hull))
    bpy.ops.object.shade_flat()
    assert_shows_the_box(hull, capfd)


def cancel(hull):
    make_active(hull)
    assert bpy.ops.hull.cancel_fields() == {"FINISHED"}


def forget_the_start(hull):
    hull.data.attributes.remove(hull.data.attributes["hull_start"])
    bpy.context.view_layer.update()


@pytest.mark.parametrize("end", [cancel, forget_the_start])
def test_flat_shading_during_a_preview_is_undone_when_that_ends(hull, end, capfd):
    assert bpy.ops.hull.add_field_recipe(recipe="FATTEN") == {"FINISHED"}
    for field in hull.hull.fields.fields:
        field.shift = (0.0, 0.0, 0.0)  # the exact normals stay
    assert bpy.ops.hull.preview_fields() == {"FINISHED"}
    bpy.context.view_layer.update()
    make_active(surface(hull))
    bpy.ops.object.shade_flat()
    bpy.context.view_layer.update()
    end(hull)
    assert not hull.hull.fields.is_previewed
    assert_shows_the_box(hull, capfd)


def test_another_mesh_is_left_as_it_is(hull, capfd):
    other = add_hull("other")
    bpy.context.view_layer.update()
    before = mesh_points(other)
    surface(hull).data = other.data
    assert_shows_the_box(hull, capfd)
    assert np.array_equal(mesh_points(other), before)
    assert surface(hull).data != other.data


def test_an_empty_mesh_is_filled(hull, capfd):
    surface(hull).data = bpy.data.meshes.new("empty")
    assert_shows_the_box(hull, capfd)


def test_surfaces_that_share_a_mesh_are_parted(hull, capfd):
    other = add_hull("other")
    other.hull.samples = 2
    bpy.context.view_layer.update()
    surface(hull).data = surface(other).data
    assert_shows_the_box(hull, capfd)
    assert_shows_the_box(other, capfd)


def test_shape_keys_of_a_surface_do_not_hold_its_points(hull, capfd):
    surface(hull).shape_key_add(name="Basis")
    surface(hull).shape_key_add(name="other").value = 1.0
    hull.data.vertices[0].co.x -= 1.0
    hull.data.update()
    assert_shows_the_box(hull, capfd)
    assert surface(hull).data.shape_keys is None


def test_points_added_by_joining_go(hull, capfd):
    bpy.ops.mesh.primitive_cube_add()
    make_active(surface(hull))
    bpy.data.objects["Cube"].select_set(True)
    bpy.ops.object.join()
    assert_shows_the_box(hull, capfd)


def test_an_instance_of_a_surface_follows(hull, capfd):
    instance = bpy.data.objects.new("instance", surface(hull).data)
    bpy.context.collection.objects.link(instance)
    hull.data.vertices[0].co.x -= 1.0
    hull.data.update()
    assert_shows_the_box(hull, capfd)
    assert instance.data == surface(hull).data


def finish(name):
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message=name)
    bpy.context.view_layer.update()


def test_undo_past_a_mesh_that_a_handler_gave_leaves_the_object_one_that_is_there(hull):
    # What handlers give after an undo is in no record: undone further, Blender crashed.
    follow = part("handlers.follow").after_update
    finish("made")
    finish("before")
    bpy.app.handlers.depsgraph_update_post.remove(follow)
    try:
        hull.data = surface(hull).data
        finish("shared")
        finish("next")
    finally:
        bpy.app.handlers.depsgraph_update_post.append(follow)
    for is_shared in (True, False):
        bpy.ops.ed.undo()
        found = next(obj for obj in bpy.context.scene.objects if obj.hull.is_hull)
        mesh = found.hull.surface_object.data
        assert mesh.as_pointer() in [one.as_pointer() for one in bpy.data.meshes]
        assert mesh != found.data
        assert (len(bpy.data.meshes) == 3) == is_shared


def test_undo_past_a_surface_that_a_handler_made_leaves_the_hull_one_that_is_there(hull):
    handlers = bpy.app.handlers.depsgraph_update_post
    own = list(handlers)
    finish("made")
    finish("before")
    handlers.clear()
    try:
        surface(hull).parent = None
        finish("alone")
        finish("next")
    finally:
        handlers.extend(own)
    for _ in range(2):
        bpy.ops.ed.undo()
        found = next(obj for obj in bpy.context.scene.objects if obj.hull.is_hull)
        objects = [one.as_pointer() for one in bpy.data.objects]
        assert found.hull.surface_object.as_pointer() in objects
        assert all(one.as_pointer() in objects for one in bpy.context.scene.collection.objects)
        assert surface(found) is not None


def test_a_surface_that_a_handler_made_stays_the_same_object_through_later_undos(hull):
    finish("made")
    surface(hull).parent = None
    finish("alone")
    name = surface(hull).name
    surface(hull).hide_set(True)
    for step in ("one", "two", "three"):
        finish(step)
    for _ in range(2):
        bpy.ops.ed.undo()
        bpy.context.view_layer.update()
        found = next(obj for obj in bpy.context.scene.objects if obj.hull.is_hull)
        assert surface(found).name == name and surface(found).hide_get()
        assert len(bpy.data.objects) == 3
        finish("on")


def test_nothing_is_given_while_an_undo_is_on_its_way(hull):
    # Undo ends sculpt mode first, of which Blender tells the handlers. What these gave an object
    # then went with the undo, and Blender crashed where the object still pointed to it.
    unrecorded = part("bridge.objects.unrecorded")
    shown = surface(hull)
    finish("made")
    unrecorded.before_undo()
    try:
        hull.data = shown.data
        shown.parent = None
        bpy.context.scene.frame_set(2)
        bpy.context.view_layer.update()
        assert hull.hull.surface_object == shown and len(bpy.data.objects) == 2
        assert shown.data == hull.data and len(bpy.data.meshes) == 2
    finally:
        part("handlers.follow").after_undo()
        part("handlers.upkeep_handlers").after_undo()
    assert surface(hull) not in (None, shown) and surface(hull).data != hull.data
