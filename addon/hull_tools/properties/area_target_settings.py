# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.area_target: a sectional area curve that is wanted."""

import bpy
from bpy.props import CollectionProperty, FloatProperty, IntProperty, StringProperty

from .shared import changed, length, switch


class HullAreaPoint(bpy.types.PropertyGroup):
    x: length("x", "From the after perpendicular", minimum=None)
    area: FloatProperty(
        name="Area m²",
        description="Of the immersed section there, both sides",
        min=0.0,
        precision=4,
        step=100,
        update=changed,
    )


class HullAreaTarget(bpy.types.PropertyGroup):
    """The curve goes through its points; between them it is the base, and what the points have been
    moved from that."""

    source: StringProperty(name="Source", description="Where the target curve comes from")
    base: CollectionProperty(type=HullAreaPoint)
    area_points: CollectionProperty(type=HullAreaPoint)
    active_area_point: IntProperty(
        name="Point", description="The point of the curve that is edited", min=0
    )
    show_target: switch(
        "Show in plot", "Draw the target and its handles in the plot of sectional areas", True
    )


CLASSES = (HullAreaPoint, HullAreaTarget)
