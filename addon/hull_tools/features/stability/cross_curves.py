# SPDX-License-Identifier: GPL-3.0-or-later
"""Cross curves of stability: KN over displacements and heels."""

from dataclasses import dataclass
from math import degrees

import numpy as np

from ...bridge import limits, native
from ...bridge.blender.units import METRIC, as_typed
from ..curves_of_form.ranges import stepped
from ..flotation.afloat import as_typed_angle
from . import loads

IS_LIVE = False

_LEAST, _GREATEST = 0.25, 1.25  # of the load, where no range is given
# Of what the hull displaces when it is wholly under water, the most that a default range asks for.
_MOST_AFLOAT = 0.95
_FEWEST_DEGREES = 10.0  # between heels: curves that are closer are not told apart


@dataclass(frozen=True)
class Inputs:
    load: loads.LoadInputs
    least_t: float  # 0: a part of the load
    greatest_t: float
    count: int
    heels: tuple  # rad


@dataclass(frozen=True)
class Result:
    """load: the loads.Load that is marked; None where there is none."""

    curves: object  # hull_native.CrossCurves
    inputs: Inputs
    load: object = None


def inputs(settings, metres_per_unit):
    loading = settings.loading
    greatest = loads.greatest_heel(loading)
    step = max(as_typed_angle(loading.heel_step), np.radians(_FEWEST_DEGREES))
    return Inputs(
        loads.load_inputs(settings, metres_per_unit),
        limits.within(
            as_typed(loading.least_t), "The least displacement in t", 0.0, limits.HEAVIEST
        ),
        limits.within(as_typed(loading.greatest_t), "The greatest one in t", 0.0, limits.HEAVIEST),
        limits.within(loading.displacement_count, "Displacements", *limits.DISPLACEMENTS),
        stepped(0.0, greatest, step, "heels")[1:],
    )


def compute(ship, given):
    load = _load(ship, given)
    displacements = np.linspace(*_range(ship.body, given, load), given.count)
    curves = native.require().cross_curves(
        ship.body,
        displacements_t=displacements,
        heels=given.heels,
        water_density=given.load.where.water_density,
        free_trim=given.load.free_trim,
        trim=given.load.where.trim,
        assumed_kg=given.load.kg if load is None else load.kg,
        progress=ship.progress,
    )
    return Result(curves, given, load)


def _load(ship, given):
    """The loads.Load; None where the range is given and she does not float as typed."""
    try:
        return loads.load(ship, given.load)
    except ValueError:
        if given.load.case is None and given.least_t and given.greatest_t:
            return None
        raise


def _range(body, given, load):
    least_t, greatest_t = given.least_t, given.greatest_t
    if not (least_t and greatest_t):
        least_t = least_t or _LEAST * load.mass_t
        whole_t = _whole_volume(body, load, given) * given.load.where.water_density
        if not load.mass_t < whole_t:
            raise ValueError(
                f"A load of {load.mass_t:g} t sinks the ship: wholly under water she displaces "
                f"{whole_t:g} t"
            )
        greatest_t = greatest_t or min(_GREATEST * load.mass_t, _MOST_AFLOAT * whole_t)
    if not greatest_t > least_t:
        raise ValueError(
            f"The greatest displacement, {greatest_t:g} t, must be more than the least, "
            f"{least_t:g} t"
        )
    return least_t, greatest_t


def _whole_volume(body, load, given):
    arguments = {**load.arguments(given.load), "free_trim": False}
    return native.require().equilibrium(body, **arguments, free_heel=False).whole_volume


def header(result):
    return ["displacement [t]", "LCG [m]"] + [
        f"KN at {degrees(heel):.4g} deg [m]" for heel in result.curves.heels
    ]


def rows(result):
    found = result.curves
    return np.column_stack([found.displacements_t, found.lcg, found.levers]).tolist()


def plot(result, name, shown=METRIC):
    found = result.curves
    trim = "free trim" if result.inputs.load.free_trim else "trim held"
    density = f"water {shown.text(result.inputs.load.where.water_density, 't/m3')}"
    return native.require().cross_curves_plot(
        found.displacements_t,
        found.heels,
        found.levers,
        subtitles=[f"{name}, {trim}, {density}; GZ = KN − KG sin φ"],
        load_t=_within(result),
        units=native.require().PlotUnits(shown.plot_sizes()),
    )


def _within(result):
    """The load's mass in t where the curves have it, else None."""
    masses = result.curves.displacements_t
    if result.load is None or not masses[0] <= result.load.mass_t <= masses[-1]:
        return None
    return result.load.mass_t
