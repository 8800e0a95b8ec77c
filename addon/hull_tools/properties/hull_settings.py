# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull: what makes a mesh object a hull, saved with the file.

Lengths are in Blender's units, like the mesh: the scene's unit scale makes metres of both.
Only what the user decides is here; results are kept by bridge.hull_state.
"""

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


def _changed(settings, context):
    """Blender tells handlers of changes made in the window by itself, but not of a script's."""
    settings.id_data.update_tag(refresh={"DATA"})


def _length(name, description, default=0.0, minimum=0.0):
    return FloatProperty(
        name=name,
        description=description,
        default=default,
        min=minimum,
        unit="LENGTH",
        subtype="DISTANCE",
        precision=5,
        update=_changed,
    )


class HullLayer(bpy.types.PropertyGroup):
    """How the faces of one material slot count; slots without an entry count fully."""

    material: PointerProperty(type=bpy.types.Material)
    in_hydrostatics: BoolProperty(
        name="Shell",
        description="The layer's faces belong to the hull's shell: surface, hydrostatics, STEP",
        default=True,
        update=_changed,
    )


class HullSettings(bpy.types.PropertyGroup):
    is_hull: BoolProperty(
        name="Hull", description="This mesh is the control mesh of a hull", options={"HIDDEN"}
    )
    half: BoolProperty(
        name="Half hull",
        description="The mesh is the port half (y ≥ 0) and is mirrored on the centre plane",
        default=True,
        update=_changed,
    )
    source: StringProperty(name="Source", description="Where the hull comes from")

    length_pp: _length("Lpp", "Length between perpendiculars; stations divide it")
    beam: _length("Beam", "Moulded breadth")
    draft: _length("Draft", "Height of the waterline over the baseline z = 0")
    depth: _length("Depth", "Moulded depth")
    water_density: FloatProperty(
        name="Density t/m³",
        description="Density of the water in t/m³: 1.025 in the sea, 1.000 in a river",
        default=1.025,
        min=0.5,
        max=2.0,
        precision=4,
        step=0.1,
        update=_changed,
    )

    scheme: EnumProperty(
        name="Scheme",
        description="Subdivision rules of the surface",
        items=(
            ("biermann", "Biermann", "Smooth at knuckles: modified weights beside creases"),
            ("catmull_clark", "Catmull–Clark", "As Blender's Subdivision Surface modifier"),
        ),
        update=_changed,
    )
    samples: IntProperty(
        name="Samples",
        description="Faces along each side of a cell in the surface object",
        default=4,
        min=1,
        max=32,
        soft_max=12,
        update=_changed,
    )
    station_count: IntProperty(
        name="Stations",
        description="Spaces between stations from the after to the forward perpendicular; "
        "0 draws none",
        default=20,
        min=0,
        max=200,
        update=_changed,
    )
    waterline_spacing: _length("Waterlines", "Distance between waterlines; 0 draws none")
    buttock_spacing: _length("Buttocks", "Distance between buttocks; 0 draws none")

    surface_object: PointerProperty(name="Surface", type=bpy.types.Object)
    lines_object: PointerProperty(name="Lines", type=bpy.types.Object)
    layers: CollectionProperty(type=HullLayer)


CLASSES = (HullLayer, HullSettings)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.hull = PointerProperty(type=HullSettings)


def unregister():
    del bpy.types.Object.hull
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
