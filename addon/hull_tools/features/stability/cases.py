# SPDX-License-Identifier: GPL-3.0-or-later
"""Load cases as they are given, and with the ship's weights in them."""

from dataclasses import dataclass

from ...bridge import limits
from . import centres, weights


@dataclass(frozen=True)
class Case:
    name: str
    mass_t: float
    centre: tuple  # LCG, TCG, VCG in m
    with_weights: bool = False  # whether the ship's are to be added
    vcg_is_guess: bool = False  # nobody gave it


# The ship without load.
SHIP = Case("Sum of the weights", 0.0, (0.0, 0.0, 0.0), True)


def cases(settings, metres_per_unit):
    """A Case of each entry of an Object.hull's load cases."""
    entries = settings.loading.load_cases
    limits.at_most(len(entries), "load cases", limits.MOST_LOADING_ENTRIES)
    return tuple(
        Case(*centres.named_mass(one, metres_per_unit), one.with_weights, one.vcg_is_guess)
        for one in entries
    )


def ship_inputs(settings, metres_per_unit, given):
    """The weights.Inputs where one of these Cases has the ship's weights, else None."""
    if any(case.with_weights for case in given):
        return weights.inputs(settings, metres_per_unit)
    return None


def whole(case, parts):
    """The Case with the ship's weights in it, weights.Part, where it wants them."""
    if not case.with_weights:
        return case
    load = weights.Part(case.name, case.mass_t, case.centre)
    both = weights.total(case.name, (*parts, load))
    return Case(case.name, both.mass_t, both.centre, True, case.vcg_is_guess)
