# SPDX-License-Identifier: GPL-3.0-or-later
"""The hulls' lines over the 3D view, as hull_state knows them: sections, knuckles, combs, and those
of light.

What is shown goes to the graphics card once; drawing it again costs next to nothing.
"""

import weakref
from contextlib import contextmanager

import gpu
from gpu.types import GPUBatch, GPUIndexBuf, GPUVertBuf

from ..bridge.blender import blender_versions, preferences
from . import line_arrays
from .view import Handler, hulls_in_view

# Times the width that is set.
WIDTHS = {"draft": 1.6, "feature": 1.3, "plane": 1.6, "reflection": 1.3, "silhouette": 2.0}
_TEETH_WIDTH, _TEETH_ALPHA = 0.7, 0.55
HIDDEN_ALPHA = 0.25  # of what is behind the surface

_batches = weakref.WeakKeyDictionary()  # by group: GPUBatch, None where there is nothing to draw
_comb_batches = weakref.WeakKeyDictionary()  # by CombGroup: (scale, teeth, outline)


def _draw():
    for shown in hulls_in_view():
        state = shown.state
        groups = [*state.lines.groups.values(), *state.fairness.level_lines.values()]
        if not groups and not state.fairness.combs:
            continue
        pen, palette = Pen(shown), preferences.colours("lines", shown.is_on_light)
        in_front = shown.hull.hull.lines.in_front
        with depth_test("NONE" if in_front else "LESS_EQUAL"):
            for group in groups:
                colour = (*palette[group.kind], 1.0)
                pen.draw(group, batch_of(group, pen.shader), WIDTHS.get(group.kind, 1.0), colour)
            _draw_combs(shown, pen, 1.0)
        if not in_front:
            with depth_test("GREATER"):
                _draw_combs(shown, pen, HIDDEN_ALPHA)


def _draw_combs(shown, pen, alpha):
    factor = shown.hull.hull.fairness.comb_factor
    palette = preferences.colours("combs", shown.is_on_light)
    for group in shown.state.fairness.combs.values():
        colour = palette[group.kind]
        teeth, outline = _comb_batches_of(group, group.scale * factor, pen.shader)
        pen.draw(group, teeth, _TEETH_WIDTH, (*colour, alpha * _TEETH_ALPHA))
        pen.draw(group, outline, 1.0, (*colour, alpha))


@contextmanager
def depth_test(mode):
    """Draws what passes the test, as gpu.state names it, before what is there."""
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_test_set(mode)
    try:
        yield
    finally:
        gpu.state.depth_test_set("NONE")
        gpu.state.blend_set("NONE")


def seen_then_hidden(hidden_alpha=HIDDEN_ALPHA):
    """The alpha to draw with, for what is seen, then for what is behind the surface. In this order:
    what is drawn is before what comes after it, so that what was hidden would be seen."""
    for mode, alpha in (("LESS_EQUAL", 1.0), ("GREATER", hidden_alpha)):
        with depth_test(mode):
            yield alpha


class Pen:
    """Draws the lines of one hull, the nearer to the eye the higher the layer."""

    def __init__(self, shown, layer=1):
        self._shown, self._layer = shown, layer
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
                gpu.matrix.load_matrix(self._shown.to_view(is_image, self._layer))
                batch.draw(self.shader)


def batch_of(group, shader):
    """The lines of a group on the graphics card; None where there are none."""
    if group not in _batches:
        _batches[group] = batch_of_strokes(line_arrays.strokes_of(group.polylines), shader)
    return _batches[group]


def batch_of_strokes(strokes, shader):
    """Strokes on the graphics card; None where there are none."""
    return _batch(_buffer(strokes.points, shader), strokes)


def _comb_batches_of(group, scale, shader):
    known = _comb_batches.get(group)
    if known is None or known[0] != scale:
        teeth, outline = line_arrays.comb_strokes(*group.comb(scale))
        buffer = _buffer(teeth.points, shader)
        known = scale, _batch(buffer, teeth), _batch(buffer, outline)
        _comb_batches[group] = known
    return known[1:]


def _buffer(points, shader):
    """Points (n, 3) on the graphics card; None where there are none."""
    if not len(points):
        return None
    buffer = GPUVertBuf(shader.format_calc(), len(points))
    buffer.attr_fill("pos", points)
    return buffer


def _batch(buffer, strokes):
    """Strokes between the points of a buffer; None where there are none."""
    if buffer is None or not len(strokes):
        return None
    return GPUBatch(type="LINES", buf=buffer, elem=GPUIndexBuf(type="LINES", seq=strokes.segments))


_handler = Handler(_draw, "POST_VIEW")
register = _handler.register


def unregister():
    _handler.unregister()
    _batches.clear()
    _comb_batches.clear()
