# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull scaled to dimensions by button and dialog, and a scale by Blender's own keys followed."""

import bpy
import numpy as np
from addon_under_test import part, state_of
from editing import hull_at_hand
from expect import assert_follows, edited_points
from sidebar import press, show_all_panels, show_panels, type_in_dialog

# From the mouse, which is on the title of the dialog as it opens, to its fields.
TO_LENGTH, TO_BEAM = (54, -62), (54, -82)


def begin(window):
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
        bpy.ops.ed.undo_push(message="begin")
    window.look(hull_at_hand())
    window.open_sidebar()
    show_panels(window, "hull")
    return hull_at_hand()


def volume():
    return state_of(hull_at_hand()).hydrostatics.values.displaced_volume


def test_typed_dimensions_and_undo(window):
    hull = begin(window)
    yield
    try:
        before, points = volume(), edited_points(hull)
        yield from press(window, "hull.set_dimensions")
        yield from type_in_dialog(window, (TO_LENGTH, "84*1.1"), (TO_BEAM, "15"))
        hull = hull_at_hand()
        assert abs(hull.hull.length_pp - 92.4) < 1e-5 and abs(hull.hull.beam - 15.0) < 1e-6
        wanted = before * 1.1 * 15.0 / 13.6
        assert abs(volume() - wanted) < 1e-6 * wanted
        assert_follows(hull)
        window.undo()
        yield
        hull = hull_at_hand()
        assert np.array_equal(edited_points(hull), points)
        assert abs(hull.hull.length_pp - 84.0) < 1e-6 and abs(volume() - before) < 1e-9 * before
        assert_follows(hull)
    finally:
        show_all_panels()


def test_escape_from_the_dialog_changes_nothing(window):
    hull = begin(window)
    yield
    try:
        points = edited_points(hull)
        yield from press(window, "hull.set_dimensions")
        window.move_by(*TO_LENGTH)
        window.click()
        window.press("A", ctrl=True)
        window.write("100")
        window.press("RET")
        window.press("ESC")
        yield
        hull = hull_at_hand()
        assert (
            np.array_equal(edited_points(hull), points) and abs(hull.hull.length_pp - 84.0) < 1e-6
        )
    finally:
        show_all_panels()


def test_a_scale_of_blenders_is_noticed_and_followed(window):
    """S X 1.1, with the scale applied by Ctrl A: the panel tells of it, and its button follows."""
    hull = begin(window)
    yield
    try:
        dimensions = part("features.dimensions.dimensions")
        draft = hull.hull.draft
        with window.in_view():
            bpy.context.scene.tool_settings.transform_pivot_point = "CURSOR"
        window.move_to_middle()
        window.press("S")
        window.press("X")
        window.write("1.1")
        window.press("RET")
        yield
        hull = hull_at_hand()
        assert np.allclose(dimensions.unapplied(hull), (1.1, 1.0, 1.0), atol=1e-6)
        with window.in_view():
            bpy.ops.object.transform_apply(location=False, rotation=False, scale=True)
            bpy.ops.ed.undo_push(message="applied")
        yield
        hull = hull_at_hand()
        assert dimensions.unapplied(hull) is None
        assert np.allclose(dimensions.noticed(hull).factors, (1.1, 1.0, 1.0), atol=1e-6)
        assert abs(hull.hull.length_pp - 84.0) < 1e-6
        yield from press(window, "hull.follow_scale")
        hull = hull_at_hand()
        assert abs(hull.hull.length_pp - 92.4) < 1e-5 and abs(hull.hull.draft - draft) < 1e-6
        assert dimensions.noticed(hull) is None
        assert_follows(hull)
    finally:
        show_all_panels()
