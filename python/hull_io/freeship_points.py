# SPDX-License-Identifier: GPL-3.0-or-later
"""What points and edges of a control mesh are to FREE!ship, which stores their kinds.

Its kinds follow from creases: none a regular point, one a dart, two a crease, more a corner, and so
is a border point of a single face. Borders are creases, as they are in the files that it saves.
"""

from collections import Counter

from .hull_data import edge_key, face_edges

REGULAR, CREASE, DART, CORNER = range(4)


def border_edges(faces):
    """The set of edges, as edge_key names them, that one face has."""
    counts = Counter(edge_key(a, b) for face in faces for a, b in face_edges(face))
    return {edge for edge, count in counts.items() if count == 1}


def point_kinds(data):
    """A list with the kind of each point of a HullData."""
    borders = border_edges(data.faces)
    creased = Counter(
        point for edge in borders | {edge_key(*edge) for edge in data.creases} for point in edge
    )
    faces = Counter(point for face in data.faces for point in face)
    on_border = {point for edge in borders for point in edge}
    tagged = set(data.corners)
    return [
        _kind(creased[point], point in tagged or faces[point] == 1 and point in on_border)
        for point in range(len(data.points))
    ]


def _kind(crease_count, is_corner):
    if is_corner or crease_count >= 3:
        return CORNER
    return (REGULAR, DART, CREASE)[crease_count]


def irregular_knuckles(data):
    """Indices of points on knuckles and borders beside which FREE!ship's surface is not that of
    Biermann's rules: where a sector between two creases has another number of faces than two, or at
    a corner than one."""
    creased = border_edges(data.faces) | {edge_key(*edge) for edge in data.creases}
    around = {}
    for face in data.faces:
        for before, point, after in zip(face[-1:] + face[:-1], face, face[1:] + face[:1]):
            around.setdefault(point, []).append((edge_key(before, point), edge_key(point, after)))
    kinds = point_kinds(data)
    found = []
    for point, faces in around.items():
        regular = {CREASE: 2, CORNER: 1}.get(kinds[point])
        if regular and any(size != regular for size in _sector_sizes(faces, creased)):
            found.append(point)
    return sorted(found)


def _sector_sizes(faces, creased):
    """How many faces each sector of a point has; faces: the two edges at the point of each."""
    left = list(faces)
    sizes = []
    while left:
        sector = [left.pop()]
        edges = {edge for edge in sector[0] if edge not in creased}
        while joined := [face for face in left if edges & set(face)]:
            left = [face for face in left if face not in joined]
            sector += joined
            edges |= {edge for face in joined for edge in face if edge not in creased}
        sizes.append(len(sector))
    return sizes
