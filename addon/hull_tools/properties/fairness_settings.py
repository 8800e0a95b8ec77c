# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.fairness: by what the hull's fairness is judged in the 3D view."""

from math import radians

import bpy
from bpy.props import (
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    StringProperty,
)

from ..bridge import limits
from ..features.surface import colour_views
from .shared import angle, changed, length, switch


def _direction(name, description, default):
    return FloatVectorProperty(
        name=name,
        description=description,
        default=default,
        subtype="XYZ",
        soft_min=-1.0,
        soft_max=1.0,
        precision=3,
        step=5,
        update=changed,
    )


def _colours_changed(settings, context):
    changed(settings, context)
    colour_views.follow()


class HullAcceptedMark(bpy.types.PropertyGroup):
    """What the design calls for: a mark of hull_fairness.lines, on a line of a kind, at a place."""

    line: StringProperty(name="Line", description="The kind of line that it is on")
    mark: StringProperty(name="Mark", description="What kind of mark it is")
    point: FloatVectorProperty(name="Place", description="Where it is", subtype="XYZ")


class HullControlCurve(bpy.types.PropertyGroup):
    """A chain of edges: those with its number (bridge.mesh.curve_marks)."""

    name: StringProperty(name="Name", description="Of the control curve", default="Curve")
    number: IntProperty(name="Number", description="By which the mesh knows its edges", min=1)
    is_shown: switch("Shown", "The curve is shown with its comb", True)


class HullFairness(bpy.types.PropertyGroup):
    comb_stations: switch("Stations", "Curvature combs on the stations")
    comb_waterlines: switch("Waterlines", "Curvature combs on the waterlines")
    comb_buttocks: switch("Buttocks", "Curvature combs on the buttocks")
    comb_diagonals: switch("Diagonals", "Curvature combs on the diagonals")
    comb_planes: switch("Planes", "Curvature combs on sections by planes of one's own")
    comb_features: switch("Knuckles, borders", "Curvature combs on knuckles and borders")
    comb_rows: switch("Rows of points", "Curvature combs on rows of control points: Show Rows")
    comb_factor: FloatProperty(
        name="Scale ×",
        description="Length of the teeth; at 1 most are shorter than a twentieth of the hull as it "
        "was when the combs were switched on, so that they can be compared while it changes",
        default=1.0,
        min=0.0,
        soft_min=0.01,
        soft_max=100.0,
        precision=2,
        update=changed,
    )
    comb_step: length("Distance", "Largest distance of the teeth; 0: a 200th of the hull", 0.0)
    show_inflections: switch("Inflections", "Mark where the bend changes sides", True)
    show_extrema: switch("Extrema", "Mark where curvature is locally greatest or least", True)

    colours: EnumProperty(
        name="Colours",
        description="What the surface is coloured by",
        items=(
            ("NONE", "None", "The surface has its own material"),
            ("GAUSSIAN", "Gaussian curvature", "Product of the principal curvatures, 1/m²: zero "
             "where the surface is developable, negative where it is a saddle"),
            ("MEAN", "Mean curvature", "Of the principal curvatures, 1/m"),
            ("MAXIMUM", "Maximum curvature", "The greater principal curvature, 1/m"),
            ("MINIMUM", "Minimum curvature", "The lesser principal curvature, 1/m: negative where "
             "the surface is hollow"),
            ("SLOPE", "Slope", "Angle between the normal and the vertical, °"),
            ("DISTANCE", "Distance", "From the hull that this one is compared with under Variants, "
             "mm: positive where this one lies outside it. Grey lies beyond its borders"),
        ),
        update=_colours_changed,
    )  # fmt: skip
    logarithmic: switch(
        "Logarithmic",
        "Decades of curvature have equal shares of the colours, for bilge and sides alike",
        True,
    )
    colour_limit: FloatProperty(
        name="Limit",
        description="Greatest value that the colours tell apart, in the unit that the legend has "
        "in metric scenes; 0: what 98 % of the surface stay below",
        min=0.0,
        precision=4,
        update=changed,
    )

    show_reflections: switch("Reflection lines", "Light lines as a mirroring hull shows them")
    line_direction: _direction(
        "Lines along", "Direction of the light lines, in the mesh's axes", (1.0, 0.0, 0.0)
    )
    light_direction: _direction(
        "Light from", "Where the middle of the light lines is, seen from the hull", (0.0, 1.0, 0.5)
    )
    reflection_spacing: angle(
        "Spacing", "Between light lines, as an angle about their direction",
        radians(5.0), radians(0.25), radians(45.0),
    )  # fmt: skip
    show_isophotes: switch("Isophotes", "Lines of equal angle between surface and light")
    isophote_direction: _direction(
        "Light from", "Direction of the light, in the mesh's axes", (0.0, 0.0, 1.0)
    )
    isophote_spacing: angle(
        "Spacing", "Between isophotes", radians(5.0), radians(0.25), radians(45.0)
    )
    show_silhouette: switch("Silhouette", "The outline of the hull as it is seen by the eye")
    eye_direction: _direction(
        "Eye", "Where the eye is, seen from the hull, for reflection lines and silhouette",
        (0.0, 1.0, 0.0),
    )  # fmt: skip
    divisions: IntProperty(
        name="Fineness",
        description="Reflection lines, isophotes and silhouette are searched on so many parts of "
        "each side of a cell: fine ones are not missed",
        default=8,
        min=limits.DIVISIONS[0],
        max=limits.DIVISIONS[1],
        update=changed,
    )
    accepted: CollectionProperty(type=HullAcceptedMark)
    curves: CollectionProperty(type=HullControlCurve)
    active_curve: IntProperty(name="Curve", description="The control curve that is chosen", min=0)


CLASSES = (HullAcceptedMark, HullControlCurve, HullFairness)
