# SPDX-License-Identifier: GPL-3.0-or-later
"""Views, curvature and lines in space, written in Blender."""

import bpy
import pytest
from addon_under_test import add_hull


@pytest.mark.parametrize("ending", ["pdf", "svg", "dxf"])
def test_a_view_is_written(tmp_path, ending):
    add_hull()
    path = tmp_path / f"box.{ending}"
    assert bpy.ops.hull.export_view(filepath=str(path), hidden=True) == {"FINISHED"}
    assert path.stat().st_size > 1000
    if ending == "dxf":
        assert "OUTLINE" in path.read_text() and "HIDDEN" in path.read_text()


def test_curvature_is_written(tmp_path):
    bpy.ops.hull.load_sample(name="coaster")
    path = tmp_path / "curvature.svg"
    done = bpy.ops.hull.export_curvature(filepath=str(path), axis="x", position=42.0, radius=2.0)
    assert done == {"FINISHED"} and path.stat().st_size > 1000
    path.unlink()
    with pytest.raises(RuntimeError, match="no section"):
        bpy.ops.hull.export_curvature(filepath=str(path), axis="x", position=500.0)
    with pytest.raises(RuntimeError, match="Keep the hull as a variant first"):
        bpy.ops.hull.export_curvature(filepath=str(path), position=42.0, with_other=True)
    assert not list(tmp_path.iterdir())


def test_lines_in_space_are_written(tmp_path):
    bpy.ops.hull.load_sample(name="coaster")
    path = tmp_path / "lines.dxf"
    assert bpy.ops.hull.export_curves(filepath=str(path), unit="mm") == {"FINISHED"}
    text = path.read_text()
    assert text.count("\nSPLINE\n") > 40 and "STATIONS" in text and "KNUCKLES_AND_BORDERS" in text


@pytest.mark.parametrize("call", ["export_view", "export_curvature", "export_curves"])
def test_unknown_endings_are_refused(tmp_path, call):
    add_hull()
    with pytest.raises(RuntimeError, match="does not say how"):
        getattr(bpy.ops.hull, call)(filepath=str(tmp_path / "box.xyz"))
    assert not list(tmp_path.iterdir())
