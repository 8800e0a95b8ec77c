# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull made of a mesh in the window: what is asked, made and taken back; Esc ends it."""

import bpy
import sidebar
from addon_under_test import part
from expect import assert_framed
from scans import lay_scan


def made():
    return next((obj for obj in bpy.data.objects if obj.name == "scan hull"), None)


def ask(window):
    sidebar.show_panels(window, "hull", "made_of")
    window.open_sidebar()
    yield
    # As few points as there can be, in less time; the dialog has what was asked last.
    last = bpy.context.window_manager.operator_properties_last("hull.hull_from_mesh")
    last.points = 90
    yield from sidebar.press(window, "hull.hull_from_mesh")


def test_a_mesh_is_made_a_hull_and_that_is_taken_back(window):
    lay_scan(window)
    yield
    try:
        yield from ask(window)
        yield from sidebar.type_in_dialog(window)
        yield lambda: made() is not None
        yield
        hull = made()
        assert bpy.context.view_layer.objects.active == hull
        report, is_current = part("features.geometry.making").last_report(hull)
        assert_framed(hull)
        assert is_current and report.told["distances"]["rms"] < 5e-4 * hull.dimensions.x
        window.move_to_middle()
        window.undo()
        yield
        assert made() is None and "scan" in bpy.data.objects
    finally:
        sidebar.show_all_panels()


def test_esc_makes_nothing(window):
    lay_scan(window)
    yield
    before = {obj.name for obj in bpy.data.objects}
    try:
        yield from ask(window)
        yield from sidebar.type_in_dialog(window, keys=("RET", "ESC"))
        jobs = part("bridge.background.jobs")
        yield lambda: not jobs._unfinished
        yield
        yield
        assert {obj.name for obj in bpy.data.objects} == before
    finally:
        sidebar.show_all_panels()
