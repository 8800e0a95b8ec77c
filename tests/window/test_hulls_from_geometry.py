# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull made of a mesh in the window: what is asked, made and taken back; Esc ends it."""

import time

import bpy
import numpy as np
import sidebar
from addon_under_test import part


def begin(window):
    """A mesh of the triangles of a sample, active and alone."""
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
        hull = bpy.context.view_layer.objects.active
        state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
        grid = state.ship.surface.tessellate(4)
        points, quads = np.array(grid.points).tolist(), np.array(grid.quads).tolist()
        bpy.ops.object.select_all(action="SELECT")
        bpy.ops.object.delete()
    mesh = bpy.data.meshes.new("scan")
    mesh.from_pydata(points, [], quads)
    scan = bpy.data.objects.new("scan", mesh)
    bpy.context.collection.objects.link(scan)
    scan.select_set(True)
    bpy.context.view_layer.objects.active = scan
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="scan")


def made():
    return next((obj for obj in bpy.data.objects if obj.name == "scan hull"), None)


def waiting_for(is_done, seconds=240.0):
    """For longer than a test waits elsewhere: fits take the processor some seconds."""
    end = time.monotonic() + seconds
    while not is_done() and time.monotonic() < end:
        pause = time.monotonic() + 5.0
        yield lambda: is_done() or time.monotonic() > pause
    assert is_done()


def ask(window):
    sidebar.show_panels(window, "hull", "made_of")
    window.open_sidebar()
    yield
    # As few points as there can be, in less time; the dialog has what was asked last.
    last = bpy.context.window_manager.operator_properties_last("hull.hull_from_mesh")
    last.points = 90
    yield from sidebar.press(window, "hull.hull_from_mesh")


def test_a_mesh_is_made_a_hull_and_that_is_taken_back(window):
    begin(window)
    yield
    try:
        yield from ask(window)
        yield from sidebar.type_in_dialog(window)
        yield from waiting_for(lambda: made() is not None)
        yield
        hull = made()
        assert bpy.context.view_layer.objects.active == hull
        report, is_current = part("features.geometry.making").last_report(hull)
        assert is_current and report.told["distances"]["rms"] < 5e-4 * hull.dimensions.x
        window.move_to_middle()
        window.undo()
        yield
        assert made() is None and "scan" in bpy.data.objects
    finally:
        sidebar.show_all_panels()


def test_esc_makes_nothing(window):
    begin(window)
    yield
    before = {obj.name for obj in bpy.data.objects}
    try:
        yield from ask(window)
        yield from sidebar.type_in_dialog(window, keys=("RET", "ESC"))
        jobs = part("bridge.background.jobs")
        yield from waiting_for(lambda: not jobs._unfinished)
        yield
        yield
        assert {obj.name for obj in bpy.data.objects} == before
    finally:
        sidebar.show_all_panels()
