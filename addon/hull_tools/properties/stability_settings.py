# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.loading: weights and centres of gravity. Centres are counted from x = y = z = 0, as
the mesh; masses are in tonnes whatever the scene's units."""

from math import radians

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatVectorProperty,
    IntProperty,
    StringProperty,
)

from .shared import angle, changed, length, mass, switch


def _vcg_given(settings, context):
    settings.vcg_is_guess = False
    changed(settings, context)


class HullLoadCase(bpy.types.PropertyGroup):
    name: StringProperty(name="Name", default="Load case", update=changed)
    mass_t: mass("Mass t", "Mass of ship and load, in tonnes")
    lcg: length("LCG", "Centre of gravity forward of the after perpendicular", minimum=None)
    tcg: length("TCG", "Centre of gravity to port of the centre plane", minimum=None)
    vcg: length("VCG", "Centre of gravity above the base line", minimum=None, update=_vcg_given)
    vcg_is_guess: BoolProperty(
        name="VCG is a guess",
        description="Nobody gave the VCG: it is that of a load whose VCG is a guess",
    )
    with_weights: switch(
        "And the ship's weights", "Those of Weights are added to this mass, as to a load alone"
    )


class HullDownfloodingPoint(bpy.types.PropertyGroup):
    name: StringProperty(name="Name", default="Opening", update=changed)
    position: FloatVectorProperty(
        name="Position",
        description="Lower edge of an opening that cannot be closed weathertight: x, y, z in the "
        "mesh's axes. The opening on the other side is meant too",
        unit="LENGTH",
        subtype="XYZ",
        update=changed,
    )


def _kg_given(settings, context):
    settings.kg_is_guess = False
    changed(settings, context)


class HullLoading(bpy.types.PropertyGroup):
    """The load whose stability is looked at, and the load cases that are looked at beside it."""

    loaded: EnumProperty(
        name="Loaded",
        description="What levers, criteria and cross curves are of",
        items=(
            ("TYPED", "As given here", "The mass and centre of gravity given below"),
            ("WEIGHTS", "The weights", "The sum of Weights: the ship without load"),
            ("CASE", "A load case", "The one that is chosen below, as Load Cases have it"),
        ),
        update=changed,
    )
    loaded_case: StringProperty(
        name="Load case", description="The load case that is loaded", update=changed
    )

    use_displacement: BoolProperty(
        name="Mass as afloat",
        description="The mass is the displacement at the draft and trim of the hydrostatics",
        default=True,
        update=changed,
    )
    mass_t: mass("Mass t", "Mass of ship and load, in tonnes")
    kg: length("VCG", "KG: centre of gravity above the base line", update=_kg_given)
    kg_is_guess: BoolProperty(
        name="VCG is a guess",
        description="Nobody gave the VCG: it is six tenths of the depth that the hull had",
    )
    use_lcb: BoolProperty(
        name="LCG over LCB",
        description="The centre of gravity is above that of buoyancy, at the trim of the "
        "hydrostatics",
        default=True,
        update=changed,
    )
    lcg: length("LCG", "Centre of gravity forward of the after perpendicular", minimum=None)
    free_trim: BoolProperty(
        name="Free trim",
        description="The trim adjusts itself at every heel; else it is held",
        default=True,
        update=changed,
    )
    heel_greatest: angle(
        "To", "Greatest heel of the righting levers", radians(90.0), radians(5.0), radians(180.0)
    )
    heel_step: angle("Step", "Between heels", radians(5.0), radians(0.5), radians(45.0))
    least_t: mass("Least Δ t", "Least displacement of the cross curves; 0: a quarter of the load")
    greatest_t: mass(
        "Greatest Δ t", "Greatest displacement of the cross curves; 0: 5/4 of the load"
    )
    displacement_count: IntProperty(
        name="Displacements",
        description="How many displacements the cross curves have",
        default=9,
        min=2,
        max=50,
        update=changed,
    )
    downflooding_points: CollectionProperty(type=HullDownfloodingPoint)
    active_downflooding_point: IntProperty(name="Opening", description="The one chosen in the list")
    load_cases: CollectionProperty(type=HullLoadCase)
    active_load_case: IntProperty(name="Load case", description="The one chosen in the list")


CLASSES = (HullLoadCase, HullDownfloodingPoint, HullLoading)
