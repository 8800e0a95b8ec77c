# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields: from hull_io's HullData to Object.hull, and back."""

from ....hull_io.hull_data import ShapeField
from ...bridge.blender.units import as_stored
from ...bridge.objects import curve_lines

# By the names of hull files; a curve object is written as the line that it shows.
_BASES = {"point": "POINT", "crease": "CREASE", "plane": "PLANE", "line": "CURVE"}


def give_fields(obj, hull, scale):
    """To a hull without fields; scale: metres of Blender's unit."""
    for field in hull.fields:
        entry = obj.hull.fields.fields.add()
        entry.name, entry.role, entry.use = field.name, field.role.upper(), field.on
        entry.base, entry.axis = _BASES[field.base], field.axis.upper()
        entry.colour, entry.falloff = field.colour, field.falloff
        entry.place = [part / scale for part in field.place]
        entry.shift = [part / scale for part in field.shift]
        entry.extent = field.extent / scale
        entry.axes = [axis in field.axes for axis in "xyz"]
        if field.line:
            points = [[part / scale for part in point] for point in field.line]
            entry.curve = curve_lines.made(field.name, points, field.closed, obj)


def take_fields(obj, scale):
    """The list of ShapeField of a hull; ValueError where a base is no line."""
    return [_taken(entry, obj, scale) for entry in obj.hull.fields.fields]


def _taken(entry, obj, scale):
    line, is_closed = [], False
    base = next(name for name, own in _BASES.items() if own == entry.base)
    if base == "line" and entry.curve is None:
        base = "point"  # nothing is drawn yet
    elif base == "line":
        points, is_closed = curve_lines.points_of(entry.curve, obj)
        line = [tuple(point) for point in (points * scale).tolist()]
    return ShapeField(
        name=entry.name,
        extent=as_stored(entry.extent) * scale,
        role=entry.role.lower(),
        on=entry.use,
        colour=tuple(as_stored(part) for part in entry.colour),
        base=base,
        place=tuple(as_stored(part) * scale for part in entry.place),
        axis=entry.axis.lower(),
        line=line,
        closed=bool(is_closed),
        falloff=as_stored(entry.falloff),
        shift=tuple(as_stored(part) * scale for part in entry.shift),
        axes="".join(axis for axis, on in zip("xyz", entry.axes) if on),
    )
