# SPDX-License-Identifier: GPL-3.0-or-later
"""The load whose stability is looked at, from the settings."""

from dataclasses import dataclass
from math import cos, tan

from ...bridge import limits, native
from ...bridge.blender.units import as_typed
from ..flotation import afloat, hydrostatics
from ..flotation.afloat import as_typed_angle


@dataclass(frozen=True)
class LoadInputs:
    """mass_t: None for the displacement afloat. lcg: None for one above the buoyancy."""

    where: afloat.Afloat
    mass_t: object
    kg: float
    kg_is_guess: bool
    lcg: object
    free_trim: bool
    downflooding_points: tuple  # of both sides


@dataclass(frozen=True)
class Load:
    mass_t: float
    lcg: float
    kg: float

    def arguments(self, given):
        """Arguments of hull_native's functions about the stability of a load."""
        return {
            "mass_t": self.mass_t,
            "centre_of_gravity": (self.lcg, 0.0, self.kg),
            "water_density": given.where.water_density,
            "free_trim": given.free_trim,
            "trim": given.where.trim,
        }


def load_inputs(settings, metres_per_unit):
    loading = settings.loading
    mass_t = None
    if not loading.use_displacement:
        mass_t = limits.within(as_typed(loading.mass_t), "Mass in t", 0.0, limits.HEAVIEST)
    if mass_t == 0.0:
        raise ValueError("Give the mass of ship and load first")
    lcg = None if loading.use_lcb else within_a_ship(loading.lcg, "LCG", metres_per_unit)
    return LoadInputs(
        afloat.afloat(settings, metres_per_unit).upright(),
        mass_t,
        within_a_ship(loading.kg, "VCG", metres_per_unit),
        loading.kg_is_guess,
        lcg,
        loading.free_trim,
        downflooding_points(loading, metres_per_unit),
    )


def within_a_ship(value, name, metres_per_unit):
    """A coordinate in m of one in Blender's units."""
    place = as_typed(value) * metres_per_unit
    return limits.within(place, f"{name} in m", -limits.LONGEST, limits.LONGEST)


def greatest_heel(loading):
    """In rad."""
    greatest = as_typed_angle(loading.heel_greatest)
    return limits.within(greatest, "The greatest heel in rad", 0.0, limits.GREATEST_HEEL)


def downflooding_points(loading, metres_per_unit):
    """Points (x, y, z) in m, those off the centre plane on both sides."""
    points = []
    limits.at_most(len(loading.downflooding_points), "openings", limits.MOST_LOADING_ENTRIES)
    for entry in loading.downflooding_points:
        x, y, z = (within_a_ship(value, entry.name, metres_per_unit) for value in entry.position)
        points += [(x, y, z)] if y == 0.0 else [(x, y, z), (x, -y, z)]
    return tuple(points)


NOTHING_FLOODS = "No downflooding point is given: no heel floods the ship."
DECK_EDGE_UNDER_WATER = (
    "The deck edge is under water upright (0°): an open transom counts as one, unless you mark the "
    "deck edge that is meant (Edges and Points)."
)


def guessed_vcg(given):
    """What to say of LoadInputs whose VCG nobody gave."""
    return f"VCG {given.kg:.4g} m is a guess, six tenths of the depth: give yours."


def load(body, given):
    """The Load of LoadInputs. ValueError when the ship does not float with it."""
    if given.mass_t is None:
        found = hydrostatics.computed(body, given.where)
        mass_t, lcb, kb = found.displacement_t, found.lcb, found.kb
    else:
        mass_t = given.mass_t
        if given.lcg is None:
            lcb, kb = _buoyancy(body, given)
    if given.lcg is not None:
        return Load(mass_t, given.lcg, given.kg)
    return Load(mass_t, lcb + (given.kg - kb) * tan(given.where.trim), given.kg)


def _buoyancy(body, given):
    """x and z of the centre of buoyancy of a mass, upright at the trim afloat."""
    found = native.require().equilibrium(
        body,
        mass_t=given.mass_t,
        centre_of_gravity=(given.where.draft_at, 0.0, given.kg),
        water_density=given.where.water_density,
        free_trim=False,
        free_heel=False,
        trim=given.where.trim,
    )
    if found.status in ("sinks", "not converged"):
        raise ValueError(found.message)
    x, _, z = found.immersion.centre_of_buoyancy
    return x, z


def trim_m(angle, heel, length_pp):
    """The trim between perpendiculars, on the ship's vertical, of an angle in rad; None at 90°."""
    if length_pp <= 0.0 or abs(cos(heel)) < 1e-9:
        return None
    return length_pp * tan(angle) / cos(heel)


def describe(found_load, given, name):
    """What a plot says below its title."""
    trim = "free trim" if given.free_trim else f"trim held at {given.where.trim_m:g} m"
    return (
        f"{name}, {found_load.mass_t:.1f} t, LCG {found_load.lcg:.3f} m, "
        f"KG {found_load.kg:.3f} m, {trim}"
    )
