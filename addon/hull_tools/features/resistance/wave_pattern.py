# SPDX-License-Identifier: GPL-3.0-or-later
"""The waves behind the hull at one speed, as cuts along her track."""

import math
from dataclasses import dataclass

import numpy as np

from ...bridge import native
from . import waves

IS_LIVE = False

inputs = waves.inputs

_POINTS, _CUTS = 301, 31
_LENGTHS = 3.0  # so many ship lengths abaft the stern, or so many waves where these are longer
_KELVIN = 1.0 / math.sqrt(8.0)  # tangent of half the wedge that waves fill
_STEEPEST = math.radians(80.0)


@dataclass(frozen=True, eq=False)
class Result:
    """x (n,): abaft the stern; y (m,): from the track; heights (m, n), all m. steepest: direction
    of waves, rad, up to which they are taken."""

    given: waves.Inputs
    x: np.ndarray
    y: np.ndarray
    heights: np.ndarray
    steepest: float


def compute(ship, given):
    hull_native = native.require()
    integral = waves.integral(ship.body, given)
    wave = 2.0 * math.pi * given.speed**2 / hull_native.GRAVITY  # the longest one's length
    reach = _LENGTHS * max(integral.length, wave)
    # Nearer than half a wave the water is not that of free waves.
    x = np.linspace(0.5 * wave, reach, _POINTS)
    y = np.linspace(0.0, _KELVIN * (reach + integral.length), _CUTS)
    steepest = _resolved(wave, y[1])
    aft = ship.hydrostatics(given.where).waterline_aft
    ship.tell(1, 4)
    heights = hull_native.wave_field(
        integral, given.speed, aft - x, y, gravity=hull_native.GRAVITY, steepest=steepest
    )
    return Result(given, x, y, heights, steepest)


def _resolved(wave, spacing):
    """The direction of which waves are two spacings of cuts long across the track, rad: shorter
    ones would be seen as longer ones that are not there."""
    ratio = 2.0 * spacing / wave  # cos² / sin of the direction
    return min(math.asin(0.5 * (math.hypot(ratio, 2.0) - ratio)), _STEEPEST)


def header(result):
    return ["abaft the stern [m]", "from the track [m]", "height [m]"]


def rows(result):
    y, x = np.meshgrid(result.y, result.x, indexing="ij")
    return np.column_stack([x.ravel(), y.ravel(), result.heights.ravel()]).tolist()


def plot(result, name):
    return native.require().wave_pattern_plot(
        result.x,
        result.y,
        result.heights,
        subtitles=[
            waves.subtitle(name, result.given),
            f"waves of directions up to {math.degrees(result.steepest):.0f}°",
        ],
    )
