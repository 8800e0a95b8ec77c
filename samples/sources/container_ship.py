# SPDX-License-Identifier: GPL-3.0-or-later
"""A large container ship after the Duisburg Test Case, fitted to its published surface.

A flat bar, two rows of points 0.22 m apart, runs round the whole centre plane: from the transom
under the counter, round the propeller boss, along the keel, round the bulb and up the stem. Within
it, lower rows of points run from the stern aperture forward and end on the bulb; upper ones begin
at the transom. The coordinates were fitted as scripts/fit_samples.py does, and rounded to
millimetres.
"""

from .barred import BarredShip

LENGTH, HALF_BEAM, DRAFT, DEPTH = 355.0, 25.5, 14.5, 34.0
BAR = 0.22

# x and z along the bar: counter, aperture, boss, keel, bulb, notch above it, stem, stem head. The
# line is a B-spline: it turns inside these points.
# fmt: off
CONTOUR = [
    (-6.743, 15.143), (-4.597, 15.087), (1.103, 14.158), (16, 12.419), (15.426, 5.855),
    (8.651, 6.124), (9.304, 4.238), (9.713, 4.467), (20.396, 0), (31.222, 0), (87.964, 0),
    (133.541, 0), (158.049, 0), (197.464, 0), (263.457, 0), (334.367, 0), (350.71, 0.042),
    (356.885, 2.404), (365.532, 5.981), (366.877, 13.15), (361.39, 15.136), (352.821, 12.963),
    (356.171, 19.283), (364.254, 28.515), (366.039, 34),
]
# Sections from aft. Four of the counter, from the bar's to the deck: bottom, bilge, border of the
# flat side, deck edge. Then ten from the boss forward: border of the flat bottom, four round the
# bilge, border of the flat side or knuckle, deck edge.
SECTIONS = [
    [
        (-6.743, 12.09, 15.655), (-6.743, 24.262, 17.224), (-6.743, 25.5, 24.052),
        (-6.743, 25.5, 34),
    ],
    [
        (-0.077, 12.082, 14.817), (2.15, 22.621, 16.056), (2.584, 25.5, 20.766),
        (7.251, 25.5, 34),
    ],
    [
        (10.844, 8.702, 13.546), (15.431, 23.354, 14.114), (18.267, 25.5, 20.076),
        (27.752, 25.5, 34),
    ],
    [
        (14.931, 0.512, 11.872), (28.778, 23.817, 12.353), (32.276, 25.5, 17.967),
        (45.835, 25.5, 34),
    ],
    [
        (10.654, 1.475, 5.569), (18.183, 0.383, 5.426), (22.105, 0.382, 10.504),
        (26.426, 5.417, 10.591), (40.225, 23.71, 11.021), (44.743, 25.5, 16.604),
        (61.952, 25.5, 34),
    ],
    [
        (19.968, 1.378, 0.692), (23.952, 3.639, 2.236), (33.826, 1.152, 8.935),
        (38.156, 8.448, 9.168), (53.892, 23.845, 9.579), (57.675, 25.5, 14.738),
        (78.165, 25.5, 34),
    ],
    [
        (32.967, 1.626, 0), (41.662, 3.376, 0.872), (51.183, 6.923, 6.209),
        (60.729, 14.76, 7.167), (71.13, 24.073, 7.697), (74.792, 25.5, 12.622),
        (100.423, 25.5, 34),
    ],
    [
        (90.704, 2.264, 0), (95.707, 9.2, 0.499), (98.574, 15.773, 0.974),
        (102.757, 20.761, 2.203), (105.35, 25.5, 5.647), (107.36, 25.5, 9.308),
        (143.904, 25.5, 34),
    ],
    [
        (138.292, 21.248, 0), (137.845, 23.071, 0), (138.595, 23.729, 0.721),
        (138.864, 24.687, 1.679), (140.522, 25.5, 3.658), (141.831, 25.5, 6.569),
        (182.723, 25.5, 34),
    ],
    [
        (160.762, 19.207, 0), (160.668, 20.797, 0), (159.522, 22.824, 0.486),
        (158.873, 24.262, 1.688), (157.103, 25.5, 3.227), (155.424, 25.5, 4.628),
        (215.081, 25.5, 34),
    ],
    [
        (199.769, 22.923, 0), (200.391, 24.536, 0), (202.595, 24.926, 1.368),
        (204.013, 25.322, 2.041), (206.971, 25.5, 3.03), (210.124, 25.5, 4.128),
        (278.209, 25.5, 34),
    ],
    [
        (265.556, 0.001, 0), (270.079, 6.388, 0.37), (267.248, 15.055, 1.407),
        (267.34, 21.259, 6.824), (263.165, 24.491, 12.991), (257.134, 25.5, 19.263),
        (271.966, 25.5, 34),
    ],
    [
        (333.778, 0.699, 0), (327.947, 2.857, 0.191), (336.104, 5.371, 11.837),
        (331.098, 8.289, 16.59), (328.398, 17.052, 22.793), (328.461, 24.378, 29.167),
        (340.73, 25.836, 34),
    ],
    [
        (352.234, 1.268, 0.338), (371.635, 6.875, 14.048), (343.846, 0.05, 11.843),
        (351.022, 2.314, 18.822), (354.091, 0.135, 20.964), (362.238, 9.384, 28.536),
        (365.501, 7.655, 34),
    ],
]
# fmt: on
SHIP = BarredShip(
    CONTOUR,
    SECTIONS,
    BAR,
    HALF_BEAM,
    counter=slice(0, 4),
    aperture=slice(6, 2, -1),
    keel=slice(6, 17),
    stem=slice(17, 25),
    flat_bottom=slice(2, 9),
)

