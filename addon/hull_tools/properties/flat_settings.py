# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.flats: the planes of the regions of faces that are kept flat."""

import bpy
from bpy.props import FloatProperty, FloatVectorProperty, IntProperty


class HullFlat(bpy.types.PropertyGroup):
    """The plane where normal · point = offset, the normal taken as of length 1, in the mesh's axes
    and the scene's units. Its faces have the number `region` in the mesh."""

    region: IntProperty(name="Region", description="The number its faces have in the mesh", min=1)
    normal: FloatVectorProperty(
        name="Normal", description="Direction across the plane", default=(0.0, 1.0, 0.0)
    )
    offset: FloatProperty(name="Offset", description="Distance of the plane from the origin")


CLASSES = (HullFlat,)
