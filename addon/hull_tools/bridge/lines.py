# SPDX-License-Identifier: GPL-3.0-or-later
"""The hull's lines: where stations, waterlines and buttocks lie, and the curves themselves."""

from dataclasses import dataclass, field

import numpy as np

from . import native
from .units import as_typed

# A spacing that would give more planes than this is a slip of the keyboard.
_MOST_PLANES = 400

# A polyline departs from the true curve by at most this part of the hull's length.
_CHORD_TOLERANCE = 1e-4

# Curves nearer to the centre plane than this part of the hull's length are not drawn twice.
_CENTRE_PLANE_TOLERANCE = 1e-6


@dataclass(frozen=True)
class Planes:
    """Positions in metres; buttocks are measured to port and stand for both sides."""

    stations: tuple = ()
    waterlines: tuple = ()
    buttocks: tuple = ()


@dataclass
class Lines:
    """Polylines (k, 3) in metres by kind, as in materials.LINE_COLOURS."""

    curves: dict = field(default_factory=dict)

    def add(self, kind, points, closed=False):
        self.curves.setdefault(kind, []).append((points, closed))


def planes(settings, points, metres_per_unit):
    """The planes that an Object.hull asks for, as far as its control points (n, 3) in m reach.

    Stations stand at Lpp / count from the after perpendicular, and go on beyond both ends.
    """
    low, high = points.min(axis=0), points.max(axis=0)
    length = as_typed(settings.length_pp) * metres_per_unit
    station_spacing = length / settings.station_count if settings.station_count else 0.0
    waterline_spacing = as_typed(settings.waterline_spacing) * metres_per_unit
    buttock_spacing = as_typed(settings.buttock_spacing) * metres_per_unit
    half_beam = max(abs(low[1]), abs(high[1]))
    return Planes(
        multiples(station_spacing, low[0], high[0], "stations"),
        multiples(waterline_spacing, low[2], high[2], "waterlines"),
        multiples(buttock_spacing, 0.0, half_beam, "buttocks"),
    )


def multiples(spacing, low, high, name, with_ends=False):
    """Multiples of the spacing between two positions, which themselves count only with_ends; none
    when the spacing is 0."""
    if spacing <= 0.0:
        return ()
    if (high - low) / spacing > _MOST_PLANES:
        raise ValueError(
            f"A spacing of {spacing:.4g} m gives more than {_MOST_PLANES} {name}: widen it"
        )
    margin = 1e-6 * spacing * (-1.0 if with_ends else 1.0)
    first = int(np.floor((low + margin) / spacing)) + 1
    last = int(np.ceil((high - margin) / spacing)) - 1
    return tuple(k * spacing for k in range(first, last + 1))


def hull_lines(surface, where, draft, half):
    """Lines of a hull_native.LimitSurface on these Planes, both sides of a half hull."""
    hull_native = native.require()
    points = surface.mesh.points
    length = float(np.ptp(points, axis=0).max())
    chord = _CHORD_TOLERANCE * length
    lines = Lines()

    def cut(kind, axis, positions):
        for position in positions:
            for curve in hull_native.section(surface, axis, position, chord):
                lines.add(kind, curve.points, curve.closed)

    cut("station", "x", where.stations)
    cut("waterline", "z", where.waterlines)
    cut("buttock", "y", where.buttocks)
    if not half:
        cut("buttock", "y", [-y for y in where.buttocks])
        cut("feature", "y", [0.0])
    if draft > 0.0:
        cut("draft", "z", [draft])
    for curve in hull_native.feature_curves(surface):
        lines.add("feature", curve.points, curve.closed)
    if half:
        _mirror(lines, _CENTRE_PLANE_TOLERANCE * length)
    return lines


def _mirror(lines, tolerance):
    flip = np.array([1.0, -1.0, 1.0])
    for curves in lines.curves.values():
        curves += [
            (points * flip, closed)
            for points, closed in curves
            if np.abs(points[:, 1]).max() > tolerance
        ]


def handy_spacing(extent, parts):
    """1, 2 or 5 times a power of ten that divides an extent into about so many parts; 0 for 0."""
    if extent <= 0.0:
        return 0.0
    wanted = extent / parts
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(min((1.0, 2.0, 5.0, 10.0), key=lambda m: abs(np.log(m * power / wanted))) * power)
