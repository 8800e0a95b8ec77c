# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.fit: to what the surface is fitted, and how."""

from math import radians

import bpy
from bpy.props import BoolProperty, FloatProperty, IntProperty, PointerProperty

from ..bridge import limits
from ..bridge.objects import hull_objects
from .shared import angle, length


def _is_target(settings, obj):
    return obj.type == "MESH" and hull_objects.hull_of(obj) != settings.id_data


def _is_lines(settings, obj):
    return obj.type in ("MESH", "CURVE") and hull_objects.hull_of(obj) != settings.id_data


class HullFit(bpy.types.PropertyGroup):
    """Nothing here changes what is shown of the hull."""

    target: PointerProperty(
        name="Target",
        description="The shape to fit to: a mesh, or points alone; where it stands counts",
        type=bpy.types.Object,
        poll=_is_target,
    )
    lines: PointerProperty(
        name="Lines",
        description="Edges or curves along which the nearest creases and borders are to run",
        type=bpy.types.Object,
        poll=_is_lines,
    )
    use_edges: BoolProperty(
        name="Creases to edges",
        description="Creases and borders are drawn to the target's sharp edges and borders, and "
        "the stem to its centre line: for surfaces that are near already",
    )
    edge_angle: angle(
        "Sharp from",
        "Edges of the target count as sharp from this angle between their faces",
        radians(30.0),
        radians(1.0),
        radians(180.0),
    )
    fairness: FloatProperty(
        name="Fairness",
        description="How much of the nearness to the target is given up for a surface that bends "
        "little, as a part of the hull's length; 0: nothing",
        default=1e-4,
        min=0.0,
        max=0.1,
        precision=6,
        step=0.001,
    )
    stiffness: FloatProperty(
        name="Stiffness",
        description="The same for control points that keep their layout; 0: nothing",
        default=1e-4,
        min=0.0,
        max=10.0,
        precision=6,
        step=0.001,
    )
    reach: length(
        "Reach",
        "What of the target is farther from the surface is left out; 0: a twentieth of the length",
    )
    draw_border: BoolProperty(
        name="Draw borders",
        description="Parts of the target beyond the surface's border draw it out to them; "
        "else they are left out",
        default=True,
    )
    stay_square: BoolProperty(
        name="Smooth centre line",
        description="Where the two halves join smoothly they go on doing so: a round or flat keel "
        "gets no knuckle; else it is as the target has it",
        default=False,
    )
    samples: IntProperty(
        name="Points",
        description="How many points are spread over the target's faces",
        default=20000,
        min=limits.FIT_POINTS[0],
        max=limits.FIT_POINTS[1],
    )


CLASSES = (HullFit,)
