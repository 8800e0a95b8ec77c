# SPDX-License-Identifier: GPL-3.0-or-later
"""Making the other side of faces, mirrored on the centre plane y = 0."""

import numpy as np

from .hull_data import KEPT_IN, edge_key, face_edges
from .hull_ties import renumbered

# Points nearer to the centre plane than this part of the hull's size, the diagonal of its box, are
# shared by both sides: hull_native.tolerances.ON_CENTRE_PLANE.
ON_CENTRE_PLANE = 1e-6
# What is this near to it, but not on it, was meant to be: hull_native.tolerances.NEAR_CENTRE_PLANE.
NEAR_CENTRE_PLANE = 1e-4
# Keel, stem and stern so near are the centre line: hull_native.tolerances.AT_CENTRE_LINE.
AT_CENTRE_LINE = 1e-3


def put_on_centre_plane(data):
    """Put points of a HullData that are on the centre plane but for noise at y = 0 exactly, in
    place; returns how many were not."""
    near = _are_on_centre_plane(data.points) & (data.points[:, 1] != 0.0)
    data.points[near, 1] = 0.0
    return int(near.sum())


def _are_on_centre_plane(points):
    size = float(np.linalg.norm(np.ptp(points, axis=0))) if len(points) else 0.0
    return np.abs(points[:, 1]) <= ON_CENTRE_PLANE * size


def mirror_faces(data, face_indices):
    """Add the mirror image of some faces of a HullData, in place; the rest stays as it is.

    Faces in the centre plane, which would be walls inside, are left out of it: flats of faces must
    not be there yet.
    Points on the centre plane are shared (and put at y = 0 exactly); tags are mirrored too. Edges
    of these faces that lie in the centre plane become creases: they were borders of a half, which
    are creases, and the surface must not change.
    """
    inside = _in_centre_plane(data, face_indices)
    face_indices = _without(data, inside, face_indices)
    faces = [data.faces[index] for index in face_indices]
    used = sorted({point for face in faces for point in face})
    is_shared = _are_on_centre_plane(data.points)
    image = {}
    new_points = []
    for point in used:
        x, y, z = data.points[point]
        if is_shared[point]:
            data.points[point, 1] = 0.0
            image[point] = point
        else:
            image[point] = len(data.points) + len(new_points)
            new_points.append((x, -y, z))
    creases, rows = set(data.creases), set(data.shown_rows)
    for face in faces:
        for a, b in face_edges(face):
            if image[a] == a and image[b] == b:
                creases.add(edge_key(a, b))
            elif edge_key(a, b) in creases:
                creases.add(edge_key(image[a], image[b]))
            if edge_key(a, b) in rows:
                rows.add(edge_key(image[a], image[b]))
    known = {frozenset(face) for face in data.faces}
    for index, face in zip(face_indices, faces):
        other_side = [image[point] for point in face][::-1]
        if frozenset(other_side) not in known:
            data.faces.append(other_side)
            data.face_layers.append(data.face_layers[index])
    for group, name in ((data, "corners"), (data, "locked"), *((data.kept, k) for k in KEPT_IN)):
        points = getattr(group, name)
        setattr(group, name, sorted({*points, *(image[p] for p in points if p in image)}))
    for group in data.groups:
        group.points = sorted({*group.points, *(image[p] for p in group.points if p in image)})
    of_other_side = [tie for tie in data.ties if image.get(tie.point, tie.point) != tie.point]
    data.ties += renumbered(of_other_side, image, reflect=True)
    data.creases, data.shown_rows = sorted(creases), sorted(rows)
    for curve in data.curves:
        curve.with_images(image)
    data.points = np.vstack([data.points, np.array(new_points).reshape(-1, 3)])


def _in_centre_plane(data, face_indices):
    near = _are_on_centre_plane(data.points)
    return {index for index in face_indices if near[data.faces[index]].all()}


def _without(data, left_out, face_indices):
    """Takes faces away; returns the other indices as they are then."""
    kept = [index for index in range(len(data.faces)) if index not in left_out]
    data.faces = [data.faces[index] for index in kept]
    data.face_layers = [data.face_layers[index] for index in kept]
    edges = {edge_key(a, b) for face in data.faces for a, b in face_edges(face)}
    data.creases = [pair for pair in data.creases if edge_key(*pair) in edges]
    data.shown_rows = [pair for pair in data.shown_rows if edge_key(*pair) in edges]
    for curve in data.curves:
        curve.within(edges)
    number = {old: new for new, old in enumerate(kept)}
    return [number[index] for index in face_indices if index in number]
