# SPDX-License-Identifier: GPL-3.0-or-later
"""Analyses that are looked at follow the hull: at once where that is quick, else when the user
pauses. Nothing is computed that no panel and no plot shows.

Blender's windows are needed for it: in the background nobody looks, and nothing is computed.
"""

import bpy

from . import analyses, hull_objects, hull_state

# A pause this long in the changes, and the numbers are made.
_PAUSE_SECONDS = 0.2

_wanted = set()  # (object's name, analysis)
_plot_cache = {}  # analysis: (result, hull's name, plot)

# What shows plots: functions that take a list of hull_native.Plot and the name of a corner.
plot_viewers = []


def latest(obj, scene, name):
    """The last Outcome for a panel to show, or None; one that is not of now is asked for."""
    outcome, is_current = analyses.last_outcome(obj, scene, name)
    if not is_current:
        _request(obj, name)
    return outcome


def show_plots(obj, scene):
    """Shows the plots that are switched on for this hull, of what is known of it; None: none.

    Quick analyses are brought up to date, the others are asked for.
    """
    plots, corner = [], "BOTTOM_LEFT"
    if obj is not None and hull_state.state_of(obj) is not None:
        corner = obj.hull.plots.corner
        shown = [name for name in analyses.PLOTTED if getattr(obj.hull.plots, name)]
        plots = [plot for name in shown for plot in _plots_of(obj, scene, name)]
    for view in plot_viewers:
        view(plots, corner)


def _plots_of(obj, scene, name):
    """The plot of an analysis, as a list that is empty where there is none yet."""
    if analyses.ANALYSES[name].IS_LIVE:
        outcome = _outcome(obj, scene, name)
    else:
        outcome = latest(obj, scene, name)
    if outcome is None or outcome.result is None:
        return []
    result, hull_name, plot = _plot_cache.get(name, (None, "", None))
    if result is not outcome.result or hull_name != obj.name:
        try:
            plot = analyses.ANALYSES[name].plot(outcome.result, obj.name)
        except ValueError:
            return []  # nothing of it can be drawn
        _plot_cache[name] = (outcome.result, obj.name, plot)
    return [plot]


def _outcome(obj, scene, name):
    try:
        return analyses.outcome_of(obj, scene, name)
    except ValueError as error:
        return analyses.Outcome(message=str(error))


def _request(obj, name):
    """Asks for an analysis at the next pause; each request puts the pause off."""
    if bpy.app.background:
        return
    _wanted.add((obj.name, name))
    _stop_timer()
    bpy.app.timers.register(_compute_wanted, first_interval=_PAUSE_SECONDS)


def _compute_wanted():
    wanted = sorted(_wanted)
    _wanted.clear()
    compute(wanted)


def compute(wanted):
    """Computes pairs (name of a hull in the scene, analysis) and shows what is switched on."""
    scene = bpy.context.scene
    for object_name, name in wanted:
        obj = scene.objects.get(object_name)
        if hull_objects.is_hull(obj):
            _outcome(obj, scene, name)
    active = bpy.context.view_layer.objects.active
    show_plots(hull_objects.hull_of(active), scene)
    _redraw_sidebars()


def _redraw_sidebars():
    for window_manager in bpy.data.window_managers:
        for window in window_manager.windows:
            for area in window.screen.areas:
                if area.type == "VIEW_3D":
                    area.tag_redraw()


def _stop_timer():
    if bpy.app.timers.is_registered(_compute_wanted):
        bpy.app.timers.unregister(_compute_wanted)


def stop():
    """Forgets all requests and plots, and shows none."""
    _stop_timer()
    _wanted.clear()
    _plot_cache.clear()
    for view in plot_viewers:
        view([], "BOTTOM_LEFT")
