# SPDX-License-Identifier: GPL-3.0-or-later
"""Analyses that are looked at follow the hull: at once where that is quick, else when the user
pauses, in a thread. Nothing is computed that no panel and no plot shows.

Blender's windows are needed for it: in the background nobody looks, and nothing is computed.
"""

from dataclasses import dataclass, field
from time import monotonic

import bpy

from ...bridge.background import timers, worker
from ...bridge.blender import redraw, units
from ...bridge.objects import hull_objects
from .. import analyses
from ..hull import hull_state
from ..variants import following

# A pause this long in the changes, and the numbers are made.
_PAUSE_SECONDS = 0.2
_LOOK_SECONDS = 0.05  # between looks at what is wanted, and at what the thread has made

_asked = {}  # (identity of a HullState, analysis): the key_of that the thread was given last
_diagrams = {}  # by the address of an area: see note_diagrams
_plot_cache = {}  # analysis: (what the plot is of, the plot, what it was made from)


@dataclass(frozen=True)
class Shown:
    """A hull_native.Plot of an analysis; it is of the hull as it is now, or a newer one is on its
    way."""

    name: str
    plot: object
    is_current: bool


@dataclass(frozen=True)
class Plots:
    """What 3D views are to show now: Shown, and the corner and size that Object.hull.plots says."""

    shown: tuple = ()
    corner: str = "BOTTOM_LEFT"
    size: float = 1.0


@dataclass
class Wanted:
    """What was missed of one hull by who looked: {analysis: (its key_of, since when)}, monotonic
    seconds."""

    since: dict = field(default_factory=dict)


def latest(obj, scene, name):
    """(the last Outcome for a panel to show or None, whether it is of the hull as it is now).

    That one is missed is noted in the hull's state, for `follow_wanted` to act on.
    """
    outcome, is_current = analyses.last_outcome(obj, scene, name)
    if not is_current:
        key, since = analyses.key_of(obj, scene, name), _wanted(obj)
        if name not in since or since[name][0] != key:
            since[name] = key, monotonic()
    return outcome, is_current


def _wanted(obj):
    return hull_state.state_of(obj).of(Wanted).since


def plots():
    """The Plots of now, for those who draw them."""
    return _plots


def show_plots(obj, scene):
    """Has the plots shown that are switched on for this hull, of what is known of it; None: none.

    Quick analyses are brought up to date, the others are noted as wanted.
    """
    found = Plots()
    if obj is not None and hull_state.state_of(obj) is not None:
        settings = obj.hull.plots
        names = [name for name in analyses.PLOTTED if getattr(settings, name)]
        shown = tuple(plot for name in names for plot in _plots_of(obj, scene, name))
        if shown:
            found = Plots(shown, settings.corner, settings.size)
    _put_on_view(found)


def note_diagrams(area, places):
    """Keeps where an area of Blender's shows plots now: by analysis (left, bottom, right, top) of
    the rectangle between the axes, and the same of the card, in dots of its region. Who draws them
    tells it, and who works in them with the mouse asks `diagram`."""
    _diagrams[area.as_pointer()] = places


def diagram(area, name):
    """Where an area shows the plot of an analysis, as noted, or None."""
    return _diagrams.get(area.as_pointer(), {}).get(name)


def _put_on_view(found):
    global _plots
    if found != _plots:
        _plots = found
        redraw.redraw()


def _plots_of(obj, scene, name):
    """The plot of an analysis, as a list that is empty where there is none yet."""
    if analyses.ANALYSES[name].IS_LIVE:
        outcome, is_current = _outcome(obj, scene, name), True
    else:
        outcome, is_current = latest(obj, scene, name)
    if outcome is None or outcome.result is None:
        return []
    others = analyses.others_beside(hull_state.state_of(obj), name)
    shown = units.shown_in(scene)
    drawn = (id(outcome.result), obj.name, shown, *map(id, others))
    known, plot, _ = _plot_cache.get(name, (None, None, None))
    if known != drawn:
        try:
            plot = analyses.plot_of(name, outcome.result, obj.name, others, shown)
        except ValueError:
            return []  # nothing of it can be drawn
        # Kept, so that their identities stay theirs.
        _plot_cache[name] = (drawn, plot, (outcome.result, others))
    return [Shown(name, plot, is_current)]


def _outcome(obj, scene, name):
    try:
        return analyses.outcome_of(obj, scene, name)
    except ValueError as error:
        return analyses.Outcome(message=str(error))


def follow_wanted():
    """Has what is wanted for the time of a pause, and is so still, computed in the thread."""
    scene, now, due = bpy.context.scene, monotonic(), []
    for obj, state in hull_state.known_hulls(bpy.context.view_layer):
        since = state.of(Wanted).since
        for name in [name for name, (_, begun) in since.items() if now - begun >= _PAUSE_SECONDS]:
            key, _ = since.pop(name)
            if not analyses.last_outcome(obj, scene, name)[1]:
                if analyses.key_of(obj, scene, name) == key:
                    due.append((obj.name, name))
    begin(due)


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
        _show_plots_of_active()
        redraw.redraw()
    return bool(finished)


def _show_plots_of_active():
    active = bpy.context.view_layer.objects.active
    show_plots(hull_objects.hull_of(active), bpy.context.scene)


def _look():
    if following.follow_asked():
        _show_plots_of_active()
    follow_wanted()
    take_finished()
    return True


_plots = Plots()
_looks = timers.Timer(_LOOK_SECONDS, _look)


def start():
    """Looks from now on, again and again, at what is wanted: what is drawn only notes it."""
    _looks.start()


def stop():
    """Forgets what is on its way, and all plots; when this returns nothing is computed."""
    _looks.stop()
    worker.stop()
    following.forget()
    _asked.clear()
    _plot_cache.clear()
    _diagrams.clear()
    _put_on_view(Plots())
