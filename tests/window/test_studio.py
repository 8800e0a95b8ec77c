# SPDX-License-Identifier: GPL-3.0-or-later
"""The studio in the window: it follows the hull at a pause, and F12 shows the hull as it is."""

import bpy
import numpy as np
from addon_under_test import part
from editing import bilge_point, editing_a_hull, hull_at_hand, select
from expect import assert_follows


def begin(window):
    """A hull in a studio, and in edit mode, with its outermost point selected."""
    hull = editing_a_hull(window)
    bpy.ops.object.mode_set(mode="OBJECT")
    with window.in_view():
        assert bpy.ops.hull.make_studio() == {"FINISHED"}
    bpy.ops.object.mode_set(mode="EDIT")
    select(hull, bilge_point(hull)[0])
    render = bpy.context.scene.render
    render.resolution_x, render.resolution_y = 16, 9
    bpy.context.scene.cycles.samples = 1
    bpy.context.preferences.view.render_display_type = "NONE"
    return hull


def drawn():
    """Points of the stations that are drawn on the hull."""
    collection = part("features.studio").find(bpy.context.scene)
    stations = next(obj for obj in collection.objects if obj.name == "Studio stations")
    return np.array([p.co[:] for s in stations.data.splines for p in s.bezier_points])


def are_lines_on_the_hull():
    """Whether the lines drawn are those of a studio that is set up for the hull as it is."""
    now = drawn()
    part("features.studio").forget()
    part("features.studio").follow(bpy.context.scene)
    return now.shape == drawn().shape and np.array_equal(now, drawn())


def drag(window):
    window.press("G")
    window.move_by(60, 40)
    window.click()


def test_it_follows_at_a_pause(window):
    hull = begin(window)
    yield
    before = drawn()
    drag(window)
    yield lambda: not np.array_equal(before, drawn())
    assert_follows(hull)
    assert are_lines_on_the_hull()
    after = drawn()
    window.undo()
    yield lambda: not np.array_equal(after, drawn())
    assert np.abs(drawn() - before).max() < 1e-5
    window.press("TAB")
    yield
    assert hull_at_hand().mode == "OBJECT" and are_lines_on_the_hull()


def test_f12_shows_what_was_dragged_just_now(window):
    begin(window)
    pictures, seen = [], []
    bpy.app.handlers.render_pre.append(lambda *unused: seen.append(drawn()))
    bpy.app.handlers.render_complete.append(lambda *unused: pictures.append(True))
    yield
    before = drawn()
    drag(window)
    window.press("F12")
    try:
        yield lambda: pictures
    finally:
        bpy.app.handlers.render_pre.pop()
        bpy.app.handlers.render_complete.pop()
    assert not np.array_equal(before, seen[0])
    assert are_lines_on_the_hull() and np.array_equal(seen[0], drawn())
