# SPDX-License-Identifier: GPL-3.0-or-later
"""A coaster: pram stern, flat bottom and flat of side, a raked stem; the port half.

Thirteen sections of eight rows and the stem. The rows: keel, the flat bottom's edge, the end of the
bilge in it, the bilge's middle, its end in the side, the flat side's edge, the side's middle, the
deck edge.
"""

from .mesh import SHELL, TRANSOM, Mesh

FEATURES = {
    "pram stern": "the four aftmost sections: the flat bottom rises straight to the transom",
    "flat bottom and side": "the points of sections amidships lie in them, to the bilge's ends",
    "round bilge": "four rows of one form amidships: a radius of 1.6 m",
    "flared bow": "the upper rows forward stand outside those at the water",
    "transom": "plane, within a crease",
}
MOST_POINTS = 113

_STERN, _BOW = {"x": (-2.6, 26.0)}, {"x": (60.0, 86.5)}
_MIDDLE = {"x": (34.0, 57.0)}
WANTED = [
    ("station", "inflection", 1, _BOW, "from the bilge to the flare of the bow"),
    ("waterline", "inflection", 1, _STERN, "the pram's bottom leaves the bilge"),
    ("waterline", "dip", 1, _MIDDLE, "the flat side between run and entrance"),
    ("waterline", "dip", 1, _BOW, "entrance straight to the shoulder"),
    ("buttock", "inflection", 2, _BOW, "from the bottom's turn to the flare of the bow"),
    ("buttock", "dip", 1, _MIDDLE, "the flat bottom between run and entrance"),
    ("buttock", "dip", 1, _STERN, "the pram's straight bottom"),
    ("feature", "inflection", 1, _BOW, "the stem, below the flare of the bow"),
    ("feature", "dip", 1, {"x": (34.0, 57.0)}, "straight between run and entrance"),
]

LENGTH, BEAM, DRAFT, DEPTH = 84.0, 13.6, 5.2, 7.4

# By section, from aft, the rows' x; forward the sections lean as the stem does.
X = (
    (-2.5,) * 8,
    (4,) * 8,
    (11,) * 8,
    (18.5,) * 8,
    (27,) * 8,
    (35,) * 8,
    (42,) * 8,
    (48.5,) * 8,
    (55,) * 8,
    (61, 61, 61.1, 61.2, 61.3, 61.3, 61.3, 61.3),
    (66.6, 66.9, 67.1, 67.4, 67.6, 67.7, 67.9, 68.1),
    (71.2, 71.7, 72.4, 73.2, 73.7, 73.9, 74.52, 74.51),
    (74.9, 75.6, 77, 78.3, 78.9, 79.1, 79.68, 80.65),
)
# Half-breadths.
Y = (
    (0, 3.566, 4.17, 4.77, 5.1, 5.1, 5.1, 5.1),
    (0, 4.239, 4.913, 5.582, 5.95, 5.95, 5.95, 5.95),
    (0, 4.691, 5.412, 6.126, 6.52, 6.52, 6.52, 6.52),
    (0, 4.912, 5.656, 6.394, 6.8, 6.8, 6.8, 6.8),
    (0, 4.912, 5.656, 6.394, 6.8, 6.8, 6.8, 6.8),
    (0, 4.912, 5.656, 6.394, 6.8, 6.8, 6.8, 6.8),
    (0, 4.912, 5.656, 6.394, 6.8, 6.8, 6.8, 6.8),
    (0, 4.912, 5.656, 6.394, 6.8, 6.8, 6.8, 6.8),
    (0, 4.912, 5.656, 6.394, 6.8, 6.8, 6.8, 6.8),
    (0, 4.2, 5.09, 5.95, 6.41, 6.63, 6.79, 6.8),
    (0, 2.75, 3.68, 4.65, 5.25, 5.54, 6.11, 6.77),
    (0, 1.5, 2.39, 3.15, 3.65, 3.95, 4.74, 5.92),
    (0, 0.65, 1.07, 1.46, 1.71, 1.92, 2.41, 3.94),
)
# Heights above the base line.
Z = (
    (5.08, 5.187, 5.205, 5.535, 6.135, 6.739, 7.42, 8.1),
    (3.62, 3.747, 3.767, 4.136, 4.804, 5.478, 6.664, 7.85),
    (2.15, 2.281, 2.302, 2.695, 3.41, 4.13, 5.875, 7.62),
    (0.84, 0.899, 0.908, 1.314, 2.052, 2.796, 5.133, 7.47),
    (0, 0, 0, 0.406, 1.144, 1.888, 4.6, 7.4),
    (0, 0, 0, 0.406, 1.144, 1.888, 4.6, 7.4),
    (0, 0, 0, 0.406, 1.144, 1.888, 4.6, 7.4),
    (0, 0, 0, 0.406, 1.144, 1.888, 4.6, 7.4),
    (0, 0, 0, 0.406, 1.144, 1.888, 4.6, 7.43),
    (0, 0, 0, 0.41, 1.18, 1.95, 4.7, 7.55),
    (0, 0, 0, 0.43, 1.25, 2.05, 4.9, 7.83),
    (0, 0, 0, 0.46, 1.32, 2.2, 5.05, 8.25),
    (0, 0, 0, 0.49, 1.38, 2.3, 5.35, 8.7),
)
# The stem, x and z, from its foot to the deck.
STEM = (
    (77.8, 0),
    (80.1, 0),
    (81.92, 0.6),
    (82.93, 1.55),
    (83.28, 2.6),
    (83.95, 5.72),
    (86.35, 9.14),
)


def make(hull_io):
    mesh = Mesh([SHELL, TRANSOM])
    rows = [mesh.row(zip(*section)) for section in zip(X, Y, Z)]
    stem = mesh.row([(x, 0.0, z) for x, z in STEM])
    mesh.strips(rows)
    # The stem has a point less than the sections, as the keel's row ends before it, in a face of
    # three corners.
    keel, flat, *_ = rows[-1]
    mesh.strip(rows[-1][1:], stem)
    mesh.face(keel, flat, stem[0])
    add_transom(mesh, rows[0])
    return mesh.hull(
        hull_io,
        "Coaster",
        "designed for this project: a coaster with a pram stern, flat bottom and flat of side",
        length_pp=LENGTH,
        beam=BEAM,
        draft=DRAFT,
        depth=DEPTH,
        water_density=1.025,
    )


def add_transom(mesh, rim):
    """Strips across the transom, from a point of its own above the flat bottom's edge inwards."""
    x, _, top = mesh.points[rim[-1]]
    middle = mesh.point((x, 0.0, top))
    quarter = mesh.point((x, mesh.points[rim[1]][1], top))
    mesh.crease(rim)
    mesh.face(rim[0], middle, quarter, rim[1], layer=1)
    mesh.face(rim[1], quarter, rim[7], rim[2], layer=1)
    mesh.face(rim[2], rim[7], rim[6], rim[3], layer=1)
    # The side is straight: no face has three of its points.
    mesh.face(rim[3], rim[6], rim[5], layer=1)
    mesh.face(rim[3], rim[5], rim[4], layer=1)
