# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a hull file that tells which faces are kept flat.

    "flats": [{"faces": [face, ...], "normal": [x, y, z], "offset": m}, ...]

The plane is where normal · point = offset; its normal has length 1. No face is in two.
"""

from .hull_data import Flat
from .limits import FURTHEST_POINT

KEY = "flats"
_KEYS = ("faces", "normal", "offset")
# A normal written with a few digits less than all.
_LENGTH_TOLERANCE = 1e-6


def parsed(check, content, face_count):
    """The list of Flat in the content of a hull file; raises HullFileError."""
    seen = set()
    return [
        _flat(check, entry, f"{KEY}[{index}]", face_count, seen)
        for index, entry in enumerate(check.list(content.get(KEY, []), KEY))
    ]


def _flat(check, value, where, face_count, seen):
    entries = check.object(value, where, _KEYS)
    for key in _KEYS:
        if key not in entries:
            raise check.error(f"{where}.{key}", "it is missing", "add it")
    faces = check.faces_apart(entries["faces"], f"{where}.faces", face_count, seen)
    normal = tuple(
        check.number(part, f"{where}.normal", -1.0, 1.0)
        for part in check.list(entries["normal"], f"{where}.normal", 3)
    )
    if abs(sum(part * part for part in normal) - 1.0) > _LENGTH_TOLERANCE:
        raise check.error(f"{where}.normal", "its length is not 1", "divide it by its length")
    offset = check.number(entries["offset"], f"{where}.offset", -FURTHEST_POINT, FURTHEST_POINT)
    return Flat(list(faces), normal, offset)


def entries(data):
    """What a hull file says of a HullData's flats, by its key."""
    return {
        KEY: [
            {
                "faces": [int(face) for face in flat.faces],
                "normal": [float(part) for part in flat.normal],
                "offset": float(flat.offset),
            }
            for flat in data.flats
        ]
    }
