# SPDX-License-Identifier: GPL-3.0-or-later
"""Surface, lines and numbers follow the control mesh, and show exactly the native surface."""

import random

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import LENGTH, add_hull, fresh_surface_points, mesh_points, part, state_of


def assert_surface_is_fresh(hull):
    # Blender keeps points in single precision.
    shown, wanted = mesh_points(hull.hull.surface_object), fresh_surface_points(hull)
    assert shown.shape == wanted.shape
    assert np.abs(shown - wanted).max() <= 1e-6 * LENGTH


def test_the_surface_follows_in_object_mode():
    hull = add_hull()
    for vertex in hull.data.vertices:
        vertex.co.z *= 2.0
    hull.data.update()
    bpy.context.view_layer.update()
    assert mesh_points(hull.hull.surface_object)[:, 2].max() == pytest.approx(6.0)
    assert_surface_is_fresh(hull)


def test_surface_lines_and_numbers_follow_in_edit_mode():
    hull = add_hull()
    before = state_of(hull).hydrostatics.values.displaced_volume
    buttocks_before = state_of(hull).lines.groups["buttock"].cut_count
    bpy.ops.object.mode_set(mode="EDIT")
    bm = bmesh.from_edit_mesh(hull.data)
    for vertex in bm.verts:
        vertex.co.y *= 1.5
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()
    assert_surface_is_fresh(hull)
    assert state_of(hull).hydrostatics.values.displaced_volume == pytest.approx(1.5 * before)
    assert state_of(hull).lines.groups["buttock"].cut_count > buttocks_before


def test_a_tag_changes_the_surface():
    hull = add_hull()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    before = mesh_points(hull.hull.surface_object)
    bpy.ops.hull.tag_smooth()
    bpy.context.view_layer.update()
    assert np.abs(mesh_points(hull.hull.surface_object) - before).max() > 0.1
    assert_surface_is_fresh(hull)


def test_edit_mode_reads_the_same_arrays_as_object_mode():
    hull = add_hull()
    read_mesh = part("bridge.mesh.mesh_arrays").read_mesh
    stored = read_mesh(hull.data)
    bpy.ops.object.mode_set(mode="EDIT")
    edited = read_mesh(hull.data)
    assert stored.topology_digest() == edited.topology_digest()
    assert stored.points_digest() == edited.points_digest()


def test_undo_brings_the_surface_back():
    hull = add_hull()
    before = mesh_points(hull.hull.surface_object)
    bpy.ops.ed.undo_push(message="before")
    for vertex in hull.data.vertices:
        vertex.co.x *= 1.5
    hull.data.update()
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="after")
    bpy.ops.ed.undo()
    hull = bpy.data.objects["box"]
    assert np.array_equal(mesh_points(hull.hull.surface_object), before)
    assert state_of(hull).hydrostatics.values.lcb == pytest.approx(LENGTH / 2)
    bpy.ops.ed.redo()
    assert state_of(bpy.data.objects["box"]).hydrostatics.values.lcb == pytest.approx(0.75 * LENGTH)


def test_settings_made_by_a_script_are_followed():
    hull = add_hull()
    hull.hull.samples = 2
    hull.hull.lines.station_count = 5
    hull.hull.lines.waterline_spacing = 0.0
    bpy.context.view_layer.update()
    assert len(hull.hull.surface_object.data.polygons) == 2 * 16 * 4
    lines = state_of(hull).lines.groups
    assert lines["station"].cut_count == 6 and lines["waterline"].cut_count == 0


def test_a_mesh_with_errors_leaves_the_last_surface():
    hull = add_hull()
    before = mesh_points(hull.hull.surface_object)
    bpy.ops.object.mode_set(mode="EDIT")
    bm = bmesh.from_edit_mesh(hull.data)
    far = bm.verts.new((5.0, 4.0, 0.0))
    bm.verts.ensure_lookup_table()
    bm.faces.new((bm.verts[2], bm.verts[6], far))
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()
    assert state_of(hull).status
    assert np.array_equal(mesh_points(hull.hull.surface_object), before)
    bm.verts.ensure_lookup_table()
    bm.verts.remove(bm.verts[8])
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()
    assert not state_of(hull).status


def test_nothing_is_done_when_nothing_changed(monkeypatch):
    hull = add_hull()
    bpy.context.view_layer.update()
    written = []
    monkeypatch.setattr(
        part("features.surface.surface_mesh"),
        "move_surface",
        lambda *arguments: written.append(1),
    )
    hull.data.update_tag()
    bpy.context.view_layer.update()
    assert not written
    hull.data.vertices[0].co.x -= 1.0
    hull.data.update_tag()
    bpy.context.view_layer.update()
    assert written == [1]


def test_normals_are_the_surface_normals():
    hull = add_hull()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.hull.tag_smooth()
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    tessellation = state_of(hull).ship.surface.tessellate(hull.hull.samples)
    surface_mesh = part("features.surface.surface_mesh")
    shared = state_of(hull).shown.points.shared
    normals = surface_mesh.surface_faces(tessellation, shared)[1].reshape(-1, 3)
    mesh = hull.hull.surface_object.data
    if hasattr(mesh, "calc_normals_split"):
        mesh.calc_normals_split()
    shown = np.empty((len(mesh.loops), 3), dtype=np.float32)
    mesh.loops.foreach_get("normal", shown.reshape(-1))
    # Blender stores a custom normal as two 16-bit angles.
    assert np.abs(shown - normals).max() < 2e-3


