# SPDX-License-Identifier: GPL-3.0-or-later
"""The tags of a hull's control mesh over the 3D view, while it is edited: see tag_drawing."""

import gpu
from mathutils import Matrix

from ..bridge.blender import blender_versions
from . import buffers, tag_drawing
from .view import Handler, hulls_in_view

_FILL_ALPHA = 0.22
_BEHIND_ALPHA = 0.30  # of what is behind the surface
_LAYER = 6  # before lines, and so that the hull's own slope does not cut symbols


def _draw():
    for shown in hulls_in_view(lambda state: True):
        if shown.hull.mode == "EDIT" and shown.hull.hull.tags.show:
            context = shown.context
            picture = tag_drawing.Picture(
                context.region_data.window_matrix @ shown.to_view(layer=_LAYER),
                gpu.state.viewport_get()[2:],
                context.preferences.system.ui_scale,
                shown.metres_per_unit,
            )
            _draw_drawing(tag_drawing.drawing_of(shown.hull, shown.state, context.scene, picture))


def _draw_drawing(drawing):
    fills = [
        (colour, *_batch("UNIFORM_COLOR", "TRIS", corners)) for colour, corners in drawing.fills
    ]
    lines = [
        (colour, width, *_batch("POLYLINE_UNIFORM_COLOR", "LINES", corners))
        for colour, width, corners in drawing.lines
    ]
    is_depth_kept = gpu.state.depth_mask_get()
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_mask_set(False)
    with gpu.matrix.push_pop(), gpu.matrix.push_pop_projection():
        gpu.matrix.load_matrix(Matrix.Identity(4))
        gpu.matrix.load_projection_matrix(Matrix.Identity(4))
        for depth_test, alpha in (("GREATER", _BEHIND_ALPHA), ("LESS_EQUAL", 1.0)):
            gpu.state.depth_test_set(depth_test)
            for colour, shader, batch in fills:
                shader.bind()
                shader.uniform_float("color", (*colour, alpha * _FILL_ALPHA))
                batch.draw(shader)
            for colour, width, shader, batch in lines:
                shader.bind()
                shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
                shader.uniform_float("lineWidth", width)
                shader.uniform_float("color", (*colour, alpha))
                batch.draw(shader)
    gpu.state.depth_mask_set(is_depth_kept)
    gpu.state.depth_test_set("NONE")
    gpu.state.blend_set("NONE")


def _batch(shader_name, form, corners):
    """(shader, its batch) of corners (n, 3)."""
    shader = blender_versions.builtin_shader(shader_name)
    return shader, buffers.batch(shader, form, pos=corners)


_handler = Handler(_draw, "POST_VIEW")
register, unregister = _handler.register, _handler.unregister
