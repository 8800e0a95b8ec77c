# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull: what makes a mesh object a hull, saved with the file.

Lengths are in Blender's units, like the mesh: the scene's unit scale makes metres of both.
Only what the user decides is here; results are kept by features.hull.hull_state.
"""

import bpy
from bpy.props import BoolProperty, IntProperty, PointerProperty

from ..bridge import limits
from . import (
    appendage_settings,
    area_target_settings,
    export_settings,
    fairness_settings,
    field_settings,
    fit_settings,
    morph_settings,
    network_settings,
    output_settings,
    plate_settings,
    production_settings,
    ship_settings,
    studio_settings,
    tag_settings,
    target_settings,
    transform_settings,
    variant_settings,
)
from .shared import changed


def _net_changed(settings, context):
    """Without its net a hull has a box in object mode, to be selected by."""
    settings.id_data.display_type = "WIRE" if settings.show_net else "BOUNDS"


class HullSettings(ship_settings.ShipSettings, bpy.types.PropertyGroup):
    is_hull: BoolProperty(
        name="Hull", description="This mesh is the control mesh of a hull", options={"HIDDEN"}
    )
    format: IntProperty(
        name="Format",
        description="How the settings are stored: see bridge.objects.migration",
        options={"HIDDEN"},
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

    tags: PointerProperty(type=tag_settings.HullTags)
    fairness: PointerProperty(type=fairness_settings.HullFairness)
    table: PointerProperty(type=output_settings.HullTable)
    plots: PointerProperty(type=output_settings.HullPlots)
    plan: PointerProperty(type=output_settings.HullPlan)
    model: PointerProperty(type=production_settings.HullModel)
    panel_mesh: PointerProperty(type=production_settings.HullPanelMesh)
    export: PointerProperty(type=export_settings.HullExport)
    plates: PointerProperty(type=plate_settings.HullPlates)
    studio: PointerProperty(type=studio_settings.HullStudio)
    fit: PointerProperty(type=fit_settings.HullFit)
    targets: PointerProperty(type=target_settings.HullTargets)
    variants: PointerProperty(type=variant_settings.HullVariants)
    transform: PointerProperty(type=transform_settings.HullTransform)
    fields: PointerProperty(type=field_settings.HullFields)
    area_target: PointerProperty(type=area_target_settings.HullAreaTarget)
    morph: PointerProperty(type=morph_settings.HullMorph)
    curve: PointerProperty(type=network_settings.HullCurve)
    appendage: PointerProperty(type=appendage_settings.HullAppendage)


CLASSES = (
    *ship_settings.CLASSES,
    *tag_settings.CLASSES,
    *plate_settings.CLASSES,
    *fairness_settings.CLASSES,
    *field_settings.CLASSES,
    *fit_settings.CLASSES,
    *transform_settings.CLASSES,
    *area_target_settings.CLASSES,
    *target_settings.CLASSES,
    *output_settings.CLASSES,
    *production_settings.CLASSES,
    *export_settings.CLASSES,
    *studio_settings.CLASSES,
    *variant_settings.CLASSES,
    *morph_settings.CLASSES,
    *network_settings.CLASSES,
    *appendage_settings.CLASSES,
    HullSettings,
)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.hull = PointerProperty(type=HullSettings)
    network_settings.register()


def unregister():
    network_settings.unregister()
    del bpy.types.Object.hull
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
