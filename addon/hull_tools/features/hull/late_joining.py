# SPDX-License-Identifier: GPL-3.0-or-later
"""Appendages are joined to hulls whose points are dragged when the user pauses: finding where
surfaces meet takes up to a second, too long for each step."""

import bpy

from ...bridge.background import timers
from ...bridge.blender import redraw
from . import hull_state

_PAUSE_SECONDS = 0.4


def can_wait(hull):
    """Whether there are pauses in which it is done: points are dragged, in a window."""
    return hull.mode == "EDIT" and not bpy.app.background


def ask():
    """Has appendages joined at the next pause; each call puts it off."""
    _pause.put_off()


def stop():
    _pause.stop()


def join():
    """Joins those that wait."""
    for hull, state in hull_state.known_hulls(bpy.context.view_layer):
        if state.ship.waits:
            hull_state.refresh(hull, bpy.context.scene)
            hull.update_tag(refresh={"DATA"})  # what goes by the joined hull follows
    redraw.redraw("VIEW_3D", "PROPERTIES")


_pause = timers.Timer(_PAUSE_SECONDS, join)
