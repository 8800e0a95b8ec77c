# SPDX-License-Identifier: GPL-3.0-or-later
"""A large container ship after the Duisburg Test Case, fitted to its published surface.

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
    (-6.743, 15.25), (-3.5, 14.965), (1.837, 14.045), (15.256, 12.586), (16.562, 6.356),
    (8.651, 5.827), (9.304, 4.238), (10.2, 4.443), (19.704, 0), (36, 0), (82, 0),
    (124, 0), (162, 0), (201, 0), (250, 0), (338.463, 0), (348.538, 0),
    (359.774, 2.95), (367.126, 8.7), (365.308, 15.073), (355.801, 14.116), (353.306, 14.401),
    (362.71, 27.56), (364.812, 29.545), (366.558, 34),
]
# Sections from aft. Four of the counter, from the bar's to the deck: bottom, bilge, border of the
# flat side, deck edge. Then ten from the boss forward: border of the flat bottom, four round the
# bilge, border of the flat side or knuckle, deck edge.
SECTIONS = [
    [
        (-6.743, 13.5, 15.534), (-6.743, 25.5, 17.846), (-6.743, 25.5, 27.207),
        (-6.743, 25.5, 34),
    ],
    [
        (0.472, 14.5, 14.829), (4.823, 25.476, 16.88), (3.918, 25.5, 25.21),
        (7.45, 25.5, 34),
    ],
    [
        (14.731, 11.5, 13.1), (12.144, 25.448, 15.038), (18.212, 25.5, 23.838),
        (27.006, 25.5, 34),
    ],
    [
        (8.072, 1.42, 13.005), (37.198, 25.397, 11.317), (29.2, 25.5, 20.628),
        (47.961, 25.5, 34),
    ],
    [
        (9.5, 1.597, 4.849), (20.082, 0.35, 5.396), (17.622, 0.25, 11.583),
        (28.564, 4.438, 10.026), (38.616, 25.401, 11.438), (45.01, 25.5, 18.951),
        (61.909, 25.5, 34),
    ],
    [
        (26.96, 2.937, 0.861), (31.09, 3.295, 5.264), (27.921, 0.44, 9.832),
        (50.016, 13.694, 8.005), (45.651, 25.427, 11.613), (61.004, 25.5, 16.933),
        (76.09, 25.5, 34),
    ],
    [
        (29.01, 2.19, 0), (50.201, 5.095, 2.295), (52.383, 8.563, 7.299),
        (70.255, 19.918, 6.562), (73.134, 25.5, 9.285), (77.878, 25.5, 15.613),
        (102.611, 25.5, 34),
    ],
    [
        (87.074, 2.235, 0), (96.826, 11.497, 0.371), (89.642, 16.296, 2.457),
        (97.984, 22.218, 3.995), (99.981, 25.5, 7.213), (104.28, 25.5, 10.828),
        (142.352, 25.5, 34),
    ],
    [
        (132.752, 18.5, 0), (125.498, 17.205, 0), (131.113, 22.113, 0),
        (133.939, 24.806, 2.104), (132.973, 25.5, 4.284), (133.932, 25.5, 6.647),
        (175.319, 25.5, 34),
    ],
    [
        (162.978, 21, 0), (162.209, 22.004, 0), (164.742, 22.534, 0),
        (161.834, 24.562, 1.229), (164.107, 25.5, 3.748), (159.533, 25.5, 4.379),
        (223.194, 25.5, 34),
    ],
    [
        (203.008, 19, 0), (205.528, 22.74, 0), (204.453, 25.5, 1.891),
        (211.005, 25.4, 3.466), (198.829, 25.5, 2.983), (211.023, 25.5, 5.789),
        (268.891, 25.5, 34),
    ],
    [
        (256.694, 3.528, 0), (254.036, 11.072, 0), (259.848, 15.83, 1.552),
        (258.503, 21.21, 5.146), (261.567, 25.31, 12.798), (249.221, 25.5, 18.259),
        (286.265, 25.5, 34),
    ],
    [
        (326.842, 2.021, 0), (328.406, 3.266, 3.108), (324.259, 6.258, 8.585),
        (327.821, 8.229, 13.272), (308.022, 16.977, 16.981), (332.712, 24.817, 30.347),
        (327.913, 25.5, 34),
    ],
    [
        (363.193, 4.377, 6.282), (364.794, 5.237, 13.613), (358.049, 0.25, 13.242),
        (346.573, 0.827, 15.434), (363.821, 0.751, 23.326), (360.974, 7.888, 27.777),
        (360.899, 14.951, 34),
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
    ("waterline", "inflection", 3, {"x": (9, 107), "z": (0, 13)}, "boss, stern bulb, run"),
    ("waterline", "dip", 1, {"x": (20, 31), "z": (4, 8)}, "the straight side of the stern bulb"),
    ("buttock", "inflection", 5, {"x": (-2, 91), "z": (3.5, 15)}, "bulb, tunnel, flat counter"),
    ("buttock", "inflection", 3, {"x": (-7, 56), "y": (22, 25), "z": (12, 20)}, "bilge aft"),
    ("buttock", "dip", 2, {"x": (-7, 31), "y": (0, 23), "z": (10, 17)}, "the straight counter"),
    ("buttock", "dip", 1, {"x": (10, 20), "y": (0, 2), "z": (2, 4)}, "the boss's straight foot"),
    ("feature", "inflection", 5, {"x": (-4, 13), "y": (0, 0.3)}, "counter, aperture, boss"),
    # Amidships: four points round the bilge are near its arc; flat bottom and side.
    ("station", "dip", 1, {"x": (140, 210), "y": (22, 25)}, "bilge: flatter where a point is"),
    ("waterline", "dip", 1, {"x": (0, 180), "y": (23, 26)}, "flat side between the shoulders"),
    ("buttock", "dip", 1, {"x": (160, 273), "z": (0, 2)}, "flat bottom"),
    ("feature", "dip", 1, {"x": (180, 190), "z": (0, 0)}, "flat bottom"),
    # The bow: V below a full deck, bulb and notch, flare to the knuckle.
    ("station", "inflection", 2, {"x": (299, 363), "z": (2, 27)}, "forefoot or bulb, then flare"),
    ("station", "dip", 1, {"x": (290, 355), "z": (0, 6)}, "straight V beside the bar"),
    ("station", "dip", 1, {"x": (290, 325), "z": (10, 15)}, "straight V at the shoulder"),
    ("waterline", "inflection", 3, {"x": (250, 366), "z": (0, 15)}, "hollow entrance, bulb"),
    ("waterline", "inflection", 2, {"x": (339, 356), "z": (16, 22)}, "hollow above the bulb"),
    ("waterline", "dip", 1, {"x": (338, 353), "z": (17, 23)}, "straight entrance at the stem"),
    ("buttock", "inflection", 1, {"x": (250, 337), "y": (5, 25), "z": (11, 15)}, "V to flare"),
    ("buttock", "inflection", 5, {"x": (329, 359), "z": (10, 31)}, "bulb, notch, flare, knuckle"),
    ("buttock", "dip", 1, {"x": (320, 337), "y": (0, 4), "z": (0, 4)}, "straight forefoot"),
    ("feature", "inflection", 3, {"x": (356, 364), "y": (0, 0.3)}, "bulb, notch, stem"),
    # Reflection lines.
    (
        "reflection",
        "wave",
        2,
        {"x": (5, 26), "y": (1.5, 11), "z": (11, 14.5)},
        "tunnel above the stern bulb to counter",
    ),
    (
        "reflection",
        "kink",
        1,
        {"x": (10, 15), "y": (0, 1.5), "z": (4.5, 6.5)},
        "the boss runs out in the stern bulb",
    ),
    (
        "reflection",
        "wave",
        1,
        {"x": (10, 15), "y": (0, 1.5), "z": (4.5, 6.5)},
        "the boss runs out in the stern bulb",
    ),
    ("reflection", "wave", 1, {"x": (90, 99), "z": (1, 2.5)}, "the bulb's end in the bottom"),
    (
        "reflection",
        "kink",
        1,
        {"x": (134, 148), "z": (0, 0.05)},
        "turns about where bilge meets flat bottom",
    ),
    (
        "reflection",
        "wave",
        1,
        {"x": (284, 299), "y": (1, 2), "z": (0, 0.2)},
        "the bottom rises beside the bar",
    ),
    (
        "reflection",
        "kink",
        1,
        {"x": (292, 320), "y": (8, 11.5), "z": (5, 14)},
        "lights of bulb and shoulder part",
    ),
    (
        "reflection",
        "wave",
        2,
        {"x": (292, 320), "y": (8, 11.5), "z": (5, 14)},
        "lights of bulb and shoulder part",
    ),
    (
        "reflection",
        "kink",
        1,
        {"x": (350, 364), "y": (3, 16), "z": (27, 32)},
        "flare, where its knuckle fades",
    ),
    (
        "reflection",
        "wave",
        2,
        {"x": (350, 364), "y": (3, 16), "z": (27, 32)},
        "flare, where its knuckle fades",
    ),
    (
        "reflection",
        "wave",
        1,
        {"x": (355, 361), "y": (0, 3), "z": (20, 25)},
        "stem, where lights run together",
    ),
    (
        "reflection",
        "kink",
        2,
        {"x": (353, 361), "y": (0, 3), "z": (12, 15)},
        "the bulb's back meets the stem",
    ),
    (
        "reflection",
        "wave",
        3,
        {"x": (353, 361), "y": (0, 3), "z": (12, 15)},
        "the bulb's back meets the stem",
    ),
    ("reflection", "kink", 1, {"x": (361, 366), "y": (0, 2.5), "z": (5.5, 9)}, "the bulb's nose"),
    ("reflection", "wave", 1, {"x": (361, 366), "y": (0, 2.5), "z": (5.5, 9)}, "the bulb's nose"),
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
