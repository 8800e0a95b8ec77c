# SPDX-License-Identifier: GPL-3.0-or-later
"""The variants of a hull: from hull_io's HullData to Object.hull.variants, and back."""

import bpy

from ....hull_io.hull_data import Variant
from ...bridge.blender import units
from ..hull import hull_creation, hull_to_data
from . import kept_hulls


def give_variants(obj, hull, scene):
    """To a hull object without variants, of which a hull_io HullData tells. Layers that a variant
    has in common with the hull share its materials."""
    scale = units.metres_per_unit(scene)
    materials = [
        ((layer.name, layer.colour), slot.material)
        for layer, slot in zip(hull.layers, obj.material_slots)
    ]
    for variant in hull.variants:
        entry = obj.hull.variants.kept.add()
        entry.name, entry.note = variant.hull.name, variant.note
        entry.mesh = bpy.data.meshes.new(f"{obj.name}, {entry.name}")
        ship = kept_hulls.as_hull(obj, entry)
        hull_creation.give_ship(ship, variant.hull, scale, materials)


def take_variants(obj, scene):
    """The list of hull_io's Variant of a hull object; ValueError when the mesh of one is gone."""
    scale = units.metres_per_unit(scene)
    found = []
    for entry in obj.hull.variants.kept:
        hull = hull_to_data.ship_data(kept_hulls.as_hull(obj, entry), scale)
        hull.name = entry.name
        found.append(Variant(hull, entry.note))
    return found
