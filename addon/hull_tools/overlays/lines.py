# SPDX-License-Identifier: GPL-3.0-or-later
"""The hulls' lines over the 3D view, as hull_state knows them.

Each group of lines goes to the graphics card once; drawing it again costs next to nothing.
"""

import weakref

import bpy
import gpu
from gpu.types import GPUBatch, GPUIndexBuf, GPUVertBuf

from ..bridge import blender_versions, hull_state, lines, units
from . import view
from .line_arrays import strokes_of

# sRGB, by the kinds of lines.KINDS, on light and on dark grounds.
COLOURS_ON_LIGHT = {
    "station": (0.05, 0.05, 0.07),
    "waterline": (0.07, 0.25, 0.80),
    "buttock": (0.05, 0.42, 0.14),
    "diagonal": (0.50, 0.12, 0.60),
    "plane": (0.80, 0.05, 0.28),
    "draft": (0.00, 0.45, 0.75),
    "feature": (0.78, 0.31, 0.00),
}
COLOURS_ON_DARK = {
    "station": (0.96, 0.96, 0.96),
    "waterline": (0.50, 0.72, 1.00),
    "buttock": (0.49, 0.87, 0.53),
    "diagonal": (0.88, 0.62, 0.96),
    "plane": (1.00, 0.48, 0.65),
    "draft": (0.30, 0.84, 1.00),
    "feature": (1.00, 0.68, 0.34),
}
_HEAVIER = {"draft": 1.6, "feature": 1.3, "plane": 1.6}  # times the width that is set

_handler = None
_batches = weakref.WeakKeyDictionary()  # of lines.Group


def colours(is_light):
    return COLOURS_ON_LIGHT if is_light else COLOURS_ON_DARK


def _draw():
    context = bpy.context
    if context.region_data is None or not context.space_data.overlay.show_overlays:
        return
    for hull, state in hull_state.known_hulls(context.view_layer):
        if state.lines and hull.visible_in_viewport_get(context.space_data):
            _draw_hull(context, hull, state)


def _draw_hull(context, hull, state):
    settings = hull.hull.lines
    palette = colours(view.has_light_ground(context, hull))
    shader = blender_versions.builtin_shader("POLYLINE_UNIFORM_COLOR")
    scale = units.metres_per_unit(context.scene)
    size = lines.size_of(state.surface)
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_test_set("NONE" if settings.in_front else "LESS_EQUAL")
    shader.bind()
    shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    width = settings.width * context.preferences.system.pixel_size
    for group in state.lines.values():
        batch = _batch_of(group, shader)
        if batch is None:
            continue
        shader.uniform_float("color", (*palette[group.kind], 1.0))
        shader.uniform_float("lineWidth", width * _HEAVIER.get(group.kind, 1.0))
        for is_image in (False, True) if group.is_mirrored else (False,):
            with view.on_hull(context, hull, size, scale, is_image):
                batch.draw(shader)
    gpu.state.depth_test_set("NONE")
    gpu.state.blend_set("NONE")


def _batch_of(group, shader):
    if group not in _batches:
        strokes = strokes_of(group.polylines)
        _batches[group] = stroke_batch(shader, strokes) if len(strokes) else None
    return _batches[group]


def stroke_batch(shader, strokes):
    """Strokes on the graphics card."""
    points = GPUVertBuf(shader.format_calc(), len(strokes.points))
    points.attr_fill("pos", strokes.points)
    return GPUBatch(type="LINES", buf=points, elem=GPUIndexBuf(type="LINES", seq=strokes.segments))


def register():
    global _handler
    if not bpy.app.background:
        _handler = bpy.types.SpaceView3D.draw_handler_add(_draw, (), "WINDOW", "POST_VIEW")


def unregister():
    global _handler
    if _handler is not None:
        bpy.types.SpaceView3D.draw_handler_remove(_handler, "WINDOW")
        _handler = None
    _batches.clear()
