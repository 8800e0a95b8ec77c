# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a hull's patches are worst: a ring over the 3D view, and what is there as text."""

import blf
import gpu
import numpy as np
from bpy_extras.view3d_utils import location_3d_to_region_2d
from gpu_extras.batch import batch_for_shader

from ..bridge.blender import blender_versions
from ..bridge.blender.palette import INK, PAPER
from ..features.conversion import worst_spots
from .view import Handler, hulls_in_view

_COLOUR = (0.90, 0.05, 0.05, 1.0)
_RADIUS, _WIDTH = 12.0, 2.5  # dots, at a scale of 1
_TEXT, _MARGIN = 12.0, 5.0
_FONT = 0


def ring(centre, radius, count=32):
    """Corners (2 count, 3) of the segments of a ring in the picture."""
    angles = np.linspace(0.0, 2.0 * np.pi, count + 1)
    circle = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(count + 1)])
    corners = np.array([*centre, 0.0]) + radius * circle
    return np.repeat(corners, 2, axis=0)[1:-1].astype(np.float32)


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
    lines = blender_versions.builtin_shader("POLYLINE_UNIFORM_COLOR")
    lines.bind()
    lines.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    for colour, width in ((PAPER, 2.0 * _WIDTH), (_COLOUR, _WIDTH)):
        lines.uniform_float("lineWidth", width * scale)
        lines.uniform_float("color", colour)
        corners = ring(place, _RADIUS * scale)
        batch_for_shader(lines, "LINES", {"pos": corners}).draw(lines)
    blf.size(_FONT, _TEXT * scale)
    width, height = blf.dimensions(_FONT, text)
    left, low = place[0] + (_RADIUS + 2.0 * _MARGIN) * scale, place[1] - 0.5 * height
    _draw_card(left, low, width, height, _MARGIN * scale)
    blf.color(_FONT, *INK)
    blf.position(_FONT, left, low, 0.0)
    blf.draw(_FONT, text)
    gpu.state.blend_set("NONE")


def _draw_card(left, low, width, height, margin):
    """The paper below a text."""
    shader = blender_versions.builtin_shader("UNIFORM_COLOR")
    x = (left - margin, left + width + margin)
    y = (low - margin, low + height + margin)
    corners = [(x[0], y[0], 0.0), (x[1], y[0], 0.0), (x[0], y[1], 0.0), (x[1], y[1], 0.0)]
    shader.bind()
    shader.uniform_float("color", PAPER)
    batch_for_shader(shader, "TRI_STRIP", {"pos": corners}).draw(shader)


_handler = Handler(_draw, "POST_PIXEL")
register, unregister = _handler.register, _handler.unregister
