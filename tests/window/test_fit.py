# SPDX-License-Identifier: GPL-3.0-or-later
"""Fitting in the window: Blender stays at work meanwhile, Esc cancels, and Ctrl-Z takes it back."""

import bpy
import numpy as np
from addon_under_test import part
from editing import editing_a_hull, hull_at_hand
from expect import are_equal, assert_follows, edited_points, snapshot


def begin(window):
    """A hull in edit mode beside its own surface, to which it is fitted, moved up by 0.3."""
    hull = editing_a_hull(window)
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    grid = part("features.hull.hull_state").state_of(hull).ship.surface.tessellate(8)
    mesh = bpy.data.meshes.new("target")
    mesh.from_pydata(np.array(grid.points).tolist(), [], np.array(grid.quads).tolist())
    target = bpy.data.objects.new("target", mesh)
    bpy.context.collection.objects.link(target)
    target.location.z = 0.3
    hull.hull.fit.target = target
    hull.hull.fit.use_edges, hull.hull.fit.draw_border = True, False
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="target")
    return hull


def is_done():
    return part("features.conversion.conversions").running(hull_at_hand()) is None


def test_a_fit_is_made_and_taken_back(window):
    hull = begin(window)
    before = snapshot(hull)
    low = edited_points(hull)[:, 2].min()
    yield
    with window.in_view():
        assert bpy.ops.hull.fit("INVOKE_DEFAULT") == {"RUNNING_MODAL"}
    assert part("features.conversion.conversions").running(hull) is not None
    yield is_done
    yield
    hull = hull_at_hand()
    assert abs(edited_points(hull)[:, 2].min() - low - 0.3) < 0.05
    assert_follows(hull)
    assert part("features.fitting.fitting").last_report(hull)[1]
    window.undo()
    yield
    assert are_equal(snapshot(hull_at_hand()), before)


def test_esc_cancels(window):
    hull = begin(window)
    hull.hull.fit.samples = 500000
    before = snapshot(hull)
    yield
    with window.in_view():
        assert bpy.ops.hull.fit("INVOKE_DEFAULT") == {"RUNNING_MODAL"}
    window.press("ESC")
    yield is_done
    yield
    assert are_equal(snapshot(hull_at_hand()), before)
    assert part("features.fitting.fitting").last_report(hull_at_hand()) == (None, False)


def test_what_ends_while_another_scene_is_shown_waits_for_its_own(window):
    """The other one has another unit."""
    hull = begin(window)
    bpy.ops.object.mode_set(mode="OBJECT")
    low = edited_points(hull)[:, 2].min()
    here, other = bpy.context.scene, bpy.data.scenes.new("in millimetres")
    other.unit_settings.scale_length = 0.001
    yield
    with window.in_view():
        assert bpy.ops.hull.fit("INVOKE_DEFAULT") == {"RUNNING_MODAL"}
    window.window.scene = other
    task = part("features.conversion.conversions").running(hull)
    yield task.is_done
    for _ in range(6):
        yield
    assert edited_points(hull)[:, 2].min() == low
    window.window.scene = here
    yield lambda: part("features.conversion.conversions").running(hull) is None
    yield
    assert abs(edited_points(hull)[:, 2].min() - low - 0.3) < 0.05
    assert part("features.fitting.fitting").last_report(hull)[1]
    bpy.data.scenes.remove(other)
    yield
