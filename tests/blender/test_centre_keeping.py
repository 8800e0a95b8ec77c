# SPDX-License-Identifier: GPL-3.0-or-later
"""Points of a half hull stay on the centre plane while they are moved in edit mode."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import part, state_of


@pytest.fixture
def hull():
    bpy.ops.hull.add_hull(kind="ROUND_BILGE")
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.view_layer.update()
    return bpy.context.object


def points(hull):
    return part("bridge.mesh.mesh_arrays").read_mesh(hull.data).points


def move(hull, indices, by):
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    for index in indices:
        for axis in range(3):
            bm.verts[index].co[axis] += by[axis]
    bmesh.update_edit_mesh(hull.data, loop_triangles=False, destructive=False)
    bpy.context.view_layer.update()


def on_centre(hull):
    return np.flatnonzero(points(hull)[:, 1] == 0.0)


def test_a_point_slides_in_the_centre_plane(hull):
    before = points(hull)
    index = int(np.argmax(before[:, 0]))
    move(hull, [index], (0.5, 0.25, -0.125))
    after = points(hull)
    assert after[index] == pytest.approx(before[index] + (0.5, 0.0, -0.125))
    assert np.array_equal(np.delete(after, index, 0), np.delete(before, index, 0))
    assert "centre plane" in state_of(hull).keeping.held
    # The surface has the point where it is now.
    shown = state_of(hull).ship.source.control.points
    assert np.array_equal(shown, after)
    inside = next(v.index for v in bmesh.from_edit_mesh(hull.data).verts if 1.0 < v.co.y < 5.0)
    move(hull, [inside], (0.0, 0.1, 0.1))
    assert state_of(hull).keeping.held == ""


def test_all_of_the_centre_stays_when_the_hull_is_scaled(hull):
    centre = on_centre(hull)
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.transform.resize(value=(1.0, 0.8, 1.0))
    bpy.context.view_layer.update()
    assert np.array_equal(on_centre(hull), centre)
    assert points(hull)[:, 1].max() > 5.0


def test_switched_off_points_go_where_they_like(hull):
    hull.hull.keep_centre = False
    index = on_centre(hull)[5]
    move(hull, [index], (0.0, 0.25, 0.0))
    assert points(hull)[index, 1] == 0.25
    hull.hull.keep_centre = True
    move(hull, [index], (0.0, 0.25, 0.0))
    assert points(hull)[index, 1] == 0.5


def test_whole_hulls_and_other_meshes_are_left_alone(hull):
    hull.hull.half = False
    index = on_centre(hull)[5]
    move(hull, [index], (0.0, 0.25, 0.0))
    assert points(hull)[index, 1] == 0.25


def test_points_off_the_border_are_left_alone(hull):
    """A point of the inside that happens to be at y = 0 is no place where the halves join."""
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    index = next(v.index for v in bm.verts if not v.is_boundary and 0.0 < v.co.y < 5.0)
    there = points(hull)[index, 1]
    hull.hull.keep_centre = False
    move(hull, [index], (0.0, -there, 0.0))
    hull.hull.keep_centre = True
    assert points(hull)[index, 1] == 0.0
    move(hull, [index], (0.0, 1.0, 0.0))
    assert points(hull)[index, 1] == 1.0


def test_extruded_from_the_centre(hull):
    """The edges of the keel, extruded, go to port as they are pulled."""
    bpy.ops.mesh.select_all(action="DESELECT")
    bm = bmesh.from_edit_mesh(hull.data)
    chosen = [e for e in bm.edges if e.is_boundary and all(v.co.y == 0.0 for v in e.verts)][:3]
    for edge in chosen:
        edge.select_set(True)
    bm.select_flush_mode()
    bmesh.update_edit_mesh(hull.data)
    count = len(points(hull))
    centre = len(on_centre(hull))
    bpy.ops.mesh.extrude_edges_indiv()
    bpy.context.view_layer.update()
    new = np.arange(count, len(points(hull)))
    assert len(new) and (points(hull)[new, 1] == 0.0).all()
    move(hull, new, (0.0, 2.0, -1.0))
    assert (points(hull)[new, 1] == 2.0).all() and len(on_centre(hull)) == centre


def test_numbers_that_are_typed_are_meant(hull):
    index = int(np.argmax(points(hull)[:, 0]))
    bpy.ops.mesh.select_all(action="DESELECT")
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bm.verts[index].select_set(True)
    bm.select_flush_mode()
    bmesh.update_edit_mesh(hull.data)
    bpy.ops.hull.put_in_plane(plane="BUTTOCK", place="POSITION", position=0.5)
    bpy.context.view_layer.update()
    assert points(hull)[index, 1] == 0.5
    bpy.ops.hull.put_in_plane(plane="BUTTOCK", place="POSITION", position=0.0)
    bpy.context.view_layer.update()
    move(hull, [index], (0.0, 0.5, 0.0))
    assert points(hull)[index, 1] == 0.0


def test_flats_hold_before_the_centre(hull):
    """A point at the rim of a flat side is moved with it, on the centre plane as it is."""
    own = next(
        r.points for r in part("features.constraints.flats").regions(hull) if r.kind == "SIDE"
    )
    move(hull, own, (0.0, -6.5, 0.0))
    assert (points(hull)[own, 1] == 0.0).all()
    move(hull, own, (0.0, 6.5, 0.0))
    assert (points(hull)[own, 1] == 6.5).all()


def test_undo_is_not_an_edit(hull):
    bpy.ops.ed.undo_push(message="begin")
    index = int(on_centre(hull)[5])
    hull.hull.keep_centre = False
    move(hull, [index], (0.0, 0.25, 0.0))
    bpy.ops.ed.undo_push(message="off")
    move(hull, [index], (0.0, -0.25, 0.0))
    bpy.context.object.hull.keep_centre = True
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="on")
    bpy.ops.ed.undo()
    hull = bpy.context.object
    bpy.context.view_layer.update()
    assert points(hull)[index, 1] == 0.25
    bpy.ops.ed.redo()
    bpy.context.view_layer.update()
    assert points(bpy.context.object)[index, 1] == 0.0


def shift(hull, index, y):
    """Puts a point beside the centre plane in object mode, as a file may have it."""
    bpy.ops.object.mode_set(mode="OBJECT")
    hull.data.vertices[index].co.y = y
    hull.data.update()
    bpy.context.view_layer.update()
    bpy.ops.object.mode_set(mode="EDIT")


def test_points_off_by_rounding_are_on_it_and_stay(hull):
    index = int(on_centre(hull)[5])
    shift(hull, index, 1e-5)
    assert not state_of(hull).ship.check.problems
    move(hull, [index], (0.25, 0.5, 0.0))
    assert points(hull)[index, 1] == 0.0


def test_points_near_it_are_told(hull):
    index = int(on_centre(hull)[5])
    shift(hull, index, 0.002)
    (problem,) = state_of(hull).ship.check.problems
    assert problem.elements == (index,)
    assert "1 point of the centre line off the centre plane, by up to 2 mm" in problem.message
    assert bpy.ops.hull.put_on_centre_plane() == {"FINISHED"}
    assert points(hull)[index, 1] == 0.0
    assert not state_of(hull).ship.check.problems
    shift(hull, index, 0.5)
    assert not state_of(hull).ship.check.problems


def test_all_that_share_the_mesh_follow_what_is_kept(hull):
    """Though one of them keeps nothing, and is followed first."""
    other = hull.copy()
    bpy.context.scene.collection.objects.link(other)
    other.hull.keep_centre, other.hull.surface_object = False, None
    bpy.context.view_layer.update()
    index = int(np.argmax(points(hull)[:, 0]))
    place = points(hull)[index] + (0.5, 0.25, -0.125)
    part("bridge.mesh.mesh_points").write(hull.data, [index], [place])
    follow = part("handlers.follow")._follow
    follow([other, hull], bpy.context.scene, bpy.context.view_layer)
    assert points(hull)[index] == pytest.approx(place * (1.0, 0.0, 1.0))
    for each in (hull, other):
        assert np.array_equal(state_of(each).ship.source.control.points, points(hull))
    bpy.data.objects.remove(other)
