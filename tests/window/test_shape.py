# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat regions that are moved as a whole, points put in planes, and the table of coordinates."""

import bmesh
import numpy as np
from addon_under_test import part
from editing import editing_a_hull, hull_at_hand, select
from expect import are_equal, assert_follows, edited_points, snapshot

# From the mouse when the table opens to its first field, and to its OK below one row.
TO_FIRST_FIELD, TO_OK = (-74, -57), (0, -84)


def test_coordinates_are_typed_in_the_table(window):
    hull = editing_a_hull(window)
    select(hull, 9)
    yield
    before, shown = edited_points(hull), snapshot(hull)
    window.search("coordinates")
    yield
    window.move_by(*TO_FIRST_FIELD)
    window.click()
    window.press("A", ctrl=True)
    window.write("12/5+2")
    window.press("RET")
    yield
    window.move_by(TO_OK[0] - TO_FIRST_FIELD[0], TO_OK[1] - TO_FIRST_FIELD[1])
    window.click()
    yield
    after = edited_points(hull)
    assert after[9].tolist() == [np.float32(4.4), *before[9, 1:]]
    assert np.array_equal(np.delete(after, 9, 0), np.delete(before, 9, 0))
    assert_follows(hull)
    window.undo()
    yield
    assert are_equal(snapshot(hull_at_hand()), shown)


def test_escape_leaves_the_table(window):
    hull = editing_a_hull(window)
    select(hull, 3, 9, 14)
    yield
    before = edited_points(hull)
    window.search("coordinates")
    yield
    window.press("ESC")
    yield
    assert np.array_equal(edited_points(hull), before)


def flat_side(hull):
    """Makes the faces in the upper side amidships flat; returns their points."""
    points = edited_points(hull)
    beam = points[:, 1].max()
    bm = bmesh.from_edit_mesh(hull.data)
    faces = [
        face.index for face in bm.faces if min(vertex.co.y for vertex in face.verts) > 0.97 * beam
    ]
    flats = part("features.constraints.flats")
    flats.mark(hull, faces, (0.0, 1.0, 0.0, beam))
    return flats.regions(hull)[0].points


def test_a_flat_side_is_moved_as_a_whole(window):
    hull = editing_a_hull(window)
    own = flat_side(hull)
    assert len(own) > 5
    select(hull, *own)
    yield
    shown = snapshot(hull)
    before = edited_points(hull)
    window.press("G")
    window.press("Y")
    window.write("0.5")
    window.press("RET")
    yield
    after = edited_points(hull)
    assert np.abs(after[own] - before[own] - (0.0, 0.5, 0.0)).max() < 1e-5
    (region,) = part("features.constraints.flats").regions(hull)
    assert region.plane.tolist() == [0.0, 1.0, 0.0, after[own[0], 1]]
    assert_follows(hull)
    window.undo()
    yield
    hull = hull_at_hand()
    assert are_equal(snapshot(hull), shown)
    (region,) = part("features.constraints.flats").regions(hull)
    assert region.plane[3] == before[own[0], 1]


def test_a_point_of_a_flat_side_slides_in_it_while_it_is_dragged(window):
    hull = editing_a_hull(window)
    own = flat_side(hull)
    select(hull, own[2])
    yield
    before = edited_points(hull)
    shown = snapshot(hull)
    window.press("G")
    window.move_by(40, 30)
    yield
    during = edited_points(hull)
    assert during[own[2], 1] == before[own[2], 1] and not np.array_equal(during, before)
    assert_follows(hull)
    window.press("ESC")
    yield
    assert np.array_equal(edited_points(hull), before) and are_equal(snapshot(hull), shown)
    window.press("G")
    window.press("Y")
    window.write("2")
    window.press("RET")
    yield
    assert np.array_equal(edited_points(hull), before)
    assert_follows(hull)


def test_a_half_hull_is_made_whole_from_the_search(window):
    hull = editing_a_hull(window)
    window.press("TAB")
    yield
    volume, faces = snapshot(hull)["volume"], len(hull.data.polygons)
    window.search("make whole")
    yield
    assert not hull.hull.half and len(hull.data.polygons) == 2 * faces
    assert np.allclose(snapshot(hull)["volume"], volume, 1e-7, 0.0)
    assert_follows(hull)
    window.undo()
    yield
    hull = hull_at_hand()
    assert hull.hull.half and len(hull.data.polygons) == faces
    assert_follows(hull)


def test_points_are_put_in_a_plane_from_the_search(window):
    hull = editing_a_hull(window)
    select(hull, 3, 9, 14)
    yield
    before, shown = edited_points(hull), snapshot(hull)
    window.search("put in plane station")
    yield
    after = edited_points(hull)
    assert np.ptp(before[[3, 9, 14], 0]) > 1.0 and np.ptp(after[[3, 9, 14], 0]) == 0.0
    assert np.array_equal(after[:, 1:], before[:, 1:])
    assert_follows(hull)
    window.undo()
    yield
    assert are_equal(snapshot(hull_at_hand()), shown)
