# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves on which shape fields are based, and which they become, in metres in the hull's axes."""

from dataclasses import dataclass

import numpy as np

from ...bridge import limits, native
from ...bridge.blender import units
from ...bridge.objects import curve_lines

# Cosine of the angle from which on a Blender curve is taken to have a knuckle where it is sampled.
_KNUCKLE = np.cos(np.radians(20.0))
# Of the hull's size: how far from a section its chords are, and what is no length.
_CHORD, _NO_LENGTH = 1e-4, 1e-9


@dataclass(frozen=True, eq=False)
class BaseCurve:
    """curve: a hull_native.FieldCurve."""

    curve: object
    is_closed: bool

    @property
    def ends(self):
        """(2, 3) its first and last point."""
        return self.curve.points_at([0.0, self.curve.length])

    @property
    def runs_aft(self):
        """Whether it ends aft of where it begins; of one across the ship, lower."""
        x, _, z = np.subtract(*self.ends[::-1])
        return bool(x < 0.0 if abs(x) > 1e-6 * self.curve.length else z < 0.0)


def place_of(field, scale):
    """(3,) a row's place."""
    return np.array([units.as_typed(value) for value in field.place]) * scale


def base_crease(field, surface, scale):
    """(its number, the hull_native.CreaseCurve) on which a row of base CREASE is based: the one
    nearest to its place."""
    curves = list(enumerate(native.require().crease_curves(surface)))
    if not curves:
        raise ValueError("The hull has no crease or border: choose another base")
    along = native.require().FieldCurve.of_crease
    return _nearest(curves, lambda each: along(each[1]), place_of(field, scale))


def of_field(field, obj, surface, scale):
    """The BaseCurve of a row whose base is one of field_rows.CURVES; surface: a
    hull_native.LimitSurface; scale: metres a unit. ValueError where there is none."""
    if field.base == "CREASE":
        _, crease = base_crease(field, surface, scale)
        return BaseCurve(native.require().FieldCurve.of_crease(crease), crease.closed)
    if field.base == "SECTION":
        return _section(field, surface, scale)
    if field.curve is None:
        raise ValueError("Choose the curve object that is its base")
    return _of_object(field.curve, obj, scale)


def target_of(field, base, obj, scale):
    """The hull_native.FieldCurve that a row's BaseCurve becomes, which begins where that does: a
    curve object that was drawn the other way is taken from its end."""
    points, is_closed = _points_of(field.becomes, obj, scale)
    if is_closed != base.is_closed:
        raise ValueError(
            "Its base and the curve that this becomes must be both open or both closed"
        )
    if not is_closed:
        first, last = base.ends
        straight = np.linalg.norm(points[0] - first) + np.linalg.norm(points[-1] - last)
        crossed = np.linalg.norm(points[-1] - first) + np.linalg.norm(points[0] - last)
        points = points[::-1] if crossed < straight else points
    return _through(points, is_closed).curve


def _of_object(curve, obj, scale):
    return _through(*_points_of(curve, obj, scale))


def _points_of(curve, obj, scale):
    """(points (n, 3), m, whether they close) of a curve object."""
    points, is_closed = curve_lines.points_of(curve, obj)
    if len(points) > limits.MOST_CURVE_POINTS:
        raise ValueError(
            f"{curve.name} is shown with {len(points)} points, {limits.MOST_CURVE_POINTS} at most "
            "may be: lower its resolution or remove points"
        )
    return points * scale, is_closed


def _section(field, surface, scale):
    place = place_of(field, scale)
    return section_near(surface, field.axis, place["XYZ".index(field.axis)], place)


def section_near(surface, axis, position, place):
    """The BaseCurve in which the plane across axis "X", "Y" or "Z" at a position, m, cuts a
    hull_native.LimitSurface, that nearest to a place (3,). ValueError where it does not."""
    size = float(np.ptp(surface.mesh.points, axis=0).max())
    found = native.require().section(surface, axis.lower(), position, chord_tolerance=_CHORD * size)
    curves = [_of_section(each, size) for each in found if len(each.points) > 1]
    if not curves:
        raise ValueError("Its plane does not cut the hull: place it where the hull is")
    return _nearest(curves, lambda each: each.curve, place)


def _of_section(section, size):
    points = np.asarray(section.points)
    count = len(points) - section.closed  # the first is repeated at the end of a closed one
    is_apart = np.linalg.norm(np.diff(points[:count], axis=0), axis=1) > _NO_LENGTH * size
    kept = np.concatenate([[0], 1 + np.flatnonzero(is_apart)])
    knuckles = np.unique(np.searchsorted(kept, np.asarray(section.knuckles) % count))
    knuckles = knuckles[knuckles < len(kept)]
    curve = native.require().FieldCurve(points[kept], knuckles=knuckles, closed=section.closed)
    return BaseCurve(curve, section.closed)


def _through(points, is_closed):
    curve = native.require().FieldCurve(points, knuckles=_knuckles(points), closed=is_closed)
    return BaseCurve(curve, is_closed)


def _nearest(curves, along, place):
    return min(curves, key=lambda curve: along(curve).distances([place])[0])


def _knuckles(points):
    sides = np.diff(points, axis=0)
    lengths = np.linalg.norm(sides, axis=1)
    if not (lengths > 0.0).all():
        raise ValueError("Points of its curve lie on one another: remove doubles")
    sides /= lengths[:, None]
    return 1 + np.flatnonzero((sides[1:] * sides[:-1]).sum(axis=1) < _KNUCKLE)
