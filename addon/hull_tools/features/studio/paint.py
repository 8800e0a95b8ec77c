# SPDX-License-Identifier: GPL-3.0-or-later
"""Paint: antifouling up to the water, a boot top above it, topsides; that of the deck, and of lines
drawn on the hull.

The height decides for each point of the picture by itself, so that the border is exactly the
waterline, whatever the faces are.
"""

from . import place, water_look
from .shader_nodes import Nodes, rgba, set_named

_INSIDE = (0.30, 0.31, 0.32)
_DECK = (0.12, 0.17, 0.15)
_ROUGHNESS = 0.3
# Of the freeboard, where the height of the boot top is not given.
_BOOT_TOP_PART = 0.08
# The number of that name in the hull's paint.
_BOOT_TOP_ENDS = "Boot top ends"

_LINE_COLOURS = {"waterline": (0.010, 0.022, 0.090), "draft": (0.85, 0.87, 0.88)}
_OTHER_LINES = (0.008, 0.008, 0.010)


def hull_paint(here, settings):
    """The material of the hull's surface; `settings`: an Object.hull.studio."""
    material = place.new_material("Studio hull paint", settings.topside)
    nodes = Nodes(material)
    height = nodes.split(nodes.add("ShaderNodeTexCoord").outputs["Object"])[2]
    colour = nodes.mix_colour(
        nodes.math("GREATER_THAN", height, nodes.named(water_look.DRAFT, here.draft)),
        rgba(settings.antifouling),
        rgba(settings.boot_top),
    )
    top = nodes.named(_BOOT_TOP_ENDS, _boot_top_ends(here, settings))
    is_topside = nodes.math("GREATER_THAN", height, top)
    colour = nodes.mix_colour(is_topside, colour, rgba(settings.topside))
    is_inside = nodes.add("ShaderNodeNewGeometry").outputs["Backfacing"]
    colour = nodes.mix_colour(is_inside, colour, rgba(_INSIDE))
    shader = nodes.add("ShaderNodeBsdfPrincipled", Base_Color=colour, Roughness=_ROUGHNESS)
    _finish(nodes, shader, here)
    return material


def _boot_top_ends(here, settings):
    freeboard = max(here.high[2] - here.draft, 0.0)
    return here.draft + (settings.boot_top_height or _BOOT_TOP_PART * freeboard)


def follow(here, settings):
    """Brings the borders of the paint, and of what is under water, to where they belong now."""
    objects = {*here.collection.objects, here.hull.hull.surface_object}
    for material in {slot.material for obj in objects for slot in obj.material_slots}:
        if material is not None and material.get(place.MARK):
            set_named(material, water_look.DRAFT, here.draft)
            set_named(material, _BOOT_TOP_ENDS, _boot_top_ends(here, settings))


def deck_paint(here):
    material = place.new_material("Studio deck paint", _DECK)
    nodes = Nodes(material)
    shader = nodes.add("ShaderNodeBsdfDiffuse", Color=rgba(_DECK))
    _finish(nodes, shader, here)
    return material


def line_paint(kind, here):
    """Of the lines of one of lines.KINDS; without gloss, as a pencil's."""
    colour = _LINE_COLOURS.get(kind, _OTHER_LINES)
    material = place.new_material(f"Studio {kind} lines", colour)
    nodes = Nodes(material)
    shader = nodes.add("ShaderNodeBsdfDiffuse", Color=rgba(colour))
    _finish(nodes, shader, here)
    return material


def _finish(nodes, shader, here):
    seen = shader.outputs[0]
    if here.in_water:
        seen = water_look.veiled(nodes, seen, here.draft, here.length)
    nodes.finish(seen)
