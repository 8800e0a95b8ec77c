# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.variants: hulls that were kept under a name, and what the hull is compared with."""

import bpy
from bpy.props import CollectionProperty, EnumProperty, IntProperty, PointerProperty, StringProperty

from ..bridge.objects import hull_objects
from . import ship_settings
from .shared import changed, switch


class HullVariant(ship_settings.ShipSettings, bpy.types.PropertyGroup):
    """A hull as it was: its settings of then, and a copy of its mesh that no object shows."""

    name: StringProperty(
        name="Name", description="What the variant is called", default="Variant", update=changed
    )
    note: StringProperty(
        name="Note", description="What sets this variant apart from the others", update=changed
    )
    mesh: PointerProperty(
        name="Mesh", description="The control mesh of the variant", type=bpy.types.Mesh
    )


def _can_be_other(settings, obj):
    return hull_objects.is_hull(obj) and obj != settings.id_data


class HullVariants(bpy.types.PropertyGroup):
    kept: CollectionProperty(type=HullVariant)
    active: IntProperty(name="Variant", description="The one chosen in the list", update=changed)
    compared_with: EnumProperty(
        name="Compared with",
        description="What the hull is compared with: ghost, differences and distances are of it",
        items=(
            ("VARIANT", "Chosen variant", "The variant that is chosen in the list"),
            ("HULL", "Another hull", "Another hull object"),
        ),
        update=changed,
    )
    other_hull: PointerProperty(
        name="Other hull",
        description="The hull object that this one is compared with, both laid on one another by "
        "their own origins",
        type=bpy.types.Object,
        poll=_can_be_other,
        update=changed,
    )
    show_ghost: switch(
        "Ghost",
        "Show the other hull's lines behind this one's, at the same places, with its knuckles and "
        "borders, and its sectional areas in the plot",
    )
    resistance_beside: switch(
        "Other hull beside",
        "Show the resistance of the hull that this one is compared with beside its own, by the "
        "same method and at the same speeds",
        True,
    )
    afloat: EnumProperty(
        name="Afloat",
        description="At which draft, trim and heel the other hull is compared",
        items=(
            ("OWN", "Each at its own draft", "Each hull at its own draft, trim and heel"),
            ("SAME", "Both at this draft", "Both hulls at the draft, trim and heel of this one"),
        ),
        update=changed,
    )


CLASSES = (HullVariant, HullVariants)
