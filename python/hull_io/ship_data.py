# SPDX-License-Identifier: GPL-3.0-or-later
"""What belongs to a hull as a ship: how she floats, what she carries and weighs, where she floods,
the wind on her, and how her resistance is found. Lengths in m and axes as in hull_data.
"""

from dataclasses import dataclass, field


@dataclass
class Afloat:
    """How the hull lies: trim_m in m by the stern between perpendiculars, heel in degrees to
    starboard; whether her openings count as closed weathertight."""

    trim_m: float = 0.0
    heel_deg: float = 0.0
    deck_closed: bool = True


LOADED = ("typed", "weights", "case")


@dataclass
class Load:
    """The load whose stability is looked at: mass in t, centre of gravity in m.

    mass_t None: the displacement as afloat. kg 0: not given. lcg None: above that of buoyancy.
    free_trim: whether the trim adjusts itself as she heels. kg_is_guess: nobody gave the kg.
    loaded: one of LOADED, the sum of the weights or the load case of the name `case` instead of
    this mass and centre.
    """

    mass_t: object = None
    kg: float = 0.0
    lcg: object = None
    free_trim: bool = True
    kg_is_guess: bool = False
    loaded: str = "typed"
    case: str = ""


@dataclass
class LoadCase:
    """A mass in t with its centre of gravity in m; with_weights: the ship's Weights are added;
    vcg_is_guess: nobody gave the vcg."""

    name: str
    mass_t: float
    lcg: float = 0.0
    tcg: float = 0.0
    vcg: float = 0.0
    with_weights: bool = False
    vcg_is_guess: bool = False


@dataclass
class Weight:
    """A part of the ship: its mass in t and the centre of that in m."""

    name: str
    mass_t: float
    lcg: float = 0.0
    tcg: float = 0.0
    vcg: float = 0.0


@dataclass
class Weights:
    """What the ship weighs without load: the shell's plating, of a thickness in m (0: not counted)
    and a density in t/m3, and all else as a list of Weight."""

    thickness: float = 0.0
    density: float = 7.85
    items: list = field(default_factory=list)


@dataclass
class DownfloodingPoint:
    """The lower edge (x, y, z) in m of an opening that can't be closed, meant on both sides."""

    name: str
    position: tuple


@dataclass
class WindArea:
    """A part of the projected lateral area above the water: m², and its centre's height in m."""

    name: str
    area: float
    z: float = 0.0


@dataclass
class Wind:
    """What the weather criterion needs to know of a ship.

    hull_profile: the profile of the hull above the water counts, beside `areas`. lever: of all
    areas over the centre of the underwater profile, in m; None: from their centres. pressure in Pa.
    keel_area: of bilge and bar keels in m². roll_period in s; None: estimated.
    """

    hull_profile: bool = True
    areas: list = field(default_factory=list)
    lever: object = None
    pressure: float = 504.0
    keel_area: float = 0.0
    sharp_bilges: bool = False
    roll_period: object = None


@dataclass
class Appendage:
    """A body joined to the hull or cut out of it, m and the hull's axes, as hull_appendages tells.

    shape: "cylinder" (start, end, sizes: radii there), "foil" (leading edges of root and tip,
    chords, section; thicknesses of the chord, 0: the section's own) or "bulb" (nose, tail, sizes[0]
    the largest diameter, section). mirrored: its image is there, too."""

    name: str
    shape: str
    start: tuple
    end: tuple
    sizes: tuple
    section: str = ""
    chord_direction: tuple = (-1.0, 0.0, 0.0)
    thickness_direction: tuple = (0.0, 1.0, 0.0)
    thicknesses: tuple = (0.0, 0.0)
    on: bool = True
    cut: bool = False
    mirrored: bool = False


RESISTANCE_METHODS = ("holtrop", "michell", "savitsky", "delft")
# Holtrop and Mennen's stern coefficients: pram, V, normal, U.
STERNS = (-25, -10, 0, 10)


@dataclass
class HoltropInputs:
    """What of a ship is given to Holtrop and Mennen's method in place of what the hull has, None
    of none: hull_native.HoltropShip, by its names."""

    length: float | None = None
    beam: float | None = None
    draft_forward: float | None = None
    draft_aft: float | None = None
    displaced_volume: float | None = None
    lcb_percent: float | None = None
    midship: float | None = None
    waterplane: float | None = None
    wetted_surface: float | None = None
    entrance_angle_deg: float | None = None
    bulb_area: float | None = None
    bulb_height: float | None = None
    transom_area: float | None = None


