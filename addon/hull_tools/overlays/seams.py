# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams and butts of the plates laid out last over the 3D view, pale where the hull has changed
since, and the names of plates that face the eye."""

import gpu
import numpy as np
from bpy_extras.view3d_utils import location_3d_to_region_2d
from mathutils import Vector

from ..bridge.blender import preferences
from ..features.production import seam_lines
from . import label_places, shapes
from .lines import Pen, batch_of, seen_then_hidden
from .view import Handler, hulls_in_view

_WIDTH, _PALE = 1.8, 0.45
_TEXT, _MARGIN = 11.0, 2.0  # dots, at a scale of 1


def _draw_lines():
    for shown in hulls_in_view():
        group = seam_lines.shown(shown.hull)
        if group is None:
            continue
        pen = Pen(shown)
        colour = preferences.colour("plates", "seam", shown.is_on_light)
        strength = 1.0 if group.is_current else _PALE
        for alpha in seen_then_hidden():
            pen.draw(group, batch_of(group, pen.shader), _WIDTH, (*colour, strength * alpha))


def _draw_names():
    for shown in hulls_in_view():
        group = seam_lines.shown(shown.hull)
        if group is not None and group.is_current:
            _draw_names_of(shown, group)


def _draw_names_of(shown, group):
    context, view = shown.context, shown.context.region_data
    scale = context.preferences.system.ui_scale
    matrix = np.array(shown.hull.matrix_world)
    places = group.places / shown.metres_per_unit @ matrix[:3, :3].T + matrix[:3, 3]
    faces = facing(places, group.normals @ matrix[:3, :3].T, view)
    chosen, corners, sizes = [], [], []
    for k in np.flatnonzero(faces):
        at = location_3d_to_region_2d(context.region, view, Vector(places[k]))
        if at is not None:
            size = np.array(shapes.measure(group.names[k], _TEXT * scale))
            chosen.append(k)
            sizes.append(size + 2.0 * _MARGIN * scale)
            corners.append(np.array(at) - 0.5 * size)
    depths = -faces[chosen] if chosen else np.empty(0)
    gpu.state.blend_set("ALPHA")
    for k, at, is_written in zip(chosen, corners, label_places.written(corners, sizes, depths)):
        if is_written:
            shapes.draw_words(group.names[k], *at, _TEXT * scale, _MARGIN * scale)
    gpu.state.blend_set("NONE")


def facing(places, normals, view):
    """(n,) how much surfaces at places (n, 3) with normals (n, 3) face the eye of a RegionView3D, 1
    fully, 0 for what turns away."""
    back = np.array(view.view_matrix.inverted())
    if view.is_perspective:
        ways = back[:3, 3] - places
        ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    else:
        ways = np.broadcast_to(back[:3, 2], places.shape)
    lengths = np.linalg.norm(normals, axis=1)
    return np.maximum((ways * normals).sum(axis=1) / np.maximum(lengths, 1e-300), 0.0)


_lines, _names = Handler(_draw_lines, "POST_VIEW"), Handler(_draw_names, "POST_PIXEL")


def register():
    _lines.register()
    _names.register()


def unregister():
    _names.unregister()
    _lines.unregister()
