# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion to patches in a thread: of the hull as it was when asked for, reported as long as it
is of the hull as it is, and gone when it should be."""

import json
import threading
import time
from math import degrees, radians

import addon_utils
import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, broaden, make_active, module_name, part, state_of

pytestmark = pytest.mark.once


def outcome_of(hull):
    return part("features.conversion.conversions").last_outcome(hull)


def begin(hull):
    return part("features.conversion.conversions").begin(hull, bpy.context.scene)


def threads():
    return [one for one in threading.enumerate() if one.name.startswith("hull job")]


@pytest.fixture(autouse=True)
def nothing_left():
    yield
    part("features.conversion.conversions").stop()
    assert not threads()


@pytest.fixture
def gate(monkeypatch):
    """Holds conversions up in the thread until it is opened, or they are cancelled; counts those
    that began."""
    module = part("features.conversion.patches")
    original = module.convert
    opened, begun = threading.Event(), threading.Semaphore(0)

    def convert_behind_gate(surface, choice, progress):
        assert threading.current_thread() is not threading.main_thread()
        begun.release()
        until = time.monotonic() + 30.0
        while not opened.wait(0.005):
            assert time.monotonic() < until
            progress(0.5)
        return original(surface, choice, progress)

    monkeypatch.setattr(module, "convert", convert_behind_gate)
    opened.begun = begun
    yield opened
    opened.set()


def test_a_box_is_exact():
    hull = add_hull()
    assert outcome_of(hull) == (None, False)
    assert bpy.ops.hull.convert() == {"FINISHED"}
    outcome, is_current = outcome_of(hull)
    quality = outcome.converted.quality
    assert is_current
    assert quality.patch_count == quality.theoretical_patch_count == 4
    assert quality.largest_distance < 1e-12 * quality.length and quality.length == 10.0
    assert quality.exact_share == pytest.approx(1.0)


def test_the_report_is_of_the_hull_and_settings_as_they_are():
    hull = add_hull()
    bpy.ops.hull.convert()
    first = outcome_of(hull)[0]
    for name, value, usual in (
        ("tolerance", 1e-7, 1e-6),
        ("seam_angle", 0.01, 0.0),
        ("matched_knots", True, False),
        ("most_control_points", 500, 0),
        ("bezier", True, False),
        ("conversion", "PER_CELL", "AUTOMATIC"),
        ("conversion", "EXACT", "AUTOMATIC"),
    ):
        setattr(hull.hull.export, name, value)
        assert outcome_of(hull) == (first, False), name
        setattr(hull.hull.export, name, usual)
        assert outcome_of(hull) == (first, True), name
    # What only the file depends on asks for no other patches.
    hull.hull.export.extent, hull.hull.export.unit = "HALF", "mm"
    hull.hull.draft = 1.0
    bpy.context.view_layer.update()
    assert outcome_of(hull) == (first, True)
    broaden(hull, 0.5)
    assert outcome_of(hull) == (first, False)
    bpy.ops.hull.convert()
    second, is_current = outcome_of(hull)
    assert is_current and second is not first
    broaden(hull, -0.5)
    assert outcome_of(hull) == (first, True)


def test_undo_brings_the_report_back():
    name = add_hull().name
    bpy.ops.hull.convert()
    first = outcome_of(bpy.data.objects[name])[0]
    bpy.ops.ed.undo_push(message="converted")
    broaden(bpy.data.objects[name], 0.5)
    bpy.ops.ed.undo_push(message="moved")
    assert not outcome_of(bpy.data.objects[name])[1]
    bpy.ops.ed.undo()
    assert outcome_of(bpy.data.objects[name]) == (first, True)
    bpy.ops.ed.redo()
    assert not outcome_of(bpy.data.objects[name])[1]


def test_settings_decide_the_patches():
    hull = add_hull()
    hull.hull.export.conversion = "PER_CELL"
    for control_points in (4, 6):
        hull.hull.export.control_points = control_points
        bpy.ops.hull.convert()
        patches = outcome_of(hull)[0].converted.patches
        assert patches.control_points(0).shape == (control_points, control_points, 3)


def test_settings_for_other_systems_decide_the_patches(freeship_folder):
    bpy.ops.hull.import_hull(filepath=str(freeship_folder / "FREE!ship demo 6.fbm"))
    hull = bpy.context.object
    settings = hull.hull.export

    def sizes():
        assert bpy.ops.hull.convert() == {"FINISHED"}
        patches = outcome_of(hull)[0].converted.patches
        shapes = [patches.control_points(k).shape[:2] for k in range(patches.patch_count)]
        return np.array(shapes).prod(axis=1)

    usual = sizes()
    settings.matched_knots = True
    matched = sizes()
    assert len(matched) == len(usual) and matched.sum() > usual.sum()
    settings.matched_knots, settings.most_control_points = False, 150
    few = sizes()
    assert usual.max() > 150 >= few.max() and len(few) > len(usual)
    settings.most_control_points, settings.bezier = 0, True
    bezier = sizes()
    assert set(bezier.tolist()) == {16} and len(bezier) > len(few)


def test_settings_survive_saving(tmp_path):
    hull = add_hull()
    settings, wanted = hull.hull.export, {
        "conversion": "PER_CELL", "control_points": 6, "tolerance": 1e-8,
        "seam_angle": radians(0.125), "matched_knots": True, "most_control_points": 900,
        "bezier": True, "extent": "SOLID", "unit": "mm", "schema": "AP242",
        "with_sections": True, "with_features": True,
    }  # fmt: skip
    for name, value in wanted.items():
        setattr(settings, name, value)
    path = str(tmp_path / "hull.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=path)
    loaded = bpy.data.objects["box"].hull.export
    assert {name: getattr(loaded, name) for name in wanted} == pytest.approx(wanted)


def test_the_tolerance_in_millimetres_is_kept_as_a_part_of_the_length():
    settings = add_hull().hull.export
    assert settings.tolerance_mm == pytest.approx(1e-2)
    settings.tolerance_mm = 0.5
    assert settings.tolerance == pytest.approx(5e-5)
    # Given as typed, though Blender keeps single precision.
    choice = part("features.conversion.patches").choice_of(settings)
    assert dict(choice.options)["tolerance"] == 5e-5


def test_what_is_not_kept_is_warned_of():
    patches = part("features.conversion.patches")
    settings = add_hull().hull.export
    asked = patches.asked_of(settings)
    assert degrees(asked.seam_angle) == pytest.approx(0.02)
    settings.tolerance = 1e-8
    assert degrees(patches.asked_of(settings).seam_angle) == pytest.approx(0.002)

    class Quality:
        length, largest_distance, largest_seam_angle, largest_gap = 10.0, 9e-6, 3e-4, 0.0
        patch_count = 2

    assert patches.warnings(Quality, asked) == []
    Quality.largest_distance, Quality.largest_seam_angle = 2e-5, 4e-4
    Quality.largest_gap = 1e-6
    distance, angle, gaps = patches.warnings(Quality, asked)
    assert "0.01 mm" in distance and "0.02°" in angle and "gaps" in gaps
    text, warns = patches.summary(patches.Converted(None, Quality, 4, True), asked)
    assert warns and "0.02 mm" in text and text.endswith(gaps)


def test_numbers_are_for_people():
    units = part("bridge.blender.units")
    assert units.format_mm(0.0) == "0 mm" and units.format_mm(8.3456e-5) == "0.0835 mm"
    assert units.format_mm(1e-12) == "below 1e-06 mm" and units.format_mm(2.3456) == "2346 mm"
    assert units.format_small_angle(radians(0.0123)) == "0.0123°"
    assert units.format_jump(21800.4) == "21800 1/m"


def test_edits_do_not_reach_what_is_being_converted(gate):
    hull = add_hull()
    task = begin(hull)
    assert gate.begun.acquire(timeout=30.0)
    for _ in range(20):
        broaden(hull, 0.05)
    gate.set()
    points = task.result().patches.positions([0, 1, 2, 3], np.full((4, 2), 0.5))
    assert points[:, 1].max() == pytest.approx(2.0)
    assert not outcome_of(hull)[1]


def test_asked_for_twice_it_is_converted_once(gate):
    hull = add_hull()
    task = begin(hull)
    assert begin(hull) is task
    hull.hull.export.tolerance = 1e-7
    other = begin(hull)
    assert other is not task
    gate.set()
    other.result()
    with pytest.raises(part("bridge.background.jobs").Cancelled):
        task.result()
    assert outcome_of(hull)[1]


def test_a_cancelled_conversion_leaves_the_last_one(gate):
    hull = add_hull()
    gate.set()
    bpy.ops.hull.convert()
    first = outcome_of(hull)[0]
    gate.clear()
    hull.hull.export.tolerance = 1e-7
    task = begin(hull)
    assert bpy.ops.hull.cancel_task.poll()
    assert bpy.ops.hull.cancel_task() == {"FINISHED"}
    with pytest.raises(part("bridge.background.jobs").Cancelled):
        task.result()
    assert outcome_of(hull) == (first, False)
    assert not bpy.ops.hull.cancel_task.poll()


def test_progress_is_told(gate):
    hull = add_hull()
    assert hull.hull.export.progress == 0.0
    task = begin(hull)
    assert gate.begun.acquire(timeout=30.0)
    until = time.monotonic() + 30.0
    while task.share < 0.5 and time.monotonic() < until:
        time.sleep(0.01)
    assert hull.hull.export.progress == pytest.approx(50.0)
    gate.set()
    task.result()
    assert task.share == 1.0


def test_progress_never_goes_back():
    shares = []
    hull = add_hull()
    patches = part("features.conversion.patches")
    source = state_of(hull).ship.source
    for conversion in ("AUTOMATIC", "EXACT", "PER_CELL"):
        hull.hull.export.conversion = conversion
        shares.clear()
        patches.convert(source.new_surface(), patches.choice_of(hull.hull.export), shares.append)
        assert shares == sorted(shares) and 0.0 <= shares[0] and shares[-1] <= 1.0


@pytest.mark.parametrize("share", [0.05, 0.5])
def test_converting_and_measuring_end_when_cancelled(freeship_folder, share):
    bpy.ops.hull.import_hull(filepath=str(freeship_folder / "FREE!ship demo 6.fbm"))
    hull, patches, cancelled = (
        bpy.context.object,
        part("features.conversion.patches"),
        part("bridge.background.jobs"),
    )
    surface, told = state_of(hull).ship.source.new_surface(), []

    def tell(done):
        told.append(done)
        if done >= share:
            raise cancelled.Cancelled

    with pytest.raises(cancelled.Cancelled):
        patches.convert(surface, patches.choice_of(hull.hull.export), tell)
    assert share <= told[-1] < share + 0.2 and len(told) > 1


def test_a_hull_deleted_meanwhile_is_no_matter(gate):
    hull = add_hull()
    task = begin(hull)
    assert gate.begun.acquire(timeout=30.0)
    bpy.data.objects.remove(hull)
    bpy.context.view_layer.update()
    gate.set()
    assert task.result().quality.patch_count == 4
    part("features.conversion.conversions").take_finished()


def test_nothing_runs_after_a_file_was_loaded(gate):
    task = begin(add_hull())
    assert gate.begun.acquire(timeout=30.0) and threads()
    bpy.ops.wm.read_homefile(use_empty=True)
    assert not threads() and task.is_done()
    assert outcome_of(add_hull()) == (None, False)


def test_nothing_runs_after_the_addon_was_disabled(gate):
    begin(add_hull())
    assert gate.begun.acquire(timeout=30.0) and threads()
    addon_utils.disable(module_name())
    try:
        assert not threads()
    finally:
        addon_utils.enable(module_name(), default_set=True)


def test_two_hulls_have_their_own(gate):
    first, second = add_hull("first"), add_hull("second")
    broaden(second, 1.0)
    tasks = [begin(first), begin(second)]
    gate.set()
    for hull, task, breadth in zip((first, second), tasks, (2.0, 3.0)):
        converted = task.result()
        points = converted.patches.positions([0, 1, 2, 3], np.full((4, 2), 0.5))
        assert points[:, 1].max() == pytest.approx(breadth)
        assert outcome_of(hull)[0].converted is converted


def test_nothing_is_converted_unasked(gate):
    hull = add_hull()
    broaden(hull, 0.5)
    hull.hull.export.tolerance = 1e-7
    bpy.context.view_layer.update()
    part("features.conversion.conversions").request(hull)  # no window: nobody looks
    assert not gate.begun.acquire(blocking=False) and not threads()


def test_a_mesh_with_errors_is_a_message():
    hull = add_hull()
    bpy.ops.hull.convert()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.delete(type="FACE")
    bpy.ops.object.mode_set(mode="OBJECT")
    with pytest.raises(RuntimeError, match="no faces"):
        bpy.ops.hull.convert()
    assert not outcome_of(hull)[1]


def test_a_reason_comes_as_a_message(monkeypatch):
    def refuse(*unused):
        raise ValueError("Face 3 cannot be")

    monkeypatch.setattr(part("features.conversion.patches"), "convert", refuse)
    hull = add_hull()
    with pytest.raises(RuntimeError, match="Face 3 cannot be"):
        bpy.ops.hull.convert()
    outcome, is_current = outcome_of(hull)
    assert is_current and outcome.converted is None and outcome.message == "Face 3 cannot be"


@pytest.mark.parametrize(
    "kind, attribute",
    [
        ("DISTANCE", "worst_point"),
        ("ANGLE", "worst_seam_point"),
        ("CURVATURE", "worst_curvature_point"),
    ],
)
def test_the_worst_spot_is_marked(freeship_folder, kind, attribute):
    scene, spots = bpy.context.scene, part("features.conversion.worst_spots")
    bpy.ops.hull.import_hull(filepath=str(freeship_folder / "FREE!ship demo 6.fbm"))
    hull = bpy.context.object
    with pytest.raises(RuntimeError, match="Convert first"):
        bpy.ops.hull.show_worst_spot(kind=kind)
    hull.location = (10.0, 20.0, 30.0)
    bpy.ops.hull.convert()
    scene.unit_settings.scale_length = 0.5
    bpy.context.view_layer.update()
    bpy.ops.hull.convert()
    assert spots.shown_spot(hull, scene) is None
    assert bpy.ops.hull.show_worst_spot(kind=kind) == {"FINISHED"}
    quality = outcome_of(hull)[0].converted.quality
    wanted = 2.0 * np.array(getattr(quality, attribute)) + hull.location
    assert np.array(scene.cursor.location) == pytest.approx(wanted, abs=1e-4)
    place, text = spots.shown_spot(hull, scene)
    assert np.array(place) == pytest.approx(wanted, abs=1e-4)
    assert text.startswith(spots.KINDS[kind][0]) and "before" not in text
    hull.hull.export.bezier = True
    assert spots.shown_spot(hull, scene)[1] == f"{text} before the last change"
    bpy.ops.hull.show_worst_spot(kind="NONE")
    assert spots.shown_spot(hull, scene) is None


def test_the_mark_is_a_ring():
    corners = part("overlays.shapes").ring((100.0, 50.0), 12.0)
    distances = np.linalg.norm(corners - (100.0, 50.0, 0.0), axis=1)
    assert distances == pytest.approx(np.full(len(corners), 12.0))
    assert len(corners) % 2 == 0  # segments
    assert corners[1::2][:-1] == pytest.approx(corners[2::2]) and len(corners) > 20
    assert corners[0] == pytest.approx(corners[-1], abs=1e-4)


def test_a_spot_that_is_not_there_is_a_message():
    hull = add_hull()
    bpy.ops.hull.convert()
    with pytest.raises(RuntimeError, match="knuckles"):
        bpy.ops.hull.show_worst_spot(kind="ANGLE")
    assert part("features.conversion.worst_spots").shown_spot(hull, bpy.context.scene) is None


def test_the_report_is_written_as_text_and_json(tmp_path):
    hull = add_hull()
    with pytest.raises(RuntimeError, match="Convert first"):
        bpy.ops.hull.export_report(filepath=str(tmp_path / "report.txt"))
    with pytest.raises(RuntimeError, match="Convert first"):
        bpy.ops.hull.copy_report()
    bpy.ops.hull.convert()
    for name in ("report.txt", "report.json"):
        assert bpy.ops.hull.export_report(filepath=str(tmp_path / name)) == {"FINISHED"}
    assert bpy.ops.hull.copy_report() == {"FINISHED"}
    quality = outcome_of(hull)[0].converted.quality
    assert (tmp_path / "report.txt").read_text(encoding="utf-8") == quality.text()
    assert isinstance(json.loads((tmp_path / "report.json").read_text(encoding="utf-8")), dict)
    broaden(hull, 0.5)
    with pytest.raises(RuntimeError, match="Convert first"):
        bpy.ops.hull.export_report(filepath=str(tmp_path / "other.txt"))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["report.json", "report.txt"]


def test_without_a_hull_there_is_nothing_to_convert():
    bpy.ops.mesh.primitive_cube_add()
    make_active(bpy.context.object)
    assert not bpy.ops.hull.convert.poll()
    assert not bpy.ops.hull.cancel_task.poll()
