# SPDX-License-Identifier: GPL-3.0-or-later
"""A point is dragged in the view, and those that are tied to it go along; Esc and undo take it
back."""

import bmesh
import bpy
import numpy as np
from addon_under_test import part
from editing import editing_a_bilge_point, hull_at_hand, select
from expect import are_equal, assert_follows, edited_points, snapshot


def test_an_anchored_point_goes_along(window):
    hull, leader, _ = editing_a_bilge_point(window)
    points = edited_points(hull)
    others = np.argsort(np.linalg.norm(points - points[leader], axis=1))
    follower = int(next(i for i in others if i != leader and points[i, 1] > 1.0))
    bpy.ops.mesh.select_all(action="DESELECT")
    select(hull, follower)
    yield
    select(hull, leader)
    with window.in_view():
        bm = bmesh.from_edit_mesh(hull.data)
        bm.verts.ensure_lookup_table()
        bm.select_history.clear()
        bm.select_history.add(bm.verts[leader])
        assert bpy.ops.hull.tie_points("EXEC_DEFAULT", True, kind="ANCHOR") == {"FINISHED"}
    bpy.ops.ed.undo_push(message="tie")
    bpy.ops.mesh.select_all(action="DESELECT")
    select(hull, leader)
    before, shown = edited_points(hull), snapshot(hull)
    way = before[follower] - before[leader]
    yield
    window.press("G")
    for _ in range(3):
        window.move_by(12, 15)
        yield
        now = edited_points(hull)
        assert np.abs(now[leader] - before[leader]).max() > 0.01
        assert np.abs(now[follower] - now[leader] - way).max() < 1e-5
        assert_follows(hull)
    window.press("ESC")
    yield
    assert np.abs(edited_points(hull) - before).max() < 1e-5
    window.press("G")
    window.move_by(20, 30)
    window.click()
    yield
    after = edited_points(hull)
    assert np.abs(after[follower] - after[leader] - way).max() < 1e-5
    assert np.abs(after[leader] - before[leader]).max() > 0.01
    assert_follows(hull)
    window.undo()
    yield
    assert are_equal(snapshot(hull_at_hand()), shown)


def test_one_that_is_tied_stays(window):
    hull, follower, _ = editing_a_bilge_point(window)
    points = edited_points(hull)
    others = np.argsort(np.linalg.norm(points - points[follower], axis=1))
    leader = int(next(i for i in others if i != follower and points[i, 1] > 1.0))
    ties = part("features.constraints.ties")
    ties.tie_points(hull, 1, np.array([follower]), np.array([(leader, leader)]))
    bpy.context.view_layer.update()
    before = edited_points(hull)
    yield
    window.press("G")
    window.move_by(12, 15)
    yield
    assert np.abs(edited_points(hull) - before).max() < 1e-5
    window.click()
    yield
    assert np.abs(edited_points(hull) - before).max() < 1e-5
    assert_follows(hull)
