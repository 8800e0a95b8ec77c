# SPDX-License-Identifier: GPL-3.0-or-later
"""Series of members: tables, whose numbers of boxes have closed forms, and files that read back."""

import csv
import re

import bpy
import numpy as np
import pytest
from addon_under_test import HALF_BREADTH, LENGTH, hull_io, mesh_points, part, state_of
from expect_morph import boxes, morph_of, set_weight

pytestmark = pytest.mark.once


@pytest.fixture(autouse=True)
def nothing_left():
    yield
    part("features.conversion.conversions").stop()


def family():
    return morph_of(*boxes((1.0, 1.0, 1.0), (2.0, 1.5, 0.5)))


def table(path):
    with open(path, encoding="utf-8-sig") as file:
        return list(csv.DictReader(file))


def test_the_table_of_a_series(tmp_path):
    made = family()
    path = tmp_path / "series.csv"
    assert bpy.ops.hull.export_series_table(filepath=str(path)) == {"FINISHED"}
    rows = table(path)
    assert [float(row["t"]) for row in rows] == pytest.approx(np.linspace(0, 1, 11))
    for row in rows:
        t = float(row["t"])
        draft = 1.8 - 0.9 * t
        assert float(row["draft [m]"]) == pytest.approx(draft)
        assert float(row["weight of box 1"]) == pytest.approx(t)
        volume = LENGTH * (1 + t) * 2.0 * HALF_BREADTH * (1 + 0.5 * t) * draft
        assert float(row["displaced volume [m3]"]) == pytest.approx(volume, rel=1e-6)
        assert float(row["Lpp [m]"]) == pytest.approx(LENGTH * (1 + t))
        assert row["remark"] == ""
    areas = table(tmp_path / "series-areas.csv")
    for row in areas:
        t = float(row["t"])
        area = 2.0 * HALF_BREADTH * (1 + 0.5 * t) * (1.8 - 0.9 * t)
        assert float(row["area [m2]"]) == pytest.approx(area, rel=1e-6)
    assert len({row["t"] for row in areas}) == 11
    set_weight(made, 0, 0.3)  # the panel's numbers of one member are the table's
    values = state_of(made).hydrostatics.values
    assert float(rows[7]["KMt [m]"]) == pytest.approx(values.kmt, rel=1e-6)


def test_between_any_weights_and_drafts_that_stay(tmp_path):
    made = family()
    made.hull.morph.follows_particulars = False
    made.hull.draft = 1.0
    path = tmp_path / "series.csv"
    bpy.ops.hull.export_series_table(
        filepath=str(path), first_weights="1.2 -0.2", last_weights="0.5 0.5", steps=2
    )
    rows = table(path)
    assert [float(row["weight of box 0"]) for row in rows] == pytest.approx([1.2, 0.85, 0.5])
    assert {float(row["draft [m]"]) for row in rows} == {1.0}
    with pytest.raises(RuntimeError, match="same hull"):
        bpy.ops.hull.export_series_table(
            filepath=str(path), first_weights="1 0", last_weights="1 0"
        )
    with pytest.raises(RuntimeError, match="number of a parent"):
        made.hull.morph.series_to = 3
        bpy.ops.hull.export_series_table(filepath=str(path))


def test_a_folded_member_is_a_row_with_its_reason(tmp_path):
    morph_of(*boxes((1.0, 1.0, 1.0), (1.0, 4.0, 1.0)))
    path = tmp_path / "series.csv"
    bpy.ops.hull.export_series_table(
        filepath=str(path), first_weights="1 0", last_weights="1.8 -0.8", steps=2
    )
    first, _, last = table(path)
    assert first["remark"] == "" and re.search("t = 1 the surface folds", last["remark"])
    assert last["displaced volume [m3]"] == ""
    count = len(list(tmp_path.iterdir()))
    with pytest.raises(RuntimeError, match="folds"):
        bpy.ops.hull.export_series(
            directory=str(tmp_path), first_weights="1 0", last_weights="1.8 -0.8", steps=2
        )
    assert len(list(tmp_path.iterdir())) == count


