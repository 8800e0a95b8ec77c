# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are written from their dialog, while Blender stays at work."""

import tempfile
import time
from pathlib import Path

import bpy
from addon_under_test import part


def test_a_table_is_written_from_its_dialog(window):
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
    hull = bpy.context.view_layer.objects.active
    hull.hull.table.trims = "-1:1:0.1"
    yield
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    path = Path(tempfile.mkdtemp()) / "table.csv"
    with window.in_view():
        bpy.ops.hull.export_table(
            "INVOKE_DEFAULT", analysis="hydrostatic_table", filepath=str(path)
        )
    yield from window.accept_file()
    yield path.exists
    yield lambda: part("features.conversion.conversions").running(hull) is None
    assert len(path.read_text().splitlines()) > 100
    path.unlink()


def esc_leaves_the_file(window, work, call, name):
    """Of an export that is begun by its dialog, whose `work`, a function of hull_native, does not
    end by itself: Esc ends it, and a file of the name is as it was. To be used by `yield from`."""
    hull_native, running = part("bridge.native").require(), part("features.conversion.conversions")
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
    hull = bpy.context.view_layer.objects.active
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    path = Path(tempfile.mkdtemp()) / name
    path.write_text("as it was")
    yield

    def endless(*unused, progress, **more):
        while True:
            progress(0.5)
            time.sleep(0.02)

    usual = getattr(hull_native, work)
    setattr(hull_native, work, endless)
    try:
        with window.in_view():
            getattr(bpy.ops.hull, call)("INVOKE_DEFAULT", filepath=str(path))
        yield from window.accept_file()
        yield lambda: running.running(hull) is not None
        window.press("ESC")
        yield lambda: running.running(hull) is None
        yield
    finally:
        setattr(hull_native, work, usual)
    assert path.read_text() == "as it was"
    assert [each.name for each in path.parent.iterdir()] == [name]
    path.unlink()


def test_escape_ends_panels(window):
    yield from esc_leaves_the_file(window, "wetted_panels", "export_panels", "ship.gdf")


def test_escape_ends_named_parts(window):
    yield from esc_leaves_the_file(window, "closed_model", "export_parts", "ship.stl")


def test_escape_ends_a_view(window):
    yield from esc_leaves_the_file(window, "view_drawing", "export_view", "ship.svg")
