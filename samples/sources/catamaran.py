# SPDX-License-Identifier: GPL-3.0-or-later
"""A catamaran: one slender demihull beside the centre plane, symmetric in itself, mirrored.

The mesh is the whole of the port demihull, outer and inner side; its border is the deck edge alone.
"""

import numpy as np

from .mesh import SHELL, TRANSOM, Mesh, by_station, faired, largest

FEATURES = {
    "demihull off the centre plane": "the mesh is symmetric about y = 4.05 m, mirrored on y = 0",
    "round bilge": "no crease but stem and transom rim; the keel's row is smooth",
    "sharp stem": "a crease from the deck edge that ends at the forefoot",
    "transom stern": "plane and square, the flat of layer Transom, with half a metre in the water",
}
MOST_POINTS = 170

WANTED = [
    ("station", "dip", 1, {"x": (0.0, 24.0), "z": (-0.1, 1.3)}, "bottom flatter than the bilges"),
    ("waterline", "dip", 2, {"x": (18.0, 29.0)}, "on both sides: entrance straight to the stem"),
    ("waterline", "dip", 2, {"x": (2.0, 11.0)}, "on both sides: straight to the transom"),
    ("waterline", "dip", 1, {"x": (0.0, 2.0), "z": (0.9, 1.1)}, "the run's flat bottom"),
    ("buttock", "dip", 1, {"x": (16.0, 26.0)}, "bottom straight between run and forefoot"),
    ("feature", "dip", 1, {"x": (-0.1, 0.1)}, "the transom's flat bottom between its bilges"),
    # Reflection lines.
    (
        "reflection",
        "kink",
        1,
        {"x": (12, 16), "y": (4, 4.1), "z": (0, 0.06)},
        "turns about on the narrow keel",
    ),
    (
        "reflection",
        "wave",
        1,
        {"x": (29.5, 30.4), "z": (0.5, 1.2)},
        "where the stem gets sharp, above the forefoot",
    ),
]

LENGTH, BEAM, DRAFT, DEPTH = 30.5, 11.0, 1.55, 3.6
# Where the demihull's own middle is, and its greatest half-breadth.
CENTRE, HALF_BREADTH = 4.05, 1.45

STATIONS = np.array([0.0, 3.2, 6.4, 9.6, 12.8, 16.0, 19.2, 22.3, 25.1, 27.5, 29.4])
# Half-breadth of the deck and height of the bottom in the demihull's middle, by x.
DECK = {0: 1.38, 6: 1.44, 12: 1.45, 18: 1.40, 22: 1.24, 25.1: 0.99, 27.5: 0.69, 29.4: 0.37}
BOTTOM = {0: 1.02, 4: 0.58, 8: 0.24, 12: 0.066, 16: 0.015, 22: 0.03, 27.5: 0.1, 29.4: 0.22}
DECK_Z = {0.0: 3.6, 12.0: 3.62, 22.0: 3.86, 29.4: 4.28}
# Half-breadths and heights of the rows, in parts of the deck's, by x: a flat run, a round bilge
# amidships, V forward.
ROUND = {
    0.0: ((0, 0.40, 0.80, 0.975, 1.0, 1.0, 1), (0, 0.0, 0.03, 0.16, 0.42, 0.70, 1)),
    9.0: ((0, 0.33, 0.70, 0.90, 0.955, 0.98, 1), (0, 0.0, 0.055, 0.19, 0.42, 0.70, 1)),
    18.0: ((0, 0.26, 0.56, 0.77, 0.875, 0.945, 1), (0, 0.0, 0.08, 0.22, 0.43, 0.70, 1)),
    29.4: ((0, 0.10, 0.23, 0.38, 0.55, 0.76, 1), (0, 0.02, 0.11, 0.25, 0.45, 0.70, 1)),
}
# The stem from above the forefoot to the deck: x and z.
STEM = ((30.28, 0.62), (30.62, 1.24), (30.98, 2.12), (31.45, 3.18), (31.97, 4.42))
STIFFNESS = 10.0


def outer_side():
    """Points (sections, rows, 3) of the outer side, from the keel to the deck, without the stem; y
    from the demihull's middle."""
    parts, bottom = by_station(ROUND, STATIONS), by_station(BOTTOM, STATIONS)[:, None]
    x = np.repeat(STATIONS[:, None], parts.shape[2], axis=1)
    y = parts[:, 0] * by_station(DECK, STATIONS)[:, None]
    z = bottom + parts[:, 1] * (by_station(DECK_Z, STATIONS)[:, None] - bottom)
    # Forward the sections lean as the stem does.
    x = x + 0.4 * np.clip((x - 16.0) / 13.4, 0.0, None) ** 2 * (z - bottom)
    grid = np.stack([x, y, z], axis=-1)
    for row in range(1, grid.shape[1]):
        end = (0.0, STEM[max(row - 2, 0)][1])
        for axis in (1, 2):
            grid[:, row, axis] = faired([*grid[:, row, axis], end[axis - 1]], STIFFNESS)[:-1]
    grid[:, :, 1] *= HALF_BREADTH / largest([*grid[:, -1, 1], 0.0])
    grid[0, :, 0] = 0.0
    return np.round(grid, 4)


def make(hull_io):
    mesh = Mesh([SHELL, TRANSOM])
    keel, outer, inner = [], [], []
    for section in outer_side():
        keel.append(mesh.point(section[0] + (0.0, CENTRE, 0.0)))
        outer.append([keel[-1], *mesh.row(section[1:] + (0.0, CENTRE, 0.0))])
        inner.append([keel[-1], *mesh.row(section[1:] * (1, -1, 1) + (0.0, CENTRE, 0.0))])
    stem = mesh.row([(x, CENTRE, z) for x, z in STEM])
    # Keel and stem are one line: the forefoot stands for three places of each side's grid.
    ends = [keel[-1], keel[-1], *stem]
    mesh.strips([*outer, ends])
    mesh.strips([ends, *inner[::-1]])
    mesh.crease([keel[-1], *stem])
    add_transom(mesh, outer[0], inner[0])
    deck = [row[-1] for row in outer] + [stem[-1]] + [row[-1] for row in inner[::-1]]
    mesh.deck(deck)
    mesh.flat((-1, 0, 0), 0.0, layer=1)
    return mesh.hull(
        hull_io,
        "Catamaran",
        "designed for this project: a fast passenger catamaran with round bilges",
        length_pp=LENGTH,
        beam=BEAM,
        draft=DRAFT,
        depth=DEPTH,
        water_density=1.025,
    )


def add_transom(mesh, outer, inner):
    """Strips across the demihull, about the keel's point triangles: the bottom is straight there,
    and no face has three points of it."""
    mesh.crease([*outer[::-1], *inner[1:]])
    for a, b, c, d in zip(outer[3:], outer[2:], inner[2:], inner[3:]):
        mesh.face(a, b, c, d, layer=1)
    keel = outer[0]
    mesh.face(outer[2], outer[1], keel, layer=1)
    mesh.face(outer[2], keel, inner[2], layer=1)
    mesh.face(keel, inner[1], inner[2], layer=1)
