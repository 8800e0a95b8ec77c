# SPDX-License-Identifier: GPL-3.0-or-later
"""Tags from the pie menu, from context menus and from the search, as a person gives them."""

import bmesh
import bpy
import numpy as np
from addon_under_test import part
from editing import editing_a_hull, hull_at_hand, select
from expect import are_equal, assert_follows, edited_points, snapshot

# Where the mouse goes in the pie menu.
LEFT, RIGHT, DOWN, UP = (-120, 0), (120, 0), (0, -120), (0, 120)


def crease_values(hull):
    bm = bmesh.from_edit_mesh(hull.data)
    layer, _ = part("bridge.blender.blender_versions").find_crease_layers(bm)
    return np.array([edge[layer] if layer else 0.0 for edge in bm.edges])


def corner_values(hull):
    bm = bmesh.from_edit_mesh(hull.data)
    _, layer = part("bridge.blender.blender_versions").find_crease_layers(bm)
    return np.array([vertex[layer] if layer else 0.0 for vertex in bm.verts])


def smooth_edges_within(hull, count):
    """Indices of some edges between faces that are no creases, the first ones from amidships."""
    points, creases = edited_points(hull), crease_values(hull)
    middle = 0.5 * (points[:, 0].min() + points[:, 0].max())
    bm = bmesh.from_edit_mesh(hull.data)
    inner = [e for e in bm.edges if len(e.link_faces) == 2 and not creases[e.index]]
    inner.sort(key=lambda edge: abs(edge.verts[0].co.x - middle))
    return [edge.index for edge in inner[:count]]


def test_a_knuckle_from_the_pie_menu_and_back(window):
    hull = editing_a_hull(window, "EDGE")
    edges = smooth_edges_within(hull, 3)
    select(hull, *edges, kind="edges")
    yield
    before = snapshot(hull)
    window.pie("Q", *LEFT, shift=True)
    yield
    assert (crease_values(hull)[edges] == 1.0).all()
    tagged = snapshot(hull)
    assert not are_equal(tagged, before)
    assert_follows(hull)
    window.undo()
    yield
    hull = hull_at_hand()
    assert (crease_values(hull)[edges] == 0.0).all()
    assert are_equal(snapshot(hull), before)
    window.redo()
    yield
    hull = hull_at_hand()
    assert are_equal(snapshot(hull), tagged)
    window.pie("Q", *RIGHT, shift=True)
    yield
    assert (crease_values(hull)[edges] == 0.0).all()
    assert are_equal(snapshot(hull), before)
    assert_follows(hull)


def test_a_corner_from_the_pie_menu_and_back(window):
    hull = editing_a_hull(window)
    index = int(edited_points(hull)[:, 1].argmax())
    select(hull, index)
    yield
    before = snapshot(hull)
    window.pie("Q", *DOWN, shift=True)
    yield
    assert corner_values(hull)[index] == 1.0
    assert not are_equal(snapshot(hull), before)
    assert_follows(hull)
    window.pie("Q", *UP, shift=True)
    yield
    assert corner_values(hull)[index] == 0.0
    assert are_equal(snapshot(hull), before)


def test_escape_closes_the_pie_menu(window):
    hull = editing_a_hull(window, "EDGE")
    select(hull, *smooth_edges_within(hull, 3), kind="edges")
    yield
    before, creases = snapshot(hull), crease_values(hull)
    window.press("Q", shift=True)
    window.move_by(*LEFT)
    window.press("ESC")
    yield
    assert are_equal(snapshot(hull), before)
    assert np.array_equal(crease_values(hull), creases)


def test_the_deck_edge_from_the_search(window):
    hull = editing_a_hull(window, "EDGE")
    points = edited_points(hull)
    edges = bmesh.from_edit_mesh(hull.data).edges
    rail = max((e for e in edges if e.is_boundary), key=lambda e: e.verts[0].co.y)
    ends = [vertex.index for vertex in rail.verts]
    select(hull, rail.index, kind="edges")
    before = snapshot(hull)
    yield
    window.search("mark as deck edge")
    yield
    deck = part("bridge.mesh.mesh_arrays").read_mesh(hull.data).deck_edge()
    assert ends in deck.tolist() and np.ptp(points[deck, 0]) > 50.0
    assert are_equal(snapshot(hull), before)
    assert_follows(hull)
    window.undo()
    yield
    assert not len(part("bridge.mesh.mesh_arrays").read_mesh(hull_at_hand().data).deck_edge())


def test_faces_are_made_flat_from_the_context_menu(window):
    hull = editing_a_hull(window, "FACE")
    points = edited_points(hull)
    bent = max(hull_faces(hull), key=lambda face: np.ptp(points[face, 1]))
    select(hull, hull_faces(hull).index(bent), kind="faces")
    yield
    window.click("RIGHTMOUSE")
    # From the end: Check Flatness, Release Flat, Make Flat and its Side.
    for key in ("END", "UP_ARROW", "UP_ARROW", "RIGHT_ARROW", "RET"):
        window.press(key)
    yield
    assert np.ptp(points[bent, 1]) > 0.1 and np.ptp(edited_points(hull)[bent, 1]) == 0.0
    assert len(hull.hull.flats) == 1
    assert_follows(hull)
    # What is flat stays so while one of its points is pulled.
    bpy.ops.mesh.select_mode(type="VERT")
    bpy.ops.mesh.select_all(action="DESELECT")
    select(hull, bent[0])
    window.press("G")
    window.move_by(20, 20)
    window.click()
    yield
    moved = edited_points(hull)
    assert np.abs(moved[bent[0]] - points[bent[0]]).max() > 0.1
    assert np.ptp(moved[bent, 1]) == 0.0
    assert_follows(hull)


def hull_faces(hull):
    """Lists of vertex indices, one for each face."""
    return [[v.index for v in face.verts] for face in bmesh.from_edit_mesh(hull.data).faces]
