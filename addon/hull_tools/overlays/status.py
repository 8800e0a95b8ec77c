# SPDX-License-Identifier: GPL-3.0-or-later
"""A quiet line at the top of the 3D view while the active hull's mesh is under construction: why
the surface is that of before."""

import bpy
import gpu

from ..bridge.blender import sentence_units, view_room
from ..bridge.objects import hull_objects
from ..features.hull import hull_state
from . import shapes
from .view import Handler

_SIZE = 12.0  # dots, at a scale of 1
_MARGIN, _GAP = 8.0, 8.0  # around the text, to the region's left border
_TEXTS, _GIZMOS = 56.0, 64.0  # what Blender's own take at the top and at the right
_HEIGHT = 22.0  # of the card
_INK, _CARD = (1.0, 0.86, 0.55, 1.0), (0.10, 0.10, 0.10, 0.85)
_ELLIPSIS = "…"


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
    hull = hull_objects.hull_of(context.view_layer.objects.active)
    text = sentence_units.in_scene_units(context.scene, status_line(hull))
    if not text:
        return
    scale = context.preferences.system.ui_scale
    left, bottom, room, height = view_room.free_room(context.area, context.region)
    size, margin = _SIZE * scale, _MARGIN * scale
    room -= (_GAP + _GIZMOS) * scale + 2.0 * margin
    text = shortened(text, room, lambda words: shapes.measure(words, size)[0])
    width = shapes.measure(text, size)[0] + 2.0 * margin
    x = left + _GAP * scale
    y = bottom + height - (_TEXTS + _HEIGHT) * scale
    gpu.state.blend_set("ALPHA")
    shapes.draw_card(x, y, width, _HEIGHT * scale, _CARD)
    gpu.state.blend_set("NONE")
    shapes.draw_text(text, x + margin, y + 0.5 * (_HEIGHT - 0.7 * _SIZE) * scale, size, _INK)


_handler = Handler(_draw, "POST_PIXEL")
register, unregister = _handler.register, _handler.unregister
