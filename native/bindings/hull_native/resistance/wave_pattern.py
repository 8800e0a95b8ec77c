# SPDX-License-Identifier: GPL-3.0-or-later
"""The waves far behind a thin ship, from her free-wave spectrum."""

import math
from dataclasses import dataclass

import numpy as np

from .positive_numbers import require_positive

# Gauss's rule of so many nodes for each turn of the phase by so much, rad.
_NODES, _TURN = 16, 12.0
_STEEPEST = math.radians(89.0)
_MOST_NODES = 200_000
_BATCH = 256  # points or nodes at once
_MOST_AT_ONCE = 4_000_000  # of points by nodes, 64 MB of each array

# Of waves_behind(): points of a cut, cuts, how far they reach in ship lengths (or waves, where
# these are longer), the tangent of half of Kelvin's wedge, and the steepest waves.
_POINTS, _CUTS, _LENGTHS = 301, 21, 3.0
_KELVIN = 1.0 / math.sqrt(8.0)
_STEEPEST_BEHIND = math.radians(80.0)


def wave_heights(integral, speed, points, *, gravity, steepest=math.radians(80.0)):
    """(n,) heights of the water in m at points (n, 2): x ahead and y in the ship's axes, m.

    integral: MichellIntegral; gravity in m/s², as it has. Of the free waves alone, which is all
    there is some wave lengths behind the stern; beside and before the ship they mean nothing.
    steepest: directions in rad up to which waves are taken; shorter ones, which stand on the ship's
    track alone, are left out. ValueError for shapes, numbers that are not finite, points so far
    away that no sum resolves their phases, and as MichellIntegral.amplitudes().
    """
    points = np.asarray(points, dtype=float)
    if points.ndim != 2 or points.shape[1] != 2 or not np.isfinite(points).all():
        raise ValueError(f"points must be finite, of shape (n, 2), not {points.shape}.")
    reach = np.abs(points).max(axis=0, initial=0.0)
    along, across, factors = _waves(integral, speed, reach, gravity, steepest)
    heights, at_once = [], max(1, min(_BATCH, _MOST_AT_ONCE // factors.size))
    for batch in np.array_split(points, max(1, math.ceil(len(points) / at_once))):
        waves = np.exp(-1j * np.outer(batch[:, 0], along))
        sides = 2.0 * np.cos(np.outer(batch[:, 1], across))
        heights.append(((waves * sides) @ factors).real)
    return np.concatenate(heights)


def wave_field(integral, speed, x, y, *, gravity, steepest=math.radians(80.0)):
    """(m, n) heights of the water in m, as wave_heights() has them, at all x (n,) along cuts at
    y (m,). Phases along and across the ship are parts of a product: so many points at once are
    quick. ValueError as wave_heights()."""
    x, y = (np.asarray(values, dtype=float) for values in (x, y))
    if x.ndim != 1 or y.ndim != 1 or not (np.isfinite(x).all() and np.isfinite(y).all()):
        raise ValueError(f"x and y must be finite, of one row each, not {x.shape} and {y.shape}.")
    reach = [np.abs(values).max(initial=0.0) for values in (x, y)]
    along, across, factors = _waves(integral, speed, reach, gravity, steepest)
    heights = np.zeros((y.size, x.size))
    for begin in range(0, factors.size, _BATCH):
        part = slice(begin, begin + _BATCH)
        sides = 2.0 * np.cos(np.outer(y, across[part])) * factors[part]
        heights += (sides @ np.exp(-1j * np.outer(along[part], x))).real
    return heights


@dataclass(frozen=True, eq=False)
class WavesBehind:
    """Cuts along a ship's track. x (n,): abaft the stern; y (m,): from the track to either side;
    heights (m, n), all m. steepest: direction of waves in rad up to which they are taken."""

    x: np.ndarray
    y: np.ndarray
    heights: np.ndarray
    steepest: float


def waves_behind(integral, speed, *, stern, gravity):
    """WavesBehind over the wedge that free waves fill, from half a wave abaft the stern, whose x in
    the ship's axes is `stern` (m): nearer the water is not that of free waves.

    Waves that are less than two spacings of the cuts long across the track are left out: they would
    be seen as longer ones that are not there. ValueError as wave_heights().
    """
    require_positive(speed=speed, gravity=gravity)
    wave = 2.0 * math.pi * speed**2 / gravity  # the longest one's length
    reach = _LENGTHS * max(integral.length, wave)
    x = np.linspace(0.5 * wave, reach, _POINTS)
    y = np.linspace(0.0, _KELVIN * (reach + integral.length), _CUTS)
    # Across the track a wave of direction θ is as long as the longest one by cos²θ / sin θ.
    ratio = 2.0 * y[1] / wave if wave > 0.0 else math.inf
    steepest = min(math.asin(0.5 * (math.hypot(ratio, 2.0) - ratio)), _STEEPEST_BEHIND)
    heights = wave_field(integral, speed, stern - x, y, gravity=gravity, steepest=steepest)
    return WavesBehind(x, y, heights, steepest)


def resistance_by_direction(amplitudes, directions, *, speed, water_density):
    """(n,) kN/rad that the waves of directions (n,) in rad, to both sides, take; amplitudes
    (n,): of MichellIntegral.amplitudes(). Over 0 to π/2 it sums up to the wave resistance (Eggers,
    Sharma & Ward 1967). water_density in t/m³."""
    square = np.abs(np.asarray(amplitudes)) ** 2 * np.cos(np.asarray(directions)) ** 3
    return math.pi * water_density * speed**2 * square


def _waves(integral, speed, reach, gravity, steepest):
    """((k,) wave numbers along the ship, (k,) across, (k,) amplitudes by weight) of a quadrature
    over directions to one side, for points as far away as reach (2,)."""
    if not 0.0 < steepest < _STEEPEST:
        raise ValueError("steepest must be above 0 and below 89° in rad.")
    require_positive(speed=speed)
    nu = gravity / speed**2
    # By u = tan θ: the phase ν √(1 + u²) (x + u y) turns no faster than so much for each u.
    end = math.tan(steepest)
    ahead = reach[0] + integral.length
    turns = nu * end * math.hypot(1.0, end) * (ahead + 2.0 * end * reach[1]) + 1.0
    parts = math.ceil(turns / _TURN)
    if parts * _NODES > _MOST_NODES:
        raise ValueError(
            "The points are too far away for waves so steep: take less than "
            f"{math.degrees(steepest):.0f}°, or nearer points."
        )
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    half = 0.5 * end / parts
    u = (half * (2.0 * np.arange(parts)[:, None] + 1.0 + nodes)).ravel()
    amplitudes = np.asarray(integral.amplitudes(speed, np.arctan(u)))
    # dθ = du / (1 + u²); waves to both sides have one amplitude.
    factors = amplitudes * np.tile(weights * half, parts) / (1.0 + u**2)
    along = nu * np.hypot(1.0, u)
    return along, along * u, factors
