# SPDX-License-Identifier: GPL-3.0-or-later
"""Bases of shape fields as lines to be seen."""

from dataclasses import dataclass

import numpy as np

from . import base_curves, bases

# Of the hull's size: so much larger is the rectangle of a plane.
_LARGER = 0.03
_POINTS_OF_CURVE, _POINTS_OF_SIDE = 257, 9


@dataclass(frozen=True, eq=False)
class Base:
    """Of the field of a number in the list. anchor: (3,) the place of the base from which its shift
    is drawn; polylines: [(k, 3)], none of a point; all in m, where the hull is without a preview.
    Their images are drawn, too."""

    number: int
    anchor: np.ndarray
    polylines: list

    @property
    def digest(self):
        """Equal for bases in the same place."""
        return tuple(line.tobytes() for line in (self.anchor, *self.polylines))


def found(obj, ground):
    """{number: Base} of the fields of a hull's list that are on, and of the chosen one; none of
    those that have no meaning, which is told when they are applied. ground: the prepared.Ground
    without a preview."""
    settings, known = obj.hull.fields, {}
    for number, row in enumerate(settings.fields):
        if not row.use and number != settings.active_field:
            continue
        try:
            known[number] = _base(number, row, obj, ground)
        except ValueError:
            continue
    return known


def _base(number, row, obj, ground):
    place = base_curves.place_of(row, ground.scale)
    if row.base == "POINT":
        return Base(number, place, [])
    if row.base == "PLANE":
        return Base(number, place, [_rectangle(row, place, ground.surface)])
    if row.base == "FACES":
        lines = _outlines(bases.cells_of(obj, row, ground.control), ground.surface)
        middles = np.array([line[0] for line in lines])
        return Base(number, middles[_nearest(middles, middles.mean(axis=0))], lines)
    curve = base_curves.of_field(row, obj, ground.surface, ground.scale).curve
    line = curve.points_at(np.linspace(0.0, curve.length, _POINTS_OF_CURVE))
    # The place of a curve object is not asked for.
    near = len(line) // 2 if row.base == "CURVE" else _nearest(line, place)
    return Base(number, line[near], [line])


def _nearest(points, place):
    return int(np.linalg.norm(points - place, axis=1).argmin())


def _outlines(cells, surface):
    """[(k, 3)] the sides of the control faces of cells: those along which one of (u, v) is 0."""
    t = np.linspace(0.0, 1.0, _POINTS_OF_SIDE)
    none = np.zeros_like(t)
    sides = (np.column_stack([t, none]), np.column_stack([none, t]))
    return [surface.positions(np.full(len(t), cell), side) for cell in cells for side in sides]


def _rectangle(row, place, surface):
    """(5, 3) corners, the first one again, around all of the hull in a field's plane."""
    points = surface.mesh.points
    low, high = points.min(axis=0), points.max(axis=0)
    low[1], high[1] = min(low[1], -high[1]), max(high[1], -low[1])
    more = _LARGER * (high - low).max()
    low, high = low - more, high + more
    axis = "XYZ".index(row.axis)
    first, second = (each for each in range(3) if each != axis)
    corners = np.tile(place, (5, 1))
    corners[:, first] = np.array((low, high, high, low, low))[:, first]
    corners[:, second] = np.array((low, low, high, high, low))[:, second]
    return corners
