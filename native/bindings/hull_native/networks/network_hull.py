# SPDX-License-Identifier: GPL-3.0-or-later
"""A network of curves as a hull: a control mesh laid over it and fitted.

Lengths are in metres.
"""

from dataclasses import dataclass

import numpy as np

from .._core import SurfaceTree
from .curve_bends import network_bends
from .extreme_flats import extreme_flats
from .girth_lines import GirthLines
from .grid_fit import GridFit
from .grid_refinement import RowsAndColumns
from .hull_grid import best_places, laid_grid
from .hull_outline import hull_outline
from .network_targets import curve_distances, network_places, network_targets
from .template_fit import fit_template

# Of the length: the tolerance that is meant where none is given.
_TOLERANCE = 3e-4
# Points at most where no budget is given: Greshake (2021) has 105 to 153 for ships.
_BUDGET = 150
# Of the tolerance: additions go on to this, as the flats cost some of it.
_AIM = 0.8


@dataclass(frozen=True)
class _Way:
    """A layout to begin with, of_post: columns that begin at a post below an arch; and how it is
    fitted: rows_stay and bends as GridFit has them; follow: what bends along the network's curves
    count for; evenness of the moves, fairness of rows and columns, and steps: first, after an
    addition, at last."""

    columns: int
    rows: int
    of_post: int
    rows_stay: bool
    bends: tuple
    follow: float
    first: tuple
    after_addition: tuple
    last: tuple


def _floating(rows):
    """Rows go to where they are wanted: with third differences that are small from the beginning
    that comes nearer to the curves with fewer points."""
    return _Way(
        6, rows, 0, False, (0.0, 0.0), 0.0,
        ((1e-1, 3e-3, 12), (1e-2, 3e-3, 12)),
        (3e-3, 3e-3, 8),
        ((1e-3, 3e-3, 15), (1e-4, 1e-3, 20), (1e-4, 1e-3, 20), (1e-4, 5e-4, 20)),
    )  # fmt: skip


def _staying(columns, rows, of_post, bends, even):
    """Around a post, bulbs and blunt bows rows that float would come to lie on one another; they
    stay, where columns meet the sections best; along curves the surface bends as these do, and
    elsewhere as little, and as evenly, as they allow. Along the girth rows and columns are even."""
    return _Way(
        columns, rows, of_post, True, bends, 2e-4,
        ((1e-1, even, 12), (1e-2, even, 10)),
        (3e-3, even, 5),
        ((3e-3, even, 15), (3e-3, even, 15), (1e-3, even, 15)),
    )  # fmt: skip


# Which layout does best depends on the hull: the first within the tolerance is taken, or the best.
_WAYS = (_floating(9), _floating(10))
# Fairer ones first: of rows that stay the first is taken, too, that is near enough in the mean.
_FAIRER, _NEARER = ((2e-5, 4e-7), 5e-3), ((1e-5, 2e-7), 3e-3)
_WAYS_OF_POST = (
    _staying(8, 12, 5, *_FAIRER), _staying(8, 12, 5, *_NEARER), _staying(8, 10, 4, *_NEARER),
)  # fmt: skip
# Of the tolerance: what is near enough in the mean.
_IN_MEAN = 1.0 / 3.0
# Of the size of points: rows of one x are within it.
_ONE_X = 2e-3


@dataclass(frozen=True)
class NetworkHull:
    """A hull laid over a network: its LimitSurface; a CurveDistance of each curve; of all places on
    curves the root mean square and the largest distance, m, and where that is; flats: tuples
    (points (k,), normal (3,), offset) of control points that are in a plane; in_rows: the share of
    control points in rows of one x; is_within: whether the largest distance is within the
    tolerance."""

    surface: object
    curves: list
    rms: float
    largest: float
    place: tuple
    flats: list
    in_rows: float
    is_within: bool


def hull_from_network(network, *, tolerance=None, budget=None, layout=None, progress=None):
    """The NetworkHull of a CurveNetwork of a half hull.

    tolerance, m: rows and columns are added where curves are missed by more, until none is or there
    are `budget` control points; None: 3e-4 of the length, 150 points. layout: a LimitSurface whose
    control mesh is taken as it is, and fitted; it has to lie near the network, with a crease or
    border for each that the network has. progress: a callable that takes the share done, 0 to 1;
    what it raises ends it.

    ValueError for a network without regions, of a whole hull, of more than one body, with another
    border than one line in the centre plane and one along the deck between two ends, and for a
    tolerance or budget that is none.
    """
    places, curve_numbers = _places(network)
    length = float(np.ptp(places[:, 0]))
    if not length > 0.0:
        raise ValueError(
            f"No part of the network is a shell: all of it lies at x = {places[0, 0]:.3f} m. Give "
            "the curves of the shell along the ship, too."
        )
    tolerance = _TOLERANCE * length if tolerance is None else float(tolerance)
    if not tolerance > 0.0:
        raise ValueError("tolerance has to be above zero.")
    budget = _BUDGET if budget is None else int(budget)
    if layout is not None:
        surface, flats = fit_template(network, layout, progress), []
    else:
        surface, flats = _laid(network, places, tolerance, budget, progress)
    curves = curve_distances(network, surface)
    return _told(network, surface, curves, flats, tolerance)


