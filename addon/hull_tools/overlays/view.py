# SPDX-License-Identifier: GPL-3.0-or-later
"""How overlays stand in the 3D view: on their hull, before its surface, in colours that can be told
from what is behind them."""

from contextlib import contextmanager

import gpu
from mathutils import Matrix, Vector

from ..bridge import shown_objects

# What lies on the surface is drawn nearer to the eye by this part of the hull's size, lest the
# surface object's flat faces hide it.
_NEARER = 1.5e-3
_LARGEST_PART = 0.05  # of the distance to the eye

# Luminance, linear, above which a background is light.
_LIGHT = 0.18


@contextmanager
def on_hull(context, hull, size, metres_per_unit, is_image=False):
    """Draws in the hull's metres, or in those of its mirror image; size in m."""
    view = context.region_data.view_matrix
    units = Matrix.Diagonal((1.0, -1.0 if is_image else 1.0, 1.0, metres_per_unit))
    model = hull.matrix_world @ units
    with gpu.matrix.push_pop():
        gpu.matrix.load_matrix(
            _nearer(context, view @ model, size / metres_per_unit) @ view @ model
        )
        yield


def _nearer(context, to_view, size):
    """Brings what is in view coordinates nearer without moving it across the picture."""
    shift = _NEARER * size
    if not context.region_data.is_perspective:
        return Matrix.Translation((0.0, 0.0, shift))
    distance = max((to_view @ Vector((0.0, 0.0, 0.0))).length, shift)
    factor = 1.0 - min(shift / distance, _LARGEST_PART)
    return Matrix.Diagonal((factor, factor, factor, 1.0))


def has_light_ground(context, hull):
    """Whether what the hull's lines are drawn upon is light: its surface, or else the view."""
    surface = shown_objects.surface_of(hull)
    space = context.space_data
    is_seen = surface is not None and surface.visible_in_viewport_get(space)
    if is_seen and space.shading.type != "WIREFRAME":
        material = surface.active_material
        colour = material.diffuse_color if material else (0.8, 0.8, 0.8)
        return _luminance(colour) > _LIGHT
    return has_light_background(context)


def has_light_background(context):
    gradients = context.preferences.themes[0].view_3d.space.gradients
    return _luminance([part**2.2 for part in gradients.high_gradient]) > _LIGHT


def _luminance(colour):
    return 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2]
