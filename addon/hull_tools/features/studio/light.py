# SPDX-License-Identifier: GPL-3.0-or-later
"""Sun and sky, or the lamp, the soft boxes and the backdrop of a photographer.

There is one lamp in either: a picture's samples are not shared between several, and less of it is
noise. Sky and soft boxes are the world's, and change softly with the direction.
"""

from dataclasses import dataclass
from math import cos, radians, sin

import bpy
from mathutils import Vector

from . import place, water_look
from .shader_nodes import Nodes, rgba

_HORIZON = (0.60, 0.74, 0.86)
# By the sine of the elevation.
_SKY = (
    (0.0, _HORIZON),
    (0.05, (0.50, 0.68, 0.86)),
    (0.18, (0.32, 0.54, 0.80)),
    (0.5, (0.16, 0.36, 0.68)),
    (1.0, (0.07, 0.20, 0.50)),
)
_BACKDROP = (0.72, 0.73, 0.74)
# What comes from below to all but the eye, from the water and from land.
_FROM_WATER = (0.30, 0.44, 0.48)
_FROM_LAND = (0.30, 0.29, 0.28)

# Soft boxes: bearing and elevation in degrees, the cosine of the angle at which they end, light.
_DIM = 0.30
_SOFT_BOXES = (
    (-150.0, 20.0, 0.55, 0.9),
    (20.0, 25.0, 0.60, 0.8),
    (95.0, 50.0, 0.55, 1.3),
)


@dataclass(frozen=True)
class _Lamp:
    """bearing, elevation, size: degrees; to starboard, where the cameras are, and a little
    ahead."""

    name: str
    bearing: float
    elevation: float
    size: float
    power: float
    colour: tuple


_LAMPS = {
    "SUN": _Lamp("Studio sun", -68.0, 38.0, 1.5, 3.2, (1.0, 0.95, 0.87)),
    "STUDIO": _Lamp("Studio key light", -62.0, 48.0, 14.0, 2.3, (1.0, 0.98, 0.95)),
}

# The border between sky and depth, a little below the horizon, so that level sight meets the sky.
_BORDER = -1e-3


def add_light(here, kind):
    """The lamp of a kind, "SUN" or "STUDIO"; returns the World."""
    wanted = _LAMPS[kind]
    lamp = bpy.data.lights.new(wanted.name, "SUN")
    lamp.energy, lamp.angle, lamp.color = wanted.power, radians(wanted.size), wanted.colour
    shown = here.add_scenery(wanted.name, lamp)
    outwards = _outwards(wanted.bearing, wanted.elevation)
    shown.location = Vector(here.centre) + 1.5 * here.length * outwards
    shown.rotation_euler = outwards.to_track_quat("Z", "Y").to_euler()
    return _world(kind, here.in_water)


def _outwards(bearing, elevation):
    bearing, elevation = radians(bearing), radians(elevation)
    level = cos(elevation)
    return Vector((level * cos(bearing), level * sin(bearing), sin(elevation)))


def backdrop_of(kind):
    """A function (nodes, sine of the elevation) for the colour of what is behind the hull."""
    return _sky if kind == "SUN" else _backdrop


def _sky(nodes, sine):
    return nodes.ramp(sine, _SKY)


def _backdrop(nodes, sine):
    return rgba(_BACKDROP)


def _world(kind, in_water):
    world = bpy.data.worlds.new("Studio")
    world[place.MARK] = True
    if hasattr(world, "cycles"):
        # Its light is found by chance alone: with this soft light that makes less noise.
        world.cycles.sampling_method = "NONE"
    nodes = Nodes(world)
    direction = nodes.add("ShaderNodeTexCoord").outputs["Generated"]
    sine = nodes.split(direction)[2]
    is_seen = nodes.add("ShaderNodeLightPath").outputs["Is Camera Ray"]
    if kind == "SUN":
        above = _sky(nodes, sine)
        below = nodes.mix_colour(is_seen, rgba(_FROM_LAND), rgba(_HORIZON))
    else:
        above = nodes.mix_colour(is_seen, _soft_boxes(nodes, direction), rgba(_BACKDROP))
        below = above
    if in_water:
        below = nodes.mix_colour(is_seen, rgba(_FROM_WATER), water_look.depth_colour(nodes, sine))
    is_above = nodes.math("GREATER_THAN", sine, _BORDER)
    colour = nodes.mix_colour(is_above, below, above)
    shader = nodes.add("ShaderNodeBackground", Color=colour).outputs[0]
    nodes.finish(shader, "ShaderNodeOutputWorld")
    return world


def _soft_boxes(nodes, direction):
    """The light of a dim room and of the soft boxes in it, as a grey."""
    light = _DIM
    for bearing, elevation, ends_at, power in _SOFT_BOXES:
        towards = tuple(_outwards(bearing, elevation))
        cosine = nodes.vector_math("DOT_PRODUCT", direction, towards).node.outputs["Value"]
        part = nodes.smooth(cosine, ends_at, 1.0)
        light = nodes.math("MULTIPLY_ADD", part, power, light)
    return light
