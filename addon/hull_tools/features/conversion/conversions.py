# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversions of hulls to patches beside Blender's own work, and what came of the last ones.

Nothing is converted unless it is asked for. A hull has one task at a time: an object with `text`,
`share` (0 to 1), is_done(), cancel() and result(), and `state`, the HullState of the hull.
"""

import contextlib
from collections import OrderedDict
from dataclasses import dataclass

import bpy

from ...bridge.background import jobs, timers
from ...bridge.blender import redraw
from ...bridge.objects import hull_objects
from ..hull import hull_state
from . import patches

_LOOK_SECONDS = 0.1
_PAUSE_SECONDS = 0.3  # in the changes of settings, before they are converted by

# Of sidebars and of file dialogs.
_AREAS = ("VIEW_3D", "FILE_BROWSER")

# Outcomes by their key: undo finds those of before, of whatever hull has the same surface.
_KEPT = 4
_recent = OrderedDict()
# That run, whatever becomes of their hulls: what comes of those that were deleted is kept for undo.
_tasks = []


@dataclass(frozen=True, eq=False)
class Outcome:
    """key: what it was made from. converted: patches.Converted, or None and `message` says why."""

    key: tuple
    converted: object = None
    message: str = ""


@dataclass
class OfHull:
    """What is converted or written of one hull, a task or None, and the Outcome of its last
    conversion or None. is_requested: it is to be converted at the next pause."""

    task: object = None
    outcome: object = None
    is_requested: bool = False


class Conversion(jobs.JobTask):
    """The task of converting what a HullState has for a surface now."""

    text = "Converting"
    is_cancelled = False

    def __init__(self, state, choice):
        source = state.ship.source
        self.state, self.key = state, _key(state, choice)
        self._job = jobs.Job(
            lambda progress: patches.convert(source.new_surface(), choice, progress)
        )

    def cancel(self):
        self.is_cancelled = True
        super().cancel()

    def converted(self):
        """The patches.Converted, which is waited for. ValueError with the reason when there is
        none, jobs.Cancelled when it was. For any thread."""
        return self._job.result()

    def result(self):
        """The same, and keeps it for all to see."""
        try:
            converted = self.converted()
        except ValueError as error:
            _note(self.state, Outcome(self.key, message=str(error)))
            raise
        _note(self.state, Outcome(self.key, converted))
        return converted


def _key(state, choice):
    return (state.ship.geometry_key, choice)


def _note(state, outcome):
    known = _recent.get(outcome.key)
    if known is not None and known.converted is outcome.converted:
        return
    state.of(OfHull).outcome = outcome
    _recent[outcome.key] = outcome
    _recent.move_to_end(outcome.key)
    while len(_recent) > _KEPT:
        _recent.popitem(last=False)


def last_outcome(obj):
    """(the last Outcome of a hull or None, whether it is of the hull and settings as they are)."""
    state = hull_state.state_of(obj)
    if state is None or state.ship.geometry_key is None:
        return None, False
    known = state.of(OfHull)
    if state.status:
        return known.outcome, False
    key = _key(state, patches.choice_of(obj.hull.export))
    outcome = _recent.get(key)
    if outcome is not None:
        known.outcome = outcome
    return known.outcome, outcome is not None


def current(obj, scene):
    """The patches.Converted of the hull and settings as they are, None when there is none."""
    hull_state.refresh(obj, scene)
    outcome, is_current = last_outcome(obj)
    return outcome.converted if is_current else None


def report_of(obj):
    """The hull_native.QualityReport of the hull and settings as they are; ValueError when there is
    none."""
    outcome, is_current = last_outcome(obj)
    if not is_current or outcome.converted is None:
        raise ValueError("There is no report of the hull as it is: press Convert first")
    return outcome.converted.quality


def running(obj):
    """The task of a hull that is not done, or None."""
    state = hull_state.state_of(obj)
    task = None if state is None else state.of(OfHull).task
    return None if task is None or task.is_done() else task


def begin(obj, scene):
    """The Conversion of a hull as it is; one of the hull as it was is cancelled.

    ValueError when its mesh has no surface, or a file of the hull is being written.
    """
    state = hull_state.up_to_date(obj, scene)
    choice = patches.choice_of(obj.hull.export)
    before = running(obj)
    if isinstance(before, Conversion) and before.key == _key(state, choice):
        return before
    clear_way(obj)
    task = Conversion(state, choice)
    watch(task)
    return task


def clear_way(obj):
    """Cancels a conversion of a hull that runs; ValueError when a file of it is being written, or
    it is being fitted."""
    task = running(obj)
    if isinstance(task, Conversion):
        task.cancel()
    elif task is not None:
        raise ValueError(f"{task.text} is under way: wait for it or cancel it")


def watch(task):
    """Makes a task that of its `state`, and has the panels show how far it is."""
    task.state.of(OfHull).task = task
    _tasks.append(task)
    _looks.start()


def take_finished():
    """Keeps what has come of the tasks that are done."""
    for task in [one for one in _tasks if one.is_done()]:
        _tasks.remove(task)
        # What went wrong is told by the operator that waits for it, and by the panel.
        with contextlib.suppress(ValueError, OSError, jobs.Cancelled):
            task.result()


def _look():
    take_finished()
    redraw.redraw(*_AREAS)
    return bool(_tasks)


def request(obj):
    """Has a hull converted at the next pause if that is due: for a file dialog that opens, and for
    settings that are changed beside it."""
    if bpy.app.background or not _is_due(obj):
        return
    hull_state.state_of(obj).of(OfHull).is_requested = True
    _pause.start()


def _is_due(obj):
    """Whether there is no conversion of a hull as it is, none under way, none just cancelled."""
    state = hull_state.state_of(obj)
    if state is None or state.status or last_outcome(obj)[1]:
        return False
    task = state.of(OfHull).task
    if not isinstance(task, Conversion):
        return running(obj) is None
    is_same = task.key == _key(state, patches.choice_of(obj.hull.export))
    return not is_same or (task.is_done() and not task.is_cancelled)


def _begin_requested():
    for obj, state in list(hull_state.known_hulls(bpy.context.view_layer)):
        known = state.of(OfHull)
        is_requested, known.is_requested = known.is_requested, False
        if is_requested and hull_objects.is_hull(obj) and _is_due(obj):
            # Why a mesh has no surface is shown by the panel.
            with contextlib.suppress(ValueError):
                begin(obj, bpy.context.scene)


_looks = timers.Timer(_LOOK_SECONDS, _look, looks=True)
_pause = timers.Timer(_PAUSE_SECONDS, _begin_requested)


def stop():
    """Cancels all tasks and forgets all outcomes; when this returns nothing is converted."""
    _looks.stop()
    _pause.stop()
    jobs.stop()
    _tasks.clear()
    _recent.clear()
