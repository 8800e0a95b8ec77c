# SPDX-License-Identifier: GPL-3.0-or-later
"""A research vessel for ice: spoon bow, sloped forefoot, tunnels aft, sides of three planes.

Rows of points run along the ship: three that are the flat bottom amidships, two in the plane of the
flare, two knuckles with the vertical side between them, the main deck and, forward of amidships,
the forecastle deck. Forward the sections lean more and more with the stem.
"""

from math import radians, tan

from .mesh import Mesh

LENGTH, HALF_BEAM, DRAFT, DEPTH = 110.0, 11.5, 7.5, 11.5
# The side leans in by this above the upper knuckle and out below the lower one, tangents.
TUMBLEHOME, FLARE = tan(radians(8.0)), tan(radians(15.0))
# Heights of the knuckles amidships.
LOWER, UPPER = 5.0, 9.0

# Where the sections cross the keel.
STATIONS = (-4.0, 5.0, 14.0, 24.0, 34.0, 46.0, 58.0, 69.0, 78.5, 86.0, 92.0)
# How far the stem is forward of its foot, row by row; and the part of it that sections lean.
STEM_RAKE = (0.0, 0.0, 1.8, 5.4, 9.2, 13.4, 16.4, 18.2, 19.3)
LEAN = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.08, 0.25, 0.5, 0.75)
# The stem from the third row on, in the centre plane: x and z.
STEM = (
    (98.31, 0.67),
    (102.8, 4.75),
    (106.5, 5.75),
    (110.4, 7.6),
    (113.4, 9.78),
    (115.22, 12.9),
    (116.3, 15.8),
)
# Two more points of the stem between its first two here, and the two of valence 3 behind them:
# without them the forefoot could not bend as it does below so flat a stem.
FOREFOOT = ((99.63, 0.0, 1.9), (100.8, 0.0, 3.19), (97.2, 0.75, 1.7), (98.39, 1.02, 3.15))

# y and z of the rows at the sections; made fair row by row, with the flats held.
# fmt: off
BREADTHS = (
    (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0),
    (2.4, 2.09, 1.9, 3.02, 5.58, 7.4, 7.41, 6.4, 4.9, 3.42, 1.89),
    (5.6, 5.39, 5.2, 6.02, 8.07, 9.05, 9.04, 8.5, 7.2, 5.37, 3.24),
    (8.8, 9, 9.2, 9.81, 10.58, 10.58, 10.58, 10.5, 9.21, 7.03, 3.9),
    (10.6, 10.89, 11.01, 11.09, 11.1, 11.1, 11.1, 11.1, 10.43, 8.59, 5.19),
    (11, 11.3, 11.45, 11.5, 11.5, 11.5, 11.5, 11.5, 10.95, 9.51, 6.1),
    (11.1, 11.4, 11.5, 11.5, 11.5, 11.5, 11.5, 11.5, 11.2, 10.04, 6.77),
    (10.75, 11.05, 11.15, 11.15, 11.15, 11.15, 11.15, 11.15, 10.97, 10.62, 8.15),
    (None, None, None, None, None, None, 10.95, 10.7, 10.81, 10.8, 8.42),
)
HEIGHTS = (
    (5.8, 4.19, 2, 0.31, 0, 0, 0, 0, 0, 0, 0),
    (6, 4.49, 2.4, 0.61, 0, 0, 0, 0, 0, 0, 0.15),
    (6.95, 7.01, 5.88, 2.69, 0, 0, 0, 0, 0, 0.6, 1.52),
    (6.3, 5, 3.7, 2.29, 1.16, 1.16, 1.16, 1.16, 1.5, 2.39, 3.97),
    (6.9, 6.3, 5.31, 3.86, 2.5, 2.5, 2.5, 2.5, 3.15, 4.61, 5.6),
    (8.01, 7.18, 6.25, 5.4, 5, 5, 5, 5, 5.56, 6.85, 7.82),
    (9, 9, 9, 9, 9, 9, 9, 9, 9.35, 9.8, 10.07),
    (11.5, 11.5, 11.5, 11.5, 11.5, 11.5, 11.5, 11.61, 11.9, 12.29, 12.61),
    (None, None, None, None, None, None, 13.02, 14.76, 15.42, 15.61, 15.7),
)
# fmt: on
# The planes of the side hold these rows between these sections, both included.
FLARE_PLANE = {3: (4, 7), 4: (4, 7)}
TUMBLEHOME_PLANE = {7: (2, 7), 8: (6, 7)}
# The section at whose deck edge the forecastle begins.
FORECASTLE = 5
# The knuckles end, fading, at these sections: the lower one at both ends, the upper one forward.
LOWER_KNUCKLE, UPPER_KNUCKLE = (2, 8), (0, 8)

