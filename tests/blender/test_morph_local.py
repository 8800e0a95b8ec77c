# SPDX-License-Identifier: GPL-3.0-or-later
"""Parents that count alone around shape fields: the bow of one, the stern of another."""

import bpy
import numpy as np
import pytest
from addon_under_test import LENGTH, mesh_points, part, state_of
from expect_morph import boxes, exact_member, morph_of, set_weight


def finer(hull):
    bpy.context.view_layer.objects.active = hull
    assert bpy.ops.hull.subdivide_exactly() == {"FINISHED"}


def family():
    """Of boxes of some points, the second one broader."""
    hulls = boxes((1.0, 1.0, 1.0), (1.0, 1.5, 1.0))
    for hull in hulls:
        for _ in range(2):
            finer(hull)
    return morph_of(*hulls)


def with_bow(made, extent=3.0):
    """The bow of the second, by a plane through the fore end."""
    bpy.ops.hull.add_field(base="PLANE")
    field = made.hull.fields.fields[-1]
    field.name, field.axis, field.place, field.extent = "Bow", "X", (LENGTH, 0.0, 0.0), extent
    made.hull.morph.active_parent = 1
    assert bpy.ops.hull.add_local_parent() == {"FINISHED"}
    bpy.context.view_layer.update()
    return field


def assert_local(made):
    state = state_of(made)
    assert not state.status and part("features.morphing.members").told(made).problem == ""
    assert part("features.morphing.members").is_of_family(made)


def test_the_bow_of_one_and_the_stern_of_another():
    made = family()
    set_weight(made, 0, 1.0)
    first, second = exact_member(made, [1.0, 0.0]), exact_member(made, [0.0, 1.0])
    with_bow(made)
    points = mesh_points(made)
    fore, aft = first[:, 0] > LENGTH - 1e-3, first[:, 0] < LENGTH - 3.5
    assert fore.any() and aft.any()
    assert np.array_equal(points[aft], first[aft])
    assert np.abs(points[fore] - second[fore]).max() < 1e-6
    between = (points[:, 1] - first[:, 1])[~fore & ~aft]
    assert (between > 1e-3).any() and (between < (second - first)[:, 1].max()).all()
    assert_local(made)


def test_it_follows_field_and_weights():
    made = family()
    field = with_bow(made)
    before = mesh_points(made)
    field.extent = 8.0
    bpy.context.view_layer.update()
    wider = mesh_points(made)
    assert not np.array_equal(before, wider)
    assert_local(made)
    set_weight(made, 0, 0.9)
    assert not np.array_equal(wider, mesh_points(made))
    assert_local(made)
    assert bpy.ops.hull.remove_local_parent() == {"FINISHED"}
    bpy.context.view_layer.update()
    assert np.array_equal(mesh_points(made), exact_member(made, [0.9, 0.1]))
    assert_local(made)


def test_undo_and_redo_of_field_and_row():
    made = family()
    bpy.ops.ed.undo_push(message="morph")
    whole = mesh_points(made)
    field = with_bow(made)
    bpy.ops.ed.undo_push(message="bow")
    bow, name = mesh_points(made), made.name
    field.extent = 8.0
    bpy.ops.ed.undo_push(message="extent")  # before what follows it, as in the window
    bpy.context.view_layer.update()
    wider = mesh_points(made)
    bpy.ops.ed.undo()
    assert np.array_equal(mesh_points(bpy.data.objects[name]), bow)
    bpy.ops.ed.redo()
    assert np.array_equal(mesh_points(bpy.data.objects[name]), wider)
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    made = bpy.data.objects[name]
    assert np.array_equal(mesh_points(made), whole)
    assert_local(made)


def test_what_has_no_meaning_is_told():
    made = family()
    with pytest.raises(RuntimeError, match="Add a field"):
        bpy.ops.hull.add_local_parent()
    with_bow(made)
    points = mesh_points(made)
    made.hull.fields.fields[0].name = "Stern"
    made.update_tag(refresh={"DATA"})  # as the window does by itself
    bpy.context.view_layer.update()
    told = part("features.morphing.members").told(made)
    assert 'no field "Bow"' in told.problem and np.array_equal(mesh_points(made), points)
    made.hull.morph.local[0].field, made.hull.morph.local[0].parent = "Stern", "nobody"
    bpy.context.view_layer.update()
    assert 'no parent "nobody"' in told.problem
    made.hull.morph.local[0].parent = made.hull.morph.parents[1].name
    bpy.context.view_layer.update()
    assert told.problem == ""
    bpy.ops.hull.add_target()
    with pytest.raises(RuntimeError, match="local parents"):
        bpy.ops.hull.find_weights()


def test_series_have_local_parents_too(tmp_path):
    made = family()
    with_bow(made)
    series = part("features.morphing.series").of_hull(made, bpy.context.scene, steps=4)
    for step in series.steps:
        bpy.ops.hull.set_weights(weights=" ".join(map(repr, step.weights)))
        found = (series.points(step)).astype(np.float32)
        assert np.array_equal(found, mesh_points(made))
