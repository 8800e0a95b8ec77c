# SPDX-License-Identifier: GPL-3.0-or-later
"""A quiet line at the foot of the 3D view while the active hull's mesh is under construction: why
the surface is that of before."""

import blf
import bpy

from ..bridge import hull_objects, hull_state
from .plots import free_room
from .view import Handler

_FONT = 0  # Blender's own
_SIZE = 12.0  # dots, at a scale of 1
_GAP = 14.0
_INK, _SHADOW = (1.0, 0.86, 0.55, 1.0), (0.0, 0.0, 0.0, 0.9)
_SHADOW_BLUR = 3
_ELLIPSIS = "…"


def status_line(hull):
    """What to say of a hull, or of None; "" when all is well."""
    state = hull_state.state_of(hull) if hull is not None else None
    if state is None or not state.status:
        return ""
    if state.surface is None:
        return state.status
    return f"The surface waits for the mesh: {state.status}"


def shortened(text, width, width_of):
    """A text that is no wider than this, by width_of(text); cut off at a word's end if it must."""
    if width_of(text) <= width:
        return text
    words = text.split(" ")
    while len(words) > 1 and width_of(" ".join(words) + _ELLIPSIS) > width:
        words.pop()
    return " ".join(words) + _ELLIPSIS


def _draw():
    context = bpy.context
    if context.region is None or not context.space_data.overlay.show_overlays:
        return
    text = status_line(hull_objects.hull_of(context.view_layer.objects.active))
    if not text:
        return
    scale = context.preferences.system.ui_scale
    left, bottom, width, _ = free_room(context.area, context.region)
    blf.size(_FONT, _SIZE * scale)
    text = shortened(text, width - 2.0 * _GAP * scale, _width)
    blf.position(_FONT, left + 0.5 * (width - _width(text)), bottom + _GAP * scale, 0.0)
    blf.color(_FONT, *_INK)
    blf.enable(_FONT, blf.SHADOW)
    blf.shadow(_FONT, _SHADOW_BLUR, *_SHADOW)
    blf.draw(_FONT, text)
    blf.disable(_FONT, blf.SHADOW)


def _width(text):
    return blf.dimensions(_FONT, text)[0]


_handler = Handler(_draw, "POST_PIXEL")
register, unregister = _handler.register, _handler.unregister
