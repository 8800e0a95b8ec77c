# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull: what makes a mesh object a hull, saved with the file.

Lengths are in Blender's units, like the mesh: the scene's unit scale makes metres of both.
Only what the user decides is here; results are kept by features.hull.hull_state.
"""

from math import radians

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from ..bridge import limits
from ..bridge.blender import preferences
from . import (
    export_settings,
    fairness_settings,
    fit_settings,
    flat_settings,
    line_settings,
    output_settings,
    stability_settings,
    studio_settings,
    tag_settings,
    wind_settings,
)
from .shared import angle, changed, length


def _net_changed(settings, context):
    """Without its net a hull has a box in object mode, to be selected by."""
    settings.id_data.display_type = "WIRE" if settings.show_net else "BOUNDS"


class HullLayer(bpy.types.PropertyGroup):
    """How the faces of one material slot count; slots without an entry count fully."""

    material: PointerProperty(
        name="Layer", description="The material of the layer's faces", type=bpy.types.Material
    )
    in_hydrostatics: BoolProperty(
        name="Shell",
        description="The layer's faces belong to the hull's shell: surface, hydrostatics, STEP",
        default=True,
        update=changed,
    )


class HullSettings(bpy.types.PropertyGroup):
    is_hull: BoolProperty(
        name="Hull", description="This mesh is the control mesh of a hull", options={"HIDDEN"}
    )
    format: IntProperty(
        name="Format",
        description="How the settings are stored: see bridge.objects.migration",
        options={"HIDDEN"},
    )
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

    trim: length(
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
    samples: IntProperty(
        name="Samples",
        description="Faces along each side of a cell in the surface object",
        default=4,
        min=1,
        max=limits.MOST_SAMPLES,
        soft_max=12,
        update=changed,
    )
    show_net: BoolProperty(
        name="Control net",
        description="Show the control net in object mode; else a box takes its place. In edit mode "
        "it is always there",
        default=True,
        update=_net_changed,
    )
    surface_object: PointerProperty(
        name="Surface", description="The object that shows the surface", type=bpy.types.Object
    )
    layers: CollectionProperty(type=HullLayer)
    flats: CollectionProperty(type=flat_settings.HullFlat)

    tags: PointerProperty(type=tag_settings.HullTags)
    lines: PointerProperty(type=line_settings.HullLines)
    fairness: PointerProperty(type=fairness_settings.HullFairness)
    loading: PointerProperty(type=stability_settings.HullLoading)
    wind: PointerProperty(type=wind_settings.HullWind)
    table: PointerProperty(type=output_settings.HullTable)
    plots: PointerProperty(type=output_settings.HullPlots)
    plan: PointerProperty(type=output_settings.HullPlan)
    export: PointerProperty(type=export_settings.HullExport)
    studio: PointerProperty(type=studio_settings.HullStudio)
    fit: PointerProperty(type=fit_settings.HullFit)


CLASSES = (
    *flat_settings.CLASSES,
    *tag_settings.CLASSES,
    *line_settings.CLASSES,
    *fairness_settings.CLASSES,
    *fit_settings.CLASSES,
    *stability_settings.CLASSES,
    *wind_settings.CLASSES,
    *output_settings.CLASSES,
    *export_settings.CLASSES,
    *studio_settings.CLASSES,
    HullLayer,
    HullSettings,
)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.hull = PointerProperty(type=HullSettings)


def unregister():
    del bpy.types.Object.hull
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
