# SPDX-License-Identifier: GPL-3.0-or-later
"""Turning faces: consistently within a component, and outwards, into the water.

A component is a set of faces joined over edges that exactly two of them share. Edges with three or
more faces join nothing, and a component that can't be turned consistently (a Moebius strip) keeps
one edge turned both ways: both are left for the mesh check to report.

Which side is out? The flux of (0, y, 0) through a component is its volume (on the side y > 0 of a
half hull) not only when it is closed: openings in the centre plane (y = 0), open decks that
are ruled athwartships and flat transoms (no normal in y) add nothing to it. So the sign of this
flux decides, measured from y = 0 for a half hull and from the component's middle for a whole one.
Where it says nothing (a flat deck, bottom or transom that touches nothing else) the faces are
turned away from the middle of the hull; a plate through that middle is turned to port, else
forward, else up.
"""

import numpy as np

from .hull_data import edge_key, face_edges

# Mean |cosine| between normal and athwartships below which a component counts as flat in y.
FLAT = 1e-3


def face_area_vectors(points, faces):
    """Area times unit normal, and centroid of the points, of each face: two (f, 3) arrays."""
    vectors = np.zeros((len(faces), 3))
    centres = np.zeros((len(faces), 3))
    by_size = {}
    for index, face in enumerate(faces):
        by_size.setdefault(len(face), []).append(index)
    for indices in by_size.values():
        corners = points[np.array([faces[index] for index in indices])]
        centre = corners.mean(axis=1, keepdims=True)
        spokes = corners - centre
        centres[indices] = centre[:, 0]
        vectors[indices] = 0.5 * np.cross(spokes, np.roll(spokes, -1, axis=1)).sum(axis=1)
    return vectors, centres


def consistent_components(faces):
    """Components of faces and which faces are to be turned to agree with their component's first.

    Returns a list of components, each a list of (face index, turned).
    """
    users = {}
    for index, face in enumerate(faces):
        for a, b in face_edges(face):
            users.setdefault(edge_key(a, b), []).append((index, a < b))
    turned = {}
    components = []
    for start in range(len(faces)):
        if start in turned:
            continue
        turned[start] = False
        component = [start]
        for index in component:
            for a, b in face_edges(faces[index]):
                pair = users[edge_key(a, b)]
                if len(pair) != 2:
                    continue
                (first, first_way), (second, second_way) = pair
                other = second if first == index else first
                if other not in turned:
                    turned[other] = turned[index] ^ (first_way == second_way)
                    component.append(other)
        components.append([(index, turned[index]) for index in component])
    return components


def _points_inwards(vectors, centres, half, hull_middle):
    """Whether a consistently turned component (area vectors, centres) faces inwards."""
    middle = 0.0 if half else 0.5 * (centres[:, 1].min() + centres[:, 1].max())
    lever = centres[:, 1] - middle
    flux = float(vectors[:, 1] @ lever)
    if abs(flux) > FLAT * float(np.linalg.norm(vectors, axis=1) @ np.abs(lever)):
        return flux < 0
    arms = centres - hull_middle
    outward = float(np.sum(vectors * arms))
    if abs(outward) > FLAT * float(np.linalg.norm(vectors, axis=1) @ np.linalg.norm(arms, axis=1)):
        return outward < 0
    total = vectors.sum(axis=0)
    decisive = [total[1], total[0], total[2]]
    return next((part < 0 for part in decisive if abs(part) > 0.1 * max(map(abs, decisive))), False)


def turn_outwards(points, faces, half):
    """Faces turned consistently and outwards. Returns (new faces, how many were turned).

    points (n, 3); faces: lists of point indices; half: the hull lies at y >= 0 and is mirrored.
    """
    if not faces:
        return [], 0
    vectors, centres = face_area_vectors(points, faces)
    middle = 0.5 * (centres.min(axis=0) + centres.max(axis=0))
    if half:
        middle[1] = 0.0
    result = list(faces)
    count = 0
    for component in consistent_components(faces):
        indices = [index for index, _ in component]
        turned = np.array([turn for _, turn in component])
        signs = np.where(turned, -1.0, 1.0)[:, None]
        inwards = _points_inwards(vectors[indices] * signs, centres[indices], half, middle)
        for index, turn in component:
            if turn != inwards:
                result[index] = faces[index][::-1]
                count += 1
    return result, count
