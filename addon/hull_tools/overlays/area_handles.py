# SPDX-License-Identifier: GPL-3.0-or-later
"""Handles of the target area curve, over the plot of sectional areas: a dot at each, and a ring and
words at that of the mouse."""

import bpy
import gpu

from ..bridge.objects import hull_objects
from ..features.area_curves import handles, stored
from . import shapes
from .view import Handler

_COLOUR, _HALO = (0.85, 0.35, 0.0, 1.0), (1.0, 1.0, 1.0, 1.0)
_RADIUS, _HELD_RADIUS, _WIDTH = 4.0, 8.0, 2.0  # dots, at a scale of 1
_TEXT, _MARGIN = 11.0, 4.0


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
    shown = handles.diagram(hull, context.scene, context.area, context.region)
    if shown is None:
        return
    held, scale = handles.held(hull), context.preferences.system.ui_scale
    places = shown.dots(handles.points_of(hull, context.scene))
    places = places[[shown.has(place) for place in places]] if held.index is None else places
    gpu.state.blend_set("ALPHA")
    for colour, radius in ((_HALO, _RADIUS + 1.5), (_COLOUR, _RADIUS)):
        shapes.draw_triangles(shapes.discs(places, radius * scale), colour)
    if held.index is not None and held.index < len(places):
        _draw_held(places[held.index], held.text, shown, scale)
    gpu.state.blend_set("NONE")


def _draw_held(place, text, shown, scale):
    shapes.draw_segments(shapes.ring(place, _HELD_RADIUS * scale), (_COLOUR, _WIDTH * scale))
    width, height = shapes.measure(text, _TEXT * scale)
    # Beside the title, where no handle and no curve is.
    _, _, right, top = shown.card
    x, y = right - width - 3.0 * _MARGIN * scale, top - height - 3.0 * _MARGIN * scale
    shapes.draw_words(text, x, y, _TEXT * scale, _MARGIN * scale)


_handler = Handler(_draw, "POST_PIXEL")
register, unregister = _handler.register, _handler.unregister
