# SPDX-License-Identifier: GPL-3.0-or-later
"""Networks of curves: Collection.hull_network, and Object.hull.curve of each curve.

Lengths are in Blender's units, but what is said to be in mm.
"""

import bpy
from bpy.props import (
    BoolProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
)

from ..bridge import limits
from ..bridge.objects import hull_objects
from .shared import changed, length, switch

KINDS = (
    ("STATION", "Station", "Across the ship"),
    ("WATERLINE", "Waterline", "Level"),
    ("BUTTOCK", "Buttock", "Along the ship, upright"),
    ("DIAGONAL", "Diagonal", "Along the ship, in a plane that falls to the side"),
    ("FREE", "Free", "Anywhere in space"),
    ("PROFILE", "Profile", "Keel, stem and stern"),
    ("DECK_EDGE", "Deck edge", "The upper border of the hull"),
)
PLANES = (
    ("NONE", "None", "The curve is free in space"),
    ("X", "Square to X", "A station's plane"),
    ("Y", "Square to Y", "A buttock's plane, or the centre plane"),
    ("Z", "Square to Z", "A waterline's plane"),
    ("OWN", "Oblique", "A plane by its normal"),
)
ROLES = (
    ("FOUND", "As Found", "Knuckles are found from the curves that cross this one"),
    ("KNUCKLE", "Knuckle", "The surface has a knuckle along it"),
    ("REFERENCE", "Reference", "Kept beside the network, and not joined with it"),
)
SHAPES = (
    ("FREE", "Free", "A smooth spline through the points, from knuckle to knuckle"),
    ("LINE", "Line", "The straight line between two points"),
    ("ARC", "Arc", "The circular arc through three points"),
    ("CONIC", "Conic", "A conic between two points, with the tangents at both ends given"),
)
ENDS = (
    ("FREE", "Free", "As the points have it"),
    ("STRAIGHT", "Straight", "Without curvature"),
    ("TANGENT", "Tangent", "Along a direction"),
    ("SLAVE_TANGENT", "Tangent of", "Along the tangent that another curve has there"),
    ("SLAVE_CURVATURE", "Curvature of", "As another curve goes and bends there"),
)


def _network_changed(settings, context):
    """A collection is told of through its objects."""
    for obj in settings.id_data.objects:
        if obj.type == "CURVE":
            obj.update_tag(refresh={"DATA"})
            return


def _is_curve(settings, obj):
    return obj.type == "CURVE" and obj != settings.id_data


def _end(name):
    return EnumProperty(
        name=name, description=f"How the curve {name.lower()}s", items=ENDS, update=changed
    )


def _direction(name):
    return FloatVectorProperty(
        name=name,
        description="Along which the curve runs there; its sense does not matter",
        default=(0.0, 1.0, 0.0),
        subtype="XYZ",
        update=changed,
    )


def _master(name):
    return PointerProperty(
        name=name,
        description="The curve of the network that is followed there",
        type=bpy.types.Object,
        poll=_is_curve,
        update=changed,
    )


class HullCurve(bpy.types.PropertyGroup):
    kind: EnumProperty(
        name="Kind", description="What it is on the hull", items=KINDS, default="FREE",
        update=changed,
    )  # fmt: skip
    plane: EnumProperty(
        name="Plane", description="In which its points are kept", items=PLANES, update=changed
    )
    position: length("Position", "Of the plane, along its axis or its normal", minimum=None)
    normal: FloatVectorProperty(
        name="Normal", description="Of the plane", default=(0.0, 0.7071068, 0.7071068),
        subtype="XYZ", update=changed,
    )  # fmt: skip
    role: EnumProperty(
        name="Role", description="What the surface does along it", items=ROLES, update=changed
    )
    shape: EnumProperty(
        name="Shape", description="How it runs between its points", items=SHAPES, update=changed
    )
    fullness: FloatProperty(
        name="Fullness",
        description="Of a conic: below 1 an ellipse, 1 a parabola, above 1 a hyperbola",
        default=1.0, min=0.01, max=100.0, update=changed,
    )  # fmt: skip
    start: _end("Start")
    end: _end("End")
    start_direction: _direction("Start along")
    end_direction: _direction("End along")
    start_master: _master("Start of")
    end_master: _master("End of")
    show_comb: switch("Comb", "Show its curvature as a comb over the view")


class HullNetwork(bpy.types.PropertyGroup):
    is_network: BoolProperty(options={"HIDDEN"})
    tolerance: length(
        "Tolerance",
        "Curves and points that are nearer are joined",
        default=0.005,
        minimum=1e-6,
        update=_network_changed,
    )
    tie: BoolProperty(
        name="Move Tied Curves",
        description="Where points of curves lie in one place, the others follow when one is moved",
        default=True,
    )
    show_surface: BoolProperty(
        name="Show Surface",
        description="Show the surface between the curves as an object that follows them",
        update=_network_changed,
    )
    samples: IntProperty(
        name="Samples",
        description="Parts of each side of a patch in the surface object",
        default=6, min=1, max=limits.MOST_SAMPLES, soft_max=12, update=_network_changed,
    )  # fmt: skip
    draft: length(
        "Draft",
        "To which the surface is immersed when it is measured, upright; 0: nothing of that is told",
        default=0.0,
        minimum=0.0,
        update=None,
    )
    surface_object: PointerProperty(name="Surface", type=bpy.types.Object)
    show_curves: BoolProperty(
        name="Show Curves",
        description="Draw curves, nodes and problems over the view, in the colours of lines",
        default=True,
    )
    comb_factor: FloatProperty(
        name="Comb Length", description="Of the combs' teeth", default=1.0, min=0.01, max=100.0
    )
    deviation_mm: FloatProperty(
        name="Mean Deviation M",
        description="In mm: how far smoothing may move the points of a curve, in the mean",
        default=10.0, min=0.0, soft_max=1000.0, precision=2,
    )  # fmt: skip
    hull_points: IntProperty(
        name="Points at Most",
        description="Control points of a hull that is laid over the network",
        default=150, min=limits.NETWORK_HULL_POINTS[0], max=limits.NETWORK_HULL_POINTS[1],
        soft_max=300,
    )  # fmt: skip
    hull_tolerance: length(
        "Hull Tolerance",
        "Rows and columns of points are added where curves are farther from the hull; 0: 3e-4 of "
        "the length",
        update=None,
    )
    layout_hull: PointerProperty(
        name="Layout",
        description="A hull near the network whose control mesh is taken as it is, and fitted: "
        "without one a new mesh is laid",
        type=bpy.types.Object,
        poll=lambda settings, obj: hull_objects.is_hull(obj),
    )
    hull: PointerProperty(
        name="Hull", description="That was laid over the network last", type=bpy.types.Object
    )
    length: length("Length", "What a curve without others to meet reaches along the ship, from the "
                   "after perpendicular", 20.0, 1e-3, None)  # fmt: skip
    half_breadth: length("Half Breadth", "What it reaches to the side", 2.5, 1e-3, None)
    depth: length("Depth", "What it reaches up from the base line", 3.0, 1e-3, None)


CLASSES = (HullCurve, HullNetwork)


def register():
    bpy.types.Collection.hull_network = PointerProperty(type=HullNetwork)


def unregister():
    del bpy.types.Collection.hull_network
