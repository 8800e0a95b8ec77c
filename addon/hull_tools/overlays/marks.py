# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks of inflections and curvature extrema over the 3D view, as large whatever the distance."""

import gpu
import numpy as np
from mathutils import Matrix

from ..bridge.blender import blender_versions, preferences
from . import buffers, mark_arrays
from .view import Handler, hulls_in_view

_SWITCHES = {
    "inflection": "show_inflections",
    "maximum": "show_extrema",
    "minimum": "show_extrema",
}
_RING_WIDTH = 2.0
_LAYER = 6  # before lines, and so that the hull's own slope does not cut symbols


def _draw():
    for shown in hulls_in_view():
        fairness = shown.hull.hull.fairness
        names = [name for name in mark_arrays.SHAPES if getattr(fairness, _SWITCHES[name])]
        if not shown.state.fairness.combs or not names:
            continue
        gpu.state.blend_set("ALPHA")
        gpu.state.depth_test_set("NONE" if shown.hull.hull.lines.in_front else "LESS_EQUAL")
        with gpu.matrix.push_pop(), gpu.matrix.push_pop_projection():
            gpu.matrix.load_matrix(Matrix.Identity(4))
            gpu.matrix.load_projection_matrix(Matrix.Identity(4))
            for name in names:
                _draw_marks(shown, name)
        gpu.state.depth_test_set("NONE")
        gpu.state.blend_set("NONE")


def _draw_marks(shown, name):
    places = _places(shown, name)
    if not len(places):
        return
    viewport = gpu.state.viewport_get()[2:]
    scale = shown.context.preferences.system.ui_scale
    corners = mark_arrays.symbols(name, places, preferences.value("mark_size") * scale, viewport)
    form = mark_arrays.SHAPES[name][0]
    shader = blender_versions.builtin_shader(
        "POLYLINE_UNIFORM_COLOR" if form == "LINES" else "UNIFORM_COLOR"
    )
    shader.bind()
    if form == "LINES":
        shader.uniform_float("viewportSize", viewport)
        shader.uniform_float("lineWidth", _RING_WIDTH * scale)
    colour = preferences.colour("marks", name, shown.is_on_light)
    shader.uniform_float("color", (*colour, 1.0))
    buffers.batch(shader, form, pos=corners).draw(shader)


def _places(shown, name):
    """Where the marks are in the picture, (n, 3), those of the mirror image too."""
    projection = shown.context.region_data.window_matrix
    found = [np.empty((0, 3))]
    for group in shown.state.fairness.combs.values():
        for is_image in (False, True) if group.is_mirrored else (False,):
            to_clip = projection @ shown.to_view(is_image, _LAYER)
            found.append(mark_arrays.in_picture(group.marks[name], to_clip))
    return np.concatenate(found)


_handler = Handler(_draw, "POST_VIEW")
register, unregister = _handler.register, _handler.unregister
