# SPDX-License-Identifier: GPL-3.0-or-later
"""Ghosts and distances follow at a pause: while points are moved nothing of them is computed.

In the background nobody pauses, and they follow at once.
"""

import bpy

from ...bridge.background import timers
from ...bridge.blender import redraw
from ..hull import hull_state
from . import distances, ghosts

_PAUSE_SECONDS = 0.2

_after = None  # what goes by them, and comes after


def ask(after):
    """Has all ghosts and distances looked after at the next pause; each call puts it off.
    `after()` is called then where any of them is another."""
    global _after
    if bpy.app.background:
        _follow_all()
    else:
        _after = after
        _pause.put_off()


def _follow_asked():
    if _follow_all():
        _after()
        redraw.redraw()


def _follow_all():
    scene, has_changed = bpy.context.scene, False
    for obj, state in list(hull_state.known_hulls(bpy.context.view_layer)):
        has_changed |= state.of(ghosts.Ghost).follow(obj, scene, state)
        has_changed |= distances.follow(obj, scene, state)
    return has_changed


_pause = timers.Timer(_PAUSE_SECONDS, _follow_asked)


def stop():
    """Nothing is asked for any longer."""
    _pause.stop()