def _places(network):
    if network.region_count == 0:
        hull_outline(network)
    return network_places(network)


def _laid(network, places, tolerance, budget, progress):
    """The surface and its flats: of the first layout within the tolerance or, where rows stay, near
    enough in the mean; else of the best one."""
    outline = hull_outline(network)
    targets, flats = network_targets(network), extreme_flats(outline, places)
    girths, bends = GirthLines(outline), network_bends(network)
    ways = _WAYS if outline.arch is None else _WAYS_OF_POST
    found, refused = [], []
    for number, way in enumerate(ways):
        told = _Progress(progress, budget, number / len(ways), 1.0 / len(ways))
        columns = max(way.columns, len(outline.knuckles) + 3)
        additions = RowsAndColumns(places, _AIM * tolerance, budget)
        try:
            at = best_places(outline, girths, way.rows) if way.rows_stay else None
            grid = laid_grid(
                outline, columns, way.rows, post_columns=way.of_post, girths=girths, at=at
            )
            fit = _grown(grid, targets, flats, way, additions, told, bends)
        except ValueError as error:
            if error is told.raised:
                raise
            refused.append((way.columns * way.rows, number, error))
            continue
        distances = np.asarray(SurfaceTree(fit.surface).closest_points(places).distances)
        rms = float(np.sqrt(np.mean(distances**2)))
        found.append((rms, number, fit))
        is_near = way.rows_stay and rms <= _IN_MEAN * tolerance
        if is_near or distances.max() <= tolerance:
            return fit.surface, fit.flat_points()
    if not found:
        raise min(refused)[2]
    fit = min(found)[2]
    return fit.surface, fit.flat_points()


def _grown(grid, targets, flats, way, additions, told, curves):
    lines = (curves, way.follow) if way.follow > 0.0 else None

    def anew():
        return GridFit(grid, targets, flats, way.rows_stay, bends=way.bends, lines=lines)

    fit = anew()
    if len(fit.points) > additions.budget:
        raise ValueError(
            f"The simplest layout has {len(fit.points)} control points, more than the budget of "
            f"{additions.budget}: give a larger one."
        )
    for evenness, fairness, steps in way.first:
        fit.run(evenness, fairness, steps, told.at(len(fit.points)))
    while additions.add_to(fit):
        fit = anew()
        fit.run(*way.after_addition, told.at(len(fit.points)))
    for evenness, fairness, steps in way.last:
        fit.flatten()
        fit.run(evenness, fairness, steps, told.at(additions.budget))
        fit.heed(additions.tolerance)
    return fit


class _Progress:
    """Tells of a share, from `start` over `width`, that grows with the points. raised: what ended
    the work in doing so."""

    def __init__(self, progress, budget, start, width):
        self._progress, self._budget, self._told = progress, budget, start
        self._start, self._width = start, width
        self.raised = None

    def at(self, count):
        if self._progress is None:
            return None
        low = self._start + self._width * 0.8 * min(1.0, count / self._budget)
        low, high = max(self._told, low), self._start + self._width

        def told(share):
            self._told = max(self._told, low + 0.2 * (high - low) * share)
            try:
                self._progress(self._told)
            except Exception as error:
                self.raised = error
                raise

        return told


def _told(network, surface, curves, flats, tolerance):
    counts = np.bincount(np.asarray(network.edge_curves), minlength=len(network.curves))
    weights = [counts[number] for number in np.flatnonzero(counts)]
    rms = float(np.sqrt(np.average([curve.rms**2 for curve in curves], weights=weights)))
    worst = max(curves, key=lambda curve: curve.largest)
    return NetworkHull(
        surface, curves, rms, worst.largest, worst.place, flats, share_in_rows(surface.mesh),
        worst.largest <= tolerance,
    )  # fmt: skip


def share_in_rows(mesh):
    """The share of control points in rows of one x: three or more joined by edges, all within 0.2 %
    of the length of one another."""
    points = np.asarray(mesh.points)
    within = _ONE_X * float(np.ptp(points[:, 0]))
    row = np.arange(len(points))

    def first(number):
        while row[number] != number:
            number = row[number]
        return number

    sizes, corners = np.asarray(mesh.face_sizes), np.asarray(mesh.face_vertices)
    for end, size in zip(np.cumsum(sizes), sizes):
        face = corners[end - size : end]
        for a, b in zip(face, np.roll(face, -1)):
            if abs(points[a, 0] - points[b, 0]) < within:
                row[first(a)] = first(b)
    rows = np.array([first(number) for number in range(len(points))])
    count = 0
    for number in np.unique(rows):
        members = points[rows == number, 0]
        if len(members) > 2 and np.ptp(members) <= within:
            count += len(members)
    return count / len(points)
