# SPDX-License-Identifier: GPL-3.0-or-later
"""Views, curvature and lines in space, written in Blender."""

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, by_path, part, sample


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


def test_curvature_beside_the_compared_hull(tmp_path, monkeypatch):
    """The variant is drawn, dashed, with its own curvature: the station is twice as large since,
    its bends are half as sharp."""
    hull = sample()
    assert bpy.ops.hull.keep_variant(name="As it was") == {"FINISHED"}
    for vertex in hull.data.vertices:
        vertex.co.yz = 2.0 * vertex.co.yz
    hull.data.update()
    bpy.context.view_layer.update()
    hull_native, drawn = part("bridge.native").require(), []
    write = hull_native.write_plot

    def kept(plot, path):
        drawn.append(plot)
        write(plot, path)

    monkeypatch.setattr(hull_native, "write_plot", kept)
    path = tmp_path / "curvature.svg"
    values = {"axis": "x", "position": 42.0, "with_other": True}
    assert bpy.ops.hull.export_curvature(filepath=str(path), **values) == {"FINISHED"}
    assert path.stat().st_size > 1000
    (plot,) = drawn
    assert plot.curve_names == [hull.name, "As it was"]
    sheet = hull_native.lay_out_plot(plot, width_mm=297.0, height_mm=210.0)
    curves = by_path("read_plots").read_curves(sheet)
    now, before = (
        np.vstack([line for dashes, line in curves if bool(dashes) == is_dashed])
        for is_dashed in (False, True)
    )
    # Curvatures are at points of each station, the sharpest between two of them.
    assert np.ptp(now[:, 0]) == pytest.approx(2.0 * np.ptp(before[:, 0]), rel=1e-3)
    assert now[:, 1].max() == pytest.approx(0.5 * before[:, 1].max(), rel=1e-2)


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
