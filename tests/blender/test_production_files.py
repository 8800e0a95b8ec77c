# SPDX-License-Identifier: GPL-3.0-or-later
"""Models and panels written in Blender: what the functions of the module make."""

import re

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, hull_io, make_active, part, sample, state_of
from edited_hulls import edit, select


def read_stl(path):
    data = path.read_bytes()
    records = np.frombuffer(
        data, np.dtype([("n", "<f4", 3), ("p", "<f4", (3, 3)), ("a", "<u2")]), -1, 84
    )
    return records["p"].astype(float)


def test_model_is_closed_at_its_scale(tmp_path):
    add_hull()
    path = tmp_path / "box.stl"
    assert bpy.ops.hull.export_model(filepath=str(path), scale=10.0) == {"FINISHED"}
    a, b, c = read_stl(path).transpose(1, 0, 2)
    volume = np.sum(np.cross(a, b) * c) / 6.0
    # The box of the tests is 10 x 4 x 3 m.
    assert volume == pytest.approx(120.0 * 1e9 / 1e3, rel=1e-6)


@pytest.mark.parametrize("ending", ["3mf", "obj", "cli"])
def test_other_files_of_the_model(tmp_path, ending):
    add_hull()
    path = tmp_path / f"box.{ending}"
    assert bpy.ops.hull.export_model(filepath=str(path), layer=1.0) == {"FINISHED"}
    assert path.stat().st_size > 300
    if ending == "cli":
        assert "$$LAYERS/30" in path.read_text()


def test_panels_of_the_hull_as_it_floats(tmp_path):
    hull = add_hull()
    hull.hull.draft = 2.0
    path = tmp_path / "box.gdf"
    assert bpy.ops.hull.export_panels(filepath=str(path), along=20) == {"FINISHED"}
    title, _, symmetry, count, *rows = path.read_text().splitlines()
    assert title and int(count) == len(rows)
    corners = np.array([row.split() for row in rows], dtype=float).reshape(-1, 4, 3)
    assert corners[..., 2].max() == 0.0 and corners[..., 2].min() == pytest.approx(-2.0)
    half = symmetry.split()[1] == "1"
    a, b, c, d = corners.transpose(1, 0, 2)
    flux = np.sum(corners.mean(axis=1)[:, 2] * np.cross(c - a, d - b)[:, 2] / 2)
    assert flux * (2 if half else 1) == pytest.approx(80.0, rel=1e-9)
    assert bpy.ops.hull.export_panels(filepath=str(tmp_path / "box.dat")) == {"FINISHED"}
    assert (tmp_path / "box.dat").read_text().splitlines()[-1] == "0 0 0 0"


def test_a_hull_out_of_the_water_is_one_sentence(tmp_path):
    hull = add_hull()
    hull.hull.draft = 0.0
    with pytest.raises(RuntimeError, match="out of the water|draft"):
        bpy.ops.hull.export_panels(filepath=str(tmp_path / "box.gdf"))
    assert not list(tmp_path.iterdir())


def test_too_many_triangles_is_one_sentence(tmp_path, monkeypatch):
    add_hull()
    monkeypatch.setattr(part("bridge.limits"), "MOST_MODEL_TRIANGLES", 10)
    with pytest.raises(RuntimeError, match="larger tolerance"):
        bpy.ops.hull.export_model(filepath=str(tmp_path / "box.stl"))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "call, name, words",
    [
        ("export_model", "box.step", ".stl, .3mf, .obj or .cli"),
        ("export_model", "box", ".stl, .3mf, .obj or .cli"),
        ("export_panels", "box.stl", ".gdf, .dat or .obj"),
        ("export_parts", "box.obj", ".stl"),
    ],
)
def test_unknown_endings_are_refused(tmp_path, call, name, words):
    hull = add_hull()
    hull.hull.draft = 2.0
    with pytest.raises(RuntimeError, match=f'"{name}" does not say.*{words}'):
        getattr(bpy.ops.hull, call)(filepath=str(tmp_path / name))
    assert not list(tmp_path.iterdir())


