# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots as arrays for the graphics card: the layout that paper gets, cut into segments and
triangles. Millimetres from the upper left corner of each plot's card, x to the right, y down."""

from dataclasses import dataclass, field

import numpy as np
from mathutils.geometry import tessellate_polygon


@dataclass(frozen=True)
class Segments:
    """Lines of one width: pairs of points (2 n, 2) with their colours (2 n, 4)."""

    width_mm: float
    points: np.ndarray
    colours: np.ndarray


@dataclass(frozen=True)
class Triangles:
    """Triangles as points (3 n, 2) with their colours (3 n, 4)."""

    points: np.ndarray
    colours: np.ndarray


@dataclass
class PlotArrays:
    """A plot to be drawn in this order; labels as in hull_native.PlotSheet."""

    width_mm: float
    height_mm: float
    areas: Triangles
    segments: list = field(default_factory=list)
    patches: Triangles = None
    labels: list = field(default_factory=list)


def arrays_of(card):
    """The arrays of a features.analyses.plot_layout.Card."""
    sheet = card.sheet
    by_width = {}
    for points, colour, width, dashes in sheet.strokes:
        pairs = _dashed(points, dashes) if dashes else _pairs(points)
        by_width.setdefault(width, []).append((pairs, colour))
    return PlotArrays(
        card.width_mm,
        card.height_mm,
        _triangles(sheet.areas),
        [Segments(width, *_joined(parts)) for width, parts in sorted(by_width.items())],
        _triangles(sheet.patches),
        sheet.labels,
    )


def _pairs(points):
    """The segments of a polyline (n, 2), each as two rows."""
    return np.repeat(points, 2, axis=0)[1:-1]


def _dashed(points, dashes):
    """The segments of a polyline (n, 2) drawn with lengths of line and gap in turn."""
    lengths = np.hypot(*np.diff(points, axis=0).T)
    along = np.concatenate([[0.0], np.cumsum(lengths)])
    ends = np.cumsum(dashes)
    period = ends[-1]
    starts = np.arange(0.0, along[-1], period)
    changes = (starts[:, None] + [0.0, *ends[:-1]]).reshape(-1)
    places = np.unique(np.concatenate([along, changes[changes < along[-1]]]))
    phases = np.mod(0.5 * (places[:-1] + places[1:]), period)
    is_drawn = np.searchsorted(ends, phases, side="right") % 2 == 0
    corners = np.column_stack([np.interp(places, along, points[:, axis]) for axis in (0, 1)])
    return np.stack([corners[:-1], corners[1:]], axis=1)[is_drawn].reshape(-1, 2)


def _joined(parts):
    """(points, colours) of several parts of one colour each."""
    if not parts:
        return np.empty((0, 2), dtype=np.float32), np.empty((0, 4), dtype=np.float32)
    points = np.concatenate([own for own, _ in parts], dtype=np.float32, casting="same_kind")
    colours = np.array([colour for _, colour in parts], dtype=np.float32)
    return points, np.repeat(colours, [len(own) for own, _ in parts], axis=0)


def _triangles(fills):
    parts = []
    for points, colour in fills:
        corners = tessellate_polygon([[(x, y, 0.0) for x, y in points]])
        parts.append((points[np.array(corners, dtype=int).reshape(-1)], colour))
    return Triangles(*_joined(parts))
