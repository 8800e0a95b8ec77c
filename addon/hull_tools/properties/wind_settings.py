# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.wind: what the weather criterion needs to know. Areas are in m² and periods in
seconds whatever the scene's units; heights are counted from z = 0, as the mesh."""

import bpy
from bpy.props import CollectionProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

from .shared import changed, length, switch


def _number(name, description, greatest, default=0.0):
    return FloatProperty(
        name=name,
        description=description,
        default=default,
        min=0.0,
        max=greatest,
        precision=2,
        step=100,
        update=changed,
    )


class HullWindArea(bpy.types.PropertyGroup):
    name: StringProperty(name="Name", default="Wind area", update=changed)
    area: _number("Area m²", "Projected lateral area of a deckhouse, of deck cargo, in m²", 1e6)
    z: length("Centre z", "Height of the area's centre above the base line", minimum=None)


class HullWind(bpy.types.PropertyGroup):
    """What the wind meets, and what damps the ship's roll."""

    source: EnumProperty(
        name="Wind area",
        description="What the wind meets above the water",
        items=(
            ("NONE", "Not known", "The weather criterion is not evaluated"),
            ("HULL", "Hull and list", "The hull's exact profile above the water, and the areas "
             "of the list: deckhouses, deck cargo"),
            ("GIVEN", "List alone", "The areas of the list, which hold the hull's too"),
        ),
        default="NONE",
        update=changed,
    )  # fmt: skip
    areas: CollectionProperty(type=HullWindArea)
    active_area: IntProperty(name="Wind area", description="The one chosen in the list")
    lever: length(
        "Lever Z",
        "From the centre of all wind areas down to that of the underwater profile; 0: as the "
        "areas' heights have it",
    )
    pressure: _number(
        "Pressure Pa",
        "Of the steady wind: 504 Pa unless the Administration approves less for restricted service",
        1e5,
        504.0,
    )
    keel_area: _number(
        "Keels m²",
        "Total area of the bilge keels, or the lateral area of the bar keel, or both together",
        1e6,
    )
    sharp_bilges: switch("Sharp bilges", "The bilge is sharp: she rolls less")
    roll_period: _number(
        "Period s", "The natural period of roll in seconds; 0: estimated as the code does", 1e3
    )


CLASSES = (HullWindArea, HullWind)
