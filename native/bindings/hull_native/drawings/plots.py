# SPDX-License-Identifier: GPL-3.0-or-later
"""The diagrams of a ship's hydrostatics and stability, as `Plot` for `write_plot` and the screen.

Arguments are in metres, radians and tonnes, as everywhere in hull_native; diagrams show heel in
degrees, and what else is told by `units`, a PlotUnits. What is optional is marked where it is
given.
"""

from dataclasses import dataclass
from operator import attrgetter

import numpy as np

from .._drawing import Plot
from .plot_units import METRIC, figures

# In the diagram of hydrostatic curves, metacentres higher than so many times that at the deepest
# draft go out of sight: at small drafts they are far above all else.
_MOST_METACENTRE = 2.0

# The largest section's curve in a Bonjean diagram is about so many station spacings wide.
_BONJEAN_WIDTH = 1.5

# Section areas nearer to the largest than this part of it are as large.
_LEVEL = 1e-6

# Levers below zero are shown down to so many times the largest, and the end of the tangent when it
# is not above so many times the largest.
_MOST_NEGATIVE_LEVER = 0.35
_MOST_TANGENT = 1.6

# Between two points of a table a curve is drawn with so many parts.
_FAIR_PARTS = 8


def sectional_area_plot(
    x,
    area,
    *,
    title="Sectional area curve",
    subtitles=(),
    lcb=None,
    length_pp=None,
    others=(),
    frame=None,
    units=METRIC,
):
    """Areas (n,) in m² of the immersed sections at x (n,) in m.

    lcb (m) marks the centre of buoyancy; length_pp (m) both perpendiculars and midship. others:
    (name, x, area) of curves that are drawn dashed beside it, such as another hull's, or (name, x,
    area, colour), sRGB or None.
    frame: ((low, high) of x, (low, high) of areas) that the axes show; None: what the curves need.
    """
    metres, square = units.symbol("m"), units.symbol("m²")
    x, area = _areas_along(x, area, units)
    plot = Plot(title, list(subtitles))
    x_range, area_range = (None, None)
    if frame is not None:
        x_range = tuple(units.of(end, "m") for end in frame[0])
        area_range = tuple(units.of(end, "m²") for end in frame[1])
    plot.add_x_axis("x from the after perpendicular", metres, range=x_range)
    plot.set_y_axis("Immersed sectional area", square, range=area_range, from_zero=True)
    curve = plot.add_curve("Sectional area", x, area)
    if x.size > 1:
        plot.add_area(curve, np.nanmin(x), np.nanmax(x), "")
    for name, other_x, other_area, *colour in others:
        where = _areas_along(other_x, other_area, units)
        plot.add_curve(name, *where, style="dashed", colour=colour[0] if colour else None)
    top = _maximum(x, area)
    if top is not None:
        level = x[area >= (1.0 - _LEVEL) * top[1]]
        label = f"largest {figures(top[1])} {square}"
        if level.size == 1:
            label += f" at {figures(top[0])} {metres}"
        # A parallel midbody has no one place of the largest area.
        middle = level[np.abs(level - level.mean()).argmin()]
        plot.add_marker(float(middle), top[1], label, curve=curve)
    if length_pp is not None:
        for at, label in ((0.0, "AP"), (0.5 * length_pp, "midship"), (length_pp, "FP")):
            plot.add_line(x=units.of(at, "m"), label=label)
    if lcb is not None:
        plot.add_line(x=units.of(lcb, "m"), label=f"LCB {units.figures(lcb, 'm')}")
    return plot


def _areas_along(x, area, units):
    x, area = _same_length(x, area, "x", "area")
    return units.of(x, "m"), units.of(area, "m²")


@dataclass(frozen=True)
class Quantity:
    """A column of a hydrostatic table: where it is in a row, and how a diagram names it."""

    attribute: str  # may reach into parts: "project.block"
    name: str
    symbol: str
    unit: str
    scale: str  # quantities of one scale share an axis


QUANTITIES = (
    Quantity("displacement_t", "Displacement Δ", "Δ", "t", "displacement"),
    Quantity("displaced_volume", "Displaced volume ∇", "∇", "m³", "volume"),
    Quantity("wetted_surface", "Wetted surface S", "S", "m²", "area"),
    Quantity("waterplane_area", "Waterplane area Aw", "Aw", "m²", "area"),
    Quantity("lcb", "LCB", "LCB", "m", "longitudinal"),
    Quantity("lcf", "LCF from AP", "LCF", "m", "longitudinal"),
    Quantity("kb", "KB", "KB", "m", "vertical"),
    Quantity("km_transverse", "KMt", "KMt", "m", "vertical"),
    Quantity("km_longitudinal", "KMl", "KMl", "m", "metacentre"),
    Quantity("tpc", "Immersion TPC", "TPC", "t/cm", "immersion"),
    Quantity("mtc", "Moment to trim MTC", "MTC", "t·m/cm", "moment"),
    Quantity("project.block", "Cb", "Cb", "", "coefficient"),
    Quantity("project.prismatic", "Cp", "Cp", "", "coefficient"),
    Quantity("project.midship", "Cm", "Cm", "", "coefficient"),
    Quantity("project.waterplane", "Cwp", "Cwp", "", "coefficient"),
)

