# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacement by the least change, typed into its dialog: a task with progress, one step of undo,
and Esc leaves all as it was."""

import bpy
from addon_under_test import part, state_of
from editing import hull_at_hand
from expect import are_equal, assert_follows, snapshot
from sidebar import press, show_all_panels, show_panels, type_in_dialog

# From the mouse, which is on the title of the dialog as it opens, to the field Cb.
TO_BLOCK = (69, -59)


def block():
    return state_of(hull_at_hand()).hydrostatics.values.project_block


def opened(window, subdivided=0):
    with window.in_view():
        bpy.ops.hull.load_sample(name="bulk_carrier")
        for _ in range(subdivided):
            bpy.ops.hull.subdivide_exactly()
        bpy.ops.ed.undo_push(message="begin")
    window.look(hull_at_hand())
    window.open_sidebar()
    show_panels(window, "transform")
    yield from press(window, "hull.change_displacement")


def test_a_typed_displacement_comes_and_is_undone(window):
    try:
        yield from opened(window)
        before = snapshot(hull_at_hand())
        yield from type_in_dialog(window, (TO_BLOCK, "0.8"))
        yield lambda: abs(block() - 0.8) < 1e-6
        assert_follows(hull_at_hand())
        window.undo()
        yield lambda: abs(block() - 0.8) > 1e-3
        assert are_equal(snapshot(hull_at_hand()), before)
    finally:
        show_all_panels()


def test_escape_leaves_all_as_it_was(window):
    try:
        yield from opened(window, subdivided=2)  # so that it takes some seconds
        before = snapshot(hull_at_hand())
        yield from type_in_dialog(window, (TO_BLOCK, "0.8"), keys=("RET", "ESC"))
        running = part("features.conversion.conversions").running
        yield lambda: running(hull_at_hand()) is None
        assert are_equal(snapshot(hull_at_hand()), before)
        assert abs(block() - 0.8) > 1e-3
    finally:
        show_all_panels()
