# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature along a plane section as a diagram, against a circle and against other hulls."""

from dataclasses import dataclass

import numpy as np

from .._core import section
from .._drawing import Plot
from ..polylines import lengths_along
from .plot_units import METRIC

_AXES = {"x": ("Station", "x"), "y": ("Buttock", "y"), "z": ("Waterline", "z")}


@dataclass(frozen=True)
class SectionCurvature:
    """girth (n,) m from the section's lowest end, or, of a waterline, its forward one; curvature
    (n,) 1/m, positive where a convex body has it; points (n, 3). Branches, and both sides of
    knuckles, are parted by a row of NaN; length in m."""

    girth: np.ndarray
    curvature: np.ndarray
    points: np.ndarray
    length: float


def section_curvature(surface, axis, position, chord_tolerance=None):
    """The SectionCurvature of a LimitSurface in the plane across axis "x", "y" or "z" at a place in
    m: exact curvatures at points of the section between which no chord is further than
    chord_tolerance, m, from it. ValueError where the plane does not meet the surface."""
    if axis not in _AXES:
        raise ValueError(f'A section is across "x", "y" or "z", not "{axis}".')
    curves = section(surface, axis, float(position), chord_tolerance)
    if not curves:
        raise ValueError(
            f"The hull has no section at {axis} = {position:g} m; choose a place within it."
        )
    return _curvature_of(curves, axis)


def _curvature_of(curves, axis):
    rows, at = [], 0.0
    for curve in curves:
        stretches = [(s.points, s.curvatures) for s in curve.stretches]
        if _is_backwards(curve.points, axis):
            stretches = [(p[::-1], c[::-1]) for p, c in reversed(stretches)]
        for points, curvatures in stretches:
            along = lengths_along(points)
            rows.append(np.column_stack([at + along, curvatures, points]))
            rows.append(np.full((1, 5), np.nan))
            at += along[-1]
    table = np.vstack(rows[:-1])
    return SectionCurvature(table[:, 0], table[:, 1], table[:, 2:], at)


def _is_backwards(points, axis):
    """Whether a curve runs from the deck down, or, of a waterline, from aft forward."""
    if axis == "z":
        return bool(points[0, 0] < points[-1, 0])
    return bool(points[0, 2] > points[-1, 2])


def curvature_plot(
    surface, axis, position, *, radius=None, others=(), name="", title=None, units=METRIC
):
    """The Plot of curvature over girth of a section: of the LimitSurface, and, dashed, of others,
    (name, LimitSurface) each; those that have no section there are named below the title. radius,
    m: a circle's curvature as a line across; None for none. units: PlotUnits. ValueError as
    section_curvature(), and for a radius that is none."""
    own = section_curvature(surface, axis, position)
    word, letter = _AXES[axis]
    told, found = [f"{word} at {letter} = {_g(position, units)}"], []
    for other_name, other in others:
        if curves := section(other, axis, float(position)):
            found.append((other_name, _curvature_of(curves, axis)))
        else:
            told.append(f"{other_name}: no section there")
    plot = Plot(title or "Curvature along a section", told)
    plot.add_x_axis("Girth", units.symbol("m"), from_zero=True)
    plot.set_y_axis("Curvature", units.symbol("1/m"), from_zero=True)
    plot.add_curve(name or "Hull", *_shown(own, units))
    for other_name, other in found:
        plot.add_curve(other_name, *_shown(other, units), style="dashed")
    if radius is not None:
        if not (radius > 0.0 and np.isfinite(radius)):
            raise ValueError(f"A circle's radius is a positive length, not {radius:g}.")
        plot.add_line(y=units.of(1.0 / radius, "1/m"), label=f"Circle R {_g(radius, units)}")
    return plot


def _shown(found, units):
    return units.of(found.girth, "m"), units.of(found.curvature, "1/m")


def _g(length, units):
    return f"{units.of(length, 'm'):g} {units.symbol('m')}"