_FROM_ZERO = {"displacement", "volume", "area", "vertical", "metacentre", "immersion", "moment"}


def hydrostatic_curves_plot(
    rows,
    *,
    title="Hydrostatic curves",
    subtitles=(),
    draft=None,
    quantities=None,
    units=METRIC,
):
    """Hydrostatics over the draft, which is upright; every quantity on a scale of its own.

    rows: objects with the attribute `draft` (m) and those of `quantities`, as
    upright_hydrostatics gives them; by default those of QUANTITIES that the rows have. draft (m)
    is marked.
    """
    rows = list(rows)
    if not rows:
        raise ValueError("Hydrostatic curves need a row of the table at least.")
    if quantities is None:
        quantities = [q for q in QUANTITIES if _known(rows, q)]
        if any(q.scale == "displacement" for q in quantities):
            quantities = [q for q in quantities if q.scale != "volume"]
    drafts = units.of(np.array([row.draft for row in rows], dtype=float), "m")
    plot = Plot(title, list(subtitles))
    plot.set_y_axis("Draft", units.symbol("m"))
    axes = {}
    for number, quantity in enumerate(quantities):
        values = units.of(np.array([_get(row, quantity) for row in rows], float), quantity.unit)
        if quantity.scale not in axes:
            columns = [
                units.of(np.array([_get(row, other) for row in rows], float), other.unit)
                for other in quantities
                if other.scale == quantity.scale
            ]
            axes[quantity.scale] = plot.add_x_axis(
                quantity.name,
                units.symbol(quantity.unit),
                range=_range_of(quantity.scale, drafts, np.array(columns)),
                from_zero=quantity.scale in _FROM_ZERO,
            )
        heights, fair_values = _fair(drafts, values)
        plot.add_curve(
            quantity.name,
            fair_values,
            heights,
            symbol=quantity.symbol,
            x_axis=axes[quantity.scale],
            style="solid" if number < 8 else "dashed",
        )
    if draft is not None:
        plot.add_line(y=units.of(draft, "m"), label=f"T {units.figures(draft, 'm')}")
    return plot


def _known(rows, quantity):
    """Whether all rows have it, and one at least a number that is not 0: 0 is unknown."""
    values = [_get(row, quantity) for row in rows]
    return None not in values and bool((np.isfinite(values) & (np.array(values) != 0.0)).any())


def _get(row, quantity):
    try:
        return attrgetter(quantity.attribute)(row)
    except AttributeError:
        return None


def _range_of(scale, drafts, columns):
    """The range of an axis (columns: (curves, drafts)), None to show all."""
    if scale not in {"vertical", "metacentre"}:
        return None
    deepest = columns[:, int(np.argmax(drafts))]
    high = _MOST_METACENTRE * np.max(deepest[np.isfinite(deepest)], initial=0.0)
    if high <= 0.0 or not np.nanmax(columns, initial=0.0) > high:
        return None
    return (0.0, high)


def bonjean_plot(
    stations,
    drafts,
    areas,
    *,
    title="Bonjean curves",
    subtitles=(),
    outline=(),
    draft=None,
    labels=None,
    units=METRIC,
):
    """Each station's immersed area over the draft, drawn from the station's place in the profile.

    stations (n,): x in m; drafts (m,) in m above the base line; areas (n, m) in m². outline: curves
    (k, 2) of x and z in m, the ship's profile. draft (m) is marked. labels: the stations' names.
    """
    stations = units.of(_numbers(stations, "stations"), "m")
    drafts = units.of(_numbers(drafts, "drafts"), "m")
    areas = units.of(np.asarray(areas, dtype=float), "m²")
    if areas.shape != (stations.size, drafts.size):
        raise ValueError(
            f"areas must have shape ({stations.size}, {drafts.size}), a row for each station and a "
            f"column for each draft, not {areas.shape}."
        )
    if labels is None:
        labels = [figures(x) for x in stations]
    if len(labels) != stations.size:
        raise ValueError(f"There are {len(labels)} labels for {stations.size} stations.")
    spacing = _typical_spacing(stations)
    largest = float(np.max(areas[np.isfinite(areas)], initial=0.0))
    area_per_spacing = _round_number(largest / _BONJEAN_WIDTH) if largest > 0.0 else 1.0
    plot = Plot(title, list(subtitles))
    plot.add_x_axis("x from the after perpendicular", units.symbol("m"))
    plot.set_y_axis("Height above base", units.symbol("m"), from_zero=True)
    for curve in outline:
        curve = units.of(np.asarray(curve, dtype=float).reshape(-1, 2), "m")
        if not np.ptp(curve, axis=0).any():
            continue  # an edge across the ship
        plot.add_curve("", curve[:, 0], curve[:, 1], colour=(0.55, 0.55, 0.55))
    for number, (x, row, label) in enumerate(zip(stations, areas, labels)):
        colour = _STATION_COLOURS[number % len(_STATION_COLOURS)]
        known = drafts[np.isfinite(row)]
        if known.size:
            ends = [known.min(), known.max()]
            plot.add_curve("", [x, x], ends, colour=colour, style="chain", guide=True)
        curve = x + row / area_per_spacing * spacing
        plot.add_curve("", curve, drafts, symbol=label, colour=colour)
    if draft is not None:
        plot.add_line(y=units.of(draft, "m"), label=f"T {units.figures(draft, 'm')}")
    plot.add_bar(spacing, f"area of {figures(area_per_spacing)} {units.symbol('m²')}")
    return plot


