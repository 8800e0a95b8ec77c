# SPDX-License-Identifier: GPL-3.0-or-later
"""Models, panels, views, diagrams, frames and what the yard gets on a full disk: one sentence with
the file's name, and what was there is as it was."""

import bpy
import pytest
from test_cad_export import full_disk
from test_plate_drawings import plated

pytestmark = pytest.mark.once

ENDINGS = {
    "model": ("stl", "3mf", "obj", "cli"),
    "panels": ("gdf", "dat", "obj"),
    "parts": ("stl",),
    "view": ("pdf", "svg", "dxf"),
    "curvature": ("pdf", "svg", "png"),
    "curves": ("dxf",),
    "frames": ("pdf", "dxf"),
    "frame_table": ("csv",),
    "templates": ("pdf", "dxf"),
    "nesting": ("pdf", "dxf"),
}
OPTIONS = {
    "curvature": {"position": 4.0, "radius": 2.0},
    "panels": {"along": 40},
    "nesting": {"stock_length": 20.0, "stock_breadth": 5.0},
}


@pytest.mark.parametrize("kind, ending", [(k, e) for k, own in ENDINGS.items() for e in own])
def test_a_full_disk_is_one_sentence(kind, ending, tmp_path):
    hull = plated(butts=5.0)
    hull.hull.draft = 2.0
    hull.hull.plates.ranges[-1].last = 400
    path = tmp_path / f"box.{ending}"
    path.write_text("as it was")
    with pytest.raises(RuntimeError, match="box") as caught, full_disk(most=500):
        getattr(bpy.ops.hull, f"export_{kind}")(filepath=str(path), **OPTIONS.get(kind, {}))
    assert "Traceback" not in str(caught.value)
    assert path.read_text() == "as it was"
    assert [each.name for each in tmp_path.iterdir()] == [path.name]
