# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.fields: shape fields that are kept with the hull."""

import bpy
from bpy.props import (
    BoolProperty,
    BoolVectorProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from .shared import changed, length, switch

ROLES = (
    ("MOVE", "Move", "What is near is shifted"),
    ("PROTECT", "Protect", "What is near keeps its place and shape"),
)
BASES = (
    ("POINT", "Point", "A point, on the hull or beside it"),
    ("CREASE", "Crease", "The crease or border of the surface that is nearest to the place"),
    ("CURVE", "Curve", "A curve object"),
    ("SECTION", "Section", "The line in which a plane square to an axis cuts the hull"),
    ("PLANE", "Plane", "A plane square to an axis"),
    ("FACES", "Faces", "The surface of faces of the control mesh"),
)

RECIPES = (
    ("SHARPEN", "Sharper Fore Ship", "Finer waterlines; deck edge or knuckle kept"),
    ("FATTEN", "Fuller Fore Ship", "Fuller waterlines; deck edge or knuckle kept"),
    ("SHEER", "Raise the Sheer", "The deck edge rises towards the bow"),
    ("BILGE", "Move the Bilge", "Fuller or slacker, along the middle of the ship"),
    ("TUNNEL", "Tunnel", "The bottom over a propeller rises towards the stern"),
    ("FLARE", "Flare", "The bow widens towards the deck; the waterline is kept"),
    ("BULB", "Bulb", "The stem is drawn out below the waterline, and widened"),
)


def _is_curve(field, obj):
    return obj.type == "CURVE"


def _falloff(name, description):
    return FloatProperty(
        name=name,
        description=description,
        default=0.6,
        min=0.0,
        max=1.0,
        soft_min=0.3,
        soft_max=0.9,
        precision=2,
        update=changed,
    )


def _shift(name, description):
    return FloatVectorProperty(
        name=name,
        description=description,
        subtype="XYZ_LENGTH",
        unit="LENGTH",
        precision=3,
        update=changed,
    )


class HullShapeField(bpy.types.PropertyGroup):
    """Lengths and places in Blender's units and the hull's own axes."""

    name: StringProperty(name="Name", description="As it is told", update=changed)
    use: switch("On", "The field counts", default=True)
    role: EnumProperty(name="Role", description="What the field does", items=ROLES, update=changed)
    colour: FloatVectorProperty(
        name="Colour",
        description="By which the field is told from others",
        subtype="COLOR",
        min=0.0,
        max=1.0,
        default=(0.9, 0.5, 0.1),
    )
    base: EnumProperty(
        name="Base",
        description="From what distances are measured",
        items=BASES,
        update=changed,
    )
    place: FloatVectorProperty(
        name="Place",
        description="Of the point; where the plane goes through; near the crease",
        subtype="XYZ_LENGTH",
        unit="LENGTH",
        precision=3,
        update=changed,
    )
    axis: EnumProperty(
        name="Square to",
        description="The axis to which the plane is square",
        items=[(axis, axis.lower(), f"Along {axis.lower()}") for axis in "XYZ"],
        update=changed,
    )
    curve: PointerProperty(
        name="Curve",
        description="The curve object",
        type=bpy.types.Object,
        poll=_is_curve,
        update=changed,
    )
    becomes: PointerProperty(
        name="Becomes",
        description="The curve object that the base becomes; without one, Shift says where it goes",
        type=bpy.types.Object,
        poll=_is_curve,
        update=changed,
    )
    faces_number: IntProperty(
        name="Faces", description="By which the mesh tells its faces", options={"HIDDEN"}
    )
    along_surface: switch(
        "Along the Surface",
        "Distances are measured along the hull's surface: what is near through thin parts, or "
        "across the gap between two hulls, is far",
    )
    extent: length("Extent", "How far from its base the field works", 5.0)
    falloff: _falloff(
        "Falloff",
        "From steep to full: above 0.9 the surface's curvature jumps at the extent, at 0 it has a "
        "cusp at the base",
    )
    shift: _shift("Shift", "Of the base, and less and less of what is around it")
    varies: switch(
        "Varies",
        "Extent, falloff and shift are those of the aft end of the base, or its lower one, and "
        "become those of its other end along it",
    )
    extent_end: length("Extent at Fore End", "At the fore end of the base, or its upper one", 5.0)
    falloff_end: _falloff("Falloff at Fore End", "At the fore end of the base, or its upper one")
    shift_end: _shift("Shift at Fore End", "Of the fore end of the base, or its upper one")
    axes: BoolVectorProperty(
        name="Axes",
        description="The coordinates that the field has a say in",
        subtype="XYZ",
        default=(True, True, True),
        update=changed,
    )


class HullFields(bpy.types.PropertyGroup):
    """Nothing here changes the hull before the fields are previewed or applied."""

    is_previewed: BoolProperty(
        name="Previewed", description="The hull is shown as the fields make it", options={"HIDDEN"}
    )
    show_fields: switch(
        "Show Fields",
        "Bases of fields that are on; of the chosen one, its shift and lines of equal intensity "
        "too",
        default=True,
    )
    show_before: switch(
        "Show Before",
        "While fields are previewed: the hull's lines as they were, as a ghost behind those of now",
        default=True,
    )
    fields: CollectionProperty(type=HullShapeField)
    active_field: IntProperty(
        name="Field", description="The field that is edited", min=0, update=changed
    )


CLASSES = (HullShapeField, HullFields)
