# SPDX-License-Identifier: GPL-3.0-or-later
"""The diagrams of a ship's resistance over speeds and of her waves, as `Plot` for `write_plot` and
the screen."""

import math

import numpy as np

from .._drawing import Plot
from ..drawings.plot_units import METRIC

# Parts in the order in which they are drawn, by the columns of a table.
_PARTS = (
    ("Friction with form", ("friction_kN", "form_kN")),
    ("Pressure", ("pressure_kN",)),
    ("Waves", ("wave_kN",)),
    ("Residuary", ("residuary_kN",)),
    ("Keel", ("keel_kN",)),
    ("Rudder", ("rudder_kN",)),
    ("Heel", ("heel_kN",)),
    ("Appendages", ("appendages_kN",)),
    ("Bulb and transom", ("bulb_kN", "transom_kN")),
    ("Correlation", ("correlation_kN",)),
)


def resistance_plot(rows, *, title="Resistance", subtitles=(), others=(), units=METRIC):
    """Total resistance and its parts over the speed in knots.

    rows: of michell_table(), holtrop_table(), savitsky_table() or delft_table(), one at least.
    others: pairs (name, rows) whose totals are drawn dashed beside it, such as another hull's or
    method's. units: PlotUnits. Rows without numbers are left out. ValueError for no rows.
    """
    rows = _with_numbers(rows)
    if not rows:
        raise ValueError("A diagram of resistance needs a row of the table at least.")
    speeds = _column(rows, "speed_kn")
    plot = Plot(title, list(subtitles))
    plot.add_x_axis("Speed", "kn")
    plot.set_y_axis("Resistance", units.symbol("kN"), from_zero=True)
    plot.add_curve("Total", speeds, units.of(_column(rows, "total_kN"), "kN"), symbol="RT")
    for name, columns in _PARTS:
        values = sum(_column(rows, column) for column in columns if column in rows[0])
        if np.any(values):
            plot.add_curve(name, speeds, units.of(values, "kN"))
    for name, other in others:
        other = _with_numbers(other)
        total = units.of(_column(other, "total_kN"), "kN")
        plot.add_curve(name, _column(other, "speed_kn"), total, style="dashed")
    return plot


def _with_numbers(rows):
    return [row for row in rows if not math.isnan(row["total_kN"])]


def _column(rows, name):
    return np.array([row[name] for row in rows], dtype=float)


# Where transverse waves end and diverging ones begin: at the cusps of Kelvin's wedge.
_CUSP_DEG = math.degrees(math.asin(1.0 / math.sqrt(3.0)))
_INK = (0.12, 0.32, 0.55)
# The highest wave of a pattern reaches over so many cuts.
_REACH = 3.0


def wave_spectrum_plot(
    directions_deg, power, *, title="Free-wave spectrum", subtitles=(), units=METRIC
):
    """Wave resistance of both sides by the direction of the free waves: power (n,) in kN per degree
    over directions_deg (n,), 0 for waves that run along with the ship. The areas are the
    resistance: of transverse waves up to 35.3°, and of diverging ones. units: PlotUnits. ValueError
    for less than two directions, or others than rise."""
    angles, power = (np.asarray(values, dtype=float) for values in (directions_deg, power))
    if angles.shape != power.shape or angles.ndim != 1 or angles.size < 2:
        raise ValueError("directions_deg and power need one length, of two at least.")
    if not np.all(np.diff(angles) > 0.0):
        raise ValueError("directions_deg must rise.")
    plot = Plot(title, list(subtitles))
    plot.add_x_axis("Direction of the waves from the ship's", "°", range=(0.0, 90.0))
    plot.set_y_axis("Resistance", f"{units.symbol('kN')}/°", from_zero=True)
    curve = plot.add_curve("Wave resistance", angles, units.of(power, "kN"))
    share = transverse_share(angles, power)
    plot.add_area(curve, float(angles[0]), _CUSP_DEG, f"transverse waves {100.0 * share:.0f} %")
    plot.add_line(x=_CUSP_DEG, label=f"cusp {_CUSP_DEG:.1f}°")
    return plot


def transverse_share(directions_deg, power):
    """The part of the area below power (n,) over directions_deg (n,) that lies below 35.3°."""
    angles, power = (np.asarray(values, dtype=float) for values in (directions_deg, power))
    both = np.sort(np.append(angles, _CUSP_DEG))
    there = np.interp(both, angles, power)
    areas = 0.5 * np.diff(both) * (there[1:] + there[:-1])
    total = areas.sum()
    return float(areas[both[1:] <= _CUSP_DEG].sum() / total) if total > 0.0 else 0.0


def wave_pattern_plot(x, y, heights, *, title="Wave pattern", subtitles=(), units=METRIC):
    """The water behind a ship as cuts along her track: heights (m, n) in m at x (n,), m abaft the
    stern, on cuts y (m,), m from the track to one side; to the other side the same is drawn. Each
    cut stands at its y, heights so many times as large that the pattern is seen; the subtitle says
    how many times. units: PlotUnits. ValueError for shapes that do not go together, or less than
    two cuts."""
    x, y, heights = (units.of(np.asarray(values, dtype=float), "m") for values in (x, y, heights))
    if heights.shape != (y.size, x.size) or y.size < 2 or x.size < 2:
        raise ValueError(
            f"heights must be of shape (cuts, points), two each at least, not {heights.shape} for "
            f"{y.size} cuts and {x.size} points."
        )
    spacing = float(np.abs(np.diff(y)).min())
    times = _round_below(_REACH * spacing / max(float(np.abs(heights).max()), 1e-12))
    plot = Plot(title, [*subtitles, f"heights {times:g} times as large"])
    reach = float(np.abs(y).max()) + spacing
    plot.add_x_axis("Abaft the stern", units.symbol("m"), range=(0.0, float(x.max())))
    plot.set_y_axis("From the track", units.symbol("m"), range=(-reach, reach))
    for at, cut in zip(y, heights):
        for side in (1.0, -1.0) if at else (1.0,):
            plot.add_curve("", x, side * at + times * cut, colour=_INK, guide=True)
    return plot


def _round_below(value):
    """1, 2 or 5 by a power of ten, not above the value."""
    power = 10.0 ** math.floor(math.log10(value))
    return next(step * power for step in (5.0, 2.0, 1.0) if step * power <= value * (1.0 + 1e-9))
