# SPDX-License-Identifier: GPL-3.0-or-later
"""A fast RoRo vessel: twin screws under a pram stern with a skeg, bulbous bow, knuckled side.

Eight rows of points run along the ship, from the centre plane to the main deck: three that are the
flat bottom amidships, the bulb forward and the skeg aft; two round the bilge; two up the side, the
upper one the flat side's knuckle; the main deck, forward of amidships the knuckle of the
forecastle, whose deck edge is a ninth row.
"""

from .mesh import Mesh

LENGTH, HALF_BEAM, DRAFT, DEPTH = 190.0, 14.5, 7.0, 15.5

# Sections from the transom to the last one before the stem, closer where the ends turn.
STATIONS = (-4.0, 7.0, 19.0, 35.0, 54.0, 76.0, 99.0, 121.0, 142.0, 158.0, 171.5, 182.0)
# The section where the bulb's neck meets the stem: its points lean forward from the fourth on.
NECK = (188.5, 188.5, 188.5, 188.6, 190.1, 191.5, 193.15, 194.3, 195.7)
# How far the points of the two sections before it lean with the stem.
RAKE = {
    -2: (0.0, 0.0, 0.0, 0.0, 0.2, 0.5, 0.85, 1.2, 1.6),
    -1: (0.0, 0.0, 0.0, 0.0, 0.5, 1.25, 2.1, 3.05, 4.0),
}
# The bulb's nose: two points of valence 3 on each side close it, where its two rows end.
NOSE = ((195.5, 0.0, 1.9), (195.5, 1.3, 1.9), (195.5, 1.3, 5.4), (195.5, 0.0, 5.4))

