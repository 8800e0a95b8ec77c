# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of a hull: in clear water, in plain light, seen over the bow quarter.

Lengths are those of the hull, so that a dinghy and a tanker look alike.
"""

import contextlib
import math
import os
import sys

import bmesh
import bpy
import numpy as np
from enabled_addon import part
from mathutils import Euler, Vector

WIDTH, HEIGHT = 1600, 900
RENDER_SAMPLES = 24

# Where the camera stands, seen from the hull: off the bow to starboard, and above the water.
BEARING_DEG, ELEVATION_DEG = 42.0, 16.0
FOCAL_LENGTH_MM = 70.0
MARGIN = 1.13

TOPSIDE = (0.52, 0.56, 0.60, 1.0)
BOOT_TOP = (0.012, 0.02, 0.035, 1.0)
ANTIFOULING = (0.55, 0.09, 0.05, 1.0)
INSIDE = (0.30, 0.31, 0.32, 1.0)
BOOT_TOP_HEIGHT = 0.035

WATER_TINT = (0.55, 0.80, 0.92, 1.0)
WATER_COLOUR = (0.30, 0.58, 0.75, 1.0)
WATER_VEIL = 0.04
WATER_MARGIN = 2.0

# Colours of the background by the sine of the elevation: the camera sees those below 0.
BACKGROUND = (
    (-1.0, (0.20, 0.22, 0.25, 1.0)),
    (-0.40, (0.42, 0.46, 0.50, 1.0)),
    (-0.08, (0.74, 0.78, 0.81, 1.0)),
    (0.10, (0.90, 0.93, 0.95, 1.0)),
    (1.0, (0.55, 0.68, 0.85, 1.0)),
)


def set_up(hull):
    """Paints the hull and puts water, light and camera around it."""
    scene = bpy.context.scene
    corners = _extent(hull)
    length = float(np.ptp(corners, axis=0).max())
    draft = hull.hull.draft
    hull.hull.surface_object.data.materials[0] = _hull_paint(draft, corners[:, 2].max())
    _add_water(scene, hull, draft, length)
    _add_sun(scene)
    scene.world = _background()
    _add_camera(scene, hull)
    _set_renderer(scene)


def _extent(hull):
    return np.array(hull.hull.surface_object.bound_box)


def _node_tree(owner):
    """The emptied node tree of a material or a world, and a function that adds nodes to it."""
    owner.use_nodes = True
    tree = owner.node_tree
    tree.nodes.clear()

    def add(kind, **inputs):
        node = tree.nodes.new(kind)
        for name, value in inputs.items():
            node.inputs[name].default_value = value
        return node

    return tree, add


def _set_stops(ramp, stops):
    elements = ramp.color_ramp.elements
    while len(elements) > 1:
        elements.remove(elements[-1])
    elements[0].position, elements[0].color = stops[0]
    for position, colour in stops[1:]:
        elements.new(position).color = colour


def _hull_paint(draft, top):
    """Antifouling below the water, a boot top, topside paint; plain grey inside."""
    material = bpy.data.materials.new("Hull paint")
    tree, add = _node_tree(material)
    place, parts = add("ShaderNodeTexCoord"), add("ShaderNodeSeparateXYZ")
    height = add("ShaderNodeMapRange")
    height.inputs["From Max"].default_value = max(top, 1.01 * draft)
    ramp = add("ShaderNodeValToRGB")
    ramp.color_ramp.interpolation = "CONSTANT"
    water_line = draft / max(top, 1.01 * draft)
    boot_top = water_line * (1.0 + BOOT_TOP_HEIGHT)
    _set_stops(ramp, [(0.0, ANTIFOULING), (water_line, BOOT_TOP), (min(boot_top, 1.0), TOPSIDE)])
    geometry, mix = add("ShaderNodeNewGeometry"), add("ShaderNodeMixRGB", Color2=INSIDE)
    paint, output = add("ShaderNodeBsdfPrincipled", Roughness=0.38), add("ShaderNodeOutputMaterial")
    for source, target in (
        (place.outputs["Object"], parts.inputs[0]),
        (parts.outputs["Z"], height.inputs["Value"]),
        (height.outputs[0], ramp.inputs[0]),
        (geometry.outputs["Backfacing"], mix.inputs["Fac"]),
        (ramp.outputs["Color"], mix.inputs["Color1"]),
        (mix.outputs["Color"], paint.inputs["Base Color"]),
        (paint.outputs[0], output.inputs["Surface"]),
    ):
        tree.links.new(source, target)
    return material


def _water():
    """Clear tinted water that veils what is below the more, the flatter one looks at it.

    It mirrors nothing: a mirrored topside would lie over the underwater body.
    """
    material = bpy.data.materials.new("Water")
    tree, add = _node_tree(material)
    flatness = add("ShaderNodeLayerWeight", Blend=WATER_VEIL)
    clear = add("ShaderNodeBsdfTransparent", Color=WATER_TINT)
    veil = add("ShaderNodeEmission", Color=WATER_COLOUR)
    mix, output = add("ShaderNodeMixShader"), add("ShaderNodeOutputMaterial")
    tree.links.new(flatness.outputs["Fresnel"], mix.inputs[0])
    tree.links.new(clear.outputs[0], mix.inputs[1])
    tree.links.new(veil.outputs[0], mix.inputs[2])
    tree.links.new(mix.outputs[0], output.inputs["Surface"])
    material.blend_method = "BLEND"
    material.diffuse_color = (0.3, 0.6, 0.7, 0.35)
    return material


def _add_water(scene, hull, draft, length):
    """A sheet that fills the picture, with no water inside the hull where it is open."""
    corners = _extent(hull)
    (aft, right), (forward, left) = corners[:, :2].min(axis=0), corners[:, :2].max(axis=0)
    # The line of sight that grazes the keel's near side goes through the sheet.
    margin = WATER_MARGIN * length + draft / math.tan(math.radians(ELEVATION_DEG))
    aft, forward, right, left = aft - margin, forward + margin, right - margin, left + margin
    outline = [(aft, right, 0.0), (forward, right, 0.0), (forward, left, 0.0), (aft, left, 0.0)]
    mesh = bpy.data.meshes.new("Water")
    if not _fill_around(mesh, outline, _waterline(hull, draft), 1e-5 * length):
        mesh.from_pydata(outline, [], [(0, 1, 2, 3)])
    mesh.materials.append(_water())
    water = bpy.data.objects.new("Water", mesh)
    water.location = hull.location + Vector((0.0, 0.0, draft))
    water.hide_select = True
    scene.collection.objects.link(water)


def _waterline(hull, draft):
    """The polylines of the hull's waterline at its draft, in the plane z = 0 of the sheet."""
    state = part("bridge.hull_state").state_of(hull)
    scale = part("bridge.units").metres_per_unit(bpy.context.scene)
    group = state.lines["draft"]
    for line in group.polylines:
        for side in (1.0, -1.0) if group.is_mirrored else (1.0,):
            yield [(x / scale, side * y / scale, 0.0) for x, y, _ in line]


