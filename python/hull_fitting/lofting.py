# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of offsets as something that a control mesh can be laid over: a surface of triangles
through the stations, the outline, and places on stations and waterlines for the fit."""

from dataclasses import dataclass

import numpy as np

from .beside import (
    HullOutline,
    NetworkTargets,
    bend_shares,
    find_ends,
    keel_range,
    lengths_along,
    points_at,
)
from .half_meshes import HalfMesh
from .outlines import end_lines
from .shells import HullShell
from .table_curves import table_curves
from .table_lines import waterline_lines
from .table_sections import TableSections

# Sections that the surface is through, and places on each.
_SECTIONS, _ACROSS = 160, 96
# Of the length: steps along lines; what places of lines count for beside points of the table, and
# what they count for on waterlines.
_STEP, _BETWEEN, _ON_WATERLINES = 1 / 250, 0.3, 1.0


@dataclass(frozen=True)
class LoftedHull:
    """shell: a HullShell; outline: a HullOutline; targets: NetworkTargets, places (n, 3) of lines
    with what they count for; told: (k, 3) the table's own points, by which distances are told."""

    shell: HullShell
    outline: HullOutline
    girths: TableSections
    targets: NetworkTargets
    told: np.ndarray
    is_drawn: bool  # of curves that were drawn, and no points of a table


def lofted(geometry):
    """The LoftedHull of an oriented Geometry of a half hull. ValueError where there are fewer than
    five stations from the keel to the deck."""
    curves = table_curves(geometry)
    waterlines = waterline_lines(curves)
    outline = _outline(curves)
    if not _has_keel(outline):
        raise ValueError(
            f"{geometry.name}: its profile does not go along one keel from stern to stem; leave "
            "fin keels, skegs and rudders out of its heights."
        )
    girths = TableSections(curves, outline, waterlines)
    points, triangles = _surface(curves, girths)
    shell = HullShell(HalfMesh(points, triangles, outline.length), {}, 0.0)
    lines = [line for x in sorted({s.x for s in curves.stations}) for line in girths.lines_at(x)]
    for line in (*lines, *waterlines):
        if not np.isfinite(line).all():
            raise ValueError(
                f"{geometry.name}: no smooth line goes through its points near x = "
                f"{np.nanmean(line[:, 0]):.2f} m; look for a wrong number there."
            )
    targets, told = _targets(curves, lines, waterlines)
    is_drawn = any(station.is_dense for station in curves.stations)
    return LoftedHull(shell, outline, girths, targets, told, is_drawn)


def _surface(curves, girths):
    """(points, triangles) through sections."""
    low, high = girths.outline.low[0], girths.outline.high[0]
    xs = np.linspace(low, high, _SECTIONS + 1)[1:-1]
    lines = [np.concatenate(pieces) for x in xs if (pieces := girths.lines_at(float(x)))]
    lines = [curves.aft, *lines] if curves.aft is not None else lines
    lines = [*lines, curves.forward] if curves.forward is not None else lines
    shares = np.linspace(0.0, 1.0, _ACROSS + 1)
    points = np.array([points_at(line, bend_shares(line), shares) for line in lines])
    numbers = np.arange(points.shape[0] * points.shape[1]).reshape(points.shape[:2])
    a, b = numbers[:-1, :-1].ravel(), numbers[1:, :-1].ravel()
    c, d = numbers[1:, 1:].ravel(), numbers[:-1, 1:].ravel()
    triangles = np.concatenate([np.stack([a, c, b], axis=1), np.stack([a, d, c], axis=1)])
    points = points.reshape(-1, 3)
    is_central = (points[triangles][:, :, 1] == 0.0).all(axis=1)
    return points, triangles[~is_central]


def _outline(curves):
    ends = [end for end in (curves.aft, curves.forward) if end is not None]
    stations = [station.points for station in curves.stations]
    every = np.concatenate([curves.profile, curves.deck, *stations, *ends])
    outline = HullOutline(
        None, float(np.ptp(every[:, 0])), every.min(axis=0), every.max(axis=0), None,
        curves.profile, curves.deck, curves.aft, curves.forward,
    )  # fmt: skip
    outline.knuckles = list(curves.knuckles)
    for name, rim in (("aft", curves.aft), ("forward", curves.forward)):
        if rim is not None:
            outline.ends[name] = end_lines(rim, _plane_of(rim))
    find_ends(outline)
    return outline


def _has_keel(outline):
    """Whether there are whole sections over half of the length."""
    try:
        low, high = keel_range(outline)
    except ValueError:  # nothing of the contour is between stern and stem
        return False
    return high - low > 0.5 * outline.length


def _plane_of(rim):
    """(place, normal) of the plane, level athwart, that a rim lies in best."""
    place = rim.mean(axis=0)
    lean = np.polyfit(rim[:, 2] - place[2], rim[:, 0] - place[0], 1)[0]
    return place, np.array([1.0, 0.0, -lean]) / np.hypot(1.0, lean)


def _targets(curves, lines, waterlines):
    """(NetworkTargets, the table's points)."""
    step = _STEP * curves.length
    told = np.concatenate(
        [_spread(s.points, step) if s.is_dense else s.points for s in curves.stations]
    )
    parts = [(told, 1.0)]
    parts += [(_spread(line, step), _BETWEEN) for line in lines]
    parts += [(_spread(line, step), _BETWEEN * _ON_WATERLINES) for line in waterlines]
    ends = [end for end in (curves.aft, curves.forward) if end is not None]
    parts += [(_spread(line, step), _BETWEEN) for line in (curves.profile, *ends)]
    points = np.concatenate([places for places, _ in parts])
    weights = np.concatenate([np.full(len(places), weight) for places, weight in parts])
    normals = np.zeros_like(points)
    return NetworkTargets(points, normals, weights, np.ones(len(points), dtype=bool)), told


def _spread(line, step):
    lengths = lengths_along(line)
    count = max(2, int(np.ceil(lengths[-1] / step)))
    return points_at(line, lengths, np.linspace(0.0, lengths[-1], count + 1))
