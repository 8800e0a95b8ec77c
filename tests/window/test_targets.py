# SPDX-License-Identifier: GPL-3.0-or-later
"""Targets by button and field: a row added, solved, taken back; Esc ends the search."""

import bpy
import numpy as np
from addon_under_test import part, state_of
from editing import hull_at_hand
from expect import assert_follows, edited_points
from sidebar import BESIDE_LIST, choose, press, show_all_panels, show_panels, to, type_in


def begin(window, name="coaster"):
    with window.in_view():
        bpy.ops.hull.load_sample(name=name)
        bpy.ops.ed.undo_push(message="begin")
    window.look(hull_at_hand())
    window.open_sidebar()
    show_panels(window, "targets")
    return hull_at_hand()


def report():
    return part("features.targets.reports").last_report(hull_at_hand())


def test_a_row_is_added_solved_and_taken_back(window):
    hull = begin(window)
    yield
    try:
        rows = hull.hull.targets.rows
        yield from press(window, "hull.add_target", BESIDE_LIST)
        yield from choose(window, "quantity", lambda: rows[-1].quantity == "CB")
        yield from type_in(window, "value", "0.75")
        points = edited_points(hull)
        yield from press(window, "hull.solve_targets")
        yield lambda: report()[0] is not None
        found, is_current = report()
        assert found.is_met and is_current
        values = state_of(hull_at_hand()).hydrostatics.values
        settings = hull_at_hand().hull
        block = values.displaced_volume / (settings.length_pp * settings.beam * settings.draft)
        assert abs(block - 0.75) < 1e-6
        assert_follows(hull_at_hand())
        window.move_to_middle()
        window.undo()
        yield
        hull = hull_at_hand()
        assert np.array_equal(edited_points(hull), points)
        assert [row.quantity for row in hull.hull.targets.rows] == ["CB"]
        assert_follows(hull)
        yield from press(window, "hull.remove_target", BESIDE_LIST)
        assert not len(hull_at_hand().hull.targets.rows)
    finally:
        show_all_panels()


def test_escape_ends_the_search(window):
    """A hull of some thousand points, for which it takes seconds."""
    hull = begin(window)
    with window.in_view():
        bpy.ops.hull.subdivide_exactly()
        bpy.ops.hull.subdivide_exactly()
        bpy.ops.hull.add_target()
        hull.hull.targets.rows[0].quantity, hull.hull.targets.rows[0].value = "CB", 0.75
        bpy.ops.ed.undo_push(message="target")
    yield
    try:
        points = edited_points(hull_at_hand())
        jobs = part("bridge.background.jobs")
        yield from to(window, "hull.solve_targets")
        window.click()
        window.press("ESC")
        yield lambda: not jobs._unfinished
        yield
        assert np.array_equal(edited_points(hull_at_hand()), points)
        assert report()[0] is None
        assert_follows(hull_at_hand())
    finally:
        show_all_panels()
