# SPDX-License-Identifier: GPL-3.0-or-later
"""The diagrams of a ship's hydrostatics and stations, as `Plot` for `write_plot` and the screen.

Arguments are in metres, radians and tonnes, as everywhere in hull_native; diagrams show what is
told by `units`, a PlotUnits. What is optional is marked where it is given.
"""

from dataclasses import dataclass
from operator import attrgetter

import numpy as np

from .._drawing import Plot
from .plot_units import METRIC, figures
from .plotted_numbers import fair, maximum, numbers, round_number, same_length, typical_spacing

# In the diagram of hydrostatic curves, metacentres higher than so many times that at the deepest
# draft go out of sight: at small drafts they are far above all else.
_MOST_METACENTRE = 2.0

# The largest section's curve in a Bonjean diagram is about so many station spacings wide.
_BONJEAN_WIDTH = 1.5

# Neighbours cross: each is told from the next by its colour.
_STATION_COLOURS = ((0.05, 0.25, 0.60), (0.75, 0.12, 0.10), (0.02, 0.45, 0.25))

# Section areas nearer to the largest than this part of it are as large.
_LEVEL = 1e-6


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
    top = maximum(x, area)
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
    x, area = same_length(x, area, "x", "area")
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
        heights, fair_values = fair(drafts, values)
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
    stations = units.of(numbers(stations, "stations"), "m")
    drafts = units.of(numbers(drafts, "drafts"), "m")
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
    spacing = typical_spacing(stations)
    largest = float(np.max(areas[np.isfinite(areas)], initial=0.0))
    area_per_spacing = round_number(largest / _BONJEAN_WIDTH) if largest > 0.0 else 1.0
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
