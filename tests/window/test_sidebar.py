# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of the sidebar, typed into and dragged: numbers and lines follow, undo takes it back."""

import bpy
import numpy as np
from addon_under_test import state_of
from editing import hull_at_hand
from expect import assert_follows, snapshot
from sidebar import show_all_panels, show_panels

# From the sidebar's upper left corner to fields of its only panel.
DRAFT, TRIM, HEEL = (90, -46), (90, -67), (90, -88)


def a_hull(window):
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
        bpy.ops.ed.undo_push(message="begin")
    window.look(hull_at_hand())
    window.open_sidebar()


def move_to_field(window, place):
    region = window.region("UI")
    window.move_to(region.x + place[0], region.y + region.height + place[1])


def test_numbers_follow_the_fields_of_hydrostatics(window):
    show_panels(window, "hydrostatics")
    try:
        yield from _numbers_follow(window)
    finally:
        show_all_panels()


def _numbers_follow(window):
    a_hull(window)
    yield
    hull = hull_at_hand()
    before = snapshot(hull)
    move_to_field(window, DRAFT)
    window.press("RET")
    window.press("A", ctrl=True)
    window.write("4.5")
    window.press("RET")
    yield
    assert hull.hull.draft == 4.5
    assert snapshot(hull)["volume"] < before["volume"]
    (waterline,) = state_of(hull).lines.groups["draft"].sections
    assert np.allclose(np.concatenate(waterline.polylines)[:, 2], 4.5)
    assert_follows(hull)

    # Dragged: all follows before the button is let go.
    move_to_field(window, HEEL)
    window.hold("LEFTMOUSE")
    window.move_by(40, 0)
    yield
    heel = hull.hull.heel
    assert heel > 0.0 and state_of(hull).hydrostatics.values.tcb < -0.01
    window.move_by(20, 0)
    window.let_go("LEFTMOUSE")
    yield
    assert hull.hull.heel > heel
    assert_follows(hull)

    window.move_to_middle()
    window.undo()
    yield
    assert hull_at_hand().hull.heel == 0.0 and hull_at_hand().hull.draft == 4.5
    window.undo()
    yield
    assert snapshot(hull_at_hand())["volume"] == before["volume"]
    assert_follows(hull_at_hand())
