# SPDX-License-Identifier: GPL-3.0-or-later
"""A quiet line at the top of the 3D view while the active hull's mesh is under construction: why
the surface is that of before."""

import blf
import bpy
import gpu
from gpu_extras.batch import batch_for_shader

from ..bridge.blender import blender_versions
from ..bridge.objects import hull_objects
from ..features.hull import hull_state
from .plots import free_room
from .view import Handler

_FONT = 0  # Blender's own
_SIZE = 12.0  # dots, at a scale of 1
_MARGIN, _GAP = 8.0, 8.0  # around the text, to the region's left border
_TEXTS, _GIZMOS = 56.0, 64.0  # what Blender's own take at the top and at the right
_HEIGHT = 22.0  # of the card
_INK, _CARD = (1.0, 0.86, 0.55, 1.0), (0.10, 0.10, 0.10, 0.85)
_ELLIPSIS = "…"
_CORNERS = ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0))


def status_line(hull):
    """What to say of a hull, or of None; "" when all is well."""
    state = hull_state.state_of(hull) if hull is not None else None
    if state is None or not state.status:
        return ""
    if state.ship.surface is None:
        return state.status
    if state.ship.is_part:
        return f"Only what makes a surface is shown: {state.status}"
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
    left, bottom, room, height = free_room(context.area, context.region)
    blf.size(_FONT, _SIZE * scale)
    margin = _MARGIN * scale
    text = shortened(text, room - (_GAP + _GIZMOS) * scale - 2.0 * margin, _width)
    width = _width(text) + 2.0 * margin
    x = left + _GAP * scale
    y = bottom + height - (_TEXTS + _HEIGHT) * scale
    _draw_card(x, y, width, _HEIGHT * scale)
    blf.position(_FONT, x + margin, y + 0.5 * (_HEIGHT - 0.7 * _SIZE) * scale, 0.0)
    blf.color(_FONT, *_INK)
    blf.draw(_FONT, text)


def _draw_card(x, y, width, height):
    shader = blender_versions.builtin_shader("UNIFORM_COLOR")
    places = [(x + u * width, y + v * height, 0.0) for u, v in _CORNERS]
    gpu.state.blend_set("ALPHA")
    shader.bind()
    shader.uniform_float("color", _CARD)
    batch_for_shader(shader, "TRI_STRIP", {"pos": places}).draw(shader)
    gpu.state.blend_set("NONE")


def _width(text):
    return blf.dimensions(_FONT, text)[0]


_handler = Handler(_draw, "POST_PIXEL")
register, unregister = _handler.register, _handler.unregister