# Neighbours cross: each is told from the next by its colour.
_STATION_COLOURS = ((0.05, 0.25, 0.60), (0.75, 0.12, 0.10), (0.02, 0.45, 0.25))


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
    heel, gz = _same_length(heel, gz, "heel", "gz")
    if slopes is not None:
        slopes = units.of(np.radians(_same_length(heel, slopes, "heel", "slopes")[1]), "m")
    gz, gm, metres = units.of(gz, "m"), units.of(gm, "m"), units.symbol("m")
    angles, levers = _fair(np.degrees(heel), gz, slopes)
    plot = Plot(title, list(subtitles))
    plot.add_x_axis("Heel φ", "°")
    plot.set_y_axis("Righting lever GZ", metres, range=_righting_range(levers, gm), from_zero=True)
    curve = plot.add_curve("GZ", angles, levers)
    for start, end, value in areas:
        start_deg, end_deg = np.degrees(start), np.degrees(end)
        label = f"area {start_deg:.4g}° to {end_deg:.4g}°: {units.fixed(value, 'm·rad', 4)}"
        plot.add_area(curve, start_deg, end_deg, label)
    top = _maximum(angles, levers)
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
    displacement_t, heels = _numbers(displacement_t, "displacement_t"), _numbers(heels, "heels")
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
        curve = _fair(displacement_t, kn[:, number])
        plot.add_curve(f"heel {angle}", *curve, symbol=angle, style=style)
    if load_t is not None:
        plot.add_line(x=units.of(load_t, "t"), label=f"load {units.figures(load_t, 't')}")
    return plot


def _numbers(values, name):
    array = np.asarray(values, dtype=float)
    if array.ndim != 1:
        raise ValueError(f"{name} must have shape (n,), not {array.shape}.")
    return array


def _same_length(x, y, x_name, y_name):
    x, y = _numbers(x, x_name), _numbers(y, y_name)
    if x.size != y.size:
        raise ValueError(f"{x_name} has {x.size} numbers and {y_name} {y.size}; as many are needed")
    return x, y


def _typical_spacing(stations):
    distances = np.diff(np.unique(stations[np.isfinite(stations)]))
    return float(np.median(distances)) if distances.size else 1.0


def _round_number(wanted):
    """1, 2 or 5 times a power of ten, the nearest."""
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(min((1.0, 2.0, 5.0, 10.0), key=lambda m: abs(np.log(m * power / wanted))) * power)


def _maximum(x, y):
    """(x, y) of the highest point; None when no number is finite."""
    if not np.isfinite(y).any():
        return None
    top = int(np.nanargmax(y))
    return float(x[top]), float(y[top])


def _fair(t, values, slopes=None):
    """A smooth curve through values (n,) at rising t (n,): (t, values) of closer points.

    Piecewise cubic; slopes not given are those of the parabola through each point and its
    neighbours.
    What is not rising, not finite or less than three points is left as it is.
    """
    if t.size < 3 or not (np.isfinite(t).all() and np.isfinite(values).all()):
        return t, values
    steps = np.diff(t)
    if not (steps > 0.0).all():
        return t, values
    if slopes is None or not np.isfinite(slopes).all():
        slopes = np.gradient(values, t, edge_order=2)
    share = np.linspace(0.0, 1.0, _FAIR_PARTS, endpoint=False)[None, :]
    h, rise = steps[:, None], np.diff(values)[:, None]
    start, end = slopes[:-1, None] * h, slopes[1:, None] * h
    between = values[:-1, None] + share * (
        start + share * (3.0 * rise - 2.0 * start - end + share * (start + end - 2.0 * rise))
    )
    places = t[:-1, None] + share * h
    return np.append(places, t[-1]), np.append(between, values[-1])


def _righting_range(gz, gm):
    """The levers to show: not far below zero, where stability has long vanished."""
    known = gz[np.isfinite(gz)]
    high = float(np.max(known, initial=0.0))
    if high <= 0.0:
        return None
    low = max(float(np.min(known)), -_MOST_NEGATIVE_LEVER * high)
    top = max(1.06 * high, 1.03 * gm if gm is not None and gm < _MOST_TANGENT * high else 0.0)
    step = _round_number((top - min(low, 0.0)) / 20.0)
    return (step * np.floor(min(low, 0.0) / step), step * np.ceil(top / step))
