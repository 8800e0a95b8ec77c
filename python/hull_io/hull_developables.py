# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a hull file that tells which rows of faces are developable regions.

    "developables": [{"faces": [face, ...], "warp": deg/m, "distance": m, "keep": true}, ...]

warp: the most of any ruling; distance: how far knuckles may move for it; keep: whether the region
is kept so while points are moved. No face is in two.
"""

from .hull_data import Developable, edge_key, face_edges
from .limits import LONGEST_DIMENSION

KEY = "developables"
_REQUIRED = ("faces", "warp", "distance")
_KEYS = (*_REQUIRED, "keep")
LARGEST_WARP, LEAST_WARP, LEAST_DISTANCE = 90.0, 1e-4, 1e-6


def parsed(check, content, face_count):
    """The list of Developable in the content of a hull file; raises HullFileError."""
    seen = set()
    return [
        _region(check, entry, f"{KEY}[{index}]", face_count, seen)
        for index, entry in enumerate(check.list(content.get(KEY, []), KEY))
    ]


def _region(check, value, where, face_count, seen):
    entries = check.object(value, where, _KEYS)
    for key in _REQUIRED:
        if key not in entries:
            raise check.error(f"{where}.{key}", "it is missing", "add it")
    faces = check.faces_apart(entries["faces"], f"{where}.faces", face_count, seen)
    return Developable(
        list(faces),
        check.number(entries["warp"], f"{where}.warp", LEAST_WARP, LARGEST_WARP),
        check.number(entries["distance"], f"{where}.distance", LEAST_DISTANCE, LONGEST_DIMENSION),
        check.flag(entries.get("keep", True), f"{where}.keep"),
    )


def between_knuckles(data, faces):
    """Developables, not kept, of faces of a HullData: those that meet at edges that are no creases
    are one region."""
    creases = {edge_key(a, b) for a, b in data.creases}
    beyond = {}
    for face in faces:
        for a, b in face_edges(data.faces[face]):
            if edge_key(a, b) not in creases:
                beyond.setdefault(edge_key(a, b), []).append(face)
    neighbours = {face: set() for face in faces}
    for at_edge in beyond.values():
        for face in at_edge:
            neighbours[face].update(at_edge)
    regions, seen = [], set()
    for face in faces:
        if face in seen:
            continue
        region, open_ones = [], [face]
        seen.add(face)
        while open_ones:
            region.append(open_ones.pop())
            further = neighbours[region[-1]] - seen
            seen |= further
            open_ones.extend(further)
        regions.append(Developable(sorted(region), keep=False))
    return regions


def entries(data):
    """What a hull file says of a HullData's developable regions, by its key, if there are."""
    found = [
        {
            "faces": [int(face) for face in region.faces],
            "warp": float(region.warp),
            "distance": float(region.distance),
            "keep": bool(region.keep),
        }
        for region in data.developables
    ]
    return {KEY: found} if found else {}
