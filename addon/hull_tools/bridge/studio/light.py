# SPDX-License-Identifier: GPL-3.0-or-later
"""Sun and sky, or the lamps and the backdrop of a photographer."""

from math import cos, radians, sin

import bpy
from mathutils import Vector

from ..shader_nodes import Nodes, rgba
from . import place, water_look

HORIZON = (0.76, 0.85, 0.92)
# By the sine of the elevation.
_SKY = (
    (0.0, HORIZON),
    (0.10, (0.60, 0.76, 0.90)),
    (0.35, (0.28, 0.50, 0.78)),
    (1.0, (0.08, 0.22, 0.52)),
)
BACKDROP = (0.72, 0.73, 0.74)
_DIM_STUDIO = 0.55  # the backdrop's light on the hull
# The light that comes from below to what is not the eye: that of the depth, and more of it.
_FROM_WATER = (0.16, 0.30, 0.34)
_FROM_LAND = (0.30, 0.29, 0.28)

# To starboard, where the cameras are, and a little ahead.
_SUN_BEARING, _SUN_ELEVATION = radians(-68.0), radians(38.0)
_SUN_POWER, _SUN_SIZE = 3.4, radians(1.5)
_SUN_COLOUR = (1.0, 0.95, 0.87)

# Lamps: bearing and elevation in degrees, distance and size in lengths, power.
_LAMPS = {
    "Studio key light": (-60.0, 48.0, 1.6, 0.9, 26.0),
    "Studio fill light": (-150.0, 22.0, 1.9, 1.2, 9.0),
    "Studio rim light": (100.0, 40.0, 1.7, 0.7, 18.0),
}

# The border between sky and depth, a little below the horizon, so that level sight meets the sky.
_BORDER = -1e-3


def add_light(here, kind, in_water):
    """Lights of a kind, "SUN" or "STUDIO"; returns the World."""
    if kind == "SUN":
        _add_sun(here)
    else:
        for name, lamp in _LAMPS.items():
            _add_lamp(here, name, *lamp)
    return _world(kind, in_water)


def _world(kind, in_water):
    world = bpy.data.worlds.new("Studio")
    world[place.MARK] = True
    nodes = Nodes(world)
    direction = nodes.add("ShaderNodeTexCoord").outputs["Generated"]
    sine = nodes.split(direction)[2]
    is_seen = nodes.add("ShaderNodeLightPath").outputs["Is Camera Ray"]
    if kind == "SUN":
        above = nodes.ramp(sine, _SKY)
        shining = _FROM_WATER if in_water else _FROM_LAND
        below = nodes.mix_colour(is_seen, rgba(shining), rgba(HORIZON))
    else:
        dim = tuple(_DIM_STUDIO * part for part in BACKDROP)
        above = below = nodes.mix_colour(is_seen, rgba(dim), rgba(BACKDROP))
    if in_water:
        depth = water_look.depth_colour(nodes, sine)
        below = nodes.mix_colour(is_seen, rgba(_FROM_WATER), depth)
    is_above = nodes.math("GREATER_THAN", sine, _BORDER)
    colour = nodes.mix_colour(is_above, below, above)
    shader = nodes.add("ShaderNodeBackground", Color=colour).outputs[0]
    nodes.finish(shader, "ShaderNodeOutputWorld")
    return world


def _add_sun(here):
    lamp = bpy.data.lights.new("Studio sun", "SUN")
    lamp.energy, lamp.angle, lamp.color = _SUN_POWER, _SUN_SIZE, _SUN_COLOUR
    sun = here.add_scenery("Studio sun", lamp)
    _aim(sun, here, _outwards(_SUN_BEARING, _SUN_ELEVATION), 1.5)


def _add_lamp(here, name, bearing, elevation, distance, size, power):
    lamp = bpy.data.lights.new(name, "AREA")
    lamp.shape, lamp.size = "DISK", size * here.length
    # In watts: what arrives falls with the square of the distance.
    lamp.energy = power * here.length**2
    lamp_object = here.add_scenery(name, lamp)
    _aim(lamp_object, here, _outwards(radians(bearing), radians(elevation)), distance)


def _outwards(bearing, elevation):
    level = cos(elevation)
    return Vector((level * cos(bearing), level * sin(bearing), sin(elevation)))


def _aim(lamp, here, outwards, distance):
    """Puts a lamp so many lengths away from the hull and turns it to it."""
    lamp.location = Vector(here.centre) + distance * here.length * outwards
    lamp.rotation_euler = outwards.to_track_quat("Z", "Y").to_euler()
