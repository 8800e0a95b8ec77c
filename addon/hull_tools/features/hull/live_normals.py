# SPDX-License-Identifier: GPL-3.0-or-later
"""The exact normals of hulls that are edited, previewed or moved by a slider come when the user
pauses: while points move, Blender shades the surface objects by their faces."""

import bpy

from ...bridge.background import timers
from ...bridge.blender import units
from . import hull_state

_PAUSE_SECONDS = 0.4


def ask():
    """Has normals written at the next pause; each call puts it off."""
    _pause.put_off()


def stop():
    _pause.stop()


def _write():
    scale = units.metres_per_unit(bpy.context.scene)
    for hull, state in hull_state.known_hulls(bpy.context.view_layer):
        if state.shown.may_move(hull):
            state.shown.is_sliding = False
            state.shown.follow_normals(hull, scale)


_pause = timers.Timer(_PAUSE_SECONDS, _write)
