# SPDX-License-Identifier: GPL-3.0-or-later
"""What the hull floats in or stands on: a sheet of water out to the horizon, or a floor."""

from math import sqrt

import bmesh
import bpy
from mathutils import Vector

from ...bridge.blender import blender_versions
from . import place, water_look
from .shader_nodes import Nodes, rgba

# In lengths of the hull.
_NEAR, _TO_THE_HORIZON = 6.0, 400.0
_WALL = 5.0
_FLOOR = 60.0
_HAZE = 30.0
_FLOOR_SEEN = (1.0, 6.0)
_CALM_FROM = 1.2

# Of waves in metres, for a hull one metre long; they grow with the root of the length, as a ship's
# own do with its speed.
_WAVE = 0.16
_REFRACTION = 1.333
# Less than a mirror, so that the underwater body is seen.
_MIRRORING = 0.68
_TINT = (0.80, 0.93, 0.95)

_LEVEL_SINE = 1e-4
_WINDOW = (0.35, 0.85)  # sines between which the surface is seen from below as a mirror, and open
_WINDOW_COLOUR = (0.42, 0.80, 0.88)
_SEEN_FROM_BELOW = 1.6  # lengths

_FLOOR_COLOUR = (0.48, 0.485, 0.49)


_WATER_NAME, _FLOOR_NAME = "Studio water", "Studio floor"


def add_water(here, backdrop):
    """Water, still empty. backdrop: see light.backdrop_of."""
    mesh = bpy.data.meshes.new(_WATER_NAME)
    mesh.materials.append(_water(here, backdrop))
    water = here.add_scenery(_WATER_NAME, mesh)
    water.visible_shadow = water.visible_diffuse = False


def follow(here, waterlines):
    """Brings the water to the draft, with none inside the hull's closed `waterlines`, polylines
    (k, 3) of both sides in m; or the floor under the keel. What is gone stays away."""
    water, floor = here.find(_WATER_NAME), here.find(_FLOOR_NAME)
    if water is not None:
        water.location.z = here.draft
        _fill_water(here, water.data, waterlines)
    if floor is not None:
        floor.location = (*here.centre[:2], here.low[2] - 1e-3 * here.length)


def _fill_water(here, mesh, waterlines):
    near, far = (_square(here, size) for size in (_NEAR, _TO_THE_HORIZON))
    scaled = [line / here.metres_per_unit for line in waterlines]
    lines = [[(float(p[0]), float(p[1]), 0.0) for p in line] for line in scaled]
    bm = bmesh.new()
    try:
        if not _fill_around(bm, near, lines, 1e-5 * here.length):
            bm.clear()
            _fill_around(bm, near, [], 1e-5 * here.length)
        # Apart from the near water, of which the waves would suffer by the size of its faces.
        inner = [min(bm.verts, key=lambda v: (v.co - Vector(corner)).length) for corner in near]
        outer = [bm.verts.new(corner) for corner in far]
        # What is below the horizon is water to those who look level, too.
        under = [bm.verts.new((x, y, -_WALL * here.length)) for x, y, _ in far]
        for i in range(4):
            bm.faces.new((inner[i - 1], outer[i - 1], outer[i], inner[i]))
            bm.faces.new((outer[i - 1], under[i - 1], under[i], outer[i]))
        bm.to_mesh(mesh)
    finally:
        bm.free()


