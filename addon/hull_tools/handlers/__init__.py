# SPDX-License-Identifier: GPL-3.0-or-later
"""What happens by itself: the one place that registers handlers."""

from functools import cache

import bpy

from ..bridge.background import timers
from ..bridge.objects import surface_upkeep
from . import follow, upkeep_handlers

_HANDLERS = (
    ("depsgraph_update_post", follow.after_update),
    ("depsgraph_update_post", upkeep_handlers.after_update),
    ("frame_change_post", follow.after_frame),
    ("frame_change_post", upkeep_handlers.after_update),
    ("render_pre", follow.before_picture),
    ("undo_pre", follow.before_undo),
    ("redo_pre", follow.before_undo),
    ("undo_post", follow.after_undo),
    ("undo_post", upkeep_handlers.after_undo),
    ("redo_post", follow.after_undo),
    ("redo_post", upkeep_handlers.after_undo),
    ("load_pre", follow.before_load),
    ("load_pre", upkeep_handlers.before_load),
    ("load_post", follow.after_load),
    ("load_post", upkeep_handlers.after_load),
)


def _begin():
    """The file that is open when the add-on is enabled was loaded without it."""
    follow.begin()
    upkeep_handlers.after_load()


@cache
def _beginning():
    """While enabling, data are out of reach: it begins right after."""
    return timers.Timer(0.0, _begin)


def register():
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)
    if not bpy.app.background:  # where no timer runs, nothing is loaded for one
        _beginning().start()


def unregister():
    _beginning().stop()
    for name, handler in _HANDLERS:
        registered = getattr(bpy.app.handlers, name)
        if handler in registered:  # other add-ons may have cleared the list
            registered.remove(handler)
    follow.forget_all()
    surface_upkeep.forget_all()
