# SPDX-License-Identifier: GPL-3.0-or-later
"""Developable regions of a hull in Blender: made, kept, undone, in files."""

from math import degrees

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import hull_io, part, sample


def bottom_faces(hull):
    """Faces of the planing boat's mesh between spray rail and chine."""
    state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    control, surface = state.ship.source.control, state.ship.surface
    found = []
    native = part("bridge.native").require()
    for face in range(len(control.face_ids)):
        try:
            row = native.RuledRow(surface, [face])
        except ValueError:
            continue
        ends = row.rulings(1)
        broad = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).min()
        if broad > 0.25 and np.asarray(surface.mesh.points)[row.points][:, 0].min() > 0.1:
            found.append(int(control.face_ids[face]))
    return found


def edited_boat():
    hull = sample("planing_boat")
    faces = bottom_faces(hull)
    bpy.ops.object.mode_set(mode="EDIT")
    select_faces(hull, faces)
    return hull, faces


def mesh_points(hull):
    """(n, 3) of a mesh in edit mode or not."""
    return part("bridge.mesh.mesh_points").read(hull.data)


def select_faces(hull, faces):
    bpy.context.tool_settings.mesh_select_mode = (False, False, True)
    bm = bmesh.from_edit_mesh(hull.data)
    for face in bm.faces:
        face.select_set(False)
    bm.faces.ensure_lookup_table()
    for index in faces:
        bm.faces[index].select_set(True)
    bmesh.update_edit_mesh(hull.data)


def regions(hull):
    return part("features.constraints.developables").regions(hull)


def worst(hull):
    state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    (each,) = part("features.modelling.developable_making").warps(hull, state)
    return each.warp


def test_made_and_kept_while_a_point_is_dragged():
    hull, faces = edited_boat()
    before = mesh_points(hull)
    assert bpy.ops.hull.make_developable(warp=1.5, distance=0.1) == {"FINISHED"}
    assert worst(hull) <= 1.5 * 1.001
    after = mesh_points(hull)
    moved = np.flatnonzero((after != before).any(axis=1))
    assert len(moved)
    (region,) = regions(hull)
    assert region.faces.tolist() == sorted(faces) and region.kept
    # A point of the knuckle is dragged: it stays there, others move.
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    index = int(moved[len(moved) // 2])
    place = np.array(bm.verts[index].co) + [0.0, 0.0, 0.01]
    bm.verts[index].co = place
    bmesh.update_edit_mesh(hull.data)
    state = part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)
    there = mesh_points(hull)
    np.testing.assert_allclose(there[index], place, atol=1e-6)
    native = part("bridge.native").require()
    untouched = after.copy()
    untouched[index] = place
    ids = state.ship.source.control.vertex_ids
    own = np.flatnonzero(np.isin(state.ship.source.control.face_ids, region.faces))
    row = native.RuledRow(state.ship.surface, own)
    if degrees(row.warps(untouched[ids]).max()) > 1.5:
        assert (np.delete(there, index, 0) != np.delete(after, index, 0)).any()
        assert worst(hull) <= 1.5 * 1.001 or state.keeping.held


def test_undone_as_one_step():
    hull, _ = edited_boat()
    bpy.ops.ed.undo_push(message="before")
    before = mesh_points(hull)
    bpy.ops.hull.make_developable(warp=1.5, distance=0.1)
    bpy.ops.ed.undo_push(message="made")
    bpy.ops.ed.undo()
    hull = bpy.context.object
    np.testing.assert_array_equal(mesh_points(hull), before)
    assert not regions(hull)


def test_released():
    hull, faces = edited_boat()
    bpy.ops.hull.make_developable(warp=5.0, distance=0.01)
    select_faces(hull, faces[:2])
    assert bpy.ops.hull.release_developable() == {"FINISHED"}
    assert regions(hull)[0].faces.tolist() == sorted(faces[2:])
    with pytest.raises(RuntimeError, match="of a developable region"):
        bpy.ops.hull.release_developable()


def test_in_hull_files(tmp_path):
    hull, faces = edited_boat()
    bpy.ops.hull.make_developable(warp=1.25, distance=0.03)
    bpy.ops.object.mode_set(mode="OBJECT")
    path = tmp_path / "boat.hull.json"
    bpy.ops.hull.export_hull(filepath=str(path))
    (region,) = hull_io().read_hull_file(path).developables
    assert len(region.faces) == len(faces) and region.keep
    assert (region.warp, region.distance) == pytest.approx((1.25, 0.03), rel=1e-6)
    bpy.ops.hull.import_hull(filepath=str(path))
    (again,) = regions(bpy.context.object)
    assert len(again.faces) == len(faces)
    assert (again.warp, again.distance) == pytest.approx((1.25, 0.03), rel=1e-6)


def test_faces_that_are_no_row_are_refused():
    hull = sample("coaster")
    bpy.ops.object.mode_set(mode="EDIT")
    select_faces(hull, [40])
    before = mesh_points(hull)
    with pytest.raises(RuntimeError, match="does not lie between two knuckles"):
        bpy.ops.hull.make_developable()
    np.testing.assert_array_equal(mesh_points(hull), before)
    assert not regions(hull)
