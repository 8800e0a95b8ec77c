# SPDX-License-Identifier: GPL-3.0-or-later
"""Analyses of a hull: tables and plots that are computed when they are looked at.

Each module of ANALYSES is one analysis:
  IS_LIVE         whether it is quick enough to follow every change while it is shown
  inputs          (Object.hull, metres per unit) → what it depends on beside the ship; hashable
  compute         (ship.Ship, inputs) → its result; no Blender in it: it may run in a thread, and
                  tells the ship's progress where it may take seconds
  header, rows    (result) → its table: names with units, and rows of numbers and texts
  plot            (result, name of the hull, shown=units.Shown) → hull_native.Plot; absent where
                  nothing is drawn.
                  Those of DRAWN_BESIDE take the beside.Curves of other hulls, too
What a user can get wrong raises ValueError in `inputs` and `compute`.
"""

from dataclasses import dataclass, field

from ...bridge.blender import units
from ..curves_of_form import beside, bonjean_curves, hydrostatic_table, sectional_areas
from ..fairness import knuckle_angles
from ..hull import hull_state
from ..lines import offset_table
from ..resistance import resistance_curves, wave_pattern, wave_spectrum
from ..stability import criteria, cross_curves, load_cases, righting_levers, weights
from ..variants import area_differences, differences

ANALYSES = {
    "hydrostatic_table": hydrostatic_table,
    "sectional_areas": sectional_areas,
    "bonjean_curves": bonjean_curves,
    "righting_levers": righting_levers,
    "cross_curves": cross_curves,
    "criteria": criteria,
    "load_cases": load_cases,
    "weights": weights,
    "resistance_curves": resistance_curves,
    "wave_pattern": wave_pattern,
    "wave_spectrum": wave_spectrum,
    "offset_table": offset_table,
    "knuckle_angles": knuckle_angles,
    "differences": differences,
    "area_differences": area_differences,
}

# Of each its name for people, and what it is. Modules run when they are first asked for something:
# these words, and which have a plot, Blender wants when the add-on is enabled.
WORDS = {
    "hydrostatic_table": (
        "Hydrostatics",
        "Over drafts and trims: table, and curves of even keel or the first trim",
    ),
    "sectional_areas": (
        "Sectional areas",
        "The sectional area curve at the draft, trim and heel of the hydrostatics",
    ),
    "bonjean_curves": (
        "Bonjean curves",
        "Areas of the stations of the lines plan over the draft",
    ),
    "righting_levers": (
        "Righting levers",
        "Levers over the heel, with what is read from the curve",
    ),
    "cross_curves": ("Cross curves", "KN over displacements and heels"),
    "criteria": (
        "IS Code criteria",
        "2008 IS Code, Part A, 2.2 and 2.3, for the load of the stability panel",
    ),
    "load_cases": ("Load cases", "How the hull floats under each load case, or why it does not"),
    "weights": ("Weights", "What the ship weighs without load: plating and list, and the sum"),
    "resistance_curves": (
        "Resistance",
        "Resistance and power over speeds, by the method of the panel",
    ),
    "wave_pattern": (
        "Wave pattern",
        "The waves behind the hull at a speed, by Michell's integral",
    ),
    "wave_spectrum": (
        "Wave spectrum",
        "Wave resistance by the direction of the waves at a speed, by Michell's integral",
    ),
    "offset_table": (
        "Table of offsets",
        "Heights and half-breadths at the stations of the lines plan",
    ),
    "knuckle_angles": (
        "Angles of knuckles",
        "The angle between the surface's normals on both sides, along the knuckles",
    ),
    "differences": (
        "Differences",
        "All particulars beside those of the hull that this one is compared with",
    ),
    "area_differences": (
        "Differences of areas",
        "Sectional areas beside those of the hull that this one is compared with",
    ),
}

_UNPLOTTED = (
    *("criteria", "load_cases", "weights", "offset_table", "differences", "area_differences"),
)
DRAWN_BESIDE = ("sectional_areas",)
PLOTTED = {name: module for name, module in ANALYSES.items() if name not in _UNPLOTTED}


@dataclass(frozen=True)
class Outcome:
    """What an analysis gave: its result, or None and the reason as a message."""

    result: object = None
    message: str = ""


@dataclass
class Known:
    """The last outcomes of one hull: (key_of, Outcome) by analysis."""

    outcomes: dict = field(default_factory=dict)


def known(state):
    """The Known of a HullState."""
    return state.of(Known)


def key_of(obj, scene, name):
    """What an analysis of a hull that has a body depends on now; ValueError when its inputs are
    wrong."""
    scale = units.metres_per_unit(scene)
    return (hull_state.state_of(obj).ship.key, ANALYSES[name].inputs(obj.hull, scale))


def others_beside(state, name):
    """The beside.Curves that the plot of an analysis has beside the hull's own."""
    return state.of(beside.Beside).of(name) if name in DRAWN_BESIDE else ()


def plot_of(name, result, title, others=(), shown=units.METRIC):
    """The hull_native.Plot of a result; others: others_beside; shown: a units.Shown. ValueError
    when it cannot be drawn."""
    return PLOTTED[name].plot(result, title, *([others] if others else []), shown=shown)


def last_outcome(obj, scene, name):
    """(Outcome of the last time or None, whether it is of the hull as it is now)."""
    state = hull_state.state_of(obj)
    if state is None or state.ship.body is None:
        return None, True
    stored_key, outcome = known(state).outcomes.get(name, (None, None))
    if state.status:  # the mesh has errors: what there was stays
        return outcome, True
    try:
        return outcome, stored_key == key_of(obj, scene, name)
    except ValueError as error:
        return Outcome(message=str(error)), True


def outcome_of(obj, scene, name):
    """The Outcome for the hull as hull_state knows it, computed when it is not of now.

    Those that follow every change are as close as live numbers are, the others as close as can be.
    """
    state = hull_state.state_of(obj)
    if state is None or state.ship.body is None:
        return Outcome(message=state.status if state else "")
    outcome, is_current = last_outcome(obj, scene, name)
    if is_current:
        return outcome or Outcome(message=state.status)
    key = key_of(obj, scene, name)
    ship = state.ship.as_it_is() if ANALYSES[name].IS_LIVE else state.ship.source.new_ship()
    outcome = computed(name, ship, key)
    store(state, name, key, outcome)
    return outcome


def computed(name, ship, key):
    """The Outcome of an analysis of a ship.Ship, by its key_of. For any thread."""
    try:
        return Outcome(ANALYSES[name].compute(ship, key[1]))
    except ValueError as error:
        return Outcome(message=str(error))


def store(state, name, key, outcome):
    known(state).outcomes[name] = (key, outcome)


def result_of(obj, scene, name):
    """The result for the hull as it is now, as close as can be; ValueError with the reason when
    there is none."""
    state = hull_state.up_to_date(obj, scene)
    if ANALYSES[name].IS_LIVE and state.ship.body is not None:
        outcome = computed(name, state.ship.source.new_ship(), key_of(obj, scene, name))
    else:
        outcome = outcome_of(obj, scene, name)
    if outcome.message:
        raise ValueError(outcome.message)
    return outcome.result
