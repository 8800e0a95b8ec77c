# SPDX-License-Identifier: GPL-3.0-or-later
"""The diagrams of a ship's stability, as `Plot` for `write_plot` and the screen.

Arguments are in metres, radians and tonnes, as everywhere in hull_native; diagrams show heel in
degrees, and what else is told by `units`, a PlotUnits. What is optional is marked where it is
given.
"""

import numpy as np

from .._drawing import Plot
from .plot_units import METRIC
from .plotted_numbers import fair, maximum, numbers, round_number, same_length

# Levers below zero are shown down to so many times the largest, and the end of the tangent when it
# is not above so many times the largest.
_MOST_NEGATIVE_LEVER = 0.35
_MOST_TANGENT = 1.6


def righting_lever_plot(
    heel,
    gz,
    *,
    title="Righting lever curve",
    subtitles=(),
    slopes=None,
    greatest=None,
    gm=None,
    vanishing=None,
    deck_edge=None,
    downflooding=None,
    areas=(),
    units=METRIC,
):
    """GZ (n,) in m over heel (n,) in rad; between the angles given the curve is interpolated.

    slopes (n,): dGZ/dheel in m/rad, which the curve then has; otherwise they are estimated.
    greatest: (heel, lever) in rad and m, by default the top of the curve drawn. gm (m) draws the
    tangent at 0, up to 1 rad; vanishing, deck_edge and downflooding are angles in rad that are
    marked; areas: (from, to, value), rad and m·rad, are shaded.
    """
    heel, gz = same_length(heel, gz, "heel", "gz")
    if slopes is not None:
        slopes = units.of(np.radians(same_length(heel, slopes, "heel", "slopes")[1]), "m")
    gz, gm, metres = units.of(gz, "m"), units.of(gm, "m"), units.symbol("m")
    angles, levers = fair(np.degrees(heel), gz, slopes)
    plot = Plot(title, list(subtitles))
    plot.add_x_axis("Heel φ", "°")
    plot.set_y_axis("Righting lever GZ", metres, range=_righting_range(levers, gm), from_zero=True)
    curve = plot.add_curve("GZ", angles, levers)
    for start, end, value in areas:
        start_deg, end_deg = np.degrees(start), np.degrees(end)
        label = f"area {start_deg:.4g}° to {end_deg:.4g}°: {units.fixed(value, 'm·rad', 4)}"
        plot.add_area(curve, start_deg, end_deg, label)
    top = maximum(angles, levers)
    if greatest is not None:
        top = (np.degrees(greatest[0]), units.of(greatest[1], "m"))
    if top is not None:
        plot.add_marker(*top, f"max {top[1]:.3f} {metres} at {top[0]:.1f}°", curve=curve)
    if gm is not None:
        radian = np.degrees(1.0)
        guide = plot.add_curve(
            f"tangent: GM {gm:.3f} {metres} at 1 rad",
            [0.0, radian],
            [0.0, gm],
            colour=(0.35, 0.35, 0.35),
            style="dashed",
            guide=True,
        )
        plot.add_marker(radian, gm, f"GM {gm:.3f} {metres}", curve=guide)
    if vanishing is not None:
        plot.add_marker(np.degrees(vanishing), 0.0, f"φv {np.degrees(vanishing):.1f}°", curve=curve)
    for angle, name in ((deck_edge, "deck edge"), (downflooding, "downflooding")):
        if angle is not None:
            plot.add_line(x=np.degrees(angle), label=f"{name} {np.degrees(angle):.1f}°")
    return plot


def cross_curves_plot(
    displacement_t,
    heels,
    kn,
    *,
    title="Cross curves of stability",
    subtitles=(),
    load_t=None,
    units=METRIC,
):
    """KN levers over the displacement, a curve for each angle of heel.

    displacement_t (n,) in t; heels (m,) in rad; kn (n, m) in m from the base line.
    load_t (t) is marked.
    """
    displacement_t, heels = numbers(displacement_t, "displacement_t"), numbers(heels, "heels")
    kn = np.asarray(kn, dtype=float)
    if kn.shape != (displacement_t.size, heels.size):
        raise ValueError(
            f"kn must have shape ({displacement_t.size}, {heels.size}), a row for each "
            f"displacement and a column for each heel, not {kn.shape}."
        )
    plot = Plot(title, list(subtitles))
    displacement_t, kn = units.of(displacement_t, "t"), units.of(kn, "m")
    plot.add_x_axis("Displacement Δ", units.symbol("t"))
    plot.set_y_axis("KN", units.symbol("m"), from_zero=True)
    for number, heel in enumerate(heels):
        angle = f"{np.degrees(heel):.4g}°"
        style = "solid" if number < 8 else "dashed"
        curve = fair(displacement_t, kn[:, number])
        plot.add_curve(f"heel {angle}", *curve, symbol=angle, style=style)
    if load_t is not None:
        plot.add_line(x=units.of(load_t, "t"), label=f"load {units.figures(load_t, 't')}")
    return plot


def _righting_range(gz, gm):
    """The levers to show: not far below zero, where stability has long vanished."""
    known = gz[np.isfinite(gz)]
    high = float(np.max(known, initial=0.0))
    if high <= 0.0:
        return None
    low = max(float(np.min(known)), -_MOST_NEGATIVE_LEVER * high)
    top = max(1.06 * high, 1.03 * gm if gm is not None and gm < _MOST_TANGENT * high else 0.0)
    step = round_number((top - min(low, 0.0)) / 20.0)
    return (step * np.floor(min(low, 0.0) / step), step * np.ceil(top / step))
