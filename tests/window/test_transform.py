# SPDX-License-Identifier: GPL-3.0-or-later
"""Moving a control point with G: the ship follows the mouse, and Esc and Ctrl-Z take it back."""

import numpy as np
from addon_under_test import state_of
from editing import (
    bilge_point,
    editing_a_bilge_point,
    editing_a_hull,
    hull_at_hand,
    selected_indices,
)
from expect import are_equal, assert_follows, edited_points, snapshot


def test_all_follows_while_the_mouse_moves(window):
    hull, index, _ = editing_a_bilge_point(window)
    yield
    before = snapshot(hull)
    window.press("G")
    for _ in range(3):
        last = snapshot(hull)
        window.move_by(12, 8)
        yield
        now = snapshot(hull)
        for what in now:
            assert now[what].shape != last[what].shape or np.abs(now[what] - last[what]).max() > 0
        assert_follows(hull)
    window.click()
    yield
    assert_follows(hull)
    moved = np.abs(edited_points(hull) - before["points"]).max(axis=1)
    assert moved[index] > 0.1 and np.count_nonzero(moved) == 1


def test_escape_leaves_all_as_it_was(window):
    hull, _, _ = editing_a_bilge_point(window)
    yield
    before = snapshot(hull)
    window.press("G")
    window.move_by(60, 40)
    yield
    assert not are_equal(snapshot(hull), before)
    window.press("ESC")
    yield
    assert are_equal(snapshot(hull), before)
    assert np.array_equal(edited_points(hull), before["points"])
    assert_follows(hull)


def test_one_move_is_one_undo_step(window):
    hull, index, _ = editing_a_bilge_point(window)
    yield
    before = snapshot(hull)
    window.press("G")
    window.move_by(60, 40)
    window.click()
    yield
    after = snapshot(hull)
    assert not are_equal(after, before)
    window.undo()
    yield
    hull = hull_at_hand()
    assert hull.mode == "EDIT" and selected_indices(hull) == [index]
    assert are_equal(snapshot(hull), before)
    assert_follows(hull)
    window.redo()
    yield
    hull = hull_at_hand()
    assert are_equal(snapshot(hull), after)
    assert_follows(hull)


def test_numbers_typed_during_a_move_are_exact(window):
    hull, index, place = editing_a_bilge_point(window)
    yield
    volume = state_of(hull).hydrostatics.values.displaced_volume
    window.press("G")
    window.press("Y")
    window.write("0.25")
    yield
    assert state_of(hull).hydrostatics.values.displaced_volume > volume
    assert_follows(hull)
    window.press("RET")
    yield
    expected = np.float32(place.y) + np.float32(0.25)
    assert abs(edited_points(hull)[index, 1] - expected) <= 1e-6 * expected
    assert_follows(hull)


def test_a_point_picked_by_click_is_moved(window):
    hull = editing_a_hull(window)
    index, place = bilge_point(hull)
    window.move_to_point(hull, place)
    window.click()
    yield
    (picked,) = selected_indices(hull)
    before = edited_points(hull)
    # Seen from port others may lie behind it; which of them is picked is Blender's business.
    assert np.hypot(*(before[picked] - before[index])[[0, 2]]) < 0.02 * max(hull.dimensions)
    window.press("G")
    window.press("Z")
    window.move_by(0, 30)
    window.click()
    yield
    moved = edited_points(hull) - before
    assert moved[picked, 2] > 0.05 and np.count_nonzero(moved) == 1
    assert_follows(hull)


def test_leaving_edit_mode_keeps_what_was_modelled(window):
    hull, _, _ = editing_a_bilge_point(window)
    yield
    window.press("G")
    window.move_by(40, 40)
    window.press("RET")
    yield
    modelled = snapshot(hull)
    window.press("TAB")
    yield
    assert hull.mode == "OBJECT"
    assert are_equal(snapshot(hull), modelled)
    assert_follows(hull)
    # Undo goes through the end of the edit session into it.
    window.undo()
    window.undo()
    yield
    hull = hull_at_hand()
    assert hull.mode == "EDIT"
    assert_follows(hull)
    assert not are_equal(snapshot(hull), modelled)
