# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields: from hull_io's HullData to Object.hull, and back."""

from ....hull_io.hull_data import FieldEnd, ShapeField
from ...bridge.blender.units import as_stored
from ...bridge.objects import curve_lines, field_faces, field_rows

# By the names of hull files; a curve object is written as the line that it shows.
_BASES = {
    "point": "POINT",
    "crease": "CREASE",
    "plane": "PLANE",
    "section": "SECTION",
    "line": "CURVE",
    "faces": "FACES",
}


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
        entry.along_surface = field.along_surface
        if field.line:
            entry.curve = _made(field.name, field.line, field.closed, obj, scale)
        if field.becomes:
            name = f"{field.name} becomes"
            entry.becomes = _made(name, field.becomes, field.closed, obj, scale)
        field_faces.give(obj, entry, field.faces)
        if field.end is not None:
            entry.varies = True
            entry.extent_end, entry.falloff_end = field.end.extent / scale, field.end.falloff
            entry.shift_end = [part / scale for part in field.end.shift]


def _made(name, points, is_closed, obj, scale):
    points = [[part / scale for part in point] for point in points]
    return curve_lines.made(name, points, is_closed, obj)


def take_fields(obj, scale):
    """The list of ShapeField of a hull; ValueError where a base is no line."""
    return [_taken(entry, obj, scale) for entry in obj.hull.fields.fields]


def _taken(entry, obj, scale):
    line, is_closed = [], False
    base = next(name for name, own in _BASES.items() if own == entry.base)
    if base == "line" and entry.curve is None:
        base = "point"  # nothing is drawn yet
    elif base == "line":
        line, is_closed = _line(entry.curve, obj, scale)
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
        faces=field_faces.of_field(obj, entry).tolist() if base == "faces" else [],
        becomes=_line(entry.becomes, obj, scale)[0] if field_rows.becomes_another(entry) else [],
        end=_end(entry, scale) if field_rows.varies(entry) else None,
        along_surface=entry.along_surface,
    )


def _line(curve, obj, scale):
    points, is_closed = curve_lines.points_of(curve, obj)
    return [tuple(point) for point in (points * scale).tolist()], is_closed


def _end(entry, scale):
    return FieldEnd(
        as_stored(entry.extent_end) * scale,
        as_stored(entry.falloff_end),
        tuple(as_stored(part) * scale for part in entry.shift_end),
    )