# y and z of the rows at the sections; made fair row by row, with the flats held.
# fmt: off
BREADTHS = [
    [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
    [0.94, 0.78, 0.51, 0.44, 1.77, 6.37, 7.53, 5.7, 3.4, 2.2, 1.61, 1.54, 1.55],
    [2.81, 1.96, 1.05, 1.31, 5.05, 10.8, 11.26, 8.5, 5.3, 3.25, 2.25, 1.92, 1.75],
    [6.93, 5.5, 4.83, 6.1, 10.01, 13.2, 13.13, 10.65, 7.09, 4.52, 2.73, 1.35, 0],
    [12.21, 12.77, 13.2, 13.68, 14.26, 14.5, 14.24, 12.55, 9.13, 6.16, 3.7, 1.65, 0],
    [13.21, 13.9, 14.33, 14.5, 14.5, 14.5, 14.5, 13.89, 11.35, 8.45, 5.5, 2.6, 0],
    [13.61, 14.21, 14.5, 14.5, 14.5, 14.5, 14.5, 14.5, 14.5, 12.58, 9.35, 5.47, 0],
    [13.81, 14.29, 14.5, 14.5, 14.5, 14.5, 14.5, 14.5, 14.5, 13.2, 10.3, 6.3, 0],
    [None, None, None, None, None, None, None, 14.5, 14.5, 13.6, 11.1, 7.1, 0],
]
HEIGHTS = [
    [6.64, 5.4, 1.17, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.5],
    [6.65, 5.4, 1.57, 0.09, 0, 0, 0, 0, 0, 0, 0, 0.2, 0.5],
    [6.67, 6.06, 4.93, 2.51, 0.44, 0, 0, 0, 0, 0, 1.45, 3.2, 5],
    [6.73, 6.13, 5.0, 3.32, 1.51, 0.82, 0.85, 1.15, 1.93, 3.13, 4.57, 5.76, 6.4],
    [7.41, 6.85, 5.98, 4.6, 3.18, 2.44, 2.49, 3.17, 4.52, 5.95, 7.3, 8.25, 8.8],
    [8.81, 8.4, 7.8, 6.86, 5.74, 4.91, 4.89, 5.76, 7.5, 9.1, 10.4, 11.1, 11.4],
    [11.81, 11.35, 10.75, 9.85, 8.7, 7.4, 7.65, 9.1, 11.5, 13.3, 14.3, 14.6, 14.75],
    [15.5, 15.5, 15.5, 15.5, 15.5, 15.5, 15.5, 15.5, 15.6, 15.85, 16.25, 16.75, 17.2],
    [None, None, None, None, None, None, None, 15.75, 16.85, 18.4, 19.6, 20.16, 20.3],
]
# fmt: on
# The section whose point of the flat side's knuckle ends it, within the plane of the side: its
# neighbours below are in the plane, too, up to the next section, so that it fades without an angle.
FLAT_SIDE_KNUCKLE = 5
# Two points of the side between that end and the deck, from that section on: the end is where the
# points around it draw it, which without them is further up.
SIDE = ((76.0, HALF_BEAM, 9.3), (99.0, HALF_BEAM, 10.4))
# The section at whose deck edge the forecastle and its knuckle begin.
FORECASTLE = 6

FEATURES = {
    "bulbous bow": "three rows run out to the nose past the neck, a stem point of valence 4",
    "skeg": "the lower rows come together on the centre plane aft, to 0.6 m of half breadth",
    "pram-type stern": "outside of the skeg the rows of the bottom rise straight to the transom",
    "forecastle knuckle": "the main deck's row is a crease from the forecastle's break to the stem",
    "flat-side knuckle": "the row below is a crease: it bounds the flat side, and comes down aft "
    "towards the waterline, where it fades out",
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
    ("waterline", "dip", 2, {"x": (-4, 10), "z": (6.4, 6.8)}, "the flat run before the transom"),
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
    ("buttock", "dip", 1, {"x": (85, 112), "z": (0, 0.4)}, "flat bottom"),
    ("feature", "dip", 1, {"x": (70, 115)}, "flat bottom and the straight part of the deck edge"),
    # Bow: bulb, neck, hollow forefoot, flare.
    ("station", "inflection", 1, {"x": (138, 190), "z": (2, 7.5)}, "forefoot or bulb, then flare"),
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
    ("waterline", "dip", 1, {"x": (168, 175), "z": (11, 13)}, "straight from shoulder to full bow"),
    ("buttock", "inflection", 1, {"x": (115, 171), "z": (4, 8.5)}, "forefoot to flare"),
    (
        "buttock",
        "inflection",
        1,
        {"x": (130, 183), "y": (2, 14), "z": (9, 12)},
        "up to the knuckle",
    ),
    (
        "buttock",
        "inflection",
        2,
        {"x": (179, 191), "y": (0, 2), "z": (3, 11)},
        "bulb, then the stem",
    ),
    ("feature", "inflection", 2, {"x": (188, 194), "y": (0, 0)}, "bulb, neck, stem"),
    ("feature", "inflection", 1, {"x": (140, 160), "y": (13, 14.5)}, "sweep up to the forecastle"),
    # Reflection lines: where lights meet or part.
    ("reflection", "wave", 1, {"x": (-2, 8), "y": (0, 3.2), "z": (5, 6.7)}, "the skeg runs out"),
    ("reflection", "wave", 1, {"x": (140, 147), "z": (2, 3)}, "the lights of bow and side part"),
    ("reflection", "wave", 1, {"x": (130, 135), "y": (14.4, 14.5)}, "the flat side's end"),
    (
        "reflection",
        "wave",
        2,
        {"x": (190, 195), "y": (0, 0.6), "z": (1, 6)},
        "round the bulb's nose",
    ),
]


def sections():
    """The rows of points from the keel to the deck edge, section by section."""
    for k in range(len(STATIONS) + 1):
        last = k == len(STATIONS)
        lean = RAKE.get(k - len(STATIONS), (0.0,) * 9)
        count = 9 if k > FORECASTLE else 8
        along = NECK if last else [STATIONS[k] + part for part in lean]
        yield [(along[j], BREADTHS[j][k], HEIGHTS[j][k]) for j in range(count)]


def strip_of_side(mesh, aft, forward):
    """The faces between two columns of the side, one of which may have a point more."""
    if len(aft) == len(forward):
        mesh.strip(aft, forward)
    else:
        mesh.face(*aft, *reversed(forward))


def make(hull_io):
    mesh = Mesh()
    rows = [mesh.row(section) for section in sections()]
    rows[FORECASTLE].append(rows[FORECASTLE][7])
    side = [[]] * FLAT_SIDE_KNUCKLE + [[point] for point in mesh.row(SIDE)]
    side += [[]] * (len(rows) - len(side))
    for k, (aft, forward) in enumerate(zip(rows, rows[1:])):
        mesh.strip(aft[:7], forward[:7])
        mesh.strip(aft[7:], forward[7 : len(aft)])
        strip_of_side(mesh, [aft[6], *side[k], aft[7]], [forward[6], *side[k + 1], forward[7]])
    nose = mesh.row(NOSE)
    mesh.strip(rows[-1][:4], nose)
    mesh.face(*nose)
    mesh.transom(rows[0])
    mesh.crease([row[6] for row in rows[FLAT_SIDE_KNUCKLE:]])
    mesh.crease([row[7] for row in rows[FORECASTLE:]])
    mesh.deck([row[-1] for row in rows])
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
