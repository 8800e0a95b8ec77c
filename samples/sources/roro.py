# SPDX-License-Identifier: GPL-3.0-or-later
"""A fast RoRo vessel: twin screws under a pram stern with a skeg, bulbous bow, knuckled side.

Eight rows of points run along the ship, from the centre plane to the deck edge: three that are the
flat bottom amidships, the bulb forward and the skeg aft; two round the bilge; two up the side, the
upper one the knuckle; the deck edge, which climbs to the forecastle.
"""

from .mesh import Mesh

LENGTH, HALF_BEAM, DRAFT, DEPTH = 190.0, 14.5, 7.0, 15.5

# Sections from the transom to the last one before the stem, closer where the ends turn.
STATIONS = (-4.0, 7.0, 19.0, 33.0, 49.0, 66.0, 85.0, 105.0, 124.0, 142.0, 158.0, 171.5, 182.0)
# The section where the bulb's neck meets the stem: its points lean forward from the fourth on.
NECK = (188.5, 188.5, 188.5, 188.6, 190.2, 192.0, 194.2, 195.6)
# How far the points of the two sections before it lean with the stem.
RAKE = {-2: (0.0, 0.0, 0.0, 0.0, 0.2, 0.6, 1.2, 1.6), -1: (0.0, 0.0, 0.0, 0.0, 0.5, 1.5, 3.0, 4.0)}
# The bulb's nose: two points of valence 3 on each side close it, where its two rows end.
NOSE = ((195.5, 0.0, 1.9), (195.5, 1.3, 1.9), (195.5, 1.3, 5.4), (195.5, 0.0, 5.4))

