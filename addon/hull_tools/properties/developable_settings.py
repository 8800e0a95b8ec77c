# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.developables: what regions of faces that are developable are to be."""

import bpy
from bpy.props import BoolProperty, FloatProperty, IntProperty


class HullDevelopable(bpy.types.PropertyGroup):
    """Of the faces with the number `region` in the mesh. Lengths are in the scene's units."""

    region: IntProperty(name="Region", description="The number its faces have in the mesh", min=1)
    warp: FloatProperty(
        name="Warp", description="No ruling is to have more, in degrees per unit", default=1.0
    )
    distance: FloatProperty(
        name="Distance", description="How far its knuckles may move for it", default=0.05
    )
    kept: BoolProperty(
        name="Kept",
        description="Keep the region developable while points are moved; otherwise its warp is "
        "only shown",
        default=True,
    )


CLASSES = (HullDevelopable,)
