# SPDX-License-Identifier: GPL-3.0-or-later
"""Analyses that are looked at follow the hull: at once where that is quick, else when the user
pauses, in a thread. Nothing is computed that no panel and no plot shows.

Blender's windows are needed for it: in the background nobody looks, and nothing is computed.
"""

from dataclasses import dataclass, field
from time import monotonic

import bpy

from ...bridge.background import timers, worker
from ...bridge.blender import preferences, redraw, units
from ...bridge.objects import hull_objects
from .. import analyses
from ..hull import hull_state
from . import plot_layout

# A pause this long in the changes, and the numbers are made. Who misses them is a panel that draws,
# and drawing starts no timer: it notes since when, and one look after the other goes by that.
_PAUSE_SECONDS = 0.2
_LOOK_SECONDS = 0.05  # between looks at what is wanted, and at what the thread has made


@dataclass(frozen=True)
class Shown:
    """The plot_layout.Card of an analysis; it is of the hull as it is now, or a newer one is on its
    way."""

    name: str
    card: object
    is_current: bool


@dataclass(frozen=True)
class Plots:
    """What 3D views are to show now: Shown, and the corner that Object.hull.plots says."""

    shown: tuple = ()
    corner: str = "BOTTOM_LEFT"


@dataclass
class Wanted:
    """What was missed of one hull by who looked: {analysis: (its key_of, since when)}, monotonic
    seconds."""

    since: dict = field(default_factory=dict)


@dataclass
class Cards:
    """The last plots of one hull: {analysis: (what it is of, the plot_layout.Card, what it was made
    from)}."""

    by_name: dict = field(default_factory=dict)


def latest(obj, scene, name):
    """(the last Outcome for a panel to show or None, whether it is of the hull as it is now).

    That one is missed is noted in the hull's state, for `follow_wanted` to act on; of a mesh with
    errors there is none.
    """
    outcome, is_current = analyses.last_outcome(obj, scene, name)
    if hull_state.is_outdated(obj):
        return outcome, False
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
        placement = plot_layout.Placement.sized(settings.corner, settings.size)
        shown = tuple(one for name in names for one in _shown_of(obj, scene, name, placement))
        if shown:
            found = Plots(shown, settings.corner)
    _put_on_view(found)


def places(area, region):
    """The plot_layout.Place of each plot of now in a region of a 3D view; [] where the view shows
    none."""
    cards, ui_scale = [one.card for one in _plots.shown], bpy.context.preferences.system.ui_scale
    factor = preferences.value("plot_size")
    return plot_layout.places_of(cards, _plots.corner, area, region, ui_scale, factor)


def place_of(name, area, region):
    """The plot_layout.Place of the plot of an analysis in a region of a 3D view, or None."""
    found = zip(_plots.shown, places(area, region))
    return next((place for one, place in found if one.name == name), None)


def _put_on_view(found):
    global _plots
    if found != _plots:
        _plots = found
        redraw.redraw()


def _shown_of(obj, scene, name, placement):
    """The Shown of an analysis, as a list that is empty where there is none yet."""
    if analyses.ANALYSES[name].IS_LIVE:
        outcome, is_current = _outcome(obj, scene, name), not hull_state.is_outdated(obj)
    else:
        outcome, is_current = latest(obj, scene, name)
    if outcome is None or outcome.result is None:
        return []
    state = hull_state.state_of(obj)
    others, cards = analyses.others_beside(state, name), state.of(Cards).by_name
    shown = units.shown_in(scene)
    drawn = (id(outcome.result), obj.name, shown, placement, *map(id, others))
    known, card, _ = cards.get(name, (None, None, None))
    if known != drawn:
        try:
            plot = analyses.plot_of(name, outcome.result, obj.name, others, shown)
            card = plot_layout.card_of(plot, placement)
        except ValueError:
            return []  # nothing of it can be drawn
        # Kept, so that their identities stay theirs.
        cards[name] = (drawn, card, (outcome.result, others))
    return [Shown(name, card, is_current)]


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
                    due.append((state, name, key))
    for one in due:
        _begin(*one)


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
    # The piece holds the state, so that no other one has its identity while it is on its way.
    purpose, source = (id(state), name), state.ship.source

    def work():
        return state, name, key, analyses.computed(name, source.ship, key)

    worker.ask(purpose, key, work)


def take_finished():
    """Keeps what the thread has made since the last time, and shows it; whether there was any."""
    finished = list(worker.fetch())
    for state, name, key, outcome in finished:
        analyses.store(state, name, key, outcome)
    if finished:
        show_plots_of_active()
        redraw.redraw()
    return bool(finished)


def show_plots_of_active():
    """Has the plots of the active hull shown."""
    active = bpy.context.view_layer.objects.active
    show_plots(hull_objects.hull_of(active), bpy.context.scene)


def _look():
    follow_wanted()
    take_finished()
    return True


_plots = Plots()
_looks = timers.Timer(_LOOK_SECONDS, _look, looks=True)


def start():
    """Looks from now on, again and again, at what is wanted: what is drawn only notes it."""
    _looks.start()


def stop():
    """Forgets what is on its way, and all plots; when this returns nothing is computed."""
    _looks.stop()
    worker.stop()
    _put_on_view(Plots())
