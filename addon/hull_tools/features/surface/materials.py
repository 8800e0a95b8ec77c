# SPDX-License-Identifier: GPL-3.0-or-later
"""The materials that Hull Tools gives to what it shows, one for each purpose, shared by all hulls.

A material is made when it is first needed and then left to the user, who may change it.
"""

import bpy
from mathutils import Color

from ...bridge.blender import blender_versions

SURFACE = "Hull surface"

# Of the curve objects, by the kinds of lines.KINDS; linear RGB.
LINE_COLOURS = {
    "station": (0.012, 0.012, 0.016),
    "waterline": (0.02, 0.12, 0.55),
    "buttock": (0.03, 0.32, 0.08),
    "diagonal": (0.36, 0.07, 0.42),
    "plane": (0.62, 0.02, 0.12),
    "draft": (0.0, 0.42, 0.75),
    "flat": (0.25, 0.25, 0.05),
    "feature": (0.75, 0.16, 0.0),
}


def surface_material():
    return _material(SURFACE, (0.62, 0.67, 0.72), roughness=0.35)


def line_material(kind):
    return _material(f"Hull {kind}", LINE_COLOURS[kind], roughness=0.6)


def attribute_material(attribute):
    """A material that has the colours of a mesh's attribute, and its name."""
    material = bpy.data.materials.get((attribute, None))  # none of another file
    if material is None:
        material = bpy.data.materials.new(attribute)
        shader = _paint(material, (0.8, 0.8, 0.8), roughness=0.7)
        node = material.node_tree.nodes.new("ShaderNodeAttribute")
        node.attribute_name = attribute
        node.location = (shader.location.x - 250.0, shader.location.y)
        base = blender_versions.shader_input(shader, "Base Color")
        material.node_tree.links.new(node.outputs["Color"], base)
    return material


def has_attribute(material, attribute):
    """Whether a material has the colours of this attribute, as one has that came from another file
    by another name."""
    nodes = material.node_tree.nodes if material.node_tree is not None else ()
    return any(node.type == "ATTRIBUTE" and node.attribute_name == attribute for node in nodes)


def layer_material(name, colour):
    """A material of its own for a layer of an imported hull; colour sRGB, each part 0 to 1."""
    material = bpy.data.materials.new(name or "Shell")
    _paint(material, Color(colour).from_srgb_to_scene_linear(), roughness=0.4)
    return material


def _material(name, colour, roughness):
    material = bpy.data.materials.get(name)
    if material is None:
        material = bpy.data.materials.new(name)
        _paint(material, colour, roughness)
    return material


def _paint(material, colour, roughness):
    """Returns the shader's node."""
    material.diffuse_color = (*colour, 1.0)
    material.roughness = roughness
    material.use_nodes = True
    shader = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    blender_versions.shader_input(shader, "Base Color").default_value = (*colour, 1.0)
    blender_versions.shader_input(shader, "Roughness").default_value = roughness
    return shader