FEATURES = {
    "bulbous bow": "four rows end on the contour of the bulb, whose lowest point has valence 2",
    "stern bulb": "three rows end on the aperture; two points of the bar make the propeller boss",
    "flat bottom": "between the bar and a crease, in the base plane",
    "flat side": "above a crease, in the plane of the largest half breadth",
    "flat-side knuckle": "the crease goes on forward of the flat side and fades before the stem",
    "transom": "plane, a layer of its own with a creased rim",
    "flat bar": "two rows of points along the whole centre plane, the outer one a crease",
}
MOST_POINTS = 136
# Full-scale values published with the design.
PUBLISHED = {"displaced_volume": 173467.0, "wetted_surface": 22032.0}
WANTED = [
    # The stern of the original: bulb, tunnel above it, flat counter, bilge.
    ("station", "inflection", 2, {"x": (8, 83), "z": (2, 13)}, "stern bulb to counter, bilge"),
    ("station", "dip", 1, {"x": (83, 105), "z": (1, 3)}, "the bulb's end in the bottom"),
    ("waterline", "inflection", 3, {"x": (9, 106), "z": (0, 13)}, "boss, stern bulb, run"),
    ("waterline", "dip", 1, {"x": (20, 27), "z": (4, 8)}, "the straight side of the stern bulb"),
    ("waterline", "inflection", 1, {"x": (-7, 3), "z": (19, 20)}, "the quarter to the transom"),
    ("buttock", "inflection", 3, {"x": (10, 91), "z": (3.5, 15)}, "bulb, tunnel, flat counter"),
    ("buttock", "inflection", 3, {"x": (-7, 56), "y": (22, 25), "z": (12, 20)}, "bilge aft"),
    ("buttock", "dip", 2, {"x": (-7, 31), "y": (0, 8), "z": (10, 15)}, "the straight counter"),
    ("buttock", "dip", 1, {"x": (80, 90), "y": (22, 23)}, "straight run along the bilge"),
    ("feature", "inflection", 5, {"x": (-4, 13), "y": (0, 0.3)}, "counter, aperture, boss"),
    # Amidships: four points round the bilge are near its arc; flat bottom and side.
    ("station", "dip", 1, {"x": (140, 210), "y": (22, 25)}, "bilge: flatter where a point is"),
    ("waterline", "inflection", 2, {"x": (155, 170), "z": (0, 1)}, "bilge of the middle body"),
    ("waterline", "dip", 1, {"x": (160, 176), "z": (2, 6)}, "flat side between the shoulders"),
    ("buttock", "inflection", 2, {"x": (155, 171), "z": (0, 0.4)}, "bilge of the middle body"),
    ("buttock", "dip", 1, {"x": (160, 273), "z": (0, 2)}, "flat bottom"),
    ("feature", "dip", 1, {"x": (180, 190), "z": (0, 0)}, "flat bottom"),
    # The bow: V below a full deck, bulb and notch, flare to the knuckle.
    ("station", "inflection", 2, {"x": (299, 363), "z": (6, 19)}, "forefoot or bulb, then flare"),
    ("station", "inflection", 1, {"x": (354, 355), "z": (31, 33)}, "bulwark above the knuckle"),
    ("station", "dip", 1, {"x": (290, 355), "z": (0, 3.5)}, "straight V beside the bar"),
    ("station", "dip", 1, {"x": (290, 301), "z": (10, 13)}, "straight V at the shoulder"),
    ("station", "dip", 3, {"x": (345, 355), "z": (14, 18)}, "the sharp stem above the bulb"),
    ("waterline", "inflection", 3, {"x": (250, 366), "z": (0, 15)}, "hollow entrance, bulb"),
    ("waterline", "inflection", 2, {"x": (340, 356), "z": (16, 22)}, "hollow above the bulb"),
    ("waterline", "dip", 1, {"x": (300, 327), "z": (0, 17)}, "straight entrance"),
    ("waterline", "dip", 1, {"x": (351, 353), "z": (17, 23)}, "straight entrance at the stem"),
    ("buttock", "inflection", 1, {"x": (250, 337), "y": (5, 25), "z": (11, 15)}, "V to flare"),
    ("buttock", "inflection", 5, {"x": (336, 358), "z": (11, 27)}, "bulb, notch, flare, knuckle"),
    ("buttock", "dip", 1, {"x": (320, 337), "y": (0, 4), "z": (0, 4)}, "straight forefoot"),
    ("buttock", "dip", 1, {"x": (336, 361), "z": (17, 26)}, "straight flare"),
    ("feature", "inflection", 2, {"x": (358, 360), "y": (0, 0.3)}, "bulb, notch, stem"),
    ("feature", "dip", 1, {"x": (356, 358), "y": (0, 0.3)}, "the bulb's foot"),
    ("feature", "inflection", 1, {"x": (279, 281), "z": (34, 34)}, "where the deck edge leaves"),
]


def make(hull_io):
    mesh, _, _ = SHIP.mesh()
    return mesh.hull(
        hull_io,
        "Container ship",
        "fitted to the surface published of the Duisburg Test Case, at full scale",
        length_pp=LENGTH,
        beam=2.0 * HALF_BEAM,
        draft=DRAFT,
        depth=DEPTH,
        water_density=1.025,
    )
