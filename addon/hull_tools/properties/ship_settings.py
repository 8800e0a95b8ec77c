# SPDX-License-Identifier: GPL-3.0-or-later
"""What decides on results beside the mesh: the settings that a hull and its variants have alike."""

from math import radians

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    PointerProperty,
    StringProperty,
)

from ..bridge import limits
from ..bridge.blender import preferences
from . import (
    developable_settings,
    flat_settings,
    line_settings,
    resistance_settings,
    stability_settings,
    weight_settings,
    wind_settings,
)
from .shared import angle, changed, length


def _renamed(layer, context):
    """The material is called alike where Blender has the name free; the layer's own name counts."""
    material = layer.material
    if layer.name and material is not None and material.library is None:
        material.name = layer.name
    changed(layer, context)


class HullLayer(bpy.types.PropertyGroup):
    """How the faces of one material slot count; slots without an entry count fully."""

    name: StringProperty(
        name="Name",
        description="What the layer is called, here and in hull files; its material too where no "
        "other has the name",
        update=_renamed,
    )
    material: PointerProperty(
        name="Layer",
        description="The material of the layer's faces",
        type=bpy.types.Material,
        update=changed,
    )
    in_hydrostatics: BoolProperty(
        name="Shell",
        description="The layer's faces belong to the hull's shell: surface, hydrostatics, STEP",
        default=True,
        update=changed,
    )
    thickness: length("Plating", "Thickness of the layer's plating; 0: that of the shell")
    density: weight_settings.density("Of the layer's plating; 0: that of the shell")


class ShipSettings:
    """Lengths are in Blender's units, like the mesh."""

    half: BoolProperty(
        name="Half hull",
        description="The mesh is the port half (y ≥ 0) and is mirrored on the centre plane",
        default=True,
        update=changed,
    )
    keep_centre: BoolProperty(
        name="Keep on centre",
        description="Points of a half hull's border that are on the centre plane stay there while "
        "they are moved in edit mode, so that both halves stay joined",
        default=True,
    )
    source: StringProperty(name="Source", description="Where the hull comes from")

    length_pp: length("Lpp", "Length between perpendiculars; stations divide it")
    beam: length("Beam", "Moulded breadth")
    draft: length("Draft", "Height of the water over the baseline z = 0, amidships")
    depth: length("Depth", "Moulded depth")
    water_density: FloatProperty(
        name="Density t/m³",
        description="Density of the water in t/m³: 1.025 in the sea, 1.000 in a river",
        default=preferences.DEFAULTS["water_density"],
        min=limits.DENSITIES[0],
        max=limits.DENSITIES[1],
        precision=4,
        step=0.1,
        update=changed,
    )

    trim_m: length(
        "Trim",
        "Draft at the after perpendicular less that at the forward one: positive by the stern",
        minimum=None,
    )
    heel: angle("Heel", "Positive to starboard", 0.0, radians(-180.0), radians(180.0))
    deck_closed: BoolProperty(
        name="Deck closed",
        description="Openings count as closed weathertight. Else the hull floods where the water "
        "rises above one, and has no hydrostatics then",
        default=True,
        update=changed,
    )

    scheme: EnumProperty(
        name="Scheme",
        description="Subdivision rules of the surface",
        items=(
            ("biermann", "Biermann", "Smooth at knuckles: modified weights beside creases"),
            ("catmull_clark", "Catmull–Clark", "As Blender's Subdivision Surface modifier"),
        ),
        update=changed,
    )
    layers: CollectionProperty(type=HullLayer)
    flats: CollectionProperty(type=flat_settings.HullFlat)
    developables: CollectionProperty(type=developable_settings.HullDevelopable)
    lines: PointerProperty(type=line_settings.HullLines)
    loading: PointerProperty(type=stability_settings.HullLoading)
    weights: PointerProperty(type=weight_settings.HullWeights)
    wind: PointerProperty(type=wind_settings.HullWind)
    resistance: PointerProperty(type=resistance_settings.HullResistance)


CLASSES = (
    *developable_settings.CLASSES,
    *flat_settings.CLASSES,
    *line_settings.CLASSES,
    *stability_settings.CLASSES,
    *weight_settings.CLASSES,
    *wind_settings.CLASSES,
    *resistance_settings.CLASSES,
    HullLayer,
)
