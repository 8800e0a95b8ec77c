# SPDX-License-Identifier: GPL-3.0-or-later
"""Analyses in a thread: of the hull as it was when asked for, and gone when they should be."""

import threading

import addon_utils
import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, broaden, compute, module_name, part, state_of

NAME = "righting_levers"


def hull_with_levers(name="box"):
    hull = add_hull(name)
    hull.hull.draft, hull.hull.loading.kg = 1.0, 1.2
    bpy.context.view_layer.update()
    return hull


def latest(hull):
    return part("features.analyses.live_analyses").latest(hull, bpy.context.scene, NAME)


def begin(hull):
    part("features.analyses.live_analyses").begin([(hull.name, NAME)])


def take_finished():
    part("bridge.background.worker").finish()
    return part("features.analyses.live_analyses").take_finished()


def threads():
    return [one for one in threading.enumerate() if one.name.startswith("hull analysis")]


@pytest.fixture(autouse=True)
def nothing_left():
    yield
    part("features.analyses.live_analyses").stop()
    assert not threads()


@pytest.fixture
def gate(monkeypatch):
    """Holds the levers up in the thread until it is opened; counts those that began."""
    module = part("features.analyses").ANALYSES[NAME]
    original = module.compute
    opened, begun = threading.Event(), threading.Semaphore(0)

    def compute_behind_gate(ship, given):
        assert threading.current_thread() is not threading.main_thread()
        begun.release()
        assert opened.wait(30.0)
        return original(ship, given)

    monkeypatch.setattr(module, "compute", compute_behind_gate)
    opened.begun = begun
    yield opened
    opened.set()


@pytest.mark.parametrize(
    "name", ["hydrostatic_table", "bonjean_curves", NAME, "cross_curves", "criteria", "load_cases"]
)
def test_the_thread_gives_what_is_given_at_once(name):
    hull, analyses = hull_with_levers(), part("features.analyses")
    bpy.ops.hull.add_load_case()
    module, scene = analyses.ANALYSES[name], bpy.context.scene
    at_once = analyses.result_of(hull, scene, name)
    part("features.analyses").known(state_of(hull)).outcomes.clear()
    compute([(hull.name, name)])
    outcome, is_current = analyses.last_outcome(hull, scene, name)
    assert is_current and outcome.result is not at_once
    assert list(map(list, module.rows(outcome.result))) == list(map(list, module.rows(at_once)))


def test_the_last_result_stays_until_there_is_a_newer_one(gate):
    hull = hull_with_levers()
    begin(hull)
    gate.set()
    assert take_finished()
    first, is_current = latest(hull)
    assert is_current
    gate.clear()
    broaden(hull, 0.5)
    begin(hull)
    assert latest(hull) == (first, False)
    gate.set()
    assert take_finished()
    second, is_current = latest(hull)
    assert is_current and second.result.levers.gm > first.result.levers.gm


def test_edits_do_not_reach_what_is_being_computed(gate):
    hull = hull_with_levers()
    wanted = (
        part("features.analyses")
        .ANALYSES["criteria"]
        .compute(
            state_of(hull).ship.source.new_ship(),
            part("features.analyses").key_of(hull, bpy.context.scene, "criteria")[1],
        )
    )
    begin(hull)
    assert gate.begun.acquire(timeout=30.0)
    part("features.analyses.live_analyses").begin([(hull.name, "criteria")])
    for _ in range(20):
        broaden(hull, 0.05)
    gate.set()
    take_finished()
    (_, outcome) = part("features.analyses").known(state_of(hull)).outcomes["criteria"]
    assert [one.value for one in outcome.result.criteria] == [one.value for one in wanted.criteria]
    assert not latest(hull)[1]


