# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of Object.hull.fields as hull_native.ShapeFields, in metres in the hull's axes."""

import numpy as np

from ...bridge import limits, native
from ...bridge.blender import units
from ...bridge.objects import curve_lines

_NORMALS = {"X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0)}
# Cosine of the angle from which on a Blender curve is taken to have a knuckle where it is sampled.
_KNUCKLE = np.cos(np.radians(20.0))


def shape_field(field, obj, surface, scale):
    """The hull_native.ShapeField of a row; surface: a hull_native.LimitSurface; scale: metres a
    unit. ValueError, naming the field, where it has no meaning."""
    try:
        return _shape_field(field, obj, surface, scale)
    except ValueError as error:
        raise ValueError(f"{field.name}: {error}") from error


def base_crease(field, surface, scale):
    """The hull_native.CreaseCurve on which a row of base CREASE is based: the one nearest to its
    place."""
    curves = native.require().crease_curves(surface)
    if not curves:
        raise ValueError("The hull has no crease or border: choose another base")
    place = [_place(field, scale)]
    along = native.require().FieldCurve.of_crease
    return min(curves, key=lambda curve: along(curve).distances(place)[0])


def base_curve(field, obj, surface, scale):
    """The hull_native.FieldCurve on which a row is based that is along a curve."""
    return _curve(field, obj, surface, scale)


def _shape_field(field, obj, surface, scale):
    options = {
        "extent": limits.within(
            units.as_typed(field.extent) * scale, "The extent in m", 1e-6, limits.LONGEST
        ),
        "falloff": limits.within(units.as_typed(field.falloff), "The falloff", 0.0, 1.0),
        "protects": field.role == "PROTECT",
        "axes": "".join(axis for axis, on in zip("xyz", field.axes) if on),
    }
    if not options["axes"]:
        raise ValueError("Switch on one axis at least")
    shift = np.array([units.as_typed(value) for value in field.shift]) * scale
    for value in shift:
        limits.within(value, "The shift in m", -limits.LONGEST, limits.LONGEST)
    if options["protects"]:
        shift[:] = 0.0
    kind = native.require().ShapeField
    if field.base == "POINT":
        return kind.at_point(_place(field, scale), shift, **options)
    if field.base == "PLANE":
        return kind.at_plane(_place(field, scale), _NORMALS[field.axis], shift, **options)
    return kind.along(_curve(field, obj, surface, scale), shift, **options)


def _place(field, scale):
    return np.array([units.as_typed(value) for value in field.place]) * scale


def _curve(field, obj, surface, scale):
    if field.base == "CREASE":
        return native.require().FieldCurve.of_crease(base_crease(field, surface, scale))
    if field.curve is None:
        raise ValueError("Choose the curve object that is its base")
    points, is_closed = curve_lines.points_of(field.curve, obj)
    points *= scale
    return native.require().FieldCurve(points, knuckles=_knuckles(points), closed=is_closed)


def _knuckles(points):
    sides = np.diff(points, axis=0)
    lengths = np.linalg.norm(sides, axis=1)
    if not (lengths > 0.0).all():
        raise ValueError("Points of its curve lie on one another: remove doubles")
    sides /= lengths[:, None]
    return 1 + np.flatnonzero((sides[1:] * sides[:-1]).sum(axis=1) < _KNUCKLE)
