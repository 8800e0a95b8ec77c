# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.weights: what the ship weighs without load. Masses are in tonnes, densities in t/m³
whatever the scene's units; centres are counted from x = y = z = 0, as the mesh."""

import bpy
from bpy.props import CollectionProperty, FloatProperty, IntProperty, StringProperty

from .shared import changed, length, mass


def density(description, default=0.0):
    return FloatProperty(
        name="Density t/m³",
        description=description,
        default=default,
        min=0.0,
        max=25.0,
        precision=3,
        step=10,
        update=changed,
    )


class HullWeight(bpy.types.PropertyGroup):
    name: StringProperty(name="Name", default="Weight", update=changed)
    mass_t: mass("Mass t", "Of this part of the ship, in tonnes")
    lcg: length("LCG", "Its centre forward of the after perpendicular", minimum=None)
    tcg: length("TCG", "Its centre to port of the centre plane", minimum=None)
    vcg: length("VCG", "Its centre above the base line", minimum=None)


class HullWeights(bpy.types.PropertyGroup):
    """The shell's plating, and a list of all else."""

    thickness: length(
        "Plating", "Thickness of the shell, with an allowance for frames; 0: it is not counted"
    )
    density: density("Of the shell: steel 7.85, aluminium 2.7, laminate 1.6", 7.85)
    items: CollectionProperty(type=HullWeight)
    active_item: IntProperty(name="Weight", description="The one chosen in the list")


CLASSES = (HullWeight, HullWeights)
