# SPDX-License-Identifier: GPL-3.0-or-later
"""Bases of shape fields as lines to be seen."""

from dataclasses import dataclass

import numpy as np

from . import bases

# Of the hull's size: so much larger is the rectangle of a plane.
_LARGER = 0.03
_POINTS_OF_CURVE = 257


@dataclass(frozen=True, eq=False)
class Base:
    """Of the field of a number in the list. anchor: (3,) the place of the base from which its shift
    is drawn; polylines: [(k, 3)], none of a point; all in m, where the hull is without a preview.
    is_mirrored: whether the image is drawn, too."""

    number: int
    anchor: np.ndarray
    polylines: list
    is_mirrored: bool

    @property
    def digest(self):
        """Equal for bases in the same place."""
        return tuple(line.tobytes() for line in (self.anchor, *self.polylines))


def found(obj, surface, scale):
    """{number: Base} of the fields of a hull's list that are on, and of the chosen one; none of
    those that have no meaning, which is told when they are applied. surface: the hull's
    LimitSurface without a preview; scale: metres a unit."""
    settings, known = obj.hull.fields, {}
    for number, row in enumerate(settings.fields):
        if not row.use and number != settings.active_field:
            continue
        try:
            known[number] = _base(number, row, obj, surface, scale)
        except ValueError:
            continue
    return known


def _base(number, row, obj, surface, scale):
    place = np.array(row.place, dtype=np.float64) * scale
    if row.base == "POINT":
        return Base(number, place, [], obj.hull.half)
    if row.base == "PLANE":
        return Base(number, place, [_rectangle(row, place, obj, surface)], obj.hull.half)
    curve = bases.base_curve(row, obj, surface, scale)
    line = curve.points_at(np.linspace(0.0, curve.length, _POINTS_OF_CURVE))
    near = line[np.linalg.norm(line - place, axis=1).argmin()]
    if row.base == "CURVE":  # its place is not asked for
        near = line[len(line) // 2]
    return Base(number, near, [line], obj.hull.half)


def _rectangle(row, place, obj, surface):
    """(5, 3) corners, the first one again, around all of the hull in a field's plane."""
    points = surface.mesh.points
    low, high = points.min(axis=0), points.max(axis=0)
    if obj.hull.half:
        low[1], high[1] = min(low[1], -high[1]), max(high[1], -low[1])
    more = _LARGER * (high - low).max()
    low, high = low - more, high + more
    axis = "XYZ".index(row.axis)
    first, second = (each for each in range(3) if each != axis)
    corners = np.tile(place, (5, 1))
    corners[:, first] = np.array((low, high, high, low, low))[:, first]
    corners[:, second] = np.array((low, low, high, high, low))[:, second]
    return corners