def test_the_sidebar_s_numbers_count(tmp_path):
    """Where the operator is not told otherwise."""
    hull = add_hull()
    hull.hull.model.scale = 20.0
    path = tmp_path / "box.stl"
    assert bpy.ops.hull.export_model(filepath=str(path)) == {"FINISHED"}
    assert np.ptp(read_stl(path)[..., 0]) == pytest.approx(500.0)
    assert bpy.ops.hull.export_model(filepath=str(path), scale=50.0) == {"FINISHED"}
    assert np.ptp(read_stl(path)[..., 0]) == pytest.approx(200.0)


def test_a_wall(tmp_path):
    add_hull()
    path = tmp_path / "box.stl"
    assert bpy.ops.hull.export_model(filepath=str(path), wall=5.0) == {"FINISHED"}
    a, b, c = read_stl(path).transpose(1, 0, 2)
    volume = np.sum(np.cross(a, b) * c) / 6.0
    # 100 x 40 x 30 mm less 90 x 30 x 20, and what the inner edges are chamfered by.
    assert volume == pytest.approx(120e3 - 54e3, rel=0.1) and volume >= 66e3 - 1e-3
    with pytest.raises(RuntimeError, match="nothing hollow"):
        bpy.ops.hull.export_model(filepath=str(path), wall=20.0)


@pytest.mark.parametrize("ending", ["stl", "3mf", "obj"])
def test_segments(tmp_path, ending):
    add_hull()
    path = tmp_path / f"box.{ending}"
    done = bpy.ops.hull.export_model(
        filepath=str(path),
        in_segments=True,
        machine_x=60.0,
        machine_y=60.0,
        machine_z=60.0,
        dowel=4.0,
    )
    assert done == {"FINISHED"}
    names = sorted(one.name for one in tmp_path.iterdir())
    assert names == ([path.name] if ending == "3mf" else [f"box-1.{ending}", f"box-2.{ending}"])
    if ending == "stl":
        volume = 0.0
        for one in tmp_path.iterdir():
            a, b, c = read_stl(one).transpose(1, 0, 2)
            assert np.ptp(read_stl(one)[..., 0]) == pytest.approx(50.0)
            volume += np.sum(np.cross(a, b) * c) / 6.0
        holes = 4 * 16 * np.sin(2 * np.pi / 32) * 2.0**2 * 12.0
        assert volume == pytest.approx(120e3 - holes, rel=1e-5)


def test_segments_in_layers_are_refused(tmp_path):
    add_hull()
    with pytest.raises(RuntimeError, match="turn In segments off"):
        bpy.ops.hull.export_model(filepath=str(tmp_path / "box.cli"), in_segments=True)
    assert not list(tmp_path.iterdir())


def test_named_parts(tmp_path):
    add_hull()
    path = tmp_path / "box.stl"
    assert bpy.ops.hull.export_parts(filepath=str(path)) == {"FINISHED"}
    rows = path.read_text().splitlines()
    solids = [row.split()[1] for row in rows if row.startswith("solid")]
    assert solids and "hull" in solids and len(set(solids)) == len(solids)
    assert [row.split()[1] for row in rows if row.startswith("endsolid")] == solids


def test_a_layer_is_a_part_of_its_own_name(tmp_path):
    """A keel by the layer of its faces: its area, both sides, closed together with the rest."""
    hull = add_hull()
    edit(hull, (False, False, True))
    select(hull, "face", [1])
    assert bpy.ops.hull.new_layer(name="Bar keel") == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    path = tmp_path / "box.stl"
    assert bpy.ops.hull.export_parts(filepath=str(path)) == {"FINISHED"}
    parts = hull_io("part_files").read_stl_parts(path)
    assert {"Bar_keel", "Shell", "deck"} == set(parts)
    a, b, c = parts["Bar_keel"].transpose(1, 0, 2)
    # The box's bottom of 10 x 4 m.
    assert np.cross(b - a, c - a).sum(axis=0) / 2.0 == pytest.approx([0, 0, -40.0], abs=1e-6)
    corners = np.vstack(list(parts.values())).reshape(-1, 3)
    points, triangles = np.unique(corners, axis=0, return_inverse=True)
    closed_model = part("bridge.native").require().ClosedModel(points, triangles.reshape(-1, 3))
    assert closed_model.open_sides == 0 and closed_model.volume == pytest.approx(120.0, rel=1e-9)


