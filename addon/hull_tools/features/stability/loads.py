# SPDX-License-Identifier: GPL-3.0-or-later
"""The load whose stability is looked at, from the settings."""

from dataclasses import dataclass, replace
from math import cos, tan

from ...bridge import limits, native
from ...bridge.blender.units import as_typed
from ..flotation import afloat, hydrostatics
from ..flotation.afloat import as_typed_angle
from . import cases, weights
from .centres import within_a_ship


@dataclass(frozen=True)
class LoadInputs:
    """mass_t: None for the displacement afloat. lcg: None for one above the buoyancy. case: a
    cases.Case that is loaded instead of what is typed, or None; ship: weights.Inputs where it has
    the ship's weights."""

    where: afloat.Afloat
    mass_t: object
    kg: float
    kg_is_guess: bool
    lcg: object
    free_trim: bool
    downflooding_points: tuple  # of both sides
    case: object = None
    ship: object = None


@dataclass(frozen=True)
class Load:
    """kg_doubt: a sentence where nobody gave the VCG, or that of a part."""

    mass_t: float
    lcg: float
    kg: float
    tcg: float = 0.0
    kg_doubt: str = ""

    def arguments(self, given):
        """Arguments of hull_native's functions about the stability of a load. Levers are to
        starboard: a ship with a list is heeled to the side of it."""
        return {
            "mass_t": self.mass_t,
            "centre_of_gravity": (self.lcg, -abs(self.tcg), self.kg),
            "water_density": given.where.water_density,
            "free_trim": given.free_trim,
            "trim": given.where.trim,
        }


def load_inputs(settings, metres_per_unit):
    """The LoadInputs of what an Object.hull says is loaded."""
    given = any_load(settings, metres_per_unit)
    loaded = settings.loading.loaded
    if loaded == "TYPED":
        return _typed(settings.loading, metres_per_unit, given)
    case = cases.SHIP if loaded == "WEIGHTS" else _chosen_case(settings, metres_per_unit)
    return replace(given, case=case, ship=cases.ship_inputs(settings, metres_per_unit, (case,)))


def any_load(settings, metres_per_unit):
    """LoadInputs of what all loads of an Object.hull share."""
    loading = settings.loading
    return LoadInputs(
        where=afloat.afloat(settings, metres_per_unit).upright(),
        mass_t=None,
        kg=0.0,
        kg_is_guess=False,
        lcg=None,
        free_trim=loading.free_trim,
        downflooding_points=downflooding_points(loading, metres_per_unit),
    )


def _typed(loading, metres_per_unit, given):
    mass_t = None
    if not loading.use_displacement:
        mass_t = limits.within(as_typed(loading.mass_t), "Mass in t", 0.0, limits.HEAVIEST)
    if mass_t == 0.0:
        raise ValueError("Give the mass of ship and load first")
    return replace(
        given,
        mass_t=mass_t,
        kg=within_a_ship(loading.kg, "VCG", metres_per_unit),
        kg_is_guess=loading.kg_is_guess,
        lcg=None if loading.use_lcb else within_a_ship(loading.lcg, "LCG", metres_per_unit),
    )


def _chosen_case(settings, metres_per_unit):
    name = settings.loading.loaded_case
    if not name:
        raise ValueError("Choose the load case that is loaded")
    for case in cases.cases(settings, metres_per_unit):
        if case.name == name:
            return case
    raise ValueError(f'There is no load case "{name}": choose the one that is loaded')


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


def remarks(found_load):
    """Sentences about what the numbers of a Load rest on."""
    if found_load.kg_doubt:
        yield found_load.kg_doubt
    if found_load.tcg != 0.0:
        side = "port" if found_load.tcg > 0.0 else "starboard"
        yield (
            f"The centre of gravity is {abs(found_load.tcg):.4g} m to {side}: levers are those of "
            f"a heel to {side}, both sides of the ship taken for equal."
        )


def load(ship, given):
    """The Load of LoadInputs on a ship.Ship. ValueError where it weighs nothing, and when the ship
    does not float with it."""
    if given.case is not None:
        parts = weights.compute(ship, given.ship).parts if given.ship else ()
        return load_of(cases.whole(given.case, parts))
    if given.mass_t is None:
        found = hydrostatics.computed(ship.body, given.where)
        mass_t, lcb, kb = found.displacement_t, found.lcb, found.kb
    else:
        mass_t = given.mass_t
        if given.lcg is None:
            lcb, kb = _buoyancy(ship.body, given)
    lcg = given.lcg
    if lcg is None:
        lcg = lcb + (given.kg - kb) * tan(given.where.trim)
    return Load(mass_t, lcg, given.kg, kg_doubt=_doubt(given.kg) if given.kg_is_guess else "")


def _doubt(kg, rests_on="is"):
    return f"VCG {kg:.4g} m {rests_on} a guess, six tenths of the depth: give yours."


def load_of(case):
    """The Load of a whole cases.Case; ValueError where it weighs nothing."""
    if not case.mass_t > 0.0:
        remedy = "plating or a list under Weights" if case.with_weights else "it a mass"
        raise ValueError(f"{case.name}: nothing is loaded, give {remedy}")
    lcg, tcg, vcg = case.centre
    doubt = _doubt(vcg, "rests on" if case.with_weights else "is") if case.vcg_is_guess else ""
    return Load(case.mass_t, lcg, vcg, tcg, doubt)


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


def describe(found_load, given, name, shown):
    """What a plot says below its title; shown: a units.Shown."""
    trim = "free trim" if given.free_trim else f"trim held at {shown.text(given.where.trim_m, 'm')}"
    what = name if given.case is None else f"{name}, {given.case.name}"
    return (
        f"{what}, {shown.text(found_load.mass_t, 't', 1)}, LCG {shown.text(found_load.lcg, 'm')}, "
        f"KG {shown.text(found_load.kg, 'm')}, {trim}"
    )