def test_hull_files_of_a_series_read_back(tmp_path):
    made = family()
    assert bpy.ops.hull.export_series(directory=str(tmp_path), steps=4) == {"FINISHED"}
    paths = sorted(tmp_path.iterdir())
    assert len(paths) == 5
    for number, path in enumerate(paths):
        t = number / 4
        bpy.context.view_layer.objects.active = made
        set_weight(made, 1, t)
        data = hull_io().read_hull_file(path)
        assert np.array_equal(data.points.astype(np.float32), mesh_points(made))
        assert data.particulars.draft == pytest.approx(made.hull.draft)
        assert data.load.kg == pytest.approx(made.hull.loading.kg)
        assert bpy.ops.hull.import_hull(filepath=str(path)) == {"FINISHED"}
        values = state_of(bpy.context.object).hydrostatics.values
        assert values.displaced_volume == pytest.approx(
            state_of(made).hydrostatics.values.displaced_volume, rel=1e-6
        )


@pytest.mark.parametrize("file_format, ending", (("STEP", ".step"), ("IGES", ".igs")))
def test_cad_files_of_a_series(tmp_path, file_format, ending):
    made = family()
    made.hull.morph.series_format = file_format
    assert bpy.ops.hull.export_series(directory=str(tmp_path), steps=2) == {"FINISHED"}
    paths = sorted(tmp_path.iterdir())
    assert len(paths) == 3 and all(path.suffix == ending for path in paths)
    for path in paths:
        report = part("bridge.native").require().read_cad_report(str(path))
        assert report["valid"]


def test_a_folder_that_is_not_there():
    family()
    with pytest.raises(RuntimeError, match="no folder"):
        bpy.ops.hull.export_series(directory="/nowhere/at/all")


def test_what_is_cancelled_leaves_nothing(tmp_path):
    made = family()
    files = part("features.morphing.series_files")
    jobs = part("bridge.background.jobs")
    old = tmp_path / f"{bpy.path.clean_name(made.name)}_t0000.hull.json"
    old.write_text("mine")
    task = files.SeriesFiles(made, bpy.context.scene, str(tmp_path), "HULL", steps=200)
    task.cancel()
    with pytest.raises(jobs.Cancelled):
        task.result()
    assert [path.name for path in tmp_path.iterdir()] == [old.name]
    assert old.read_text() == "mine"


def test_what_is_left_out_of_the_shell_is_left_out_of_the_series(tmp_path):
    """A member at t is the hull at these weights, with the same layers."""
    made = family()
    layer = made.hull.layers.add()
    layer.material, layer.in_hydrostatics = bpy.data.materials.new("Fin"), False
    made.data.materials.clear()
    for material in (bpy.data.materials.new("Shell"), layer.material):
        made.data.materials.append(material)
    # What has the first point goes, so that others have other numbers.
    faces = [face.index for face in made.data.polygons if 0 in face.vertices]
    for face in made.data.polygons:
        face.material_index = int(face.index in faces)
    made.data.update()
    bpy.context.view_layer.update()
    state = part("features.hull.hull_state").up_to_date(made, bpy.context.scene)
    made.hull.morph.shown_mesh = part("features.morphing.members")._mesh_key(
        part("bridge.objects.hull_mesh").read(made)
    )
    series = part("features.morphing.series").of_hull(made, bpy.context.scene, steps=2)
    control = series.member(series.steps[1]).control
    assert control.points.shape == state.ship.source.control.points.shape
    assert np.allclose(control.points, state.ship.source.control.points, atol=1e-6)


def test_a_series_goes_to_no_folder_that_is_not_named():
    family()
    with pytest.raises(RuntimeError, match="No folder is named"):
        bpy.ops.hull.export_series()


def test_both_tables_are_written_or_none(tmp_path):
    family()
    path, taken = tmp_path / "series.csv", tmp_path / "series-areas.csv"
    path.write_text("as it was")
    taken.mkdir()
    with pytest.raises(RuntimeError, match="folder"):
        bpy.ops.hull.export_series_table(filepath=str(path))
    assert path.read_text() == "as it was" and set(tmp_path.iterdir()) == {path, taken}
