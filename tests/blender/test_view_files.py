# SPDX-License-Identifier: GPL-3.0-or-later
"""Views, curvature and lines in space, written in Blender."""

import bpy
import pytest
from addon_under_test import add_hull, part


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


FIGURES = ("control-mesh", "lines-plan", "reflection", "rendering", "sections-plan")


@pytest.mark.once
@pytest.mark.parametrize("ending", ["png", "svg"])
def test_figures_are_written(tmp_path, ending):
    """As plain Python writes them, whatever the object is called; in edit mode, too."""
    hull = add_hull()
    hull.name = 'a <b> & "c" ü'
    if ending == "svg":
        bpy.ops.object.mode_set(mode="EDIT")
    path = tmp_path / f"box 'é.{ending}"
    assert bpy.ops.hull.export_figures(filepath=str(path)) == {"FINISHED"}
    made = sorted(one.name for one in tmp_path.iterdir())
    assert made == [f"box 'é-{figure}.{ending}" for figure in FIGURES]
    assert all(one.stat().st_size > 1000 for one in tmp_path.iterdir())


@pytest.mark.once
def test_figures_of_a_whole_hull_of_odd_size(tmp_path):
    """A box of 10 by 4 by 3 mm, both sides, in a scene in millimetres."""
    bpy.context.scene.unit_settings.scale_length = 0.001
    hull = add_hull()
    hull.hull.half = False
    assert bpy.ops.hull.export_figures(filepath=str(tmp_path / "tiny.pdf")) == {"FINISHED"}
    assert len(list(tmp_path.iterdir())) == len(FIGURES)


def test_figures_that_are_cancelled_leave_all_as_it_was(tmp_path):
    hull = add_hull()
    kept = tmp_path / "box-rendering.png"
    kept.write_text("before")
    module, jobs = part("features.exchange.figure_files"), part("bridge.background.jobs")
    task = module.FigureFiles(hull, bpy.context.scene, str(tmp_path / "box.png"))
    task.cancel()
    with pytest.raises(jobs.Cancelled):
        task.result()
    part("features.conversion.conversions").take_finished()
    assert [one.name for one in tmp_path.iterdir()] == [kept.name]
    assert kept.read_text() == "before"
    with pytest.raises(RuntimeError, match="Nothing can be written to the folder"):
        bpy.ops.hull.export_figures(filepath=str(tmp_path / "nowhere" / "box.png"))
    with pytest.raises(RuntimeError, match="does not say how"):
        bpy.ops.hull.export_figures(filepath=str(tmp_path / "box.jpg"))
    assert [one.name for one in tmp_path.iterdir()] == [kept.name]
