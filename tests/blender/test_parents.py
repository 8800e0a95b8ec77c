# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls that parents, constraints or points of meshes carry, or that have no room of their own."""

import bpy
import pytest
from addon_under_test import add_hull, make_active, part, state_of
from mathutils import Matrix
from test_blenders_tools import BOX, assert_shows


def test_a_hull_on_anothers_surface_follows_where_that_is_put_back():
    """Blender tells of no object that moves along with what a handler moves."""
    carrier, box = add_hull(), add_hull()
    shown = carrier.hull.surface_object
    box.parent = shown
    bpy.context.view_layer.update()
    shown.matrix_basis = Matrix.Scale(-1.0, 4, (1.0, 0.0, 0.0))
    bpy.context.view_layer.update()
    assert f'parent "{shown.name}"' in state_of(box).status
    bpy.context.collection.objects.link(bpy.data.objects.new("Other", None))
    bpy.context.view_layer.update()
    assert shown.matrix_world == Matrix() and state_of(box).status == ""
    shown.matrix_basis = Matrix.Scale(-1.0, 4, (1.0, 0.0, 0.0))
    bpy.context.view_layer.update()
    carrier.location.x = 1.0
    bpy.context.view_layer.update()
    assert shown.matrix_basis == Matrix() and state_of(box).status == ""


@pytest.mark.parametrize("mode", ["XYZ", "QUATERNION", "AXIS_ANGLE"])
def test_a_surface_turned_by_deltas_is_put_back_at_once(mode, capfd):
    hull = add_hull()
    shown = hull.hull.surface_object
    shown.rotation_mode, shown.rotation_euler = mode, (0.3, 0.2, 0.1)
    shown.delta_rotation_euler, shown.delta_scale = (1.0, 1.83, 2.73), (0.3, 1.7, -1.1)
    shown.delta_rotation_quaternion, shown.delta_location = (0.7, 0.1, 0.2, 0.3), (1.0, 2.0, 3.0)
    hull.location.x = 1.0
    bpy.context.view_layer.update()
    bpy.context.view_layer.update()
    assert shown.matrix_basis == Matrix() and shown.matrix_world == hull.matrix_world
    assert "Traceback" not in capfd.readouterr().err
    hull.delta_rotation_euler = (1.0, 1.8, 2.7)
    bpy.context.view_layer.update()
    assert "has rotation or scale" in state_of(hull).status
    assert "Traceback" not in capfd.readouterr().err


def test_parents_may_move_a_hull_and_not_turn_it():
    hull = add_hull()
    before = state_of(hull).hydrostatics.values
    carrier = bpy.data.objects.new("carrier", None)
    bpy.context.collection.objects.link(carrier)
    hull.parent, carrier.location = carrier, (7.0, 0.0, 1.0)
    bpy.context.view_layer.update()
    assert state_of(hull).hydrostatics.values == before and not state_of(hull).status
    assert_shows(hull, BOX)
    carrier.rotation_euler.z = 0.5
    bpy.context.view_layer.update()
    assert 'parent "carrier"' in state_of(hull).status and "Alt P" in state_of(hull).status
    # What the message says is the remedy.
    make_active(hull)
    bpy.ops.object.parent_clear(type="CLEAR_KEEP_TRANSFORM")
    bpy.ops.object.transform_apply(location=False)
    bpy.context.view_layer.update()
    assert not state_of(hull).status


def test_a_constraint_that_turns_is_named():
    hull, target = add_hull(), bpy.data.objects.new("target", None)
    bpy.context.collection.objects.link(target)
    target.rotation_euler.x = 0.3
    hull.constraints.new("COPY_ROTATION").target = target
    bpy.context.view_layer.update()
    assert "constraint" in state_of(hull).status
    hull.constraints[0].mute = True
    bpy.context.view_layer.update()
    assert not state_of(hull).status


