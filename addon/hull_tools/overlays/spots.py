# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a hull's patches are worst: a ring over the 3D view, and what is there as text."""

import gpu
from bpy_extras.view3d_utils import location_3d_to_region_2d

from ..bridge.blender.palette import PAPER
from ..features.conversion import worst_spots
from . import shapes
from .view import Handler, hulls_in_view

_COLOUR = (0.90, 0.05, 0.05, 1.0)
_RADIUS, _WIDTH = 12.0, 2.5  # dots, at a scale of 1
_TEXT, _MARGIN = 12.0, 5.0


def _draw():
    for shown in hulls_in_view(lambda state: worst_spots.marked(state).kind):
        spot = worst_spots.shown_spot(shown.hull, shown.context.scene)
        if spot is None:
            continue
        point, text = spot
        context = shown.context
        place = location_3d_to_region_2d(context.region, context.region_data, point)
        if place is not None:
            _draw_spot(place, text, context.preferences.system.ui_scale)


def _draw_spot(place, text, scale):
    gpu.state.blend_set("ALPHA")
    width = _WIDTH * scale
    shapes.draw_segments(
        shapes.ring(place, _RADIUS * scale), (PAPER, 2.0 * width), (_COLOUR, width)
    )
    _, height = shapes.measure(text, _TEXT * scale)
    left, low = place[0] + (_RADIUS + 2.0 * _MARGIN) * scale, place[1] - 0.5 * height
    shapes.draw_words(text, left, low, _TEXT * scale, _MARGIN * scale)
    gpu.state.blend_set("NONE")


_handler = Handler(_draw, "POST_PIXEL")
register, unregister = _handler.register, _handler.unregister