def _square(here, size):
    """Corners of a square around the hull, so many lengths to each side."""
    (x, y), half = here.centre[:2], size * here.length
    return [(x + i * half, y + j * half, 0.0) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def _fill_around(bm, outline, polylines, weld_distance):
    """Fills a BMesh between an outline and closed lines in it; False where these do not close."""
    for polyline in (outline + outline[:1], *polylines):
        vertices = [bm.verts.new(point) for point in polyline]
        for ends in zip(vertices, vertices[1:]):
            bm.edges.new(ends)
    bmesh.ops.remove_doubles(bm, verts=bm.verts, dist=weld_distance)
    if any(len(vertex.link_edges) != 2 for vertex in bm.verts):
        return False
    bmesh.ops.triangle_fill(bm, edges=bm.edges)
    for face in bm.faces:
        face.normal_update()
        if face.normal.z < 0.0:
            face.normal_flip()
    return bool(bm.faces)


def _water(here, backdrop):
    material = place.new_material("Studio water", (0.3, 0.6, 0.7, 0.35))
    nodes = Nodes(material)
    geometry = nodes.add("ShaderNodeNewGeometry").outputs
    sine = nodes.math("ABSOLUTE", nodes.split(geometry["Incoming"])[2])
    distance = nodes.add("ShaderNodeCameraData").outputs["View Distance"]
    ripples = _ripples(nodes, here, distance)
    shader = nodes.mix_shader(
        geometry["Backfacing"],
        _from_above(nodes, here, distance, ripples, backdrop),
        _from_below(nodes, here, distance, sine, ripples),
    )
    # Level sight alone meets the sides: EEVEE draws them over the sheet, which is before them.
    upwards = nodes.math("ABSOLUTE", nodes.split(geometry["True Normal"])[2])
    is_side = nodes.math("LESS_THAN", upwards, 0.5)
    is_side = nodes.math("MULTIPLY", is_side, nodes.math("GREATER_THAN", sine, _LEVEL_SINE))
    nothing = nodes.add("ShaderNodeBsdfTransparent").outputs[0]
    nodes.finish(nodes.mix_shader(is_side, shader, nothing))
    blender_versions.make_see_through(material)
    return material


def _ripples(nodes, here, distance):
    """The normal of small waves, which are too small to be seen far away."""
    wave = _WAVE * sqrt(here.length * here.metres_per_unit) / here.metres_per_unit
    coordinates = nodes.add("ShaderNodeTexCoord").outputs["Object"]
    noise = nodes.add(
        "ShaderNodeTexNoise", Vector=coordinates, Scale=1.0 / wave, Detail=2.0, Distortion=0.4
    )
    part = nodes.math("DIVIDE", distance, _CALM_FROM * here.length)
    strength = nodes.math("DIVIDE", 0.16, nodes.math("ADD", 1.0, nodes.math("POWER", part, 2.0)))
    bump = nodes.add(
        "ShaderNodeBump", Strength=strength, Distance=0.4 * wave, Height=noise.outputs["Fac"]
    )
    return bump.outputs[0]


def _from_above(nodes, here, distance, ripples, backdrop):
    """Clear where one looks down, a mirror of the sky where one looks along, haze far away.

    The mirror image is worked out, not traced: there is no noise in it, and no image of the
    topsides over the underwater body.
    """
    fresnel = nodes.add("ShaderNodeFresnel", IOR=_REFRACTION, Normal=ripples).outputs[0]
    clear = nodes.add("ShaderNodeBsdfTransparent", Color=rgba(_TINT)).outputs[0]
    towards_eye = nodes.add("ShaderNodeNewGeometry").outputs["Incoming"]
    from_eye = nodes.vector_math("SCALE", towards_eye)
    from_eye.node.inputs["Scale"].default_value = -1.0
    sine = nodes.split(nodes.vector_math("REFLECT", from_eye, ripples))[2]
    mirror = nodes.emission(backdrop(nodes, nodes.math("ABSOLUTE", sine)))
    near = nodes.mix_shader(nodes.math("MULTIPLY", fresnel, _MIRRORING), clear, mirror)
    part = nodes.math("POWER", nodes.math("DIVIDE", distance, _HAZE * here.length), 2.0)
    clearness = nodes.math("EXPONENT", nodes.math("MULTIPLY", part, -1.0))
    return nodes.mix_shader(clearness, nodes.emission(backdrop(nodes, 0.0)), near)


def _from_below(nodes, here, distance, sine, ripples):
    """Bright where one looks up steeply, a mirror of the depth else."""
    slope = nodes.split(ripples)[0]
    seen = nodes.math("ADD", sine, nodes.math("MULTIPLY", slope, 1.5))
    depth = water_look.depth_colour(nodes, sine)
    colour = nodes.mix_colour(nodes.smooth(seen, *_WINDOW), depth, rgba(_WINDOW_COLOUR))
    part = nodes.math("DIVIDE", distance, _SEEN_FROM_BELOW * here.length)
    clearness = nodes.math("EXPONENT", nodes.math("MULTIPLY", part, -1.0))
    return nodes.emission(nodes.mix_colour(clearness, depth, colour))


def add_floor(here, backdrop):
    """A floor that goes over into the backdrop, and is not there from below."""
    size = _FLOOR * here.length
    corners = [(-size, -size, 0.0), (size, -size, 0.0), (size, size, 0.0), (-size, size, 0.0)]
    mesh = bpy.data.meshes.new(_FLOOR_NAME)
    mesh.from_pydata(corners, [], [(0, 1, 2, 3)])
    mesh.materials.append(_floor(here, backdrop))
    floor = here.add_scenery(_FLOOR_NAME, mesh)
    # The bottom is lit through it, and can be looked at from below.
    floor.visible_shadow = floor.visible_diffuse = False


def _floor(here, backdrop):
    material = place.new_material("Studio floor", _FLOOR_COLOUR)
    nodes = Nodes(material)
    x, y, _ = nodes.split(nodes.add("ShaderNodeTexCoord").outputs["Object"])
    squares = (nodes.math("MULTIPLY", part, part) for part in (x, y))
    away = nodes.math("SQRT", nodes.math("ADD", *squares))
    near, far = (part * here.length for part in _FLOOR_SEEN)
    plain = nodes.add("ShaderNodeBsdfDiffuse", Color=rgba(_FLOOR_COLOUR)).outputs[0]
    shader = nodes.mix_shader(
        nodes.smooth(away, near, far), plain, nodes.emission(backdrop(nodes, 0.0))
    )
    is_below = nodes.add("ShaderNodeNewGeometry").outputs["Backfacing"]
    nothing = nodes.add("ShaderNodeBsdfTransparent").outputs[0]
    nodes.finish(nodes.mix_shader(is_below, shader, nothing))
    blender_versions.make_see_through(material)
    return material
