# SPDX-License-Identifier: GPL-3.0-or-later
"""A control mesh laid over a hull that exists as triangles, and fitted to it."""

from dataclasses import dataclass

import numpy as np
from hull_io.triangles import spread_points
from hull_native import SurfaceTree
from hull_native.girth_lines import GirthLines
from hull_native.grid_fit import GridFit, extreme_flats
from hull_native.grid_refinement import RowsAndColumns
from hull_native.hull_grid import keel_range, laid_grid
from hull_native.network_targets import NetworkTargets

from .outlines import shell_outline

# Of the length: the tolerance where none is given; points at most where no budget is given.
TOLERANCE, BUDGET = 3e-4, 150
# Places of the fit, and stations in which flats are looked for.
_PLACES, _STATIONS, _PER_STATION = 6000, 60, 120
_COLUMNS, _COLUMNS_OF_POST, _ROWS = 6, 7, 9
_AIM = 0.8
# Evenness of the moves and steps: first, after an addition, at last.
_FIRST = ((1e-1, 12), (1e-2, 12))
_AFTER_ADDITION = (1e-2, 6)
_LAST = ((3e-3, 12), (1e-3, 15), (1e-3, 15))


@dataclass(frozen=True)
class FittedHull:
    """surface: the LimitSurface; outline: what it was laid along; flats: tuples (points, normal,
    offset); rows: lists of control points that have one x."""

    surface: object
    outline: object
    flats: list
    fit: object


def fit_shell(shell, *, tolerance=None, budget=None, progress=None):
    """The FittedHull of a HullShell. tolerance, m; budget: control points at most. ValueError where
    the shell has no outline that a hull can be laid along."""
    outline = shell_outline(shell)
    tolerance = TOLERANCE * outline.length if tolerance is None else float(tolerance)
    if not tolerance > 0.0:
        raise ValueError("The tolerance has to be above zero.")
    budget = BUDGET if budget is None else int(budget)
    mesh = shell.mesh
    girths = GirthLines(outline, (mesh.points, mesh.triangles))
    places, normals = spread_points(mesh.points, mesh.triangles, _PLACES)
    targets = NetworkTargets(
        places, normals, np.full(len(places), 1.0), np.zeros(len(places), dtype=bool)
    )
    flats = extreme_flats(outline, _station_places(outline, girths))
    columns = _COLUMNS if outline.arch is None else _COLUMNS_OF_POST
    grid = laid_grid(outline, columns, _ROWS, girths=girths)
    fit = GridFit(grid, targets, flats)
    if len(fit.points) > budget:
        raise ValueError(
            f"The simplest layout has {len(fit.points)} control points, more than the budget of "
            f"{budget}: give a larger one."
        )
    for evenness, steps in _FIRST:
        fit.run(evenness, steps, progress)
    additions = RowsAndColumns(places, _AIM * tolerance, budget)
    while additions.add_to(fit):
        fit = GridFit(grid, targets, flats)
        fit.run(*_AFTER_ADDITION, progress)
    for evenness, steps in _LAST:
        fit.flatten()
        fit.run(evenness, steps, progress)
    return FittedHull(fit.surface, outline, fit.flat_points(), fit)


def _station_places(outline, girths):
    low, high = keel_range(outline)
    lines = []
    for x in np.linspace(low, high, _STATIONS + 2)[1:-1]:
        line = girths.at(float(x))
        lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
        at = np.linspace(0.0, lengths[-1], _PER_STATION)
        lines.append(np.stack([np.interp(at, lengths, c) for c in line.T], axis=1))
        lines[-1][:, 0] = x
    return np.concatenate(lines)


def distances_from(surface, points):
    """m, of points (n, 3) from a LimitSurface."""
    return np.asarray(SurfaceTree(surface).closest_points(points).distances)
