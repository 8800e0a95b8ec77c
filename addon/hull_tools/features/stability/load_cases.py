# SPDX-License-Identifier: GPL-3.0-or-later
"""How the hull floats under each load case, or why it does not."""

from dataclasses import dataclass
from math import degrees

from ...bridge import limits, native
from ...bridge.blender.units import as_typed
from ..flotation import afloat
from . import loads, weights

IS_LIVE = False

AFLOAT = ("stable", "neutral", "unstable")


@dataclass(frozen=True)
class Case:
    name: str
    mass_t: float
    centre: tuple  # LCG, TCG, VCG in m
    with_weights: bool = False  # whether the ship's are to be added


@dataclass(frozen=True)
class Inputs:
    cases: tuple
    where: afloat.Afloat
    ship: object  # weights.Inputs where a case has her weights, else None


@dataclass(frozen=True)
class CaseEquilibrium:
    """draft_mean, draft_aft, draft_forward, trim_m (m), heel (rad), gm (m) are None unless afloat;
    status as hull_native.Equilibrium's, or "refused"; message: a sentence where there is more to
    say than that it is stable."""

    case: Case
    status: str
    message: str
    draft_mean: object = None
    draft_aft: object = None
    draft_forward: object = None
    trim_m: object = None
    heel: object = None
    gm: object = None


def inputs(settings, metres_per_unit):
    limits.at_most(len(settings.loading.load_cases), "load cases", limits.MOST_LOADING_ENTRIES)
    cases = tuple(
        Case(
            one.name,
            limits.within(as_typed(one.mass_t), f"{one.name}: mass in t", 0.0, limits.HEAVIEST),
            tuple(
                loads.within_a_ship(value, one.name, metres_per_unit)
                for value in (one.lcg, one.tcg, one.vcg)
            ),
            one.with_weights,
        )
        for one in settings.loading.load_cases
    )
    ship = None
    if any(case.with_weights for case in cases):
        ship = weights.inputs(settings, metres_per_unit)
    return Inputs(cases, afloat.afloat(settings, metres_per_unit).upright(), ship)


def compute(ship, given):
    """A CaseEquilibrium of each case."""
    found = []
    parts = weights.compute(ship, given.ship).parts if given.ship else ()
    for case in given.cases:
        ship.tell(len(found), len(given.cases))
        found.append(_equilibrium(ship.body, _with_weights(case, parts), given.where))
    return found


def _with_weights(case, parts):
    """The Case with the ship's weights in it, where it wants them."""
    if not case.with_weights:
        return case
    load = weights.Part(case.name, case.mass_t, case.centre)
    both = weights.total(case.name, (*parts, load))
    return Case(case.name, both.mass_t, both.centre, True)


def _equilibrium(body, case, where):
    try:
        found = native.require().equilibrium(
            body,
            mass_t=case.mass_t,
            centre_of_gravity=case.centre,
            water_density=where.water_density,
            draft_at=where.draft_at,
        )
    except ValueError as error:
        return CaseEquilibrium(case, "refused", str(error))
    message = "" if found.status == "stable" and found.left is None else found.message
    if found.status not in AFLOAT:
        return CaseEquilibrium(case, found.status, message)
    length_pp = where.length_pp
    return CaseEquilibrium(
        case,
        found.status,
        message,
        found.draft_mean,
        found.draft(0.0) if length_pp else None,
        found.draft(length_pp) if length_pp else None,
        loads.trim_m(found.trim, found.heel, length_pp),
        found.heel,
        found.gm_transverse,
    )


def header(result):
    return [
        "load case",
        "mass [t]",
        "LCG [m]",
        "TCG [m]",
        "VCG [m]",
        "outcome",
        "mean draft [m]",
        "draft aft [m]",
        "draft forward [m]",
        "trim by the stern [m]",
        "heel to starboard [deg]",
        "GM [m]",
        "remark",
    ]


def rows(result):
    for found in result:
        heel_deg = None if found.heel is None else degrees(found.heel)
        yield [found.case.name, found.case.mass_t, *found.case.centre, found.status,
               found.draft_mean, found.draft_aft, found.draft_forward, found.trim_m, heel_deg,
               found.gm, found.message]  # fmt: skip
