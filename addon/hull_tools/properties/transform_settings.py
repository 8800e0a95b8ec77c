# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.transform: what is kept when the hull is transformed."""

import bpy
from bpy.props import StringProperty

from .shared import length


def _group_names(settings, context, text):
    return [group.name for group in settings.id_data.vertex_groups]


class HullTransform(bpy.types.PropertyGroup):
    """Nothing here changes what is shown of the hull."""

    kept_group: StringProperty(
        name="Held points",
        description="Vertex group of control points that stay where they are, as those of a bulb "
        "or a skeg; empty: none",
        search=_group_names,
    )
    kept_aft: length(
        "Aft end kept",
        "Sections stay that are nearer than this to the aft end; 0: none",
    )
    kept_fore: length(
        "Fore end kept",
        "Sections stay that are nearer than this to the fore end; 0: none",
    )
    kept_fade: length(
        "Fade",
        "The length over which sections go from kept to shifted; 0: a tenth of the hull's length",
    )


CLASSES = (HullTransform,)