# y and z of the eight rows at the sections; made fair row by row, with the flats held.
# fmt: off
BREADTHS = [
    [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
    [1.1, 0.8, 0.51, 0.57, 1.23, 4.12, 7.56, 7.5, 5.32, 3.4, 2.2, 1.61, 1.54, 1.55],
    [2.81, 1.99, 1.05, 1.18, 3.66, 8.75, 11.7, 10.9, 8.01, 5.3, 3.4, 2.31, 1.94, 1.75],
    [6.67, 5.5, 4.91, 5.89, 8.98, 12.17, 13.62, 12.75, 10.18, 7.09, 4.52, 2.73, 1.35, 0],
    [12.21, 12.77, 13.2, 13.62, 14.12, 14.5, 14.5, 14.02, 12.2, 9.2, 6.3, 3.75, 1.68, 0],
    [13.21, 13.9, 14.33, 14.5, 14.5, 14.5, 14.5, 14.5, 13.7, 11.4, 8.65, 5.78, 2.85, 0],
    [13.61, 14.21, 14.5, 14.5, 14.5, 14.5, 14.5, 14.5, 14.5, 14.5, 13, 10.05, 6, 0],
    [13.81, 14.29, 14.5, 14.5, 14.5, 14.5, 14.5, 14.5, 14.5, 14.5, 13.7, 11.3, 7.3, 0],
]
HEIGHTS = [
    [6.64, 5.62, 0.85, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.5],
    [6.65, 5.76, 1.69, 0.12, 0, 0, 0, 0, 0, 0, 0, 0, 0.2, 0.5],
    [6.66, 6.05, 4.85, 2.89, 0.77, 0, 0, 0, 0, 0, 0.41, 1.59, 3.21, 5],
    [6.73, 6.18, 5.14, 3.54, 1.86, 0.96, 0.77, 0.91, 1.22, 1.93, 3.13, 4.57, 5.76, 6.4],
    [7.41, 6.85, 5.98, 4.77, 3.48, 2.64, 2.36, 2.59, 3.31, 4.52, 6, 7.39, 8.38, 9],
    [8.81, 8.4, 7.8, 6.98, 6.01, 5.21, 4.78, 4.98, 5.96, 7.69, 9.56, 11.03, 11.86, 12.2],
    [11.81, 11.48, 11.03, 10.48, 9.82, 9.2, 8.74, 8.76, 9.82, 12.09, 14.32, 15.73, 16.42, 16.8],
    [15.5, 15.5, 15.5, 15.5, 15.5, 15.5, 15.5, 15.5, 15.79, 16.89, 18.49, 19.66, 20.16, 20.3],
]
# fmt: on
# Sections, by number: the first whose knuckle is a crease. Its points below the knuckle are in the
# plane of the side up to the next section, so that the knuckle begins without an angle.
KNUCKLE_FROM = 6

FEATURES = {
    "bulbous bow": "three rows run out to the nose past the neck, a stem point of valence 4",
    "skeg": "the lower rows come together on the centre plane aft, to 0.6 m of half breadth",
    "pram-type stern": "outside of the skeg the rows of the bottom rise straight to the transom",
    "forecastle knuckle": "the seventh row is a crease to the stem, the side above it steeper",
    "flat-side knuckle": "the same crease bounds the flat side and fades out amidships",
    "flat bottom": "the lowest three rows in the base plane",
    "transom": "plane, a layer of its own with a creased rim",
}
MOST_POINTS = 117
WANTED = [
    # Stern: skeg, root, pram bottom, bilge.
    ("station", "inflection", 2, {"x": (-4, 54), "y": (0, 8), "z": (0, 7)}, "skeg to pram bottom"),
    (
        "station",
        "dip",
        1,
        {"x": (50, 60), "y": (4, 8), "z": (0, 1)},
        "the skeg's end in the bottom",
    ),
    ("waterline", "inflection", 2, {"x": (5, 60), "y": (0, 6.5), "z": (0, 7)}, "round the skeg"),
    ("buttock", "inflection", 1, {"x": (5, 48), "z": (1.5, 7.5)}, "bottom to the straight run"),
    ("waterline", "dip", 1, {"x": (0, 10), "z": (6.4, 6.8)}, "the flat run before the transom"),
    ("buttock", "dip", 1, {"x": (25, 45), "y": (13, 14.5)}, "above the bilge, along the side"),
    (
        "buttock",
        "inflection",
        1,
        {"x": (-4, 9), "y": (12, 14.5)},
        "the quarter's bilge to the transom",
    ),
    (
        "buttock",
        "dip",
        1,
        {"x": (8, 28), "y": (0, 2.5), "z": (1, 6)},
        "the skeg's foot to the pram",
    ),
    ("feature", "inflection", 1, {"x": (8, 16), "y": (0, 0), "z": (2, 5)}, "the skeg's end"),
    # Midship: flat bottom and side.
    ("waterline", "dip", 1, {"x": (70, 90), "y": (14, 14.5)}, "flat side between two shoulders"),
    ("waterline", "dip", 1, {"x": (80, 90), "z": (9, 10)}, "flat side, where the knuckle begins"),
    ("buttock", "dip", 1, {"x": (85, 112), "z": (0, 0.4)}, "flat bottom"),
    ("feature", "dip", 1, {"x": (70, 115)}, "flat bottom and the straight part of the deck edge"),
    # Bow: bulb, neck, hollow forefoot, flare.
    ("station", "inflection", 1, {"x": (138, 190), "z": (2, 7.5)}, "forefoot or bulb, then flare"),
    ("station", "dip", 1, {"x": (145, 163), "z": (5, 7)}, "straight V from the bilge to the flare"),
    ("station", "dip", 2, {"x": (186, 195), "z": (2, 10)}, "sides of the bulb, side of the stem"),
    (
        "waterline",
        "inflection",
        1,
        {"x": (125, 170), "z": (0, 10)},
        "fore shoulder to a fine entrance",
    ),
    ("waterline", "inflection", 1, {"x": (175, 190), "z": (0, 6)}, "entrance to the bulb"),
    ("waterline", "dip", 1, {"x": (180, 186), "z": (6, 8)}, "the neck above the bulb"),
    ("waterline", "dip", 1, {"x": (168, 175), "z": (11, 14.5)}, "shoulder, then the full bow deck"),
    ("buttock", "inflection", 1, {"x": (115, 171), "z": (4, 8.5)}, "forefoot to flare"),
    (
        "buttock",
        "inflection",
        1,
        {"x": (130, 181), "y": (2, 14), "z": (9, 12)},
        "up to the knuckle",
    ),
    (
        "buttock",
        "inflection",
        2,
        {"x": (179, 191), "y": (0, 2), "z": (3, 11)},
        "bulb, then the stem",
    ),
    ("buttock", "dip", 1, {"x": (170, 178), "y": (4, 5), "z": (8, 10)}, "straight flare"),
    ("feature", "inflection", 2, {"x": (188, 194), "y": (0, 0)}, "bulb, neck, stem"),
    ("feature", "inflection", 1, {"x": (140, 160), "y": (13, 14.5)}, "sweep up to the forecastle"),
]


def sections():
    """The rows of points from the keel to the deck edge, section by section."""
    for k in range(len(STATIONS) + 1):
        last = k == len(STATIONS)
        lean = RAKE.get(k - len(STATIONS), (0.0,) * 8)
        along = NECK if last else [STATIONS[k] + part for part in lean]
        yield [(along[j], BREADTHS[j][k], HEIGHTS[j][k]) for j in range(8)]


def make(hull_io):
    mesh = Mesh()
    rows = [mesh.row(section) for section in sections()]
    mesh.strips(rows)
    nose = mesh.row(NOSE)
    mesh.strip(rows[-1][:4], nose)
    mesh.face(*nose)
    mesh.transom(rows[0])
    mesh.crease([row[6] for row in rows[KNUCKLE_FROM:]])
    mesh.deck([row[7] for row in rows])
    mesh.flat((0, 1, 0), HALF_BEAM)
    mesh.flat((0, 0, 1), 0.0)
    mesh.flat((-1, 0, 0), -STATIONS[0], layer=1)
    return mesh.hull(
        hull_io,
        "RoRo vessel",
        "designed for this project, after the fast RoRo vessels of the 1990s and later",
        length_pp=LENGTH,
        beam=2.0 * HALF_BEAM,
        draft=DRAFT,
        depth=DEPTH,
        water_density=1.025,
    )
