# SPDX-License-Identifier: GPL-3.0-or-later
"""In Blender: a hull as a mirror of light lines that run along the ship, before plain grey."""

import math

import bpy
import numpy as np
from hull_fairness.lights import BANDS, VIEWS
from mathutils import Vector

LIGHT, DARK, AROUND = (0.94, 0.95, 0.96, 1.0), (0.035, 0.05, 0.075, 1.0), (0.62, 0.64, 0.66, 1.0)
RENDER_SAMPLES = 32
WIDTH, HEIGHT = 1600, 800
FOCAL_LENGTH_MM, MARGIN = 70.0, 1.03


def set_up(surface_object):
    """Paints the hull, and sets renderer and surroundings."""
    scene = bpy.context.scene
    surface_object.data.materials.clear()
    surface_object.data.materials.append(_mirror())
    world = bpy.data.worlds.new("Grey")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = AROUND
    scene.world = world
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = RENDER_SAMPLES
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 0
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    scene.render.resolution_percentage = 100
    scene.render.dither_intensity = 0.0
    scene.render.image_settings.file_format = "PNG"


def _mirror():
    """Bands by the angle around the ship's length of what is mirrored at a point."""
    material = bpy.data.materials.new("Light lines")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()

    def add(kind, **settings):
        node = tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(node, name, value)
        return node

    place, parts = add("ShaderNodeTexCoord"), add("ShaderNodeSeparateXYZ")
    angle = add("ShaderNodeMath", operation="ARCTAN2")
    turns = add("ShaderNodeMath", operation="MULTIPLY")
    turns.inputs[1].default_value = BANDS / (2.0 * math.pi)
    band = add("ShaderNodeMath", operation="FRACT")
    is_light = add("ShaderNodeMath", operation="GREATER_THAN")
    is_light.inputs[1].default_value = 0.5
    mix = add("ShaderNodeMixRGB")
    mix.inputs["Color1"].default_value, mix.inputs["Color2"].default_value = DARK, LIGHT
    shine, output = add("ShaderNodeEmission"), add("ShaderNodeOutputMaterial")
    for source, target in (
        (place.outputs["Reflection"], parts.inputs[0]),
        (parts.outputs["Z"], angle.inputs[0]),
        (parts.outputs["Y"], angle.inputs[1]),
        (angle.outputs[0], turns.inputs[0]),
        (turns.outputs[0], band.inputs[0]),
        (band.outputs[0], is_light.inputs[0]),
        (is_light.outputs[0], mix.inputs["Fac"]),
        (mix.outputs[0], shine.inputs["Color"]),
        (shine.outputs[0], output.inputs["Surface"]),
    ):
        tree.links.new(source, target)
    return material


def look_from(surface_object, view):
    """A camera so far away that the hull just fits."""
    scene = bpy.context.scene
    lens = bpy.data.cameras.new(view)
    lens.lens = FOCAL_LENGTH_MM
    camera = bpy.data.objects.new(view, lens)
    scene.collection.objects.link(camera)
    scene.camera = camera
    bearing, elevation = (math.radians(angle) for angle in VIEWS[view])
    back = Vector((math.cos(bearing), math.sin(bearing), math.tan(elevation)))
    camera.rotation_euler = back.to_track_quat("Z", "Y").to_euler()
    bpy.context.view_layer.update()
    mesh, place = surface_object.data, surface_object.matrix_world
    points = np.array([place @ vertex.co for vertex in mesh.vertices])
    at, _ = camera.camera_fit_coords(
        bpy.context.evaluated_depsgraph_get(), points.reshape(-1).tolist()
    )
    centre = Vector(0.5 * (points.min(axis=0) + points.max(axis=0)))
    camera.location = centre + MARGIN * (at - centre)
    length = float(np.ptp(points, axis=0).max())
    lens.clip_start, lens.clip_end = 0.01 * length, 100.0 * length
