# SPDX-License-Identifier: GPL-3.0-or-later
"""Handles of the target area curve, over the plot of sectional areas: a dot at each, and a ring and
words at that of the mouse."""

import blf
import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..bridge.blender import blender_versions
from ..bridge.blender.palette import INK, PAPER
from ..bridge.objects import hull_objects
from ..features.area_curves import handles, stored
from .spots import ring
from .view import Handler

_COLOUR, _HALO = (0.85, 0.35, 0.0, 1.0), (1.0, 1.0, 1.0, 1.0)
_RADIUS, _HELD_RADIUS, _WIDTH = 4.0, 8.0, 2.0  # dots, at a scale of 1
_FONT, _TEXT, _MARGIN = 0, 11.0, 4.0


def discs(centres, radius, count=16):
    """Corners (3 count k, 3) of the triangles of discs at centres (k, 2)."""
    angles = np.linspace(0.0, 2.0 * np.pi, count + 1)
    rim = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    fan = np.stack([np.zeros((count, 2)), rim[:-1], rim[1:]], axis=1).reshape(-1, 2)
    corners = (np.asarray(centres)[:, None, :] + fan[None]).reshape(-1, 2)
    return np.column_stack([corners, np.zeros(len(corners))]).astype(np.float32)


def _draw():
    context = bpy.context
    hull = hull_objects.hull_of(context.view_layer.objects.active)
    if hull is None or context.area is None or not context.space_data.overlay.show_overlays:
        return
    settings = hull.hull
    if not stored.is_there(hull) or not settings.plots.sectional_areas:
        return
    if not settings.area_target.show_target:
        return
    shown = handles.diagram(hull, context.scene, context.area)
    if shown is None:
        return
    held, scale = handles.held(hull), context.preferences.system.ui_scale
    places = shown.dots(handles.points_of(hull, context.scene))
    places = places[[shown.has(place) for place in places]] if held.index is None else places
    gpu.state.blend_set("ALPHA")
    fill = blender_versions.builtin_shader("UNIFORM_COLOR")
    fill.bind()
    for colour, radius in ((_HALO, _RADIUS + 1.5), (_COLOUR, _RADIUS)):
        fill.uniform_float("color", colour)
        batch_for_shader(fill, "TRIS", {"pos": discs(places, radius * scale)}).draw(fill)
    if held.index is not None and held.index < len(places):
        _draw_held(places[held.index], held.text, shown, scale)
    gpu.state.blend_set("NONE")


def _draw_held(place, text, shown, scale):
    lines = blender_versions.builtin_shader("POLYLINE_UNIFORM_COLOR")
    lines.bind()
    lines.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    lines.uniform_float("lineWidth", _WIDTH * scale)
    lines.uniform_float("color", _COLOUR)
    corners = ring(place, _HELD_RADIUS * scale)
    batch_for_shader(lines, "LINES", {"pos": corners}).draw(lines)
    blf.size(_FONT, _TEXT * scale)
    width, height = blf.dimensions(_FONT, text)
    # Beside the title, where no handle and no curve is.
    _, _, right, top = shown.card
    x, y = right - width - 3.0 * _MARGIN * scale, top - height - 3.0 * _MARGIN * scale
    _draw_card(x, y, width, height, _MARGIN * scale)
    blf.color(_FONT, *INK)
    blf.position(_FONT, x, y, 0.0)
    blf.draw(_FONT, text)


def _draw_card(left, low, width, height, margin):
    """The paper below a text."""
    shader = blender_versions.builtin_shader("UNIFORM_COLOR")
    x, y = (left - margin, left + width + margin), (low - margin, low + height + margin)
    shader.bind()
    shader.uniform_float("color", PAPER)
    corners = [(x[0], y[0], 0.0), (x[1], y[0], 0.0), (x[0], y[1], 0.0), (x[1], y[1], 0.0)]
    batch_for_shader(shader, "TRI_STRIP", {"pos": corners}).draw(shader)


_handler = Handler(_draw, "POST_PIXEL")
register, unregister = _handler.register, _handler.unregister
