# SPDX-License-Identifier: GPL-3.0-or-later
"""Files for others: written whole or not at all, and read back."""

import csv
import threading
from types import MethodType, SimpleNamespace

import bpy
import pytest
from addon_under_test import add_hull, part


def test_a_folder_that_is_not_there_is_one_message(tmp_path):
    add_hull()
    for export in (
        bpy.ops.hull.export_lines,
        bpy.ops.hull.export_hull,
        bpy.ops.hull.export_table,
    ):
        with pytest.raises(RuntimeError) as caught:
            export(filepath=str(tmp_path / "nowhere" / "box.out"))
        assert "Traceback" not in str(caught.value)
    assert not list(tmp_path.iterdir())


def test_lines_plan(tmp_path):
    add_hull()
    path = tmp_path / "box.svg"
    assert bpy.ops.hull.export_lines(filepath=str(path)) == {"FINISHED"}
    assert "<svg" in path.read_text()


def test_table_of_hydrostatics(tmp_path):
    hull = add_hull()
    hull.hull.draft = 2.0
    path = tmp_path / "box.csv"
    assert bpy.ops.hull.export_table(filepath=str(path)) == {"FINISHED"}
    with open(path, newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [float(row["draft [m]"]) for row in rows] == pytest.approx(
        [0.2 * k for k in range(1, 11)]
    )
    for row in rows:
        volume = 40.0 * float(row["draft [m]"])
        assert float(row["displaced volume [m3]"]) == pytest.approx(volume, rel=1e-9)
        assert float(row["displacement [t]"]) == pytest.approx(1.025 * volume, rel=1e-9)
    assert [path.name for path in tmp_path.iterdir()] == ["box.csv"]


def test_the_format_is_chosen_in_the_dialog():
    cls, rna = bpy.types.HULL_OT_export_lines, bpy.ops.hull.export_lines.get_rna_type()
    dialog = SimpleNamespace(
        format=".pdf",
        _chosen=".pdf",
        filepath="/tmp/plan.pdf",
        properties=SimpleNamespace(bl_rna=rna),
    )
    dialog._endings = MethodType(cls._endings, dialog)

    def check(**changes):
        vars(dialog).update(changes)
        cls.check(dialog, None)
        return dialog.filepath, dialog.format

    assert check(format=".dxf") == ("/tmp/plan.dxf", ".dxf")
    assert check(filepath="/tmp/other.svg") == ("/tmp/other.svg", ".svg")
    assert check(filepath="/tmp/no ending") == ("/tmp/no ending.svg", ".svg")
    assert check() == ("/tmp/no ending.svg", ".svg")
    assert rna.properties["format"].enum_items.keys() == [".pdf", ".svg", ".png", ".dxf"]


def sample_with_a_long_table():
    bpy.ops.hull.load_sample(name="coaster")
    hull = bpy.context.object
    hull.hull.table.trims = "-1:1:0.1"
    bpy.context.view_layer.update()
    return hull


def test_a_cancelled_table_leaves_the_file_as_it_was(tmp_path, monkeypatch):
    """The work is held up in its first part, until it was cancelled."""
    hull = sample_with_a_long_table()
    module = part("features.curves_of_form.hydrostatic_table")
    begun, cancelled = threading.Event(), threading.Event()
    original = module._afloat

    def afloat_behind_gate(*arguments):
        assert threading.current_thread() is not threading.main_thread()
        begun.set()
        assert cancelled.wait(30.0)
        return original(*arguments)

    monkeypatch.setattr(module, "_afloat", afloat_behind_gate)
    path = tmp_path / "table.csv"
    path.write_text("before")
    task = part("features.exchange.file_tasks").Table(
        hull, bpy.context.scene, "hydrostatic_table", str(path)
    )
    assert begun.wait(30.0)
    assert part("features.conversion.conversions").running(hull) is task
    task.cancel()
    cancelled.set()
    with pytest.raises(part("bridge.background.jobs").Cancelled):
        task.result()
    assert path.read_text() == "before"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("name", ["hydrostatic_table", "cross_curves"])
def test_a_long_table_tells_how_far_it_is(name, tmp_path, monkeypatch):
    hull = sample_with_a_long_table()
    shares, jobs = [], part("bridge.background.jobs")
    told = jobs.Job._tell

    def note(job, share):
        shares.append(share)
        told(job, share)

    monkeypatch.setattr(jobs.Job, "_tell", note)
    bpy.ops.hull.export_table(analysis=name, filepath=str(tmp_path / "table.csv"))
    assert len(shares) > 5 and shares == sorted(shares) and shares[-1] == 1.0
    # What was computed is known to the panels now.
    outcome, is_current = part("features.analyses").last_outcome(hull, bpy.context.scene, name)
    assert is_current and outcome.result is not None


def test_all_files_of_a_hull_are_in_the_menu():
    """File › Export has each operator that writes a file of the hull."""
    found = []

    class Layout:
        def operator(self, name, **unused):
            found.append(name)

        def operator_menu_enum(self, name, *unused, **more):
            found.append(name)

    owner = type("Menu", (), {"layout": Layout()})()
    part("operators.export_hull").draw_export_menu(owner, bpy.context)
    names = {name for name in dir(bpy.ops.hull) if name.startswith("export_")}
    # Those of networks, families and reports are in their own panels.
    others = {"network", "series", "series_table", "report"}
    names -= {f"export_{name}" for name in others}
    assert {f"hull.{name}" for name in names} == set(found)
