# SPDX-License-Identifier: GPL-3.0-or-later
"""The angle along the knuckles: between the surface's normals on both sides of them."""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.blender.units import METRIC

IS_LIVE = True

_SAMPLES = 8  # of a control edge
_ALONG = 0.5  # of its length: a knuckle that reaches less in x runs across


@dataclass(frozen=True)
class Knuckle:
    """One crease, from end to end: vertices (k,) its control points, positions (n, 3) in m and
    arc_lengths (n,) in m of samples, their angles (n,) in rad; length in m; least, mean, largest
    angle in rad. Positive angles bend away from the water, negative ones are hollows."""

    number: int
    vertices: np.ndarray
    positions: np.ndarray
    arc_lengths: np.ndarray
    angles: np.ndarray
    length: float
    least: float
    mean: float
    largest: float

    @property
    def reach(self):
        """(least, greatest) x of it, m."""
        return self.positions[:, 0].min(), self.positions[:, 0].max()

    @property
    def is_across(self):
        """Whether it runs across the ship rather than along her."""
        return np.ptp(self.positions[:, 0]) < _ALONG * self.length


def of_surface(surface):
    """The Knuckles of a hull_native.LimitSurface, the longest first."""
    found = []
    for index, curve in enumerate(native.require().crease_curves(surface)):
        if curve.kind == "crease":
            found.append(_measured(surface, index, curve))
    return sorted(found, key=lambda one: -one.length)


def _measured(surface, index, curve):
    angles = native.require().knuckle_angles(surface, index, samples_per_edge=_SAMPLES)
    return Knuckle(
        index,
        curve.vertices,
        curve.evaluate(angles.t)[0],
        angles.arc_lengths,
        angles.angles,
        angles.length,
        angles.least,
        angles.mean,
        angles.largest,
    )


def inputs(settings, metres_per_unit):
    return ()


def compute(ship, where):
    found = of_surface(ship.body.surface)
    if not found:
        raise ValueError("The hull has no knuckle: select edges and make them creases")
    return found


def header(result):
    return [
        "knuckle",
        "along it [m]",
        "x from AP [m]",
        "y to port [m]",
        "z above base [m]",
        "angle [deg]",
    ]


def rows(result):
    return [
        [place + 1, *row]
        for place, one in enumerate(result)
        for row in np.column_stack(
            [one.arc_lengths, one.positions, np.degrees(one.angles)]
        ).tolist()
    ]


def plot(result, name, shown=METRIC):
    """Over x; over the length along them for knuckles that run across the ship, where a step in x
    may be the whole knuckle."""
    known = [(f"{number}", one) for number, one in enumerate(result, 1) if _is_drawn(one)]
    groups = [
        ("x", "x from the after perpendicular", [one for one in known if not one[1].is_across]),
        ("s", "Along the knuckle", [one for one in known if one[1].is_across]),
    ]
    groups = [group for group in groups if group[2]] or groups[:1]
    is_mixed = len(groups) > 1
    note = ["x: from the after perpendicular, s: along the knuckle"] if is_mixed else []
    sizes = native.require().PlotUnits(shown.plot_sizes())
    plot = native.require().Plot("Angles of knuckles", [name, *note])
    plot.set_y_axis("Angle of the knuckle", "°", from_zero=False)
    for symbol, label, knuckles in groups:
        axis = plot.add_x_axis(label, sizes.symbol("m"))
        for number, one in knuckles:
            is_known = np.isfinite(one.angles)
            places = one.arc_lengths if symbol == "s" else one.positions[:, 0]
            plot.add_curve(
                f"{number} over {symbol}" if is_mixed else number,
                sizes.of(places[is_known], "m"),
                np.degrees(one.angles[is_known]),
                x_axis=axis,
            )
    return plot


def _is_drawn(one):
    return np.count_nonzero(np.isfinite(one.angles)) > 1