def test_only_the_newest_of_those_that_wait_is_computed(gate):
    hull = hull_with_levers()
    begin(hull)
    assert gate.begun.acquire(timeout=30.0)
    for _ in range(5):
        broaden(hull, 0.1)
        begin(hull)
        begin(hull)  # asked for twice, computed once
    gate.set()
    assert take_finished()
    assert gate.begun.acquire(blocking=False) and not gate.begun.acquire(blocking=False)
    outcome, is_current = latest(hull)
    assert is_current and outcome.result.levers.gm == pytest.approx(0.5 + 5.0**2 / 12.0 - 1.2)


def test_what_came_too_late_is_shown_as_out_of_date(gate):
    hull = hull_with_levers()
    hull.hull.plots.righting_levers = True
    begin(hull)
    assert gate.begun.acquire(timeout=30.0)
    broaden(hull, 0.5)
    gate.set()
    take_finished()
    live = part("features.analyses.live_analyses")
    assert [one.is_current for one in live.plots().shown] == [False]
    compute([(hull.name, NAME)])
    assert [one.is_current for one in live.plots().shown] == [True]


def test_a_hull_deleted_meanwhile_is_no_matter(gate):
    hull = hull_with_levers()
    begin(hull)
    assert gate.begun.acquire(timeout=30.0)
    bpy.data.objects.remove(hull)
    bpy.context.view_layer.update()
    gate.set()
    assert take_finished()
    assert not part("features.hull.hull_state")._states


def test_an_export_does_not_wait_for_the_thread(gate, tmp_path):
    hull = hull_with_levers()
    begin(hull)
    assert gate.begun.acquire(timeout=30.0)
    path = tmp_path / "table.csv"
    assert bpy.ops.hull.export_table(analysis="criteria", filepath=str(path)) == {"FINISHED"}
    assert path.exists() and part("bridge.background.worker").is_busy()


def test_a_reason_comes_as_a_message():
    hull = hull_with_levers()
    hull.hull.loading.use_displacement, hull.hull.loading.mass_t = False, 1e4
    bpy.context.view_layer.update()
    compute([(hull.name, NAME)])
    outcome, is_current = latest(hull)
    assert is_current and outcome.result is None and "inks" in outcome.message


def open_soon(gate):
    threading.Timer(0.2, gate.set).start()


def test_nothing_runs_after_a_file_was_loaded(gate):
    hull = hull_with_levers()
    begin(hull)
    assert gate.begun.acquire(timeout=30.0) and threads()
    open_soon(gate)
    bpy.ops.wm.read_homefile(use_empty=True)
    assert not threads() and not part("bridge.background.worker").is_busy()
    assert not part("features.analyses.live_analyses").take_finished()


def test_nothing_runs_after_the_addon_was_disabled(gate):
    hull = hull_with_levers()
    begin(hull)
    assert gate.begun.acquire(timeout=30.0) and threads()
    open_soon(gate)
    addon_utils.disable(module_name())
    try:
        assert not threads()
    finally:
        addon_utils.enable(module_name(), default_set=True)


def test_two_hulls_have_their_own():
    hulls = [hull_with_levers("first"), hull_with_levers("second")]
    hulls[1].hull.draft = 1.5
    bpy.context.view_layer.update()
    compute([(hull.name, NAME) for hull in hulls])
    gms = []
    for hull in hulls:
        outcome, is_current = latest(hull)
        assert is_current
        gms.append(outcome.result.levers.gm)
    assert np.array(gms) == pytest.approx([0.5 + 16 / 12 - 1.2, 0.75 + 16 / 18 - 1.2])


def test_a_timer_that_looks_goes_on_after_an_error(capsys):
    """Else nothing would take what workers give; others end, and the next need starts them."""
    timer = part("bridge.background.timers").Timer
    looking, once = timer(0.1, lambda: 1 // 0, looks=True), timer(0.1, lambda: 1 // 0)
    assert [looking._called(), looking._called()] == [0.1, 0.1]
    assert capsys.readouterr().err.count("Traceback") == 1
    with pytest.raises(ZeroDivisionError):
        once._called()
