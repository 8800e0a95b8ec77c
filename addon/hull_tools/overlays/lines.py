# SPDX-License-Identifier: GPL-3.0-or-later
"""The hulls' lines over the 3D view, as hull_state knows them: sections, knuckles, combs, and those
of light.

What is shown goes to the graphics card once; drawing it again costs next to nothing.
"""

import weakref
from contextlib import contextmanager

import gpu
import numpy as np
from gpu.types import GPUBatch, GPUIndexBuf, GPUVertBuf

from ..bridge import blender_versions
from .line_arrays import Strokes, strokes_of, strokes_of_segments
from .view import Handler, hulls_in_view

# sRGB, by the kinds of bridge.lines and bridge.level_lines, on light and on dark grounds.
COLOURS_ON_LIGHT = {
    "station": (0.05, 0.05, 0.07),
    "waterline": (0.07, 0.25, 0.80),
    "buttock": (0.05, 0.42, 0.14),
    "diagonal": (0.50, 0.12, 0.60),
    "plane": (0.80, 0.05, 0.28),
    "draft": (0.00, 0.45, 0.75),
    "flat": (0.42, 0.38, 0.00),
    "feature": (0.78, 0.31, 0.00),
    "isophote": (0.45, 0.10, 0.10),
    "reflection": (0.08, 0.08, 0.30),
    "silhouette": (0.00, 0.00, 0.00),
}
COLOURS_ON_DARK = {
    "station": (0.96, 0.96, 0.96),
    "waterline": (0.50, 0.72, 1.00),
    "buttock": (0.49, 0.87, 0.53),
    "diagonal": (0.88, 0.62, 0.96),
    "plane": (1.00, 0.48, 0.65),
    "draft": (0.30, 0.84, 1.00),
    "flat": (0.86, 0.84, 0.40),
    "feature": (1.00, 0.68, 0.34),
    "isophote": (1.00, 0.72, 0.66),
    "reflection": (0.92, 0.95, 1.00),
    "silhouette": (1.00, 1.00, 0.80),
}
# Combs stand out from the hull: these can be told from light and dark alike.
COMB_COLOURS = {
    "station": (0.85, 0.20, 0.58),
    "waterline": (0.12, 0.50, 0.95),
    "buttock": (0.08, 0.62, 0.25),
    "diagonal": (0.62, 0.36, 0.92),
    "plane": (0.95, 0.25, 0.30),
    "feature": (0.95, 0.50, 0.05),
}
# Times the width that is set.
_WIDTHS = {"draft": 1.6, "feature": 1.3, "plane": 1.6, "reflection": 1.3, "silhouette": 2.0}
_TEETH_WIDTH, _TEETH_ALPHA = 0.7, 0.55
_HIDDEN_ALPHA = 0.25  # of combs behind the surface

_batches = weakref.WeakKeyDictionary()  # by group: GPUBatch, None where there is nothing to draw
_comb_batches = weakref.WeakKeyDictionary()  # by CombGroup: (scale, teeth, outline)


def colours(is_on_light):
    return COLOURS_ON_LIGHT if is_on_light else COLOURS_ON_DARK


def _draw():
    for shown in hulls_in_view():
        state = shown.state
        groups = [*state.lines.values(), *state.level_lines.values()]
        if not groups and not state.combs:
            continue
        pen, palette = _Pen(shown), colours(shown.is_on_light)
        in_front = shown.hull.hull.lines.in_front
        with _depth_test("NONE" if in_front else "LESS_EQUAL"):
            for group in groups:
                colour = (*palette[group.kind], 1.0)
                pen.draw(group, _batch_of(group, pen.shader), _WIDTHS.get(group.kind, 1.0), colour)
            _draw_combs(shown, pen, 1.0)
        if not in_front:
            with _depth_test("GREATER"):
                _draw_combs(shown, pen, _HIDDEN_ALPHA)


def _draw_combs(shown, pen, alpha):
    factor = shown.hull.hull.fairness.comb_factor
    for group in shown.state.combs.values():
        colour = COMB_COLOURS[group.kind]
        teeth, outline = _comb_batches_of(group, group.scale * factor, pen.shader)
        pen.draw(group, teeth, _TEETH_WIDTH, (*colour, alpha * _TEETH_ALPHA))
        pen.draw(group, outline, 1.0, (*colour, alpha))


@contextmanager
def _depth_test(mode):
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_test_set(mode)
    yield
    gpu.state.depth_test_set("NONE")
    gpu.state.blend_set("NONE")


class _Pen:
    """Draws the lines of one hull."""

    def __init__(self, shown):
        self._shown = shown
        context = shown.context
        self._width = shown.hull.hull.lines.width * context.preferences.system.pixel_size
        self._viewport = gpu.state.viewport_get()[2:]
        self.shader = blender_versions.builtin_shader("POLYLINE_UNIFORM_COLOR")

    def draw(self, group, batch, width, colour):
        if batch is None:
            return
        self.shader.bind()
        self.shader.uniform_float("viewportSize", self._viewport)
        self.shader.uniform_float("color", colour)
        self.shader.uniform_float("lineWidth", self._width * width)
        for is_image in (False, True) if group.is_mirrored else (False,):
            with gpu.matrix.push_pop():
                gpu.matrix.load_matrix(self._shown.to_view(is_image))
                batch.draw(self.shader)


def _batch_of(group, shader):
    if group not in _batches:
        _batches[group] = _stroke_batch(shader, strokes_of(group.polylines))
    return _batches[group]


def _comb_batches_of(group, scale, shader):
    known = _comb_batches.get(group)
    if known is None or known[0] != scale:
        segments, teeth_count = group.segments(scale)
        parts = (segments[:teeth_count], segments[teeth_count:])
        known = scale, *(_stroke_batch(shader, strokes_of_segments(part)) for part in parts)
        _comb_batches[group] = known
    return known[1:]


def _stroke_batch(shader, strokes: Strokes):
    """Strokes on the graphics card; None where there are none."""
    if not len(strokes):
        return None
    points = GPUVertBuf(shader.format_calc(), len(strokes.points))
    points.attr_fill("pos", np.ascontiguousarray(strokes.points))
    return GPUBatch(type="LINES", buf=points, elem=GPUIndexBuf(type="LINES", seq=strokes.segments))


_handler = Handler(_draw, "POST_VIEW")
register = _handler.register


def unregister():
    _handler.unregister()
    _batches.clear()
    _comb_batches.clear()
