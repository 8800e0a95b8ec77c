# SPDX-License-Identifier: GPL-3.0-or-later
"""Networks of curves over the 3D view: their curves and combs, nodes, problems, and the curve that
is being drawn."""

import bpy
import gpu
import numpy as np
from gpu.types import GPUBatch, GPUVertBuf

from ..bridge.blender import blender_versions, preferences
from ..bridge.objects import networks
from ..features.networks import drawing, network_state
from . import network_arrays, shapes
from .lines import batch_of_strokes, seen_then_hidden
from .view import Handler, brought_nearer, is_light_ground, is_seen

_WIDTH, _TEETH_WIDTH, _TEETH_ALPHA = 1.8, 0.9, 0.55
_NODE, _PROBLEM, _PROBLEM_WIDTH, _POINT, _PLACE = 5.0, 9.0, 2.0, 4.0, 5.5
_PEN = (1.0, 0.45, 0.05, 1.0)
_LAYER = 2  # before a hull's lines


def _seen_networks():
    """Triples (context, network, NetworkArrays) of those of which the view shows a curve."""
    context = bpy.context
    if context.region_data is None or not context.space_data.overlay.show_overlays:
        return
    for network, state in network_state.known_networks():
        if not network.hull_network.show_curves:
            continue
        curves = (one for one in network.objects if one.type == "CURVE")
        if any(is_seen(context, one) for one in curves if one.name in context.view_layer.objects):
            yield context, network, network_arrays.of_network(network, state)


def _is_on_light(context, network):
    return is_light_ground(context, networks.surface_of(network))


def _draw_lines():
    for context, network, found in _seen_networks():
        shader = blender_versions.builtin_shader("POLYLINE_UNIFORM_COLOR")
        is_light = _is_on_light(context, network)
        lines = preferences.colours("lines", is_light)
        combs = preferences.colours("combs", is_light)
        width = context.preferences.system.pixel_size
        view = context.region_data.view_matrix
        view = brought_nearer(context, view, found.centre, found.size, _LAYER) @ view
        with gpu.matrix.push_pop():
            gpu.matrix.load_matrix(view)
            for alpha in seen_then_hidden():
                _strokes(found, "lines", shader, lines, _WIDTH * width, alpha)
                teeth = alpha * _TEETH_ALPHA
                _strokes(found, "teeth", shader, combs, _TEETH_WIDTH * width, teeth)
                _strokes(found, "outlines", shader, combs, width, alpha)
                _nodes(found, (*lines["station"], alpha), _NODE * width)


def _strokes(found, part, shader, palette, width, alpha):
    shader.bind()
    shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    shader.uniform_float("lineWidth", width)
    for ink, strokes in getattr(found, part).items():
        if (part, ink) not in found.batches:
            found.batches[part, ink] = batch_of_strokes(strokes, shader)
        batch = found.batches[part, ink]
        if batch is not None:
            shader.uniform_float("color", (*palette[ink], alpha))
            batch.draw(shader)


def _nodes(found, colour, size):
    if not len(found.nodes):
        return
    shader = blender_versions.builtin_shader("UNIFORM_COLOR")
    if "nodes" not in found.batches:
        points = GPUVertBuf(shader.format_calc(), len(found.nodes))
        points.attr_fill("pos", found.nodes.astype(np.float32))
        found.batches["nodes"] = GPUBatch(type="POINTS", buf=points)
    shader.bind()
    shader.uniform_float("color", colour)
    gpu.state.point_size_set(size)
    found.batches["nodes"].draw(shader)
    gpu.state.point_size_set(1.0)


def _draw_marks():
    pen = drawing.at_hand(bpy.context.scene)
    for context, network, found in _seen_networks():
        scale = context.preferences.system.ui_scale
        is_light = _is_on_light(context, network)
        gpu.state.blend_set("ALPHA")
        colour = preferences.colour("tags", "problem", is_light)
        for place in _in_picture(context, found.problems):
            shapes.draw_segments(
                shapes.ring(place, _PROBLEM * scale), ((*colour, 1.0), _PROBLEM_WIDTH * scale)
            )
        gpu.state.blend_set("NONE")
    if pen is not None and bpy.context.region_data is not None:
        _draw_pen(bpy.context, pen)


def _draw_pen(context, pen):
    scale = context.preferences.system.ui_scale
    places = [*pen.points, *([] if pen.place is None else [pen.place])]
    seen = _in_picture(context, np.array(places).reshape(-1, 3))
    if len(seen) < len(places) or not len(seen):
        return
    gpu.state.blend_set("ALPHA")
    flat = np.column_stack([seen, np.zeros(len(seen))]).astype(np.float32)
    if len(flat) > 1:
        shapes.draw_segments(np.repeat(flat, 2, axis=0)[1:-1], (_PEN, 1.5 * scale))
    if pen.points:
        shapes.draw_triangles(shapes.discs(seen[: len(pen.points)], _POINT * scale), _PEN)
    if pen.place is not None and pen.is_snapped:
        shapes.draw_triangles(shapes.discs(seen[-1:], _PLACE * scale), _PEN)
    gpu.state.blend_set("NONE")


def _in_picture(context, points):
    """(k, 2) dots in the region of those points (n, 3) that are before the eye."""
    if not len(points):
        return np.empty((0, 2))
    seen = drawing.in_picture(context.region, context.region_data, points)
    return seen[np.isfinite(seen).all(axis=1)]


_lines, _marks = Handler(_draw_lines, "POST_VIEW"), Handler(_draw_marks, "POST_PIXEL")


def register():
    _lines.register()
    _marks.register()


def unregister():
    _marks.unregister()
    _lines.unregister()
    network_arrays.forget_all()
