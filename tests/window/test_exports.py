# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are written from their dialog, while Blender stays at work."""

import tempfile
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


def esc_leaves_the_file(window, call, name, **options):
    """Of an export that is begun by its dialog and takes seconds: Esc ends it, and a file of the
    name is as it was. To be used by `yield from`."""
    running = part("features.conversion.conversions").running
    hull = bpy.context.view_layer.objects.active
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    path = Path(tempfile.mkdtemp()) / name
    path.write_text("as it was")
    yield
    with window.in_view():
        getattr(bpy.ops.hull, call)("INVOKE_DEFAULT", filepath=str(path), **options)
    yield from window.accept_file()
    yield lambda: running(hull) is not None
    window.press("ESC")
    yield lambda: running(hull) is None
    yield
    assert path.read_text() == "as it was"
    assert [each.name for each in path.parent.iterdir()] == [name]
    path.unlink()


def ship(window):
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
    return bpy.context.view_layer.objects.active


def test_escape_ends_panels(window):
    ship(window)
    yield from esc_leaves_the_file(window, "export_panels", "ship.gdf", along=300)


def test_escape_ends_named_parts(window):
    ship(window)
    yield from esc_leaves_the_file(window, "export_parts", "ship.stl", part_tolerance=0.1)


def test_escape_ends_a_view(window):
    lines = ship(window).hull.lines
    lines.station_count, lines.waterline_spacing, lines.buttock_spacing = 200, 0.05, 0.05
    yield from esc_leaves_the_file(window, "export_view", "ship.svg", hidden=True)
