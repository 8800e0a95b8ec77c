# SPDX-License-Identifier: GPL-3.0-or-later
"""A point of the stem that is dragged in the view slides in the centre plane, and one that is kept
in its station slides in that."""

import bpy
import numpy as np
from editing import editing_a_hull, hull_at_hand
from expect import are_equal, assert_follows, edited_points, snapshot
from mathutils import Vector
from window import FROM_ABOVE


def stem_head(hull):
    points = edited_points(hull)
    index = int(np.argmax(points[:, 0]))
    assert points[index, 1] == 0.0
    return index, Vector(points[index].tolist())


def test_the_stem_is_dragged(window):
    hull = editing_a_hull(window)
    window.look(hull, FROM_ABOVE)
    index, place = stem_head(hull)
    before, shown = edited_points(hull), snapshot(hull)
    window.move_to_point(hull, place)
    window.click()
    yield
    bpy.ops.ed.undo_push(message="select")
    window.press("G")
    for _ in range(3):
        window.move_by(-10, 20)
        yield
        now = edited_points(hull)
        assert now[index, 1] == 0.0 and now[index, 0] < before[index, 0]
        assert_follows(hull)
    window.press("ESC")
    yield
    assert np.array_equal(edited_points(hull), before)
    window.press("G")
    window.move_by(-30, 60)
    window.click()
    yield
    after = edited_points(hull)
    assert after[index, 1] == 0.0 and after[index, 0] < before[index, 0]
    assert_follows(hull)
    window.undo()
    yield
    assert are_equal(snapshot(hull_at_hand()), shown)


def test_a_point_kept_in_its_station_is_dragged(window):
    hull = editing_a_hull(window)
    window.look(hull, FROM_ABOVE)
    points = edited_points(hull)
    index = int(np.argmax(points[:, 1]))
    window.move_to_point(hull, Vector(points[index].tolist()))
    window.click()
    yield
    bpy.ops.hull.keep_points("EXEC_DEFAULT", True, plane="STATION")
    bpy.ops.ed.undo_push(message="keep")
    before, shown = edited_points(hull), snapshot(hull)
    yield
    window.press("G")
    for _ in range(3):
        window.move_by(15, 20)
        yield
        now = edited_points(hull)
        assert now[index, 0] == before[index, 0] and now[index, 1] != before[index, 1]
        assert_follows(hull)
    window.click()
    yield
    assert edited_points(hull)[index, 0] == before[index, 0]
    window.undo()
    yield
    assert np.array_equal(edited_points(hull_at_hand()), before)
    assert are_equal(snapshot(hull_at_hand()), shown)
