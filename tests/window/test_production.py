# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels Model and Panels by button and field: made, their figures; Esc ends it."""

import bpy
from addon_under_test import part
from editing import hull_at_hand
from sidebar import press, show_all_panels, show_panels, to, type_in


def begin(window, panel, name="coaster"):
    with window.in_view():
        bpy.ops.hull.load_sample(name=name)
        bpy.ops.ed.undo_push(message="begin")
    window.look(hull_at_hand())
    window.open_sidebar()
    show_panels(window, panel)
    return hull_at_hand()


def model_figures():
    return part("features.production.model_figures").model_figures(hull_at_hand())


def test_a_model_is_made_from_its_panel(window):
    begin(window, "model")
    yield
    try:
        yield from type_in(window, "scale", "200")
        yield from press(window, "hull.make_model")
        yield lambda: model_figures()[1]
        rows = dict(model_figures()[0].rows)
        assert int(rows["Triangles"]) > 1000
        # Numbers that are changed afterwards leave it pale.
        yield from type_in(window, "scale", "100")
        assert model_figures()[0] is not None and not model_figures()[1]
    finally:
        show_all_panels()


def test_panels_are_made_from_their_panel(window):
    begin(window, "panel_mesh")
    figures = part("features.production.model_figures").panel_figures
    yield
    try:
        yield from type_in(window, "along", "20")
        yield from press(window, "hull.make_panels")
        yield lambda: figures(hull_at_hand(), bpy.context.scene)[1]
        rows = dict(figures(hull_at_hand(), bpy.context.scene)[0].rows)
        assert int(rows["Panels"]) > 100 and rows["Sides"] == "Port half"
    finally:
        show_all_panels()


def test_escape_ends_a_wall_that_takes_long(window):
    """Within the native call: it has some million cubes to look at."""
    hull = begin(window, "model")
    hull.hull.model.scale, hull.hull.model.wall = 20.0, 2.5
    yield
    try:
        jobs = part("bridge.background.jobs")
        yield from to(window, "hull.make_model")
        window.click()
        yield lambda: bool(jobs._unfinished)
        window.press("ESC")
        yield lambda: not jobs._unfinished
        yield
        assert model_figures() == (None, False)
    finally:
        show_all_panels()
