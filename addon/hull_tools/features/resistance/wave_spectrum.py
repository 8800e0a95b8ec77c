# SPDX-License-Identifier: GPL-3.0-or-later
"""The free-wave spectrum at one speed: which waves take the resistance."""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.blender.units import METRIC
from . import free_waves

IS_LIVE = False

inputs = free_waves.inputs

_DIRECTIONS_DEG = np.linspace(0.0, 85.0, 681)


@dataclass(frozen=True, eq=False)
class Result:
    """amplitudes: complex (n,), m. resistance: kN, of the waves of all directions."""

    given: free_waves.Inputs
    amplitudes: np.ndarray
    resistance: float

    @property
    def power(self):
        """(n,) kN per degree of direction, of both sides."""
        found = native.require().resistance_by_direction(
            self.amplitudes,
            np.radians(_DIRECTIONS_DEG),
            speed=self.given.speed,
            water_density=self.given.where.water_density,
        )
        return np.radians(found)


def compute(ship, given):
    integral = free_waves.integral(ship.body, given)
    amplitudes = integral.amplitudes(given.speed, np.radians(_DIRECTIONS_DEG))
    ship.tell(1, 2)
    (found,) = integral.resistance([given.speed])
    return Result(given, np.asarray(amplitudes), found.resistance)


def header(result):
    return ["direction [deg]", "amplitude [m]", "phase [deg]", "wave resistance [kN/deg]"]


def rows(result):
    found = result.amplitudes
    columns = _DIRECTIONS_DEG, np.abs(found), np.degrees(np.angle(found)), result.power
    return np.column_stack(columns).tolist()


def plot(result, name, shown=METRIC):
    return native.require().wave_spectrum_plot(
        _DIRECTIONS_DEG,
        result.power,
        subtitles=[
            free_waves.subtitle(name, result.given, shown),
            f"wave resistance {_force(result, shown)}",
        ],
        units=native.require().PlotUnits(shown.plot_sizes()),
    )


def _force(result, shown):
    force, symbol = shown.in_unit(result.resistance, "kN")
    return f"{force:.4g} {symbol}"