FEATURES = {
    "complex stem contour": "sloped forefoot below a raked stem, refined by four points, two of "
    "them of valence 3",
    "tunnelled stern": "the third row is above its neighbours aft",
    "tumblehome": "above the upper knuckle, to the deck edge",
    "forecastle knuckle": "the row of the main deck is a crease from the forecastle's break on",
    "flat side in three parts": "planes of flare, vertical and of tumblehome between two knuckles",
    "flat bottom": "the lowest three rows in the base plane",
    "transom": "plane, a layer of its own with a creased rim",
}
MOST_POINTS = 119
WANTED = [
    # Stern: from the centre plane up into the tunnel and down to its outer lip.
    ("station", "inflection", 2, {"x": (-4, 34), "y": (2.5, 9), "z": (0.5, 7)}, "tunnel"),
    ("station", "dip", 1, {"x": (4, 16), "y": (10, 11), "z": (5, 6.5)}, "up to the straight side"),
    ("station", "dip", 1, {"x": (31, 37), "y": (7, 9), "z": (0.5, 1)}, "the tunnel's end"),
    ("waterline", "inflection", 2, {"x": (1, 34), "y": (2, 9), "z": (0.5, 6.5)}, "tunnel"),
    ("waterline", "dip", 1, {"x": (31, 35), "y": (4, 6), "z": (0, 0.6)}, "the tunnel's end"),
    ("buttock", "inflection", 1, {"x": (7, 28), "z": (2, 5)}, "bottom to the straight run"),
    ("buttock", "inflection", 2, {"x": (7, 20), "y": (11, 11.2)}, "along the side above the bilge"),
    ("feature", "inflection", 2, {"x": (-4, -4)}, "the tunnel in the transom"),
    ("feature", "inflection", 1, {"x": (6, 12), "y": (0, 0)}, "bottom to the straight run"),
    # Midship: flat bottom, sides of three planes.
    ("waterline", "dip", 1, {"x": (38, 70), "y": (9, 11.51)}, "flat side between two shoulders"),
    ("buttock", "dip", 1, {"x": (47, 65), "z": (0, 3.3)}, "flat bottom and flare"),
    ("feature", "dip", 1, {"x": (45, 70)}, "flat bottom and straight knuckles"),
    # Bow: sloped forefoot, spoon, flare.
    ("station", "inflection", 2, {"x": (90, 103), "z": (1.5, 5.3)}, "forefoot to spoon"),
    ("station", "dip", 1, {"x": (74, 92), "z": (0.8, 3)}, "straight frames of the ice belt"),
    (
        "waterline",
        "inflection",
        1,
        {"x": (90, 99), "y": (1, 4), "z": (0, 4.5)},
        "shoulder to forefoot",
    ),
    (
        "waterline",
        "dip",
        1,
        {"x": (85, 93), "y": (3, 4.5), "z": (0, 2.1)},
        "straight to the forefoot",
    ),
    ("waterline", "dip", 1, {"x": (79, 84), "z": (5, 6.5)}, "where the lower knuckle ends"),
    ("waterline", "dip", 1, {"x": (12, 16), "z": (6, 7)}, "where the lower knuckle ends"),
    (
        "buttock",
        "inflection",
        2,
        {"x": (90, 105), "y": (0, 5.5), "z": (1.5, 6)},
        "forefoot to spoon",
    ),
    ("buttock", "dip", 1, {"x": (98, 102), "y": (0, 1), "z": (2, 4)}, "the slope of the forefoot"),
    ("buttock", "dip", 1, {"x": (78, 96), "y": (6, 10.1), "z": (2.5, 5)}, "straight spoon"),
    (
        "buttock",
        "inflection",
        2,
        {"x": (79, 103), "y": (8, 11.1), "z": (6.5, 11.2)},
        "spoon to flare",
    ),
    ("buttock", "dip", 1, {"x": (100, 104), "y": (7, 8), "z": (9, 11)}, "straight flare"),
    ("feature", "inflection", 2, {"x": (98, 106), "y": (0, 0)}, "forefoot to raked stem"),
    ("feature", "inflection", 1, {"x": (56, 62), "z": (12.5, 14)}, "sweep up to the forecastle"),
    ("feature", "inflection", 1, {"x": (78, 83), "z": (14.5, 15.5)}, "tumblehome to flare"),
    # Reflection lines.
    ("reflection", "wave", 1, {"x": (14, 18), "z": (7, 9)}, "where the lower knuckle ends"),
    ("reflection", "wave", 1, {"x": (74, 83), "z": (6.5, 11)}, "where the knuckles end"),
    (
        "reflection",
        "wave",
        1,
        {"x": (86, 91), "y": (5, 7.5), "z": (1.4, 3)},
        "shoulder to forefoot",
    ),
    (
        "reflection",
        "wave",
        2,
        {"x": (97, 99.5), "y": (0, 2.2), "z": (1.5, 3.6)},
        "irregular points of the stem's contour",
    ),
]


