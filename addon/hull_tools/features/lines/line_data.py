# SPDX-License-Identifier: GPL-3.0-or-later
"""Which lines a hull shows: from hull_io's LineChoice to Object.hull.lines, and back."""

from ....hull_io.hull_data import LINE_KINDS, CutPlane, LineChoice
from ...bridge.blender.units import as_stored

_LENGTHS = ("waterline_spacing", "buttock_spacing", "frame_spacing")
_AS_THEY_ARE = ("station_count", "stations", "waterlines", "buttocks", "diagonals")


def give_lines(lines, choice, scale):
    """To an Object.hull.lines without planes; scale: metres of Blender's unit."""
    for kind in LINE_KINDS:
        setattr(lines, f"show_{kind}", kind in choice.shown)
    for name in _LENGTHS:
        setattr(lines, name, getattr(choice, name) / scale)
    for name in _AS_THEY_ARE:
        setattr(lines, name, getattr(choice, name))
    lines.stations_in = choice.stations_in.upper()
    for plane in choice.planes:
        entry = lines.planes.add()
        entry.name, entry.is_shown = plane.name, plane.shown
        entry.normal = plane.normal
        entry.point = [part / scale for part in plane.point]


def take_lines(lines, scale):
    """The LineChoice of an Object.hull.lines."""
    choice = LineChoice(
        shown=tuple(kind for kind in LINE_KINDS if getattr(lines, f"show_{kind}")),
        stations_in=lines.stations_in.lower(),
        planes=[
            CutPlane(
                plane.name,
                tuple(as_stored(part) for part in plane.normal),
                tuple(as_stored(part) * scale for part in plane.point),
                plane.is_shown,
            )
            for plane in lines.planes
        ],
    )
    for name in _LENGTHS:
        setattr(choice, name, as_stored(getattr(lines, name)) * scale)
    for name in _AS_THEY_ARE:
        setattr(choice, name, getattr(lines, name))
    return choice
