# SPDX-License-Identifier: GPL-3.0-or-later
"""Control nets in object mode, in a colour of their own: Blender draws them as black as stations.

What is selected stays in Blender's colours of what is selected.
"""

import weakref

import gpu
import numpy as np

from ..bridge.blender import blender_versions, preferences
from . import line_arrays
from .lines import batch_of_strokes
from .view import Handler, hulls_in_view

_WIDTH = 1.6  # dots: a little wider than Blender's own line, which it hides
_batches = weakref.WeakKeyDictionary()  # by HullState: (key of its geometry, GPUBatch)


def net_of(mesh):
    """The Strokes of all edges of a hull_native.ControlMesh."""
    sizes, corners = mesh.face_sizes, mesh.face_vertices
    following = np.roll(corners, -1)
    ends = np.cumsum(sizes)
    following[ends - 1] = corners[ends - sizes]
    edges = np.unique(np.sort(np.stack([corners, following], axis=1), axis=1), axis=0)
    return line_arrays.Strokes(mesh.points.astype(np.float32), edges.astype(np.int32))


def _draw():
    shader = None
    for shown in hulls_in_view():
        hull = shown.hull
        if hull.mode != "OBJECT" or hull.display_type != "WIRE" or hull.select_get():
            continue
        shader = shader or blender_versions.builtin_shader("POLYLINE_UNIFORM_COLOR")
        shader.bind()
        shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
        colour = preferences.colours("net", shown.is_on_light)["net"]
        shader.uniform_float("color", (*colour, 1.0))
        pixel = shown.context.preferences.system.pixel_size
        shader.uniform_float("lineWidth", _WIDTH * pixel)
        gpu.state.depth_test_set("NONE" if hull.show_in_front else "LESS_EQUAL")
        with gpu.matrix.push_pop():
            gpu.matrix.load_matrix(shown.to_view())
            _batch_of(shown.state, shader).draw(shader)
        gpu.state.depth_test_set("NONE")


def _batch_of(state, shader):
    key = state.ship.geometry_key
    known = _batches.get(state)
    if known is None or known[0] != key:
        known = key, batch_of_strokes(net_of(state.ship.surface.mesh), shader)
        _batches[state] = known
    return known[1]


_handler = Handler(_draw, "POST_VIEW")
register = _handler.register


def unregister():
    _handler.unregister()
    _batches.clear()
