# SPDX-License-Identifier: GPL-3.0-or-later
"""Analyses that are looked at follow the hull: at once where that is quick, else when the user
pauses, in a thread. Nothing is computed that no panel and no plot shows.

Blender's windows are needed for it: in the background nobody looks, and nothing is computed.
"""

from dataclasses import dataclass

import bpy

from ...bridge.background import timers, worker
from ...bridge.blender import redraw
from ...bridge.objects import hull_objects
from .. import analyses
from ..hull import hull_state

# A pause this long in the changes, and the numbers are made.
_PAUSE_SECONDS = 0.2
_LOOK_SECONDS = 0.05  # between looks at what the thread has made

_wanted = set()  # (object's name, analysis)
_asked = {}  # (identity of a HullState, analysis): the key_of that the thread was given last
_plot_cache = {}  # analysis: (result, hull's name, plot)

# What shows plots: functions that take a list of Shown and, unless nothing is shown,
# Object.hull.plots, which says where.
plot_viewers = []


@dataclass(frozen=True)
class Shown:
    """A hull_native.Plot; it is of the hull as it is now, or a newer one is on its way."""

    plot: object
    is_current: bool


def latest(obj, scene, name):
    """(the last Outcome for a panel to show or None, whether it is of the hull as it is now).

    One that is not is asked for.
    """
    outcome, is_current = analyses.last_outcome(obj, scene, name)
    if not is_current:
        _request(obj, name)
    return outcome, is_current


def show_plots(obj, scene):
    """Shows the plots that are switched on for this hull, of what is known of it; None: none.

    Quick analyses are brought up to date, the others are asked for.
    """
    shown, settings = [], None
    if obj is not None and hull_state.state_of(obj) is not None:
        settings = obj.hull.plots
        names = [name for name in analyses.PLOTTED if getattr(settings, name)]
        shown = [plot for name in names for plot in _plots_of(obj, scene, name)]
    for view in plot_viewers:
        view(shown, settings)


def _plots_of(obj, scene, name):
    """The plot of an analysis, as a list that is empty where there is none yet."""
    if analyses.ANALYSES[name].IS_LIVE:
        outcome, is_current = _outcome(obj, scene, name), True
    else:
        outcome, is_current = latest(obj, scene, name)
    if outcome is None or outcome.result is None:
        return []
    result, hull_name, plot = _plot_cache.get(name, (None, "", None))
    if result is not outcome.result or hull_name != obj.name:
        try:
            plot = analyses.ANALYSES[name].plot(outcome.result, obj.name)
        except ValueError:
            return []  # nothing of it can be drawn
        _plot_cache[name] = (outcome.result, obj.name, plot)
    return [Shown(plot, is_current)]


def _outcome(obj, scene, name):
    try:
        return analyses.outcome_of(obj, scene, name)
    except ValueError as error:
        return analyses.Outcome(message=str(error))


def _request(obj, name):
    """Asks for an analysis at the next pause; each request for something new puts it off."""
    if bpy.app.background:
        return
    _wanted.add((obj.name, name))
    _pause.put_off()


def _begin_wanted():
    wanted = sorted(_wanted)
    _wanted.clear()
    begin(wanted)
    if worker.is_busy():
        _looks.start()


def begin(wanted):
    """Has pairs (name of a hull in the scene, analysis) computed in the thread."""
    scene = bpy.context.scene
    for object_name, name in wanted:
        obj = scene.objects.get(object_name)
        if not hull_objects.is_hull(obj):
            continue
        _, is_current = analyses.last_outcome(obj, scene, name)
        if not is_current:
            _begin(hull_state.state_of(obj), name, analyses.key_of(obj, scene, name))


def _begin(state, name, key):
    purpose, source = (id(state), name), state.ship.source
    if _asked.get(purpose) == key:
        return  # on its way already
    _asked[purpose] = key

    def work():
        return state, name, key, analyses.computed(name, source.ship, key)

    worker.ask(purpose, work)


def take_finished():
    """Keeps what the thread has made since the last time, and shows it; whether there was any."""
    finished = list(worker.fetch())
    for state, name, key, outcome in finished:
        analyses.store(state, name, key, outcome)
        if _asked.get((id(state), name)) == key:
            del _asked[id(state), name]
    if finished:
        active = bpy.context.view_layer.objects.active
        show_plots(hull_objects.hull_of(active), bpy.context.scene)
        redraw.redraw()
    return bool(finished)


def _look():
    take_finished()
    return worker.is_busy()


_pause = timers.Timer(_PAUSE_SECONDS, _begin_wanted)
_looks = timers.Timer(_LOOK_SECONDS, _look)


def stop():
    """Forgets all requests and plots, and shows none; when this returns nothing is computed."""
    _pause.stop()
    _looks.stop()
    worker.stop()
    _wanted.clear()
    _asked.clear()
    _plot_cache.clear()
    for view in plot_viewers:
        view([], None)
