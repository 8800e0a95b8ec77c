# SPDX-License-Identifier: GPL-3.0-or-later
"""The waves behind the hull at one speed, as cuts along her track."""

import math
from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.blender.units import METRIC
from . import free_waves

IS_LIVE = False

inputs = free_waves.inputs


@dataclass(frozen=True, eq=False)
class Result:
    given: free_waves.Inputs
    behind: object  # hull_native.WavesBehind


def compute(ship, given):
    hull_native = native.require()
    integral = free_waves.integral(ship.body, given)
    stern = ship.hydrostatics(given.where).waterline_aft
    ship.tell(1, 4)
    behind = hull_native.waves_behind(
        integral, given.speed, stern=stern, gravity=hull_native.GRAVITY
    )
    return Result(given, behind)


def header(result):
    return ["abaft the stern [m]", "from the track [m]", "height [m]"]


def rows(result):
    found = result.behind
    y, x = np.meshgrid(found.y, found.x, indexing="ij")
    return np.column_stack([x.ravel(), y.ravel(), found.heights.ravel()]).tolist()


def plot(result, name, shown=METRIC):
    found = result.behind
    return native.require().wave_pattern_plot(
        found.x,
        found.y,
        found.heights,
        subtitles=[
            free_waves.subtitle(name, result.given, shown),
            f"waves of directions up to {math.degrees(found.steepest):.0f}°",
        ],
        units=native.require().PlotUnits(shown.plot_sizes()),
    )
