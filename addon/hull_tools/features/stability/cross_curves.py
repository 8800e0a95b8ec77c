# SPDX-License-Identifier: GPL-3.0-or-later
"""Cross curves of stability: KN over displacements and heels."""

from dataclasses import dataclass
from math import degrees

import numpy as np

from ...bridge import limits, native
from ...bridge.blender.units import as_typed
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
    curves: object  # hull_native.CrossCurves
    inputs: Inputs


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
    displacements = np.linspace(*_range(ship.body, given), given.count)
    curves = native.require().cross_curves(
        ship.body,
        displacements_t=displacements,
        heels=given.heels,
        water_density=given.load.where.water_density,
        free_trim=given.load.free_trim,
        trim=given.load.where.trim,
        assumed_kg=given.load.kg,
        progress=ship.progress,
    )
    return Result(curves, given)


def _range(body, given):
    least_t, greatest_t = given.least_t, given.greatest_t
    if not (least_t and greatest_t):
        load = loads.load(body, given.load)
        least_t = least_t or _LEAST * load.mass_t
        whole_t = _whole_volume(body, load, given) * given.load.where.water_density
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


def plot(result, name):
    found = result.curves
    trim = "free trim" if result.inputs.load.free_trim else "trim held"
    density = f"water {result.inputs.load.where.water_density:g} t/m³"
    return native.require().cross_curves_plot(
        found.displacements_t,
        found.heels,
        found.levers,
        subtitles=[f"{name}, {trim}, {density}; GZ = KN − KG sin φ"],
    )
