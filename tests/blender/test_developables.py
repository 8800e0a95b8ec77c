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


def row_of(hull, region):
    """(the RuledRow of a region, its control points as numbers of the mesh)."""
    state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    control = state.ship.source.control
    own = np.flatnonzero(np.isin(control.face_ids, region.faces))
    return part("bridge.native").require().RuledRow(state.ship.surface, own), control.vertex_ids


# Points of both knuckles, fore and aft, and shifts that take the warp beyond its limit.
@pytest.mark.parametrize("near, shift", [
    ((4.78, 0.83, 0.28), 0.01), ((5.25, 1.56, 0.58), 0.01), ((9.17, 0.64, 0.40), 0.01),
    ((9.49, 1.02, 0.86), 0.02), ((5.25, 1.56, 0.58), -0.02),
])  # fmt: skip
def test_made_and_kept_while_a_point_is_dragged(near, shift):
    hull, faces = edited_boat()
    before = mesh_points(hull)
    assert bpy.ops.hull.make_developable(warp=1.5, distance=0.1) == {"FINISHED"}
    assert worst(hull) <= 1.5 * 1.001
    after = mesh_points(hull)
    assert (after != before).any()
    (region,) = regions(hull)
    assert region.faces.tolist() == sorted(faces) and region.kept
    # A point of the knuckle is dragged: left alone the row would have too much warp.
    row, ids = row_of(hull, region)
    own = ids[row.points]
    index = int(own[np.linalg.norm(after[own] - near, axis=1).argmin()])
    place = after[index] + [0.0, 0.0, shift]
    untouched = after.copy()
    untouched[index] = place
    assert degrees(row.warps(untouched[ids]).max()) > 1.5 * 1.1
    # It stays where it is put, and others move until that is as it was asked for.
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bm.verts[index].co = place
    bmesh.update_edit_mesh(hull.data)
    part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)
    there = mesh_points(hull)
    np.testing.assert_allclose(there[index], place, atol=1e-6)
    others = np.setdiff1d(own, [index])
    assert (there[others] != after[others]).any()
    elsewhere = np.setdiff1d(np.arange(len(there)), own)
    np.testing.assert_array_equal(there[elsewhere], after[elsewhere])
    assert worst(hull) <= 1.5 * 1.001


def test_points_with_other_numbers_have_not_moved_and_the_next_move_is_answered():
    hull, _ = edited_boat()
    assert bpy.ops.hull.make_developable(warp=1.5, distance=0.1) == {"FINISHED"}
    bpy.context.view_layer.update()
    before = mesh_points(hull)
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.sort_elements(type="REVERSE", elements={"VERT"})
    bpy.context.view_layer.update()
    np.testing.assert_array_equal(mesh_points(hull), before[::-1])
    (region,) = regions(hull)
    row, ids = row_of(hull, region)
    own = ids[row.points]
    after = mesh_points(hull)
    index = int(own[np.linalg.norm(after[own] - (9.49, 1.02, 0.86), axis=1).argmin()])
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bm.verts[index].co.z += 0.02
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()
    there = mesh_points(hull)
    others = np.setdiff1d(own, [index])
    assert (there[others] != after[others]).any()
    assert worst(hull) <= 1.5 * 1.001


def drawn_rulings(hull):
    """{colour's name: segments (k, 2, 2)} of what the switch of rulings adds to the picture of a
    hull, seen along z at a twentieth of its size."""
    scene, drawing = bpy.context.scene, part("overlays.tag_drawing")
    state = part("features.hull.hull_state").refresh(hull, scene)
    view = np.diag([0.05, 0.05, 0.01, 1.0])
    picture = drawing.Picture(view, (1000, 1000), 1.0, 1.0)
    names = {tuple(c): n for n, c in part("bridge.blender.preferences").colours("tags").items()}
    for name in hull.hull.tags.bl_rna.properties.keys():
        if name.startswith("show_"):
            setattr(hull.hull.tags, name, name == "show_developables")
    found = {}
    for colour, _, corners in drawing.drawing_of(hull, state, scene, picture).lines:
        ends = np.asarray(corners).reshape(-1, 2, 3)[:, :, :2]
        found[names[tuple(colour)]] = ends / 0.05
    hull.hull.tags.show_developables = False
    assert not drawing.drawing_of(hull, state, scene, picture).lines
    return found


def test_rulings_are_drawn_and_those_with_too_much_warp_in_red():
    hull, faces = edited_boat()
    assert bpy.ops.hull.make_developable(warp=1.5, distance=0.1) == {"FINISHED"}
    drawn = drawn_rulings(hull)
    assert set(drawn) == {"flat"}
    # Those of the exact strip: straight lines between the knuckles' curves.
    (region,) = regions(hull)
    row, _ = row_of(hull, region)
    rulings = row.rulings(3)
    assert len(rulings) == 4 * len(faces)
    np.testing.assert_allclose(drawn["flat"], rulings[:, :, :2], atol=1e-5)
    state = part("features.hull.hull_state").state_of(hull)
    tree = part("bridge.native").require().SurfaceTree(state.ship.surface)
    for share in (0.0, 0.3, 1.0):
        between = (1.0 - share) * rulings[:, 0] + share * rulings[:, 1]
        np.testing.assert_allclose(tree.closest_points(between).distances, 0.0, atol=1e-9)
    # A limit between the least and the largest warp of its faces divides them.
    warps = np.degrees(row.warps())
    limit = 0.5 * (warps.min() + warps.max())
    entry = hull.hull.developables[0]
    entry.kept, entry.warp = False, limit
    drawn = drawn_rulings(hull)
    over = 4 * int((warps > limit).sum())
    assert 0 < over < len(rulings)
    assert {name: len(ends) for name, ends in drawn.items()} == {
        "problem": over,
        "flat": len(rulings) - over,
    }


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
