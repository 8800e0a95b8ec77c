# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of Object.hull.fields as hull_native.ShapeFields, in metres in the hull's axes."""

import bpy
import numpy as np

from ...bridge import limits, native
from ...bridge.blender import units

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
    points, is_closed = _line(field.curve, obj, scale)
    return native.require().FieldCurve(points, knuckles=_knuckles(points), closed=is_closed)


def _line(curve, hull, scale):
    """(points (n, 3), whether they close) of a Blender curve as the view shows it."""
    if len(curve.data.splines) != 1:
        raise ValueError(
            f"{curve.name} has {len(curve.data.splines)} splines: take a curve object of one"
        )
    shown = curve.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = shown.to_mesh()
    try:
        points = np.array([vertex.co for vertex in mesh.vertices], dtype=np.float64)
        is_line = len(mesh.polygons) == 0
    finally:
        shown.to_mesh_clear()
    if not is_line or len(points) < 2:
        raise ValueError(f"{curve.name} is no line: take off its bevel, extrusion and fill")
    matrix = np.array(hull.matrix_world.inverted() @ curve.matrix_world, dtype=np.float64)
    points = scale * (points @ matrix[:3, :3].T + matrix[:3, 3])
    return points, curve.data.splines[0].use_cyclic_u


def _knuckles(points):
    sides = np.diff(points, axis=0)
    lengths = np.linalg.norm(sides, axis=1)
    if not (lengths > 0.0).all():
        raise ValueError("Points of its curve lie on one another: remove doubles")
    sides /= lengths[:, None]
    return 1 + np.flatnonzero((sides[1:] * sides[:-1]).sum(axis=1) < _KNUCKLE)
