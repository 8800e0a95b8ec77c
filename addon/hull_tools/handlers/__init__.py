# SPDX-License-Identifier: GPL-3.0-or-later
"""What happens by itself: the one place that registers handlers."""

import bpy

from . import follow

_HANDLERS = {
    "depsgraph_update_post": follow.after_update,
    "undo_post": follow.after_undo,
    "redo_post": follow.after_undo,
    "load_pre": follow.before_load,
    "load_post": follow.after_load,
}


def register():
    for name, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, name).append(handler)


def unregister():
    for name, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, name).remove(handler)
    follow.forget_all()
