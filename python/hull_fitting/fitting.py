# SPDX-License-Identifier: GPL-3.0-or-later
"""A control mesh laid over a hull that exists as triangles, and fitted to it."""

from dataclasses import dataclass, replace

import numpy as np

from .beside import GirthLines, GridFit, RowsAndColumns, extreme_flats
from .beside import hull_native as hn
from .beside import keel_range, laid_grid
from .immersion import immersed
from .outlines import shell_outline
from .progress import part_of
from .row_places import row_places
from .targets import shell_targets

# Of the length: the tolerance where none is given; points at most where no budget is given.
TOLERANCE, BUDGET = 3e-4, 150
# Stations in which flats are looked for, and places in each.
_STATIONS, _PER_STATION = 60, 120
# Columns; with a stern post, and how many of these begin at that.
_COLUMNS, _COLUMNS_OF_POST, _AT_POST = 6, 7, 5
_AIM = 0.8
# Evenness of the moves and steps: first, after an addition, at last.
_FIRST = ((1e-1, 12), (1e-2, 12))
_AFTER_ADDITION = (1e-2, 0.0, 6)
# Of the work: the first runs, and those with the additions.
_BEGUN, _ADDED = 0.1, 0.6
_LAST = ((3e-3, 12), (1e-3, 12), (3e-4, 15), (3e-4, 15))


@dataclass(frozen=True)
class _Way:
    """rows: of one x to begin with; rows_stay, fairness: as GridFit has them."""

    rows: int
    rows_stay: bool
    fairness: float
    with_knuckles: bool = True


# Which layout does best depends on the hull: the best of these is taken.
_WAYS = (
    _Way(10, False, 3e-6),
    _Way(11, True, 1e-6),
    _Way(10, False, 3e-6, False),
    _Way(11, True, 1e-6, False),
)
# Of few points, as of a table, a surface is to be fair between them.
_WAYS_OF_TABLE = (_Way(11, True, 1e-5), _Way(10, False, 1e-5))
# Rows and columns at most: of hulls for which there are few points.
_LAYOUTS = ((99, 99), (6, 5), (5, 4))
# Of the tolerance: what misses no more than this is good enough.
_GOOD = 0.4
# What an error of area or volume counts for, of the length; parts of a face's side.
_OFF, _PARTS = 0.02, 6
# A surface whose area or volume is off by more lies in folds, and fairer ones are tried. Creases
# along knuckles are done without only where that misses by so many times less.
_FOLDED, _FAIRER, _WITHOUT = 3e-3, (4.0, 16.0), 2.0


@dataclass(frozen=True)
class FittedHull:
    """surface: the LimitSurface; outline: what it was laid along; flats: tuples (points, normal,
    offset); rows: lists of control points that have one x."""

    surface: object
    outline: object
    flats: list
    fit: object


def fit_shell(
    shell, *, tolerance=None, budget=None, stern_post=True, knuckles=True, progress=None, loft=None
):  # fmt: skip
    """The FittedHull of a HullShell. tolerance, m; budget: control points at most; stern_post,
    knuckles: whether such as are found are laid out; loft: the LoftedHull that the shell is of.
    ValueError where the shell has no outline that a hull can be laid along."""
    outline = shell_outline(shell) if loft is None else loft.outline
    if not stern_post and outline.aft is not None:
        outline.arch = outline.post = None
    if not knuckles:
        outline.knuckles = []
    tolerance = TOLERANCE * outline.length if tolerance is None else float(tolerance)
    if not 0.0 < tolerance < np.inf:
        raise ValueError("The tolerance has to be above zero.")
    budget = BUDGET if budget is None else int(budget)
    trial = _Trial(shell, outline, tolerance, budget, loft)
    ways = [way for way in _WAYS if way.with_knuckles]
    if outline.knuckles:
        ways += [way for way in _WAYS if not way.with_knuckles]
    # Of a table area and volume are too little known to tell folds.
    fairer = _FAIRER if loft is None else ()
    if loft is not None and not loft.is_drawn:
        ways = _WAYS_OF_TABLE
    tried = _Tried(trial, len(ways) + len(fairer), progress)
    for way in ways:
        tried.add(way)
        if tried.best is not None and tried.best[0] < _GOOD * tolerance:
            break
    if tried.best is None:
        raise tried.refused
    way = tried.best[2]
    for times in fairer:
        if tried.best[1] > _FOLDED:
            tried.add(replace(way, fairness=times * way.fairness))
    fit = tried.best[3]
    return FittedHull(fit.surface, fit.grid.outline, fit.flat_points(), fit)


