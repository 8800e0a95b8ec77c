# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.resistance: speeds and method, and what of a ship only her designer knows. Speeds are
in knots and areas in m² whatever the scene's units."""

from math import radians

import bpy
from bpy.props import EnumProperty, FloatProperty, PointerProperty

from .shared import angle, changed, length, mass, switch


def _number(name, description, default, greatest, minimum=0.0, precision=2):
    return FloatProperty(
        name=name,
        description=description,
        default=default,
        min=minimum,
        max=greatest,
        precision=precision,
        step=10,
        update=changed,
    )


_FROM_HULL = "0: what the hull has"


def _length(name, description, minimum=0.0):
    return length(name, f"{description}; {_FROM_HULL}", minimum=minimum)


def _input(name, description, greatest, minimum=0.0):
    return FloatProperty(
        name=name,
        description=f"{description}; {_FROM_HULL}",
        min=minimum,
        max=greatest,
        precision=2,
        step=10,
        update=changed,
    )


class HullHoltropInputs(bpy.types.PropertyGroup):
    """What is given to Holtrop and Mennen's method, by the names of hull_native.HoltropShip."""

    length: _length("Length", "On the waterline")
    beam: _length("Beam", "On the waterline")
    draft_forward: _length("T fwd", "At the waterline's forward end, to the base line")
    draft_aft: _length("T aft", "At the waterline's after end, to the base line")
    displaced_volume: _input("∇ m³", "Displaced volume in m³", 1e8)
    lcb_percent: _input(
        "LCB %", "Forward of the middle of the waterline, in % of its length", 50.0, -50.0
    )
    midship: _input("CM", "Largest section by beam and draft", 1.1)
    waterplane: _input("CWP", "Waterplane by length and beam", 1.1)
    wetted_surface: _input("S m²", "Wetted surface in m²", 1e6)
    entrance_angle_deg: _input("iE °", "Half angle of entrance of the waterline, in degrees", 89.0)
    bulb_area: _input("Bulb m²", "Section of the bulb where the water meets the stem, in m²", 1e6)
    bulb_height: _length("Bulb z", "Centre of that section above the keel")
    transom_area: _input("AT m²", "Of the transom in the water when at rest, in m²", 1e6)


class HullDelftInputs(bpy.types.PropertyGroup):
    """What is given of the canoe body to the Delft series, by hull_native.DelftYacht's names, and
    of all keels and all rudders by hull_native.DelftFin's."""

    length: _length("Length", "On the waterline")
    beam: _length("Beam", "On the waterline")
    draft: _length("Draft", "Of the canoe body")
    volume: _input("∇ m³", "Displaced volume of the canoe body, in m³", 1e8)
    waterplane_area: _input("Aw m²", "Area of the waterplane, in m²", 1e6)
    wetted_surface: _input("S m²", "Wetted surface of the canoe body, in m²", 1e6)
    prismatic: _input("CP", "Prismatic coefficient of the canoe body, on the waterline", 1.1)
    midship: _input("CM", "Largest section by beam and draft", 1.1)
    lcb: _length("LCB", "Centre of buoyancy abaft the waterline's forward end")
    lcf: _length("LCF", "Centre of flotation abaft the waterline's forward end")
    keel_wetted_surface: _input("Keel m²", "Wetted surface of the keels, both sides, in m²", 1e6)
    keel_chord: _length("Keel c", "Mean chord of the keels")
    keel_thickness: _input("Keel t/c", "Thickness of the keels by their chord", 1.1)
    keel_volume: _input("Keel m³", "Volume of the keels, in m³", 1e8)
    keel_total_draft: _length("Keel T", "Draft of the yacht with the keel")
    keel_centre: _length(
        "Keel Z", "Centre of the keels' volume below the canoe body; negative: above", None
    )
    rudder_wetted_surface: _input(
        "Rud. m²", "Wetted surface of the rudders, both sides, in m²", 1e6
    )
    rudder_chord: _length("Rud. c", "Mean chord of the rudders")
    rudder_thickness: _input("Rud. t/c", "Thickness of the rudders by their chord", 1.1)


