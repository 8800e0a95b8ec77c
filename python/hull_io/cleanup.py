# SPDX-License-Identifier: GPL-3.0-or-later
"""What is mended in a file's faces and tags, and how the user hears of it.

Mended, with a note each: points repeated one after another in a face (one is kept; a face of fewer
than 3 points is left out), faces that still touch a point twice (left out), a face with exactly the
points of an earlier one (left out; of two in different layers the one of the shell stays). Tags
that fit no face (creases that are no edge of a face) are dropped without a note: they mean
nothing. Everything else, such as edges of three faces, is left as it is for the mesh check.
"""

from .hull_data import edge_key, face_edges


def listed(indices, limit=8):
    """Indices for a sentence: all of them, or the first few and how many more."""
    shown = ", ".join(str(index) for index in indices[:limit])
    more = len(indices) - limit
    return f"{shown} and {more} more" if more > 0 else shown


def without_repeats(face):
    """The face with each run of one point (also around the end) reduced to a single one."""
    return [point for point, following in zip(face, face[1:] + face[:1]) if point != following]


def clean_faces(faces, face_layers, layers):
    """Faces of 3 or more distinct points, no two alike.

    Returns (faces, face_layers, notes); the order of what stays is kept.
    """
    reduced, too_small, pinched, doubled = [], [], [], []
    cleaned = [without_repeats(face) for face in faces]
    kept_by_points = {}
    for index, face in enumerate(cleaned):
        distinct = frozenset(face)
        if len(distinct) < 3:
            too_small.append(index)
            continue
        if len(distinct) < len(face):
            pinched.append(index)
            continue
        if len(face) < len(faces[index]):
            reduced.append(index)
        earlier = kept_by_points.setdefault(distinct, index)
        if earlier != index:
            in_shell = [layers[face_layers[which]].in_hydrostatics for which in (earlier, index)]
            if in_shell == [False, True]:
                kept_by_points[distinct] = index
                doubled.append(earlier)
            else:
                doubled.append(index)
    kept = sorted(kept_by_points.values())
    notes = [
        f"{text}: face {listed(indices)} of the file."
        for text, indices in (
            ("Repeated points were taken out", reduced),
            ("Left out for having fewer than 3 different points", too_small),
            ("Left out for touching a point twice", pinched),
            ("Left out for having the points of another face", doubled),
        )
        if indices
    ]
    return [cleaned[index] for index in kept], [face_layers[index] for index in kept], notes


def creases_of_faces(pairs, faces):
    """The distinct pairs that are an edge of a face, each with its smaller index first."""
    edges = {edge_key(a, b) for face in faces for a, b in face_edges(face)}
    return sorted({edge_key(a, b) for a, b in pairs} & edges)