def _fill_around(mesh, outline, polylines, weld_distance):
    """Fills a mesh between an outline and closed lines in it; False where these do not close."""
    bm = bmesh.new()
    try:
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
        bm.to_mesh(mesh)
        return bool(mesh.polygons)
    finally:
        bm.free()


def _add_sun(scene):
    light = bpy.data.lights.new("Sun", "SUN")
    light.energy = 2.2
    light.angle = math.radians(8.0)
    light.color = (1.0, 0.96, 0.90)
    sun = bpy.data.objects.new("Sun", light)
    sun.rotation_euler = Euler((math.radians(48.0), 0.0, math.radians(15.0)))
    scene.collection.objects.link(sun)


def _background():
    world = bpy.data.worlds.new("Studio")
    tree, add = _node_tree(world)
    direction, parts = add("ShaderNodeTexCoord"), add("ShaderNodeSeparateXYZ")
    height = add("ShaderNodeMapRange")
    height.inputs["From Min"].default_value = -1.0
    ramp, background = add("ShaderNodeValToRGB"), add("ShaderNodeBackground", Strength=0.9)
    _set_stops(ramp, [(0.5 * (sine + 1.0), colour) for sine, colour in BACKGROUND])
    output = add("ShaderNodeOutputWorld")
    for source, target in (
        (direction.outputs["Generated"], parts.inputs[0]),
        (parts.outputs["Z"], height.inputs["Value"]),
        (height.outputs[0], ramp.inputs[0]),
        (ramp.outputs["Color"], background.inputs["Color"]),
        (background.outputs[0], output.inputs["Surface"]),
    ):
        tree.links.new(source, target)
    return world


def _add_camera(scene, hull):
    """Looks at the hull from off the starboard bow, so far away that it just fits."""
    lens = bpy.data.cameras.new("Bow quarter")
    lens.lens = FOCAL_LENGTH_MM
    camera = bpy.data.objects.new("Bow quarter", lens)
    scene.collection.objects.link(camera)
    scene.camera = camera
    bearing, elevation = math.radians(-BEARING_DEG), math.radians(ELEVATION_DEG)
    outwards = Vector(
        (
            math.cos(elevation) * math.cos(bearing),
            math.cos(elevation) * math.sin(bearing),
            math.sin(elevation),
        )
    )
    camera.rotation_euler = outwards.to_track_quat("Z", "Y").to_euler()
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    surface = hull.hull.surface_object
    bpy.context.view_layer.update()
    points = np.array([surface.matrix_world @ vertex.co for vertex in surface.data.vertices])
    place, _ = camera.camera_fit_coords(
        bpy.context.evaluated_depsgraph_get(), points.reshape(-1).tolist()
    )
    centre = Vector(0.5 * (points.min(axis=0) + points.max(axis=0)))
    camera.location = centre + MARGIN * (place - centre)
    length = float(np.ptp(points, axis=0).max())
    lens.clip_start, lens.clip_end = 0.01 * length, 200.0 * length


def _set_renderer(scene):
    scene.render.engine = "CYCLES"
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "PNG"
    scene.view_settings.view_transform = "Standard"
    scene.cycles.device = "CPU"
    scene.cycles.samples = RENDER_SAMPLES
    scene.cycles.max_bounces = 2
    scene.cycles.use_adaptive_sampling = True
    scene.cycles.use_denoising = _can_denoise(scene)


def _can_denoise(scene):
    """Whether this Blender was built with a denoiser: the list of them is then not empty."""
    kinds = scene.cycles.bl_rna.properties["denoiser"].enum_items
    return len(kinds) > 0


@contextlib.contextmanager
def quiet_output():
    """Keeps Blender's own lines about every tile off the terminal."""
    sys.stdout.flush()
    terminal = os.dup(1)
    with open(os.devnull, "wb") as nowhere:
        os.dup2(nowhere.fileno(), 1)
    try:
        yield
    finally:
        os.dup2(terminal, 1)
        os.close(terminal)
