# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that took seconds, run once more by Blender's own Repeat Last."""

import bpy
from addon_under_test import part


def _loaded(window):
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
    return bpy.context.view_layer.objects.active


def _is_done():
    hull = bpy.context.view_layer.objects.active
    return part("features.conversion.conversions").running(hull) is None


def _listed():
    """The operators that Blender can repeat, the last one last."""
    return [each.bl_idname for each in bpy.context.window_manager.operators]


def test_a_task_is_repeated(window):
    hull = _loaded(window)
    yield
    with window.in_view():
        assert bpy.ops.hull.convert("INVOKE_DEFAULT") == {"RUNNING_MODAL"}
    yield _is_done
    yield lambda: _listed()[-1:] == ["HULL_OT_convert"]
    hull.hull.export.tolerance *= 0.5
    window.move_to_middle()
    for _ in range(2):
        window.press("R", shift=True)
        yield
        yield _is_done
        assert part("features.conversion.conversions").last_outcome(hull)[1]
        assert _listed().count("HULL_OT_convert") == 1