def place(row, section):
    """(x, y, z) of a point of the sections before the stem."""
    x = STATIONS[section] + LEAN[section] * STEM_RAKE[row]
    y, z = BREADTHS[row][section], HEIGHTS[row][section]
    if _within(FLARE_PLANE, row, section):
        y = HALF_BEAM - FLARE * (LOWER - z)
    if _within(TUMBLEHOME_PLANE, row, section):
        y = HALF_BEAM - TUMBLEHOME * (z - UPPER)
    return x, y, z


def _within(plane, row, section):
    first, last = plane.get(row, (1, 0))
    return first <= section <= last


def make(hull_io):
    mesh = Mesh()
    count = len(STATIONS)
    rows = [
        mesh.row(place(row, k) for row in range(9 if k > FORECASTLE else 8)) for k in range(count)
    ]
    rows[FORECASTLE].append(rows[FORECASTLE][7])
    foot = rows[-1][0]
    stem = [foot, foot, *mesh.row((x, 0.0, z) for x, z in STEM)]
    for aft, forward in zip(rows, rows[1:]):
        mesh.strip(aft[: len(forward)], forward[: len(aft)])
    mesh.strip(rows[-1][:3], stem[:3])
    mesh.strip(rows[-1][3:], stem[3:])
    low, high, behind_low, behind_high = mesh.row(FOREFOOT)
    before_low, before_high = rows[-1][2], rows[-1][3]
    mesh.face(before_low, before_high, behind_high, behind_low)
    mesh.face(before_low, behind_low, low, stem[2])
    mesh.face(behind_low, behind_high, high, low)
    mesh.face(behind_high, before_high, stem[3], high)
    mesh.transom(rows[0])
    for row, (first, last) in ((5, LOWER_KNUCKLE), (6, UPPER_KNUCKLE)):
        mesh.crease([rows[k][row] for k in range(first, last + 1)])
    mesh.crease([row[7] for row in rows[FORECASTLE:]] + [stem[7]])
    mesh.deck([row[-1] for row in rows] + [stem[8]])
    mesh.flat((0, 0, 1), 0.0)
    mesh.flat((0, 1, 0), HALF_BEAM)
    mesh.flat((0, 1, -FLARE), (HALF_BEAM - FLARE * LOWER) / (1 + FLARE**2) ** 0.5)
    mesh.flat((0, 1, TUMBLEHOME), (HALF_BEAM + TUMBLEHOME * UPPER) / (1 + TUMBLEHOME**2) ** 0.5)
    mesh.flat((-1, 0, 0), -STATIONS[0], layer=1)
    return mesh.hull(
        hull_io,
        "Research vessel",
        "designed for this project, after the ice-going research vessels of the polar institutes",
        length_pp=LENGTH,
        beam=2.0 * HALF_BEAM,
        draft=DRAFT,
        depth=DEPTH,
        water_density=1.025,
    )
