# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of Object.hull.fields as hull_native.ShapeFields, in metres in the hull's axes."""

import numpy as np

from ...bridge import limits, native
from ...bridge.blender import units
from ...bridge.objects import field_faces, field_rows
from . import base_curves

_NORMALS = {"X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0)}


def shape_field(field, obj, own):
    """The hull_native.ShapeField of a row; own: the prepared.Prepared. ValueError, naming the
    field, where it has no meaning."""
    try:
        made = _shape_field(field, obj, own)
        return made.along_surface(own.net()) if field_rows.goes_along_surface(field) else made
    except ValueError as error:
        raise ValueError(f"{field.name}: {error}") from error


def cells_of(obj, field, control):
    """(k,) the cells of a row's faces, of a surface of mesh_arrays.ControlArrays. ValueError
    without."""
    own = np.isin(control.face_ids, field_faces.of_field(obj, field))
    if not own.any():
        raise ValueError("Select its faces in edit mode, and press Take Faces")
    # A face has a cell at each of its corners.
    return np.flatnonzero(np.repeat(own, control.face_sizes))


def _shape_field(field, obj, own):
    kind, scale = native.require().ShapeField, own.scale
    options = {"axes": "".join(axis for axis, on in zip("xyz", field.axes) if on)}
    if not options["axes"]:
        raise ValueError("Switch on one axis at least")
    if field.base in field_rows.CURVES:
        return _along_curve(field, obj, own, options)
    options.update(extent=_extent(field, "extent", scale), falloff=_falloff(field, "falloff"))
    options["protects"] = field.role == "PROTECT"
    shift = _shift(field, "shift", scale)
    if field.base == "POINT":
        return kind.at_point(base_curves.place_of(field, scale), shift, **options)
    if field.base == "PLANE":
        place = base_curves.place_of(field, scale)
        return kind.at_plane(place, _NORMALS[field.axis], shift, **options)
    cells = cells_of(obj, field, own.control)
    return kind.of_region(own.surface, cells, shift, **options)


def _along_curve(field, obj, own, options):
    kind, scale = native.require().ShapeField, own.scale
    base = base_curves.of_field(field, obj, own.surface, scale)

    def wanted(read, name, *arguments):
        values = [read(field, name, *arguments)]
        if not field_rows.varies(field):
            return values[0]
        values.append(read(field, f"{name}_end", *arguments))
        return (0.0, base.curve.length), np.array(values[::-1] if base.runs_aft else values)

    if field_rows.varies(field) and base.is_closed:
        raise ValueError("A closed base has no ends: switch off Varies")
    options.update(extent=wanted(_extent, "extent", scale), falloff=wanted(_falloff, "falloff"))
    if field_rows.becomes_another(field):
        other = base_curves.target_of(field, base, obj, scale)
        return kind.to_curve(base.curve, other, **options)
    options["protects"] = field.role == "PROTECT"
    return kind.along(base.curve, wanted(_shift, "shift", scale), **options)


def _extent(field, name, scale):
    value = units.as_typed(getattr(field, name)) * scale
    return limits.within(value, "The extent in m", 1e-6, limits.LONGEST)


def _falloff(field, name):
    return limits.within(units.as_typed(getattr(field, name)), "The falloff", 0.0, 1.0)


def _shift(field, name, scale):
    shift = np.array([units.as_typed(value) for value in getattr(field, name)]) * scale
    for value in shift:
        limits.within(value, "The shift in m", -limits.LONGEST, limits.LONGEST)
    return np.zeros(3) if field.role == "PROTECT" else shift
