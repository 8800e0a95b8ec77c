# SPDX-License-Identifier: GPL-3.0-or-later
"""A large container ship after the Duisburg Test Case, fitted to its published surface.

The test case is that of el Moctar, Shigunov & Zorn 2012.

A flat bar, two rows of points 0.22 m apart, runs round the whole centre plane: from the transom
under the counter, round the propeller boss, along the keel, round the bulb and up the stem. Within
it, lower rows of points run from the stern aperture forward and end on the bulb; upper ones begin
at the transom. The coordinates were fitted as scripts/fit_samples.py does, faired, and rounded to
millimetres.
"""

from .barred import BarredShip

LENGTH, HALF_BEAM, DRAFT, DEPTH = 355.0, 25.5, 14.5, 34.0
BAR = 0.22

# x and z along the bar: counter, aperture, boss, keel, bulb, notch above it, stem, stem head. The
# line is a B-spline: it turns inside these points.
# fmt: off
CONTOUR = [
    (-6.743, 15.25), (-3.5, 14.974), (1.671, 14.059), (14.865, 12.67), (16.882, 6.598),
    (8.651, 5.707), (9.304, 4.238), (10.2, 4.423), (19.777, 0), (36, 0), (82, 0),
    (124, 0), (162, 0), (201, 0), (250, 0), (338.277, 0), (349.066, 0),
    (360.406, 3.271), (367.063, 8.869), (365.322, 14.921), (356.528, 14.208), (353.294, 14.358),
    (358.807, 22.322), (364.31, 28.76), (366.602, 34),
]
# Sections from aft. Four of the counter, from the bar's to the deck: bottom, bilge, border of the
# flat side, deck edge. Then ten from the boss forward: border of the flat bottom, four round the
# bilge, border of the flat side or knuckle, deck edge.
SECTIONS = [
    [
        (-6.743, 13.5, 15.502), (-6.743, 25.5, 17.935), (-6.743, 25.5, 26.912),
        (-6.743, 25.5, 34),
    ],
    [
        (0.841, 14.5, 14.795), (5.74, 25.459, 16.743), (3.295, 25.5, 25.267),
        (7.638, 25.5, 34),
    ],
    [
        (15.034, 11.5, 13.021), (11.452, 25.344, 15.213), (19.027, 25.5, 23.056),
        (26.92, 25.5, 34),
    ],
    [
        (7.139, 1.61, 13.169), (39.202, 25.456, 11.004), (26.478, 25.5, 21.46),
        (49.252, 25.5, 34),
    ],
    [
        (9.5, 1.538, 4.897), (20.092, 0.35, 5.446), (18.296, 0.25, 11.53),
        (28.658, 4.83, 10.016), (38.526, 25.46, 11.529), (44.251, 25.5, 19.06),
        (62.753, 25.5, 34),
    ],
    [
        (26.689, 2.963, 0.857), (33.152, 3.419, 5.502), (26.924, 0.54, 9.988),
        (52.87, 14.437, 7.708), (43.889, 25.291, 11.93), (61.652, 25.5, 16.675),
        (75.387, 25.5, 34),
    ],
    [
        (28.624, 2.18, 0), (50.407, 5.208, 2.57), (53.024, 8.846, 7.312),
        (71.188, 20.4, 6.446), (72.138, 25.5, 9.807), (78.507, 25.5, 14.434),
        (102.758, 25.5, 34),
    ],
    [
        (86.505, 2.473, 0), (98.901, 11.749, 0.205), (89.489, 17.165, 2.774),
        (97.267, 22.249, 4.268), (100.533, 25.5, 7.077), (104.701, 25.5, 11.229),
        (142.111, 25.5, 34),
    ],
    [
        (133.399, 16, 0), (126.748, 18.2, 0), (129.535, 21.259, 0),
        (135.306, 24.241, 1.402), (133.656, 25.5, 3.919), (132.431, 25.5, 6.907),
        (175.377, 25.5, 34),
    ],
    [
        (162.94, 21, 0), (163.46, 21.974, 0), (163.505, 22.677, 0),
        (161.995, 24.516, 1.159), (162.149, 25.5, 3.505), (162.435, 25.5, 3.964),
        (222.901, 25.5, 34),
    ],
    [
        (202.471, 19, 0), (202.733, 22.924, 0), (208.282, 25.5, 2.067),
        (210.145, 25.5, 3.534), (201.98, 25.5, 3.581), (205.036, 25.5, 6.632),
        (270.457, 25.5, 34),
    ],
    [
        (258.655, 4.847, 0), (254.943, 11.15, 0), (258.645, 15.724, 1.533),
        (261.378, 21.027, 5.536), (255.501, 25.5, 11.412), (261.477, 25.5, 20.299),
        (282.718, 25.5, 34),
    ],
    [
        (327.539, 1.84, 0), (329.381, 3.49, 4), (324.261, 5.779, 7.68),
        (323.361, 8.76, 12.886), (315.699, 15.15, 16.718), (325.3, 24.752, 29.044),
        (326.105, 25.5, 34),
    ],
    [
        (363.083, 4.619, 6.576), (364.473, 5.008, 13.209), (360.545, 0.559, 14),
        (347.732, 0.424, 13.511), (360.528, 0.5, 23.539), (359.947, 10.022, 28.154),
        (359.981, 16.291, 34),
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
    flat_bottom=slice(2, 8),
)

FEATURES = {
    "bulbous bow": "four rows end on the contour of the bulb, whose lowest point has valence 2",
    "stern bulb": "three rows end on the aperture; two points of the bar make the propeller boss",
    "flat bottom": "between the bar and a crease, which ends before the forefoot",
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
    ("waterline", "inflection", 3, {"x": (9, 107), "z": (0, 13)}, "boss, stern bulb, run"),
    ("waterline", "dip", 1, {"x": (20, 31), "z": (4, 10)}, "the straight side of the stern bulb"),
    ("buttock", "inflection", 5, {"x": (-2, 91), "z": (3.5, 15)}, "bulb, tunnel, flat counter"),
    ("buttock", "inflection", 3, {"x": (-7, 56), "y": (22, 25), "z": (12, 20)}, "bilge aft"),
    ("buttock", "dip", 2, {"x": (-7, 31), "y": (0, 23), "z": (10, 17)}, "the straight counter"),
    ("buttock", "dip", 1, {"x": (10, 20), "y": (0, 2), "z": (2, 4)}, "the boss's straight foot"),
    ("feature", "inflection", 5, {"x": (-4, 13), "y": (0, 0.3)}, "counter, aperture, boss"),
    # Amidships: four points round the bilge are near its arc; flat bottom and side.
    ("station", "dip", 1, {"x": (140, 210), "y": (22, 25)}, "bilge: flatter where a point is"),
    ("waterline", "dip", 1, {"x": (0, 180), "y": (23, 26)}, "flat side between the shoulders"),
    ("buttock", "dip", 1, {"x": (160, 273), "z": (0, 2)}, "flat bottom"),
    ("feature", "dip", 1, {"x": (149, 190), "z": (0, 0)}, "flat bottom"),
    # The bulb's round nose comes to the flat bar with a hollow of 2 to 5 cm, which the original,
    # without a bar, has not.
    ("station", "inflection", 1, {"x": (354, 364), "y": (0, 1.5), "z": (2, 7)}, "bulb to bar"),
    ("waterline", "inflection", 1, {"x": (354, 363), "z": (2, 6.5)}, "bulb to bar"),
    # The bow: V below a full deck, bulb and notch, flare to the knuckle.
    ("station", "inflection", 2, {"x": (299, 363), "z": (2, 28)}, "forefoot or bulb, then flare"),
    ("station", "dip", 1, {"x": (290, 355), "z": (0, 6)}, "straight V beside the bar"),
    ("station", "dip", 1, {"x": (284, 325), "z": (10, 15)}, "straight V at the shoulder"),
    ("waterline", "inflection", 3, {"x": (250, 366), "z": (0, 15)}, "hollow entrance, bulb"),
    ("waterline", "inflection", 1, {"x": (335, 356), "z": (16, 22)}, "hollow above the bulb"),
    ("waterline", "dip", 1, {"x": (338, 353), "z": (17, 23)}, "straight entrance at the stem"),
    ("buttock", "inflection", 1, {"x": (250, 337), "y": (5, 25), "z": (11, 15)}, "V to flare"),
    ("buttock", "inflection", 5, {"x": (329, 359), "z": (10, 32)}, "bulb, notch, flare, knuckle"),
    ("buttock", "dip", 1, {"x": (320, 338), "y": (0, 4), "z": (0, 4)}, "straight forefoot"),
    ("buttock", "dip", 1, {"x": (360, 363), "y": (0, 2), "z": (25, 27)}, "straight stem"),
    ("feature", "inflection", 3, {"x": (356, 364), "y": (0, 0.3)}, "bulb, notch, stem"),
    # Reflection lines.
    ("reflection", "wave", 3, {"x": (4, 26), "z": (11, 14.5)}, "tunnel and flat counter"),
    ("reflection", "wave", 1, {"x": (10, 15), "z": (4.5, 6.5)}, "the boss in the stern bulb"),
    ("reflection", "wave", 1, {"x": (90, 99), "z": (1, 2.5)}, "the bulb's end in the bottom"),
    ("reflection", "wave", 3, {"x": (292, 305), "z": (5, 15)}, "bulb and shoulder part"),
    ("reflection", "kink", 1, {"x": (350, 364), "z": (27, 32)}, "where the knuckle fades"),
    ("reflection", "wave", 3, {"x": (346, 365), "z": (25, 32)}, "where the knuckle fades"),
    ("reflection", "kink", 1, {"x": (355, 361), "z": (20, 25)}, "the sharp stem"),
    ("reflection", "wave", 1, {"x": (351, 361), "z": (20, 25)}, "the sharp stem"),
    ("reflection", "kink", 2, {"x": (353, 361), "z": (12, 15)}, "the bulb's back at the stem"),
    ("reflection", "wave", 3, {"x": (351, 362), "z": (12, 15)}, "the bulb's back at the stem"),
    ("reflection", "kink", 1, {"x": (361, 366), "z": (5.5, 9)}, "the bulb's nose"),
    ("reflection", "wave", 1, {"x": (361, 366), "z": (5.5, 9)}, "the bulb's nose"),
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
