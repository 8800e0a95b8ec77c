# SPDX-License-Identifier: GPL-3.0-or-later
"""The target area curve dragged by a handle in the plot over the view."""

import bpy
import numpy as np
from addon_under_test import part
from editing import hull_at_hand
from window import FROM_PORT


def begin(window):
    """The coaster with a target beside its own curve in the plot; its operator runs then."""
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
        bpy.ops.hull.take_area_curve(handles=7)
    hull = hull_at_hand()
    bpy.ops.ed.undo_push(message="begin")
    window.look(hull, FROM_PORT)
    return hull


def shown(window):
    handles = part("features.area_curves.handles")
    region = window.region()
    return handles.diagram(hull_at_hand(), bpy.context.scene, window.area, region)


def drag(window, index, right, up):
    """Drags a handle of the plot by so many dots."""
    handles = part("features.area_curves.handles")

    def to_handle():
        x, y = shown(window).dots(handles.points_of(hull_at_hand(), bpy.context.scene))[index]
        region = window.region()
        window.cursor = round(region.x + x), round(region.y + y)
        window._simulate("MOUSEMOVE", "NOTHING")

    window.actions.append(to_handle)
    window.drag(right, up)


def values(hull):
    return np.array([(point.x, point.area) for point in hull.hull.area_target.area_points])


def test_a_handle_is_dragged_and_taken_back(window):
    hull = begin(window)
    yield lambda: shown(window) is not None
    before, frame = values(hull), shown(window)
    with window.in_view():
        assert bpy.ops.hull.drag_area_curve("INVOKE_DEFAULT") == {"RUNNING_MODAL"}
    drag(window, 2, 8, 24)
    yield
    now = values(hull)
    left, bottom, right, top = frame.rectangle
    per_dot = (np.ptp(frame.frame[0]) / (right - left), np.ptp(frame.frame[1]) / (top - bottom))
    # To where the mouse is, which stands on whole dots.
    assert np.abs((now - before)[2] / per_dot - (8, 24)).max() < 1.0
    assert np.array_equal(np.delete(now, 2, axis=0), np.delete(before, 2, axis=0))
    curve = part("features.area_curves.live_target").known(hull).curve
    assert np.abs(curve.areas - now[:, 1]).max() < 1e-5
    (plot,) = part("features.analyses.live_analyses").plots().shown
    assert plot.card.plot.curve_names == ["Sectional area", "Target"]
    window.press("RET")
    yield
    assert np.array_equal(values(hull), now)
    window.undo()
    yield
    assert np.array_equal(values(hull_at_hand()), before)


def test_what_was_dragged_without_a_target_can_be_done_again(window):
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
    bpy.ops.ed.undo_push(message="begin")
    window.look(hull_at_hand(), FROM_PORT)
    with window.in_view():
        assert bpy.ops.hull.drag_area_curve("INVOKE_DEFAULT") == {"RUNNING_MODAL"}
    yield lambda: shown(window) is not None
    drag(window, 4, 0, -24)
    yield
    window.press("RET")
    yield
    before, numbers = values(hull_at_hand()), part("features.area_curves.stored").numbers
    base = numbers(hull_at_hand())[0]
    with window.in_view():
        assert bpy.ops.ed.undo_redo() == {"FINISHED"}
    yield
    assert np.abs(values(hull_at_hand()) - before).max() < 1e-4
    assert np.array_equal(numbers(hull_at_hand())[0], base) and len(base)
    assert hull_at_hand().hull.plots.sectional_areas


def test_escape_leaves_the_target_as_it_was(window):
    hull = begin(window)
    yield lambda: shown(window) is not None
    before = values(hull)
    with window.in_view():
        bpy.ops.hull.drag_area_curve("INVOKE_DEFAULT")
    drag(window, 3, 0, 30)
    drag(window, 1, 5, -10)
    yield
    now = values(hull)
    assert np.abs(now - before).max(axis=1).nonzero()[0].tolist() == [1, 3]
    # Nothing is undone while handles are dragged.
    window.undo()
    yield
    assert np.array_equal(values(hull), now)
    window.press("ESC")
    yield
    assert np.array_equal(values(hull_at_hand()), before)
    assert part("features.area_curves.live_target").known(hull_at_hand()).frame is None