def test_a_hull_that_follows_itself_is_refused_at_once():
    """Blender turns it after all was told of what moved."""
    hull, other = add_hull(), add_hull("other")
    constraint = hull.constraints.new("DAMPED_TRACK")
    for target in (hull.hull.surface_object, other):
        constraint.target = target
        other.constraints.new("COPY_LOCATION").target = hull
        bpy.context.view_layer.update()
        assert "follows itself" in state_of(hull).status
    for one in other.constraints:
        one.mute = True
    bpy.context.view_layer.update()
    assert "follows itself" not in state_of(hull).status
    hull.constraints.remove(constraint)
    bpy.context.view_layer.update()
    assert not state_of(hull).status and not state_of(other).status


def test_a_hull_held_by_three_points_is_refused():
    """Upright now, it is turned when one of them moves, and Blender may tell of that too late."""
    bearer, hull, child = add_hull("bearer"), add_hull("hull"), add_hull("child")
    bearer.data.vertices.add(3)
    for vertex, place in zip(bearer.data.vertices[-3:], ((0, 0, 0), (0, 1, 0), (0, 0, 1))):
        vertex.co = place
    hull.parent, child.parent = bearer, hull
    for kind, is_refused in (("VERTEX_3", True), ("VERTEX", False), ("OBJECT", False)):
        hull.parent_type = kind
        hull.parent_vertices = [len(bearer.data.vertices) - 3 + i for i in range(3)]
        bpy.context.view_layer.update()
        for one in (hull, child):
            assert ('"hull" is turned by three points of "bearer"' in state_of(one).status) == (
                is_refused
            ), (kind, one.name)
    hull.parent_type = "VERTEX_3"
    bpy.context.view_layer.update()
    # What the message says is the remedy.
    make_active(hull)
    bpy.ops.object.parent_clear(type="CLEAR_KEEP_TRANSFORM")
    bpy.ops.object.transform_apply(location=False)
    bpy.context.view_layer.update()
    assert not state_of(hull).status


def test_a_hull_scaled_to_nothing_has_no_place_for_the_cursor(tmp_path):
    """Nor for what is elsewhere: that is a sentence, with what helps."""
    hull, words = add_hull(), '"box" is scaled to nothing in a direction: clear its scale first'
    line = bpy.data.objects.new("line", bpy.data.curves.new("line", "CURVE"))
    line.data.splines.new("POLY").points.add(1)
    bpy.context.collection.objects.link(line)
    hull.scale.y = 0.0
    bpy.context.view_layer.update()
    fields, plating = part("features.fields.field_list"), part("features.hull.plating_data")
    targets, scene = part("features.fitting.fit_targets"), bpy.context.scene
    for work in (
        lambda: part("bridge.objects.hull_objects").from_world(hull),
        lambda: fields.add(hull, scene),
        lambda: targets.shape_arrays(line, hull, 1.0),
        lambda: plating.points_of(line, hull),
        lambda: part("bridge.objects.curve_lines").points_of(line, hull),
    ):
        with pytest.raises(ValueError, match=words):
            work()
    assert not hull.hull.fields.fields
    hull.scale.y = 1.0
    bpy.context.view_layer.update()
    assert part("bridge.objects.hull_objects").from_world(hull) == Matrix()


def test_a_file_shows_a_hull_that_was_turned_by_what_is_not_in_it(tmp_path):
    """Of an object that is in no scene and turns a hull, a file has the turn alone."""
    hull = add_hull()
    target = bpy.data.objects.new("target", None)
    bpy.context.collection.objects.link(target)
    target.location = (3.0, 40.0, 7.0)
    hull.constraints.new("TRACK_TO").target = target
    bpy.context.view_layer.update()
    bpy.context.collection.objects.unlink(target)
    bpy.context.view_layer.update()
    assert "by a constraint" in state_of(hull).status
    path = str(tmp_path / "hull.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    hull = bpy.context.object
    assert hull.constraints[0].target is None
    assert state_of(hull).status == ""
    assert_shows(hull, BOX)
