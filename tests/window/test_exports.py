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
