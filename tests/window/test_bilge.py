# SPDX-License-Identifier: GPL-3.0-or-later
"""Bilges rounded, and the surface brought to a coordinate, as from the search of operators."""

import bpy
import numpy as np
from addon_under_test import part, state_of
from editing import editing_a_hull, hull_at_hand
from expect import are_equal, assert_follows, edited_points, snapshot
from window import FROM_AHEAD

# From the mouse when the dialogs open to their OK.
TO_OK, TO_OK_OF_BILGE = (0, -203), (0, -88)


def new_hull(window):
    with window.in_view():
        bpy.ops.hull.add_hull(kind="ROUND_BILGE")
    hull = bpy.context.view_layer.objects.active
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_mode(type="VERT")
    window.look(hull, FROM_AHEAD)
    return hull


def midbody_rows(hull):
    """The points of some sections amidships."""
    points = edited_points(hull)
    x = points[:, 0] / max(hull.dimensions)
    return np.flatnonzero((x > 0.3) & (x < 0.65))


def run_with_dialog(window, name, to_ok):
    """Finds an operator by the search, and takes what its dialog offers."""
    window.search(name)
    yield
    window.move_by(*to_ok)
    window.click()
    yield


def test_a_bilge_is_rounded_in_one_step(window):
    hull = new_hull(window)
    part("bridge.mesh.selection").select(bpy.context, hull, "vertex", midbody_rows(hull))
    bpy.ops.ed.undo_push(message="select")
    before = snapshot(hull)
    yield
    yield from run_with_dialog(window, "Bilge Radius", TO_OK_OF_BILGE)
    assert_follows(hull)
    moved = np.abs(edited_points(hull) - before["points"]).max(axis=1) > 0.0
    assert moved.any() and moved[midbody_rows(hull)].sum() == moved.sum()
    points = edited_points(hull)[midbody_rows(hull)]
    radius = 2.7  # that of new hulls, which the dialog offers
    centre = np.array([points[:, 1].max() - radius, radius])
    bilge = points[(points[:, 1] > centre[0] + 0.3) & (points[:, 2] < radius - 0.3), 1:]
    assert len(bilge) and np.abs(np.linalg.norm(bilge - centre, axis=1) - radius).max() < 0.3
    window.undo()
    yield
    assert are_equal(snapshot(hull_at_hand()), before)


def test_a_coordinate_is_taken_from_the_cursor(window):
    hull = editing_a_hull(window)
    x = 0.45 * max(hull.dimensions)
    bpy.context.scene.cursor.location = (x, 6.25, 3.0)
    bpy.ops.ed.undo_push(message="cursor")
    before = snapshot(hull)
    yield
    yield from run_with_dialog(window, "Surface to Coordinate", TO_OK)
    assert_follows(hull)
    assert not are_equal(snapshot(hull), before)
    assert_has(hull, x, 6.25)
    bpy.context.scene.cursor.location = (x + 9.0, 6.125, 3.0)
    window.move_to_middle()
    yield from run_with_dialog(window, "Surface to Coordinate", TO_OK)
    assert_has(hull, x + 9.0, 6.125)


def assert_has(hull, x, y):
    """The surface has this y at this x and z = 3."""
    tree = part("bridge.native").require().SurfaceTree(state_of(hull).ship.surface)
    hits = tree.all_ray_hits(np.array([x, -50.0, 3.0]), np.array([0.0, 1.0, 0.0]))
    assert np.abs(hits.points[:, 1] - y).min() < 1e-5
