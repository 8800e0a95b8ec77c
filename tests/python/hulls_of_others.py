# SPDX-License-Identifier: GPL-3.0-or-later
"""Copies of a hull as other programs might have left it: noisy, with both sides, to starboard, of
triangles, torn apart, with a wall inside, pinched at a point."""

import copy
import zlib

import numpy as np

NOISES = (1e-9, 1e-8, 1e-7, 1e-6, 1e-5)  # of the size

# How much of the volume may change. Triangles and torn borders make another surface of coarse
# meshes.
_CHANGES = {"of triangles": 0.15, "torn": 0.1}
_CHANGE_BY_NOISE, _ROUNDING = 30.0, 1e-6
_CHANGES_OF_ONE = {
    # Its faces in the centre plane are left out, and their edges become knuckles.
    ("Parent 22_Oort.fbm", "whole"): 1e-3,
    # Four points of its centre line are up to 0.03 mm off the plane, where the sides do not join.
    # The ends of these slits are corners, which the surface passes through.
    ("ellipsoid321.fbm", "whole"): 1e-3,
}
# Her keel is up to 8 cm off the centre plane: both sides leave her open, which is told by the
# volume from breadths.
OPEN_KEEL = ("50dragger.fbm", "whole")
# Of a dock cut through deck and end the one part is a sheet that its closing doubles: with the
# noise of single precision its volume is below zero. Merging the points along the cut mends it.
REFUSED = {("pdock+weght_symm.fbm", "torn"): "torn off another body.*points that are there twice"}


def most_faces(kind):
    """Of copies with more faces STEP and IGES take long: triangles have a patch each."""
    return 130 if kind == "of triangles" else 1100


def change_of_volume(name, kind):
    """How much of the original's volume that of a copy may differ."""
    if (name, kind) in _CHANGES_OF_ONE:
        return _CHANGES_OF_ONE[name, kind]
    noise = float(kind.split()[1]) if kind.startswith("noise") else 0.0
    return _CHANGES.get(kind, _CHANGE_BY_NOISE * noise + _ROUNDING)


def chosen(names, kinds, few):
    """Pairs (name, kind): so many of each name that all kinds come in turn; all where few is 0."""
    for index, name in enumerate(names):
        wanted = [kinds[(few * index + k) % len(kinds)] for k in range(few)] if few else kinds
        yield from ((name, kind) for kind in wanted)


def chosen_copies(names, copies_of, few):
    """The same of the hulls of these names and their copies by kind, copies_of(name), and all that
    are REFUSED, or open."""
    some = list(chosen(names, list(copies_of(names[0])), few)) if names else []
    special = [pair for pair in (*REFUSED, OPEN_KEEL) if pair[0] in names]
    return some + [pair for pair in special if pair not in some]


def copies(data, seed, mirror_faces):
    """{name: HullData}; the same for the same arguments. mirror_faces: that of hull_io."""
    made = {f"noise {noise:g}": noisy(data, noise, seed) for noise in NOISES}
    made["whole"] = whole(copy.deepcopy(data), mirror_faces)
    for make in (to_starboard, of_triangles, torn, with_a_wall, pinched):
        made[make.__name__.replace("_", " ")] = make(copy.deepcopy(data))
    return made


def noisy(data, noise, seed):
    random = np.random.default_rng([seed, zlib.crc32(data.name.encode())])
    data = copy.deepcopy(data)
    size = float(np.ptp(data.points, axis=0).max())
    data.points += noise * size * random.uniform(-1.0, 1.0, data.points.shape)
    return data


def whole(data, mirror_faces):
    if data.half:
        mirror_faces(data, range(len(data.faces)))
        data.half = False
    return data


def to_starboard(data):
    data.points[:, 1] *= -1.0
    data.faces = [face[::-1] for face in data.faces]
    return data


def of_triangles(data):
    pieces = [
        ([face[0], a, b], layer)
        for face, layer in zip(data.faces, data.face_layers)
        for a, b in zip(face[1:], face[2:])
    ]
    data.faces, data.face_layers = [face for face, _ in pieces], [layer for _, layer in pieces]
    return data


def torn(data):
    """Parted amidships: the faces further forward have points of their own."""
    middle = 0.5 * (data.points[:, 0].min() + data.points[:, 0].max())
    forward = [i for i, face in enumerate(data.faces) if data.points[face, 0].mean() > middle]
    aft = {point for i, face in enumerate(data.faces) if i not in set(forward) for point in face}
    shared = sorted({point for i in forward for point in data.faces[i]} & aft)
    image = {point: len(data.points) + k for k, point in enumerate(shared)}
    data.points = np.vstack([data.points, data.points[shared]])
    for i in forward:
        data.faces[i] = [image.get(point, point) for point in data.faces[i]]
    edges = {frozenset(pair) for face in data.faces for pair in zip(face, face[1:] + face[:1])}
    both = [(image.get(a, a), image.get(b, b)) for a, b in data.creases]
    data.creases = sorted(
        {tuple(sorted(p)) for p in (*data.creases, *both) if frozenset(p) in edges}
    )
    data.corners = sorted({*data.corners, *(image[p] for p in data.corners if p in image)})
    for name in ("deck_edge", "shown_rows"):
        setattr(data, name, [pair for pair in getattr(data, name) if frozenset(pair) in edges])
    return data


def merged(data):
    """Points at the same place are one again, as Merge by Distance makes them."""
    places = np.round(data.points, 6)
    _, first, number = np.unique(places, axis=0, return_index=True, return_inverse=True)
    number = number.reshape(-1)
    data.points = data.points[first]
    data.faces = [[int(number[point]) for point in face] for face in data.faces]
    data.creases = sorted({tuple(sorted(int(number[p]) for p in pair)) for pair in data.creases})
    data.corners = sorted({int(number[point]) for point in data.corners})
    return data


def with_a_wall(data):
    """A plate on an inner edge that is not on the centre plane, as a web frame on the shell."""
    users = {}
    for face in data.faces:
        for a, b in zip(face, face[1:] + face[:1]):
            users.setdefault(tuple(sorted((a, b))), []).append(face)
    inner = [edge for edge, at_edge in sorted(users.items()) if len(at_edge) == 2]
    inner = [e for e in inner if np.ptp(data.points[list(e)], axis=0).max() > 0.0]
    edge = max(inner, key=lambda e: np.abs(data.points[list(e), 1]).min())
    inwards = 0.2 * data.points[list(edge)] * [0.0, 1.0, 0.0]
    data.points = np.vstack([data.points, data.points[list(edge)] - inwards])
    data.faces.append([edge[0], edge[1], len(data.points) - 1, len(data.points) - 2])
    data.face_layers.append(data.face_layers[0])
    return data


def pinched(data):
    """A triangle that touches the hull in its highest point only."""
    top = int(np.argmax(data.points[:, 2]))
    size = float(np.ptp(data.points, axis=0).max())
    x, y, z = data.points[top]
    data.points = np.vstack(
        [
            data.points,
            [(x + 0.01 * size, y, z + 0.02 * size), (x - 0.01 * size, y, z + 0.02 * size)],
        ]
    )
    data.faces.append([top, len(data.points) - 2, len(data.points) - 1])
    data.face_layers.append(data.face_layers[0])
    return data
