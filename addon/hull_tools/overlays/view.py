# SPDX-License-Identifier: GPL-3.0-or-later
"""How overlays stand in the 3D view: on their hull, before its surface, in colours that can be told
from what is behind them."""

from functools import cached_property

import bpy
from mathutils import Matrix, Vector

from ..bridge.blender import units, view_depth
from ..bridge.objects import shown_objects
from ..features.hull import hull_state
from ..features.lines import lines

# What lies on the surface is drawn nearer to the eye by this part of the hull's size, lest the
# surface object's flat faces hide it.
_NEARER = 1.5e-3
_LARGEST_PART = 0.05  # of the distance to the eye

# Luminance, linear, above which a background is light.
_LIGHT = 0.18


class HullInView:
    """A hull with its HullState, as one 3D view shows it."""

    def __init__(self, context, hull, state):
        self.context, self.hull, self.state = context, hull, state
        self.metres_per_unit = units.metres_per_unit(context.scene)
        if has_surface(state):
            self.size = lines.size_of(state.ship.surface)
        else:  # of a mesh that never was without errors
            self.size = max(hull.dimensions) * self.metres_per_unit

    @cached_property
    def is_on_light(self):
        """Whether what is drawn of the hull lies on something light; see has_light_ground."""
        return has_light_ground(self.context, self.hull)

    def to_view(self, is_image=False, layer=1):
        """From the hull's metres, or those of its mirror image, to view coordinates, the nearer the
        higher the layer."""
        scale = 1.0 / self.metres_per_unit
        units = Matrix.Diagonal((scale, -scale if is_image else scale, scale, 1.0))
        to_view = self.context.region_data.view_matrix @ self.hull.matrix_world @ units
        middle, size = (0.5 * self.size, 0.0, 0.0), self.size / self.metres_per_unit
        return brought_nearer(self.context, to_view, middle, size, layer) @ to_view


def brought_nearer(context, to_view, middle, size, layer):
    """Brings what is in view coordinates nearer without moving it across the picture: something of
    a size, Blender's units, with its middle at a place that to_view brings there."""
    shift = layer * _NEARER * size
    if not context.region_data.is_perspective:
        return Matrix.Translation((0.0, 0.0, shift))
    distance = max((to_view @ Vector(middle)).length, shift)
    clip_start = context.space_data.clip_start
    shift = layer * view_depth.nearer_by(shift / layer, distance, clip_start)
    factor = 1.0 - min(shift / distance, _LARGEST_PART)
    return Matrix.Diagonal((factor, factor, factor, 1.0))


def has_surface(state):
    return state.ship.surface is not None


def hulls_in_view(is_wanted=has_surface):
    """A HullInView of each hull that the view at hand shows, and whose HullState is wanted; none
    where the view shows no overlays."""
    context = bpy.context
    if context.region_data is None or not context.space_data.overlay.show_overlays:
        return
    for hull, state in hull_state.known_hulls(context.view_layer):
        if is_wanted(state) and is_seen(context, hull):
            yield HullInView(context, hull, state)


def is_seen(context, obj):
    """Whether the 3D view at hand shows an object."""
    depsgraph = context.view_layer.depsgraph
    if depsgraph is not None:
        obj = obj.evaluated_get(depsgraph)  # objects themselves do not know of local views
    return obj.visible_in_viewport_get(context.space_data)


def has_light_ground(context, hull):
    """Whether what the hull's lines are drawn upon is light: its surface, or else the view."""
    surface = shown_objects.surface_of(hull)
    if is_shaded(context, surface) and hull.hull.fairness.colours == "SLOPE":
        return False  # the sides of a ship are in the dark middle of its colours
    return is_light_ground(context, surface)


def is_shaded(context, surface):
    """Whether the 3D view at hand shows the faces of an object, or None."""
    has_faces = context.space_data.shading.type != "WIREFRAME"
    return has_faces and surface is not None and is_seen(context, surface)


def is_light_ground(context, surface):
    """Whether an object, or None, is light, or else the view."""
    if is_shaded(context, surface):
        material = surface.active_material
        return _luminance(material.diffuse_color if material else (0.8, 0.8, 0.8)) > _LIGHT
    gradients = context.preferences.themes[0].view_3d.space.gradients
    return _luminance([part**2.2 for part in gradients.high_gradient]) > _LIGHT


def _luminance(colour):
    return 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2]


class Handler:
    """A function that draws in 3D views, while it is registered."""

    def __init__(self, draw, stage):
        self._draw, self._stage, self._handle = draw, stage, None

    def register(self):
        if not bpy.app.background:
            self._handle = bpy.types.SpaceView3D.draw_handler_add(
                self._draw, (), "WINDOW", self._stage
            )

    def unregister(self):
        if self._handle is not None:
            bpy.types.SpaceView3D.draw_handler_remove(self._handle, "WINDOW")
            self._handle = None