def test_the_mirrored_half_closes_the_surface():
    hull = add_hull()
    surface = hull.hull.surface_object.data
    points = mesh_points(hull.hull.surface_object)
    on_plane = points[:, 1] == 0.0
    assert np.count_nonzero(points[:, 1] > 0.0) == np.count_nonzero(points[:, 1] < 0.0)
    faces_of_edge = {}
    for polygon in surface.polygons:
        for key in polygon.edge_keys:
            faces_of_edge[key] = faces_of_edge.get(key, 0) + 1
    keel = [n for (a, b), n in faces_of_edge.items() if on_plane[a] and on_plane[b]]
    assert keel and set(keel) == {2}


def pull_a_point(hull, by):
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bm.verts[3].co.y += by
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()


def test_normals_wait_while_points_move_and_come_at_a_pause(monkeypatch):
    hull = add_hull()
    surface_mesh, written = part("features.surface.surface_mesh"), []
    write = surface_mesh.write_normals
    monkeypatch.setattr(surface_mesh, "write_normals", lambda *a: (written.append(1), write(*a)))
    bpy.ops.object.mode_set(mode="EDIT")
    for _ in range(3):
        pull_a_point(hull, 0.1)
    assert not written
    part("features.hull.live_normals")._write()
    assert written == [1]
    part("features.hull.live_normals")._write()
    assert written == [1], "they are there"
    bpy.context.view_layer.update()
    assert_surface_is_fresh(hull)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    assert written == [1], "nothing has moved since"


def test_a_surface_that_is_hidden_waits_until_it_is_seen():
    hull = add_hull()
    shown = hull.hull.surface_object
    bpy.ops.object.mode_set(mode="EDIT")
    shown.hide_render = True
    shown.hide_set(True)
    before = mesh_points(shown)
    pull_a_point(hull, 0.5)
    assert np.array_equal(mesh_points(shown), before)
    assert state_of(hull).hydrostatics.values.displaced_volume > 0.0
    shown.hide_set(False)
    bpy.context.view_layer.update()
    assert_surface_is_fresh(hull)
    shown.hide_set(True)
    pull_a_point(hull, 0.5)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    assert_surface_is_fresh(hull)


def test_only_what_moved_is_computed_and_it_is_all_that_moved():
    """A fan of moves here and there, in edit mode, with images that come and go at the keel."""
    hull = add_hull()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide(number_cuts=3)
    bpy.context.view_layer.update()
    choice = random.Random(5)
    for step in range(30):
        bm = bmesh.from_edit_mesh(hull.data)
        vertex = choice.choice(list(bm.verts))
        vertex.co.x += choice.gauss(0.0, 0.1)
        vertex.co.z += choice.gauss(0.0, 0.1)
        if step % 5 == 0:
            vertex.co.y += 0.1
        bmesh.update_edit_mesh(hull.data)
        bpy.context.view_layer.update()
        assert_surface_is_fresh(hull)


@pytest.fixture
def counted(monkeypatch):
    """How often each step was taken for all hulls, by its name."""
    counts = {}

    def count(owner, name):
        original = getattr(owner, name)

        def step(*arguments):
            counts[name] = counts.get(name, 0) + 1
            return original(*arguments)

        monkeypatch.setattr(owner, name, step)

    arrays = part("bridge.mesh.mesh_arrays")
    count(arrays, "read_mesh")
    count(arrays.MeshData, "topology_digest")
    count(arrays.MeshData, "points_digest")
    count(part("bridge.objects.hull_objects"), "refusal")
    count(part("features.constraints.flat_keeping"), "keep")
    count(part("features.surface.surface_mesh"), "move_surface")
    count(part("features.flotation.hydrostatics"), "computed")
    count(part("features.lines.lines"), "groups")
    count(part("features.fairness.combs"), "combs")
    return counts


def test_each_step_is_taken_once_for_a_point_that_moves(counted):
    hull = add_hull()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.view_layer.update()
    pull_a_point(hull, 0.1)
    counted.clear()
    pull_a_point(hull, 0.1)
    assert set(counted.values()) == {1} and len(counted) == 9, counted


def test_only_what_follows_an_edit_writes_the_mesh():
    hull, hull_state, scene = add_hull(), part("features.hull.hull_state"), bpy.context.scene
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.view_layer.update()

    def beside_centre():
        bm = bmesh.from_edit_mesh(hull.data)
        bm.verts.ensure_lookup_table()
        return bm.verts[0].co

    beside_centre().y = 0.5
    assert not hull_state.follow_edit(hull, scene).status
    assert beside_centre().y == 0.0 and "centre" in state_of(hull).keeping.held
    beside_centre().y = 0.5
    hull_state.refresh(hull, scene)
    assert beside_centre().y == 0.5
    hull_state.follow_edit(hull, scene)
    assert beside_centre().y == 0.5, "known to be there"
    beside_centre().y = 0.0
    hull_state.follow_edit(hull, scene)
    beside_centre().y = 0.5
    hull_state.follow_edit(hull, scene, False)
    assert beside_centre().y == 0.5 and not state_of(hull).keeping.held


def test_what_later_subjects_keep_is_theirs():
    class Mine:
        pass

    first, second = add_hull(), add_hull("second")
    assert state_of(first).of(Mine) is state_of(first).of(Mine)
    assert state_of(first).of(Mine) is not state_of(second).of(Mine)


def test_a_hull_without_a_surface_is_refused_with_the_reason():
    hull, hull_state = add_hull(), part("features.hull.hull_state")
    scene = bpy.context.scene
    assert hull_state.up_to_date(hull, scene) is state_of(hull)
    hull.scale = (2.0, 1.0, 1.0)
    with pytest.raises(ValueError, match="Ctrl A"):
        hull_state.up_to_date(hull, scene)
    hull.scale = (1.0, 1.0, 1.0)
    assert hull_state.up_to_date(hull, scene).status == ""
