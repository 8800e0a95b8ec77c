# SPDX-License-Identifier: GPL-3.0-or-later
"""How the hull floats under each load case, or why it does not, and her stability with it."""

from dataclasses import dataclass
from math import degrees, radians

from ...bridge import native
from . import cases, criteria, loads, righting_levers, weights

IS_LIVE = False

AFLOAT = ("stable", "neutral", "unstable")


@dataclass(frozen=True)
class Inputs:
    cases: tuple  # of cases.Case
    ship: object  # weights.Inputs where a case has her weights, else None
    levers: righting_levers.Inputs
    criteria: criteria.Inputs


@dataclass(frozen=True)
class Stability:
    """What is read from the levers, m and rad, None where there is none; areas: (from, to, area) in
    rad and m·rad. outcomes: as criteria.Result's; notes: sentences."""

    greatest_lever: object
    greatest_lever_heel: object
    vanishing_heel: object
    areas: tuple
    outcomes: tuple
    notes: tuple

    def outcome(self):
        """ "fail" where a criterion is not met, else that of 2.2."""
        outcomes = {paragraph: outcome for paragraph, outcome, _ in self.outcomes}
        return "fail" if "fail" in outcomes.values() else outcomes[criteria.GENERAL]

    def area(self, start_deg, end_deg):
        """m·rad below the levers between two heels, None where they end before."""
        ends = radians(start_deg), radians(end_deg)
        return next((area for start, end, area in self.areas if (start, end) == ends), None)


@dataclass(frozen=True)
class CaseEquilibrium:
    """draft_mean, draft_aft, draft_forward, trim_m (m), heel (rad), gm (m) are None unless afloat;
    status as hull_native.Equilibrium's, or "refused"; message: a sentence where there is more to
    say than that it is stable. stability: a Stability, None where there is none, for which
    no_stability has the reason."""

    case: cases.Case
    status: str
    message: str
    draft_mean: object = None
    draft_aft: object = None
    draft_forward: object = None
    trim_m: object = None
    heel: object = None
    gm: object = None
    stability: object = None
    no_stability: str = ""

    def remark(self):
        """All there is to say, in a line."""
        said = [self.message, self.no_stability]
        if self.stability is not None:
            said += self.stability.notes
        return " ".join(dict.fromkeys(text for text in said if text))


def inputs(settings, metres_per_unit):
    given = cases.cases(settings, metres_per_unit)
    load = loads.any_load(settings, metres_per_unit)
    return Inputs(
        given,
        cases.ship_inputs(settings, metres_per_unit, given),
        righting_levers.of_inputs(settings, load),
        criteria.of_inputs(settings, metres_per_unit, load),
    )


def compute(ship, given):
    """A CaseEquilibrium of each case."""
    found = []
    parts = weights.compute(ship, given.ship).parts if given.ship else ()
    for case in given.cases:
        ship.tell(len(found), len(given.cases))
        found.append(_of_case(ship, cases.whole(case, parts), given))
    return found


def _of_case(ship, case, given):
    where = given.levers.load.where
    try:
        found = native.require().equilibrium(
            ship.body,
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
        *_stability(ship, case, given),
    )


def _stability(ship, case, given):
    """(Stability, "") of a whole case, or (None, why there is none)."""
    try:
        load = loads.load_of(case)
        levers = righting_levers.of_load(ship, load, given.levers)
        judged = criteria.of_load(ship, load, given.criteria)
    except ValueError as error:
        return None, str(error)
    found = levers.levers
    stability = Stability(
        found.greatest_lever,
        found.greatest_lever_heel,
        found.vanishing_heel,
        tuple(levers.areas()),
        tuple(
            (paragraph, outcome, tuple(failed)) for paragraph, outcome, failed in judged.outcomes()
        ),
        tuple(note for note in (judged.no_weather, *judged.notes()) if note),
    )
    return stability, ""


_EQUILIBRIUM = (
    *("load case", "mass [t]", "LCG [m]", "TCG [m]", "VCG [m]", "outcome", "mean draft [m]"),
    *("draft aft [m]", "draft forward [m]", "trim by the stern [m]", "heel to starboard [deg]"),
    "GM [m]",
)
_AREAS_DEG = ((0.0, 30.0), (0.0, 40.0), (30.0, 40.0))
_STABILITY = (
    *("greatest GZ [m]", "heel of greatest GZ [deg]", "GZ vanishes at [deg]"),
    *(f"area {start:g} to {end:g} deg [m rad]" for start, end in _AREAS_DEG),
    *(f"2008 IS Code Part A {paragraph}" for paragraph in criteria.NAMES),
)


def header(result):
    return [*_EQUILIBRIUM, *_STABILITY, "remark"]


def rows(result):
    for found in result:
        yield [found.case.name, found.case.mass_t, *found.case.centre, found.status,
               found.draft_mean, found.draft_aft, found.draft_forward, found.trim_m,
               _degrees(found.heel), found.gm, *_stability_row(found.stability),
               found.remark()]  # fmt: skip


def _stability_row(stability):
    if stability is None:
        return [None] * len(_STABILITY)
    return [
        stability.greatest_lever,
        _degrees(stability.greatest_lever_heel),
        _degrees(stability.vanishing_heel),
        *(stability.area(*ends) for ends in _AREAS_DEG),
        *(outcome for _, outcome, _ in stability.outcomes),
    ]


def _degrees(angle):
    return None if angle is None else degrees(angle)