@dataclass
class DelftInputs:
    """The same of a canoe body for the Delft series: hull_native.DelftYacht, by its names; of keels
    and rudders hull_native.DelftFin."""

    length: float | None = None
    beam: float | None = None
    draft: float | None = None
    volume: float | None = None
    waterplane_area: float | None = None
    wetted_surface: float | None = None
    prismatic: float | None = None
    midship: float | None = None
    lcb: float | None = None
    lcf: float | None = None
    keel_wetted_surface: float | None = None
    keel_chord: float | None = None
    keel_thickness: float | None = None
    keel_volume: float | None = None
    keel_total_draft: float | None = None
    keel_centre: float | None = None
    rudder_wetted_surface: float | None = None
    rudder_chord: float | None = None
    rudder_thickness: float | None = None


@dataclass
class MichellInputs:
    """The same for the friction beside Michell's integral: hull_native.michell_table, by its
    names."""

    length: float | None = None
    wetted_surface: float | None = None


# Their units, as tables have them.
HOLTROP_UNITS = {
    "length": "m",
    "beam": "m",
    "draft_forward": "m",
    "draft_aft": "m",
    "displaced_volume": "m3",
    "lcb_percent": "%",
    "midship": "",
    "waterplane": "",
    "wetted_surface": "m2",
    "entrance_angle_deg": "°",
    "bulb_area": "m2",
    "bulb_height": "m",
    "transom_area": "m2",
}
DELFT_UNITS = {
    "length": "m",
    "beam": "m",
    "draft": "m",
    "volume": "m3",
    "waterplane_area": "m2",
    "wetted_surface": "m2",
    "prismatic": "",
    "midship": "",
    "lcb": "m",
    "lcf": "m",
    "keel_wetted_surface": "m2",
    "keel_chord": "m",
    "keel_thickness": "",
    "keel_volume": "m3",
    "keel_total_draft": "m",
    "keel_centre": "m",
    "rudder_wetted_surface": "m2",
    "rudder_chord": "m",
    "rudder_thickness": "",
}
MICHELL_UNITS = {"length": "m", "wetted_surface": "m2"}

# Of what is given in place of what the hull has, what may be nothing at all.
ZERO_INPUTS = ("lcb_percent", "bulb_area", "transom_area", "deadrise_deg", "keel_centre")
# Whether hulls lie beside one another: as the hull has it, or one of both whatever it has.
HULLS_BESIDE = ("found", "one", "beside")


@dataclass
class Resistance:
    """How the resistance is reckoned: method, first, last and step of speeds in knots, and what
    only the designer knows. Lengths in m, areas in m²; 0: not given. Of chine_beam, deadrise_deg,
    planing_mass_t and planing_lcg, of Savitsky's method, 0 is what the hull has; wave_speed_kn, of
    wave pattern and spectrum, 0: the last speed. roughness_um: of the hull, µm. zeros: which of
    ZERO_INPUTS are 0 where that is given as their number: none of the hull's counts. hulls: one of
    HULLS_BESIDE. blade_area_ratio: AE/AO; pitch_ratio: P/D, of twin screws; open_stern: a single
    screw behind shafts and brackets."""

    method: str = "holtrop"
    speeds_kn: tuple = (6.0, 16.0, 1.0)
    form_factor: float = 1.0
    stern: int = 0
    appendage_area: float = 0.0
    appendage_factor: float = 1.5
    propeller_diameter: float = 0.0
    twin_screw: bool = False
    open_water_efficiency: float = 0.0
    shaft_efficiency: float = 1.0
    blade_area_ratio: float = 0.6
    pitch_ratio: float = 1.0
    open_stern: bool = False
    thruster_diameter: float = 0.0
    thruster_coefficient: float = 0.005
    roughness_um: float = 150.0
    planing_mass_t: float = 0.0
    planing_lcg: float = 0.0
    deadrise_deg: float = 0.0
    chine_beam: float = 0.0
    shaft_angle_deg: float = 0.0
    thrust_arm: float = 0.0
    heel_deg: float = 0.0
    wave_speed_kn: float = 0.0
    zeros: tuple = ()
    hulls: str = "found"
    holtrop: HoltropInputs = field(default_factory=HoltropInputs)
    delft: DelftInputs = field(default_factory=DelftInputs)
    michell: MichellInputs = field(default_factory=MichellInputs)
