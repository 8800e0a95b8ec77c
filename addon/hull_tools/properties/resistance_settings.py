# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.resistance: speeds and method, and what of a ship only her designer knows. Speeds are
in knots and areas in m² whatever the scene's units."""

from math import radians

import bpy
from bpy.props import EnumProperty, FloatProperty

from .shared import angle, changed, length, switch


def _number(name, description, default, greatest, minimum=0.0):
    return FloatProperty(
        name=name,
        description=description,
        default=default,
        min=minimum,
        max=greatest,
        precision=2,
        step=10,
        update=changed,
    )


class HullResistance(bpy.types.PropertyGroup):
    """Resistance over speeds."""

    method: EnumProperty(
        name="Method",
        description="What the resistance is reckoned by",
        items=(
            ("HOLTROP", "Holtrop", "Holtrop and Mennen 1984: displacement ships, with propulsion "
             "factors"),
            ("MICHELL", "Michell", "ITTC 1957 line and Michell's integral over the exact surface: "
             "slender ships"),
            ("SAVITSKY", "Savitsky", "Savitsky 1964: planing boats with chines, at the trim at "
             "which they run"),
            ("DELFT", "Delft series", "Keuning and Sonnenberg 1998: sailing yachts, with the keels "
             "and rudders among the appendages, upright and heeled"),
        ),
        default="HOLTROP",
        update=changed,
    )  # fmt: skip
    speed_from: _number("From kn", "First speed, in knots", 6.0, 100.0)
    speed_to: _number("To kn", "Last speed, in knots", 16.0, 100.0)
    speed_step: _number("Step kn", "Between speeds, in knots", 1.0, 100.0)
    form_factor: _number("1 + k", "Form factor of the friction line", 1.0, 10.0)
    stern: EnumProperty(
        name="Stern",
        description="The shape of the sections aft",
        items=(
            ("0", "Normal", "Normal sections"),
            ("10", "U-shaped", "U-shaped sections with a Hogner stern"),
            ("-10", "V-shaped", "V-shaped sections"),
            ("-25", "Pram", "Pram with gondola"),
        ),
        default="0",
        update=changed,
    )
    appendage_area: _number(
        "Appendages m²", "Wetted surface of appendages that are not in the hull, in m²", 0.0, 1e6
    )
    appendage_factor: _number(
        "1 + k2", "Of appendages: rudder 1.5, skeg 1.5 to 2, brackets 3, bilge keels 1.4", 1.5, 10.0
    )
    propeller_diameter: length(
        "Propeller", "Its diameter, for wake and thrust deduction; 0: not reckoned"
    )
    twin_screw: switch("Twin screws", "Two propellers")
    deadrise: angle(
        "Deadrise", "Of the bottom, its mean where it is wet", radians(15.0), 0.0, radians(44.0)
    )
    chine_beam: length(
        "Chine beam", "Mean breadth over the chines where they are wet; 0: that of the waterline"
    )
    shaft_angle: angle(
        "Shaft angle", "Of the shaft against the keel", 0.0, radians(-45.0), radians(45.0)
    )
    thrust_arm: length(
        "Thrust arm", "How far the shaft's line runs below the centre of gravity", minimum=None
    )
    heel: angle("Heel", "At which the yacht sails, to either side", 0.0, 0.0, radians(35.0))


CLASSES = (HullResistance,)
