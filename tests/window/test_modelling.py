# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's own tools of edit mode, that change the mesh while the mouse moves: the ship follows,
also through meshes that are no surface for a while."""

import bmesh
import bpy
import numpy as np
from addon_under_test import mesh_points, state_of
from editing import bilge_point, editing_a_hull, hull_at_hand, select
from expect import are_equal, assert_follows, edited_points, snapshot
from mathutils import Vector


def edges_of(hull):
    """Pairs (index, edge) of edges within the hull, those along it from amidships first."""
    middle = 0.5 * max(hull.dimensions)
    edges = [edge for edge in bmesh.from_edit_mesh(hull.data).edges if len(edge.link_faces) == 2]

    def far(edge):
        a, b = (vertex.co for vertex in edge.verts)
        return abs(0.5 * (a.x + b.x) - middle) - abs(a.x - b.x) - a.y - b.y

    return sorted(edges, key=far)


def test_a_loop_cut_follows_while_it_slides(window):
    hull = editing_a_hull(window)
    edge = edges_of(hull)[0]
    place = sum((vertex.co for vertex in edge.verts), Vector()) / 2.0
    before = snapshot(hull)
    window.move_to_point(hull, place)
    window.press("R", ctrl=True)
    window.move_by(2, 0)
    window.click()
    yield
    assert len(edited_points(hull)) > len(before["points"])
    assert_follows(hull)
    held = snapshot(hull)
    window.move_by(12, 0)
    yield
    assert not are_equal(snapshot(hull), held)
    assert_follows(hull)
    window.click()
    yield
    assert_follows(hull)
    window.undo()
    yield
    assert are_equal(snapshot(hull_at_hand()), before)
    assert_follows(hull_at_hand())


def test_a_mesh_that_is_no_surface_keeps_the_last_one(window):
    hull = editing_a_hull(window, "EDGE")
    select(hull, edges_of(hull)[0].index, kind="edges")
    yield
    before, shown = snapshot(hull), mesh_points(hull.hull.surface_object)
    # Extruded from within, the edge has three faces.
    window.press("E")
    window.move_by(10, 40)
    yield
    assert "edge" in state_of(hull).status.lower()
    assert np.array_equal(mesh_points(hull.hull.surface_object), shown)
    window.click()
    yield
    assert state_of(hull).status
    assert np.array_equal(mesh_points(hull.hull.surface_object), shown)
    window.undo()
    yield
    hull = hull_at_hand()
    assert not state_of(hull).status and are_equal(snapshot(hull), before)
    assert_follows(hull)


def test_a_mesh_is_mended_by_hand(window):
    hull = editing_a_hull(window, "EDGE")
    select(hull, edges_of(hull)[0].index, kind="edges")
    yield
    count = len(edited_points(hull))
    window.press("E")
    window.move_by(10, 40)
    window.click()
    yield
    assert state_of(hull).status
    # What was extruded is selected still: its points go.
    window.press("X")
    yield
    window.press("V")
    yield
    assert len(edited_points(hull)) == count
    assert not state_of(hull).status
    assert_follows(hull)


def test_proportional_editing_moves_many_points(window):
    hull = editing_a_hull(window)
    select(hull, bilge_point(hull)[0])
    bpy.context.scene.tool_settings.proportional_size = 20.0
    window.press("O")
    yield
    before = edited_points(hull)
    window.press("G")
    window.press("Z")
    window.move_by(0, 10)
    yield
    assert_follows(hull)
    window.click()
    yield
    assert np.count_nonzero(np.any(edited_points(hull) != before, axis=1)) > 5
    assert_follows(hull)
    window.press("O")
    yield
    assert not bpy.context.scene.tool_settings.use_proportional_edit


def test_rotate_and_scale_follow(window):
    hull = editing_a_hull(window)
    points = edited_points(hull)
    select(hull, *np.flatnonzero(points[:, 0] > np.quantile(points[:, 0], 0.8)))
    yield
    for key, number in (("S", "1.1"), ("R", "3")):
        last = snapshot(hull)
        window.press(key)
        window.press("Z" if key == "S" else "Y")
        window.write(number)
        yield
        assert not are_equal(snapshot(hull), last)
        assert_follows(hull)
        window.press("RET")
        yield
        assert_follows(hull)
    window.undo()
    window.undo()
    yield
    assert np.array_equal(edited_points(hull_at_hand()), points)
    assert_follows(hull_at_hand())
