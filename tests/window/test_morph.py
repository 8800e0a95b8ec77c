# SPDX-License-Identifier: GPL-3.0-or-later
"""A morph by mouse: made of two ships, its slider dragged and taken back, Esc while it is made."""

import bpy
import numpy as np
from addon_under_test import part, state_of
from editing import hull_at_hand
from expect import assert_follows, edited_points
from expect_morph import assert_is_member, boxes, morph_of, select
from sidebar import press, show_all_panels, show_panels, to, type_in


def load(window, *names):
    """Samples, selected, the last one the active one."""
    with window.in_view():
        for name in names:
            bpy.ops.hull.load_sample(name=name)
        hulls = [obj for obj in bpy.context.scene.objects if obj.hull.is_hull]
        active = hull_at_hand()
        select(active, *(hull for hull in hulls if hull != active))
        bpy.ops.ed.undo_push(message="begin")
    return hulls


def open_panel(window):
    window.open_sidebar()
    show_panels(window, "morph", "morph_pairs")


def weights(hull):
    return [entry.weight for entry in hull.hull.morph.parents]


def is_made():
    """Whether the morph is the hull at hand."""
    hull = hull_at_hand()
    return hull is not None and len(hull.hull.morph.parents) == 2


def switch_all_on(hull):
    lines, fairness, plots = hull.hull.lines, hull.hull.fairness, hull.hull.plots
    for kind in ("stations", "waterlines", "buttocks", "diagonals", "design_waterline", "features"):
        setattr(lines, f"show_{kind}", True)
    lines.waterline_spacing, lines.buttock_spacing, lines.diagonals = 1.0, 1.0, "8/40"
    for name in ("comb_stations", "comb_waterlines", "show_reflections"):
        setattr(fairness, name, True)
    for name in part("features.analyses").PLOTTED:
        setattr(plots, name, True)


def test_a_slider_is_dragged_and_taken_back(window):
    """With all lines and plots on, made from the panel's button."""
    load(window, "bulk_carrier", "container_ship")
    open_panel(window)
    yield
    try:
        yield from press(window, "hull.make_morph")
        yield is_made
        made = hull_at_hand()
        switch_all_on(made)
        bpy.context.view_layer.update()
        bpy.ops.ed.undo_push(message="all on")
        window.look(made)
        yield
        before, points = weights(made), edited_points(made)
        yield from to(window, "weight")
        window.drag(25, 0)
        yield
        made = hull_at_hand()
        assert weights(made)[0] > before[0] + 0.05
        assert abs(sum(weights(made)) - 1.0) < 1e-6
        assert_is_member(made)
        assert_follows(made)
        yield lambda: not part("bridge.background.worker").is_busy()
        yield lambda: not state_of(made).shown.is_sliding  # exact normals have come
        window.move_to_middle()
        window.undo()
        yield
        made = hull_at_hand()
        assert weights(made) == before and np.array_equal(edited_points(made), points)
        assert_is_member(made)
        assert_follows(made)
        window.redo()
        yield
        made = hull_at_hand()
        assert weights(made)[0] > before[0] + 0.05
        assert_is_member(made)
        for _ in range(3):  # the weight, what was switched on, the morph
            window.undo()
            yield
        hulls = [obj for obj in bpy.context.scene.objects if obj.hull.is_hull]
        assert len(hulls) == 2 and not any(len(hull.hull.morph.parents) for hull in hulls)
    finally:
        show_all_panels()


def test_escape_leaves_all_as_it_was(window):
    load(window, "roro", "container_ship")
    open_panel(window)
    yield
    try:
        jobs = part("bridge.background.jobs")
        count = len(bpy.data.objects)
        yield from to(window, "hull.make_morph")
        window.click()
        window.press("ESC")
        yield lambda: not jobs._unfinished
        yield
        assert len(bpy.data.objects) == count and not is_made()
        assert_follows(hull_at_hand())
    finally:
        show_all_panels()


def test_a_weight_is_typed_in_and_the_hull_made_its_own(window):
    with window.in_view():
        made = morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9)))
        bpy.ops.ed.undo_push(message="morph")
    window.look(made)
    open_panel(window)
    yield
    try:
        yield from type_in(window, "weight", "0.2")
        made = hull_at_hand()
        assert [round(weight, 6) for weight in weights(made)] == [0.2, 0.8]
        assert_is_member(made)
        points = edited_points(made)
        yield from press(window, "hull.leave_family")
        made = hull_at_hand()
        assert not made.hull.morph.parents and np.array_equal(edited_points(made), points)
        window.move_to_middle()
        window.undo()
        yield
        made = hull_at_hand()
        assert_is_member(made)
        window.undo()
        yield
        assert weights(hull_at_hand()) == [0.5, 0.5]
        assert_is_member(hull_at_hand())
    finally:
        show_all_panels()
