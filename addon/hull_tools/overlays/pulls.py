# SPDX-License-Identifier: GPL-3.0-or-later
"""What is held while the surface is pulled: a ring at the point, a line from where it was, and a
circle around what follows."""

import bpy
import gpu
import numpy as np
from bpy_extras.view3d_utils import location_3d_to_region_2d
from mathutils import Vector

from ..bridge.blender import units
from ..features.modelling import pull_lines
from . import shapes
from .view import Handler

_COLOUR, _HALO = (0.95, 0.45, 0.0, 1.0), (1.0, 1.0, 1.0, 0.9)
_RADIUS, _START, _WIDTH, _HALO_WIDTH = 8.0, 3.0, 2.0, 4.5  # dots, at a scale of 1


def strokes(start, now, scale, around=0.0):
    """Corners (n, 3) of the segments that show a pull, in the picture: a ring where the point is, a
    smaller one where it was, a line between, and a circle of a radius `around` the latter."""
    parts = [shapes.ring(now, _RADIUS * scale)]
    if around > _RADIUS * scale:
        parts.append(shapes.ring(start, around, 96))
    way = np.subtract(now, start)
    length = np.hypot(*way)
    if length > (_RADIUS + _START) * scale:
        ends = np.array(
            [start + way * _START * scale / length, now - way * _RADIUS * scale / length]
        )
        parts += [shapes.ring(start, _START * scale), np.column_stack([ends, np.zeros(2)])]
    return np.concatenate(parts).astype(np.float32)


def _draw():
    context = bpy.context
    pulled = pull_lines.shown(context.view_layer)
    if pulled is None or context.region_data is None:
        return
    hull, mark = pulled
    places = [_in_picture(context, hull, point) for point in (mark.start, mark.now)]
    if None in places:
        return
    scale = context.preferences.system.ui_scale
    around = _dots_of(context, hull, mark)
    corners = strokes(np.array(places[0]), np.array(places[1]), scale, around)
    gpu.state.blend_set("ALPHA")
    shapes.draw_segments(corners, (_HALO, _HALO_WIDTH * scale), (_COLOUR, _WIDTH * scale))
    gpu.state.blend_set("NONE")


def _dots_of(context, hull, mark):
    """The radius of a Mark in the picture, as it is where the pull began; 0 where it has none."""
    beside = context.region_data.view_rotation @ Vector((mark.radius, 0.0, 0.0))
    points = mark.start, Vector(mark.start) + hull.matrix_world.to_3x3().inverted() @ beside
    places = [_in_picture(context, hull, point) for point in points]
    return 0.0 if None in places else (places[1] - places[0]).length


def _in_picture(context, hull, point):
    scale = units.metres_per_unit(context.scene)
    place = hull.matrix_world @ (Vector(point) / scale)
    return location_3d_to_region_2d(context.region, context.region_data, place)


_handler = Handler(_draw, "POST_PIXEL")
register, unregister = _handler.register, _handler.unregister
