# SPDX-License-Identifier: GPL-3.0-or-later
"""Ghosts and distances follow at a pause: while points are moved nothing of them is computed.

In the background nobody pauses, and they follow at once.
"""

from time import monotonic

import bpy

from ...bridge.blender import redraw
from ..hull import hull_state
from . import distances, ghosts

_PAUSE_SECONDS = 0.2

_due = None  # monotonic seconds of the next look at what they are made of


def ask():
    """Has all ghosts and distances looked after at the next pause; each call puts it off."""
    global _due
    if bpy.app.background:
        _follow_all()
    else:
        _due = monotonic() + _PAUSE_SECONDS


def follow_asked():
    """Looks after them where that was asked for and the pause is over; returns whether anything is
    another then."""
    global _due
    if _due is None or monotonic() < _due:
        return False
    _due = None
    has_changed = _follow_all()
    if has_changed:
        redraw.redraw()
    return has_changed


def _follow_all():
    scene, has_changed = bpy.context.scene, False
    for obj, state in list(hull_state.known_hulls(bpy.context.view_layer)):
        has_changed |= state.of(ghosts.Ghost).follow(obj, scene, state)
        has_changed |= distances.follow(obj, scene, state)
    return has_changed


def forget():
    """Nothing is asked for any longer."""
    global _due
    _due = None