class HullMichellInputs(bpy.types.PropertyGroup):
    """What is given to the friction beside Michell's integral, by hull_native.michell_table's
    names."""

    length: _length("Length", "By which the Reynolds number of the friction goes")
    wetted_surface: _input("S m²", "Wetted surface for the friction, in m²", 1e6)


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
    open_stern: switch(
        "Open stern", "A single screw behind shafts and brackets, as fast ships have it"
    )
    blade_area_ratio: _number(
        "AE/AO", "Expanded area of the blades by that of the propeller's disc", 0.6, 2.0, 0.1
    )
    pitch_ratio: _number("P/D", "Pitch of the propellers by their diameter", 1.0, 5.0, 0.1)
    open_water_efficiency: _number(
        "Open water",
        "Efficiency of the propeller in open water, for the delivered power; 0: not reckoned",
        0.0,
        0.99,
    )
    shaft_efficiency: _number(
        "Shaft", "What gears and bearings leave of the engine's power", 1.0, 1.0, 0.01
    )
    thruster_diameter: length("Thruster", "Diameter of a bow thruster's tunnel; 0: none")
    thruster_coefficient: _number(
        "CBTO", "Of the bow thruster's opening, from 0.003 to 0.012", 0.005, 0.1, precision=4
    )
    hulls: EnumProperty(
        name="Hulls",
        description="Whether hulls lie beside one another, which the method does not know",
        items=(
            ("FOUND", "As found", "What the hull has"),
            ("ONE", "One ship", "One ship, whatever is found"),
            ("BESIDE", "Side by side", "Hulls beside one another, as a catamaran's"),
        ),
        default="FOUND",
        update=changed,
    )
    roughness_um: _number("Roughness µm", "Of the hull; 150: that of new ships", 150.0, 1e4, 1.0)
    planing_mass_t: mass("Mass t", f"Of the boat, in t; {_FROM_HULL}", precision=2)
    planing_lcg: length(
        "LCG", f"Centre of gravity before the transom, along the keel; {_FROM_HULL}"
    )
    deadrise: angle(
        "Deadrise",
        "Mean of the bottom where it is wet; 0: that of the hull, over the waterline's after half",
        0.0,
        0.0,
        radians(44.0),
    )
    chine_beam: length(
        "Chine B", "Mean breadth over the chines where they are wet; 0: that of the waterline"
    )
    shaft_angle: angle(
        "Shaft angle", "Of the shaft against the keel", 0.0, radians(-45.0), radians(45.0)
    )
    thrust_arm: length(
        "Thrust arm", "How far the shaft's line runs below the centre of gravity", minimum=None
    )
    heel: angle("Heel", "At which the yacht sails, to either side", 0.0, 0.0, radians(35.0))
    wave_speed_kn: _number(
        "Waves at kn", "Speed of wave pattern and spectrum, in knots; 0: the last speed", 0.0, 100.0
    )
    zeros: EnumProperty(
        name="Count as 0",
        description="Counts as 0 where no number is given, whatever the hull has",
        items=(
            ("lcb_percent", "LCB", "In the middle of the waterline"),
            ("bulb_area", "Bulb", "Without a bulb"),
            ("transom_area", "Transom", "No transom in the water"),
            ("deadrise_deg", "Deadrise", "A flat bottom"),
            ("keel_centre", "Keel Z", "The keels' centre as deep as the canoe body"),
        ),
        options={"ENUM_FLAG"},
        update=changed,
    )
    holtrop: PointerProperty(type=HullHoltropInputs)
    delft: PointerProperty(type=HullDelftInputs)
    michell: PointerProperty(type=HullMichellInputs)


CLASSES = (HullHoltropInputs, HullDelftInputs, HullMichellInputs, HullResistance)
