# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields over the 3D view: their bases, and of the chosen one its shift and lines of equal
intensity on the hull."""

import weakref

import gpu
import numpy as np
from mathutils import Color

from ..bridge.blender import blender_versions
from ..bridge.objects import hull_objects
from ..features.fields import handles, isolines, seen
from ..features.modelling import drags, pull_lines
from . import field_arrays, shapes
from .lines import batch_of_strokes, seen_then_hidden
from .view import Handler, hulls_in_view

# Dots, at a scale of 1.
_BASE, _CHOSEN_BASE, _LEVEL, _EDGE, _CIRCLE, _ARROW = 1.8, 3.6, 1.3, 2.2, 1.2, 2.6
_DOT, _CHOSEN_DOT, _IMAGE_DOT, _HANDLE, _HELD = 4.5, 6.0, 2.5, 5.0, 8.0
_HALO, _HALO_WIDTH = (1.0, 1.0, 1.0, 0.9), 1.5
_BEHIND = 0.3  # how much is seen of what is behind the surface
_LAYER = 3  # before the hull's lines

_batches = weakref.WeakKeyDictionary()  # by what is seen: GPUBatches


def _seen_hulls():
    """Pairs (HullInView, seen.Seen) of the active hull, where the view shows it."""
    for shown in hulls_in_view():
        active = hull_objects.hull_of(shown.context.view_layer.objects.active)
        if shown.hull == active and shown.hull.hull.fields.show_fields:
            found = shown.state.of(seen.Seen)
            if found.bases or found.chosen is not None:
                yield shown, found


def colour_of(row):
    """sRGB of a field, as its swatch in the panel is."""
    return tuple(Color(row.colour).from_scene_linear_to_srgb())


# On the hull


def _draw_lines():
    for shown, found in _seen_hulls():
        shader = blender_versions.builtin_shader("POLYLINE_UNIFORM_COLOR")
        shader.bind()
        shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
        with gpu.matrix.push_pop():
            gpu.matrix.load_matrix(shown.to_view(layer=_LAYER))
            for alpha in seen_then_hidden(_BEHIND):
                _draw_strokes(shown, found, shader, alpha)


def _draw_strokes(shown, found, shader, alpha):
    rows, pixel = shown.hull.hull.fields.fields, shown.context.preferences.system.pixel_size
    chosen = [] if found.chosen is None else [found.chosen]
    for base in {*found.bases, *chosen}:
        if base.number < len(rows):
            width = _CHOSEN_BASE if base in chosen else _BASE
            _stroke(_batch_of_base(base, shader), width * pixel, rows[base.number], shader, alpha)
    # What is behind the surface would only hide what is before it.
    if found.lines is None or alpha < 1.0 or found.chosen.number >= len(rows):
        return
    for batch, intensity in zip(_batches_of_lines(found.lines, shader), isolines.INTENSITIES):
        width = _EDGE if intensity == 0.0 else _LEVEL
        _stroke(batch, width * pixel, rows[found.chosen.number], shader, alpha)


def _stroke(batch, width, row, shader, alpha):
    if batch is not None:
        shader.uniform_float("lineWidth", width)
        shader.uniform_float("color", (*colour_of(row), alpha))
        batch.draw(shader)


def _batch_of_base(base, shader):
    if base not in _batches:
        _batches[base] = batch_of_strokes(field_arrays.base_strokes([base]), shader)
    return _batches[base]


def _batches_of_lines(lines, shader):
    if lines not in _batches:
        strokes = (field_arrays.level_strokes(part, lines.is_mirrored) for part in lines.levels)
        _batches[lines] = [batch_of_strokes(one, shader) for one in strokes]
    return _batches[lines]


# Over the picture: dots, the arrow, handles


def _draw_marks():
    for shown, found in _seen_hulls():
        gpu.state.blend_set("ALPHA")
        rows = shown.hull.hull.fields.fields
        for base in found.bases:
            if base is not found.chosen and base.number < len(rows):
                _draw_dots(shown, base, rows[base.number], _DOT)
        if found.chosen is not None and found.chosen.number < len(rows):
            row = rows[found.chosen.number]
            _draw_dots(shown, found.chosen, row, _CHOSEN_DOT)
            _draw_handles(shown, found.chosen, row)
        gpu.state.blend_set("NONE")


def _draw_dots(shown, base, row, radius):
    scale = shown.context.preferences.system.ui_scale
    places = _in_picture(_eye(shown), field_arrays.dots(base))
    for place, size in zip(places, (radius, _IMAGE_DOT)):
        if not np.isnan(place).any():
            _draw_discs(place[None], size * scale, (*colour_of(row), 1.0), scale)


def _draw_handles(shown, base, row):
    scale, held, eye = (
        shown.context.preferences.system.ui_scale,
        handles.held(shown.hull),
        _eye(shown),
    )
    if eye.from_clip is None:
        return
    found = handles.places(row, base, eye, shown.metres_per_unit)
    start, *places = _in_picture(eye, np.array([base.anchor, *found.values()]))
    places = dict(zip(found, places))
    colour = (*colour_of(row), 1.0)
    if "shift" in places and not np.isnan((start, places["shift"])).any():
        _draw_arrow(*field_arrays.arrow(start, places["shift"], scale), colour, scale)
    if not held.is_on:
        return
    if row.base != "PLANE" and not np.isnan((start, places["extent"])).any():
        circle = shapes.ring(start, float(np.hypot(*(places["extent"] - start))), 96)
        shapes.draw_segments(circle, (colour, _CIRCLE * scale))
    for kind, place in places.items():
        radius = _HELD if held.kind == kind else _HANDLE
        if not np.isnan(place).any():
            _draw_discs(place[None], radius * scale, colour, scale)


def _draw_arrow(segments, head, colour, scale):
    if not len(segments):
        return
    halo, width = (_ARROW + 2.0 * _HALO_WIDTH) * scale, _ARROW * scale
    shapes.draw_segments(segments, (_HALO, halo), (colour, width))
    shapes.draw_triangles(head, colour)


def _eye(shown):
    context = shown.context
    scale = shown.metres_per_unit
    return pull_lines.eye_of(shown.hull, scale, context.region_data, context.region)


def _in_picture(eye, points):
    """(k, 2) dots of points (k, 3), m, of the hull; NaN behind the eye."""
    return drags.in_picture(eye.to_clip, eye.size, points)


def _draw_discs(places, radius, colour, scale):
    shapes.draw_triangles(shapes.discs(places, radius + _HALO_WIDTH * scale), _HALO)
    shapes.draw_triangles(shapes.discs(places, radius), colour)


_lines, _marks = Handler(_draw_lines, "POST_VIEW"), Handler(_draw_marks, "POST_PIXEL")


def register():
    _lines.register()
    _marks.register()


def unregister():
    _marks.unregister()
    _lines.unregister()
    _batches.clear()