class _Tried:
    """best: (what it misses by, m, the share by which area or volume is off, _Way, GridFit) of the
    best of the ways that were tried, None without one; refused: why the last one was that was."""

    def __init__(self, trial, count, progress):
        self._trial, self._count, self._progress = trial, count, progress
        self._done, self.best, self.refused = 0, None, None

    def add(self, way):
        told = part_of(self._progress, *(k / self._count for k in (self._done, self._done + 1)))
        self._done += 1
        try:
            fit = self._trial.fitted(way, told)
        except ValueError as error:
            self.refused = error
            return
        distance, off = self._trial.misses(fit)
        misses = distance + _OFF * self._trial.outline.length * off
        if not way.with_knuckles:
            misses *= _WITHOUT
        if self.best is None or misses < self.best[0]:
            self.best = misses, off, way, fit


class _Trial:
    """Fits of one shell in several ways."""

    def __init__(self, shell, outline, tolerance, budget, loft):
        mesh = shell.mesh
        self.outline, self.tolerance, self.budget = outline, tolerance, budget
        self.girths = loft.girths if loft else GirthLines(outline, (mesh.points, mesh.triangles))
        self.targets = shell_targets(mesh) if loft is None else loft.targets
        self.have_normals = loft is None
        self.wanted = loft.told if loft and not loft.is_drawn else self.targets.points
        self.flats = extreme_flats(outline, _station_places(outline, self.girths))
        self.whole = immersed(mesh.points, mesh.triangles, outline, outline.high[2])

    def fitted(self, way, progress):
        """The GridFit of a _Way."""
        outline = self.outline if way.with_knuckles else replace(self.outline, knuckles=[])
        for layout in _LAYOUTS:
            grid = self._grid(outline, way, *layout)
            fit = self._fit(grid, way)
            if len(fit.points) <= self.budget:
                break
        else:
            raise ValueError(
                f"The simplest layout has {len(fit.points)} control points, more than the budget "
                f"of {self.budget}: give a larger one."
            )
        for number, (evenness, steps) in enumerate(_FIRST):
            told = part_of(progress, *(_BEGUN * (number + k) / len(_FIRST) for k in (0, 1)))
            fit.run(evenness, 0.0, steps, told)
        first, most = len(fit.points), max(self.budget, len(fit.points) + 1)
        additions = RowsAndColumns(self.wanted, _AIM * self.tolerance, self.budget)
        while additions.add_to(fit):
            fit = self._fit(grid, way)
            done = _BEGUN + (_ADDED - _BEGUN) * (len(fit.points) - first) / (most - first)
            fit.run(*_AFTER_ADDITION, part_of(progress, done, done))
        for number, (evenness, steps) in enumerate(_LAST):
            fit.flatten()
            share = (1.0 - _ADDED) / len(_LAST)
            done = _ADDED + share * number
            fit.run(evenness, 0.0, steps, part_of(progress, done, done + share))
            fit.heed(self.tolerance)
        return fit

    def _grid(self, outline, way, most_rows, most_columns):
        columns = _COLUMNS if self.outline.arch is None else _COLUMNS_OF_POST
        columns = max(min(columns, most_columns), len(outline.knuckles) + 2)
        if most_columns > _COLUMNS:
            columns = max(columns, len(outline.knuckles) + 3)
        rows = min(way.rows, most_rows)
        at = row_places(self.outline, self.girths, rows)
        post = min(_AT_POST, columns - 1)
        return laid_grid(outline, columns, rows, girths=self.girths, at=at, post_columns=post)

    def _fit(self, grid, way):
        return GridFit(
            grid,
            self.targets,
            self.flats,
            way.rows_stay,
            way.fairness,
            by_normals=self.have_normals,
        )

    def misses(self, fit):
        """(m, the root mean square of distances; the share by which area or volume is off): a
        surface that lies in folds is near everywhere, but too large."""
        distances = distances_from(fit.surface, self.targets.points)
        volume, area = _volume_and_area(fit.surface, self.outline)
        off = [abs(found / meant - 1.0) for found, meant in zip((volume, area), self.whole)]
        return float(np.sqrt(np.mean(distances**2))), max(off)


def _volume_and_area(surface, outline):
    """(∇, m³, area, m²) of both sides of a hull up to its deck."""
    facets = surface.tessellate(_PARTS)
    quads = facets.quads
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    whole = replace(outline, aft=None, forward=None)
    return immersed(np.asarray(facets.points), triangles, whole, outline.high[2])


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
    return np.asarray(hn.SurfaceTree(surface).closest_points(points).distances)