def test_figures_of_the_model_and_of_the_panels():
    hull = add_hull()
    hull.hull.draft = 2.0
    made = part("features.production.model_figures")
    assert made.model_figures(hull) == (None, False)
    assert bpy.ops.hull.make_model() == {"FINISHED"}
    figures, is_current = made.model_figures(hull)
    assert is_current and dict(figures.rows)["Volume"] == "120.0 cm³"
    assert dict(figures.rows)["Size mm"] == "100 × 40 × 30"
    hull.hull.model.scale = 50.0
    assert made.model_figures(hull) == (figures, False)
    assert bpy.ops.hull.make_panels() == {"FINISHED"}
    figures, is_current = made.panel_figures(hull, bpy.context.scene)
    assert is_current and dict(figures.rows)["Exact ∇"] == "80.0 m³"
    hull.hull.draft = 1.5
    assert not made.panel_figures(hull, bpy.context.scene)[1]


def test_panels_of_a_sheet_have_no_volume_to_be_off(capfd):
    hull = add_hull()
    for vertex in hull.data.vertices:
        vertex.co.y = 0.0
    hull.data.update()
    hull.hull.draft = 2.0
    bpy.context.view_layer.update()
    assert bpy.ops.hull.make_panels() == {"FINISHED"}
    made = part("features.production.model_figures")
    figures, _ = made.panel_figures(hull, bpy.context.scene)
    assert dict(figures.rows)["Off ∇"] == "–"
    assert "Warning" not in capfd.readouterr().err


def test_cancelling_leaves_nothing(tmp_path):
    hull = add_hull()
    files = part("features.production.production_files")
    made = part("features.production.made_models")
    jobs = part("bridge.background.jobs")
    task = files.ModelFile(
        hull, bpy.context.scene, str(tmp_path / "box.stl"), made.ModelOptions(100.0, 0.05, 2.0), 0.2
    )
    task.cancel()
    with pytest.raises(jobs.Cancelled):
        task.result()
    part("features.conversion.conversions").take_finished()
    assert not list(tmp_path.iterdir())


def without_title(path):
    """The bytes of a file but for the hull's name and those of parts, which count up."""
    return re.sub(rb"\A[^\n]*\n|solid [^\n]*\n|\.001", b"", path.read_bytes())


def with_keel():
    hull = sample("sailing_yacht")
    bpy.ops.hull.add_appendage(kind="FIN_KEEL")
    bpy.context.view_layer.update()
    make_active(hull)
    return hull, part("bridge.objects.appendages").of_hull(hull)[0].name


def test_files_of_a_hull_with_a_keel_say_that_they_are_without(tmp_path, capfd):
    """And are what they are without one, as is the error that panels are told to have."""
    calls = (
        ("export_model", "a.stl", {"tolerance": 1.0, "scale": 20.0}),
        ("export_panels", "a.gdf", {}),
        ("export_parts", "b.stl", {"part_tolerance": 20.0}),
    )
    sample("sailing_yacht")
    texts, files = [], []
    for call, name, options in calls:
        getattr(bpy.ops.hull, call)(filepath=str(tmp_path / name), **options)
        texts.append(capfd.readouterr().out)
        files.append(without_title(tmp_path / name))
    hull, keel = with_keel()
    for (call, name, options), text, data in zip(calls, texts, files):
        getattr(bpy.ops.hull, call)(filepath=str(tmp_path / name), **options)
        told = capfd.readouterr().out
        assert f"Without {keel}: appendages are in closed STEP and IGES files" in told
        assert "Without" not in text
        assert without_title(tmp_path / name) == data
        if call == "export_panels":
            assert (
                re.search(r"volume [+-][\d.]+ %", told)[0]
                == re.search(r"volume [+-][\d.]+ %", text)[0]
            )
    for make, figures in (
        (bpy.ops.hull.make_model, lambda models: models.model_figures(hull)),
        (bpy.ops.hull.make_panels, lambda models: models.panel_figures(hull, bpy.context.scene)),
    ):
        make()
        found, is_current = figures(part("features.production.model_figures"))
        assert is_current and f"Without {keel}" in found.remark
    # The exact volume beside the panels is the bare hull's.
    volume = float(dict(found.rows)["Exact ∇"].split()[0])
    joined = state_of(hull).hydrostatics.values.displaced_volume
    assert joined > 1.01 * volume
