# SPDX-License-Identifier: GPL-3.0-or-later
"""Developable regions: rows of faces between two knuckles whose rulings have little warp.

A region is a number that its faces have in the mesh, as those of flats have; what it is to be is in
Object.hull.developables, in Blender's units. What moves points for it is developable_keeping.
"""

from dataclasses import dataclass
from math import isfinite

import numpy as np

from ...bridge.mesh import face_numbers
from . import region_entries

ATTRIBUTE = "hull_developable"


@dataclass(frozen=True, eq=False)
class Region:
    """faces (f,) by their indices in the mesh; warp, the most of any ruling, in degrees per unit;
    distance, how far knuckles may move; kept, whether they do while points are moved."""

    number: int
    faces: np.ndarray
    warp: float
    distance: float
    kept: bool


def regions(obj):
    """The Regions of a hull that its mesh has faces of."""
    if not obj.hull.developables:
        return []
    numbers = face_numbers.read(obj.data, ATTRIBUTE)
    known = {entry.region: entry for entry in obj.hull.developables if _is_sound(entry)}
    return [
        Region(
            number,
            np.flatnonzero(numbers == number),
            known[number].warp,
            known[number].distance,
            known[number].kept,
        )
        for number in np.unique(numbers[numbers > 0]).tolist()
        if number in known
    ]


def _is_sound(entry):
    return isfinite(entry.warp) and isfinite(entry.distance) and min(entry.warp, entry.distance) > 0


def mark(obj, faces, warp, distance, kept=True):
    """Makes faces (f,) a region of its own; returns its number. No point is moved."""
    number = region_entries.new_number("developables", _numbers(obj))
    face_numbers.write(obj.data, ATTRIBUTE, faces, number)
    entry = obj.hull.developables.add()
    entry.region, entry.warp, entry.distance, entry.kept = number, warp, distance, kept
    clear_unused(obj)
    return number


def release(obj, faces):
    """These faces are of no developable region any longer."""
    face_numbers.write(obj.data, ATTRIBUTE, faces, 0)
    clear_unused(obj)


def _numbers(obj):
    return set(np.unique(face_numbers.read(obj.data, ATTRIBUTE)).tolist())


def clear_unused(obj):
    """Removes what is known of regions that have no face any longer."""
    region_entries.keep_only(obj.hull.developables, _numbers(obj))
