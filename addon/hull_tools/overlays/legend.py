# SPDX-License-Identifier: GPL-3.0-or-later
"""What the colours of the surface mean: a bar with numbers at the left of the 3D view."""

import blf
import bpy
import gpu
from gpu_extras.batch import batch_for_shader

from ..bridge.blender import blender_versions, units, view_room
from ..bridge.blender.palette import INK, PAPER
from ..bridge.objects import hull_objects, shown_objects
from ..features.hull import hull_state
from ..features.surface import colours
from . import legend_arrays
from .view import Handler, is_shaded

_FONT = 0
_TEXT_MM = 2.5
_GAP = 12.0  # dots to the region's border, at a scale of 1

_made = (None, None)  # of the last time: (scale, units.Shown), LegendArrays


def legend_of(hull):
    """The LegendArrays of the colours that a hull's surface has, None when it has none."""
    global _made
    state = hull_state.state_of(hull) if hull is not None else None
    scale = None if state is None else state.shown.colour_scale
    if scale is None:
        return None
    made_of = (scale, units.shown_in(bpy.context.scene))
    if _made[0] != made_of:
        title = colours.TITLES[state.shown.colour_field]
        _made = (made_of, legend_arrays.arrays_of(scale, title, made_of[1].plot_sizes()))
    return _made[1]


def legend_in_view(context, hull):
    """The same where the 3D view at hand shows the surface, else None."""
    is_seen = hull is not None and is_shaded(context, shown_objects.surface_of(hull))
    return legend_of(hull) if is_seen else None


def _draw():
    context = bpy.context
    if context.region is None or not context.space_data.overlay.show_overlays:
        return
    hull = hull_objects.hull_of(context.view_layer.objects.active)
    arrays = legend_in_view(context, hull)
    if arrays is not None:
        _draw_legend(context, arrays, is_low=hull.hull.plots.corner == "TOP_LEFT")


def _draw_legend(context, arrays, is_low):
    """LegendArrays where no plot is: at the bottom if `is_low`, else below the texts at the top."""
    scale = context.preferences.system.ui_scale
    dots = view_room.DOTS_PER_MM * scale
    room = view_room.free_room(context.area, context.region)
    left, bottom, _, height = room
    if height <= 0.0:
        return
    dots *= min(1.0, height / ((legend_arrays.HEIGHT_MM + 8.0) * dots))
    blf.size(_FONT, _TEXT_MM * dots)
    widest = max((_width(text) for _, text in arrays.labels), default=0.0)
    width = arrays.card_width_mm(_width(arrays.title) / dots, widest / dots)
    x = left + _GAP * scale
    below = view_room.below_texts(room, context.space_data, scale)
    highest = max(below[3] - legend_arrays.HEIGHT_MM * dots, 0.0)
    y = bottom + (_GAP * scale if is_low else highest)
    shader = blender_versions.builtin_shader("SMOOTH_COLOR")
    gpu.state.blend_set("ALPHA")
    with gpu.matrix.push_pop():
        gpu.matrix.translate((x, y))
        gpu.matrix.scale((dots, dots))
        for points, shades in (arrays.card(width, PAPER), arrays.bar, arrays.ticks(INK)):
            batch_for_shader(shader, "TRIS", {"pos": points, "color": shades}).draw(shader)
    blf.color(_FONT, *INK)
    for (place_x, place_y), text in arrays.placed_texts():
        blf.position(_FONT, x + place_x * dots, y + place_y * dots, 0.0)
        blf.draw(_FONT, text)
    gpu.state.blend_set("NONE")


def _width(text):
    return blf.dimensions(_FONT, text)[0]


_handler = Handler(_draw, "POST_PIXEL")
register, unregister = _handler.register, _handler.unregister
