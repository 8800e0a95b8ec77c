# SPDX-License-Identifier: GPL-3.0-or-later
"""A large tanker or bulk carrier after KVLCC2, fitted to its published surface.

A flat bar, two rows of points 0.25 m apart, runs round the whole centre plane: from the transom
under the counter, round the propeller boss, along the keel, round the bulb and up the stem. Within
it, lower rows of points run from the stern aperture forward and end on the bulb; upper ones begin
at the transom. The coordinates are those of a fit to that surface, rounded to millimetres.
"""

from .barred import BarredShip

LENGTH, HALF_BEAM, DRAFT, DEPTH = 320.0, 29.0, 20.8, 28.0
BAR = 0.25

# x and z along the bar: counter, aperture, boss, keel, bulb, notch above it, stem, stem head. The
# line is a B-spline: it turns inside these points.
# fmt: off
CONTOUR = [
    (-5.5, 18.866), (0.41, 17.138), (6.702, 15.508), (12.4, 12.992), (9.555, 7.767),
    (6.104, 6.983), (5.313, 4.712), (8.028, 2.627), (9.34, 0), (31.286, 0), (63.339, 0),
    (118, 0), (236, 0), (287.527, 0), (315.256, 0), (323.165, 1.168), (327.887, 4.681),
    (330.362, 10.783), (327.577, 15.254), (320.652, 18.081), (319.596, 21.028),
    (321.535, 24.649), (323.798, 28),
]
# Sections from aft. Four of the counter, from the bar to the deck. Then eight from the boss on:
# border of the flat bottom, four round the bilge, border of the flat side, deck edge.
SECTIONS = [
    [
        (-5.5, 4.592, 19.923), (-5.5, 7.676, 21.948), (-5.5, 8.808, 24.458), (-5.5, 9.007, 28),
    ],
    [
        (0.916, 6.103, 18.663), (1.335, 10.707, 21.159), (1.621, 12.289, 24.041),
        (1.749, 12.386, 28),
    ],
    [
        (7.8, 6.714, 17.004), (8.261, 12.79, 19.807), (8.638, 15.298, 23.297),
        (8.984, 15.614, 28),
    ],
    [
        (14.089, 5.347, 15.292), (14.72, 13.968, 17.75), (15.499, 17.857, 22.485),
        (16.171, 18.214, 28),
    ],
    [
        (8.564, 1.233, 5.155), (12.437, 1.285, 7.289), (16.486, 1.053, 10.697),
        (20.01, 6.273, 13.669), (21.21, 15.139, 16.606), (22.247, 20.361, 21.707),
        (23.303, 20.617, 28),
    ],
    [
        (11.96, 1.732, 1.174), (15.987, 3.59, 4.001), (22.27, 3.393, 9.49),
        (26.902, 8.469, 12.629), (29.458, 17.319, 15.113), (30.822, 22.973, 20.966),
        (31.97, 22.829, 28),
    ],
    [
        (32.905, 3.866, 0), (35.904, 7.384, 2.071), (38.24, 9.274, 7.771),
        (39.573, 15.316, 10.921), (40.742, 23.403, 15.729), (42.086, 26.198, 23.856),
        (43.083, 25.816, 28),
    ],
    [
        (65.452, 8.156, 0), (65.293, 15.466, 2.139), (64.865, 20.689, 5.248),
        (64.47, 25.168, 9.501), (64.111, 27.383, 14.444), (63.687, 28.669, 19.803),
        (63.524, 29, 28),
    ],
    [
        (118, 26.44, 0), (118, 27.295, 0), (118, 28.127, 0.331), (118, 28.729, 1.005),
        (118, 29, 1.674), (118, 29, 2.427), (118, 29, 28),
    ],
    [
        (236, 26.593, 0), (236, 27.399, 0), (236, 28.187, 0.313), (236, 28.756, 0.943),
        (236, 29, 1.576), (236, 29, 2.293), (236, 29, 28),
    ],
    [
        (284.825, 13.953, 0), (284.463, 18.621, 0.937), (284.332, 22.645, 2.643),
        (284.303, 25.647, 5.455), (284.427, 27.542, 9.23), (284.49, 28.438, 13.557),
        (283.281, 29, 28),
    ],
    [
        (315.681, 2.875, 0), (315.14, 9.073, 3.389), (313.702, 13.815, 8.159),
        (312.392, 15.992, 13.284), (310.779, 15.752, 18.128), (309.639, 15.699, 22.457),
        (310.418, 19.997, 28),
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
    keel=slice(6, 15),
    stem=slice(15, 23),
    flat_bottom=slice(2, 8),
    flat_side=slice(7, 11),
)
# The ends of the parallel middle body, among the sections.
MIDDLE_BODY = (8, 9)

FEATURES = {
    "displacement bulb": "four rows end on the contour of the stem, which bulges below the water",
    "stern bulb": "three rows end on the aperture; two points of the bar make the propeller boss",
    "parallel middle body": "two equal sections of creases, no points between them",
    "flat bottom": "between the bar and a crease, in the base plane",
    "flat side": "above a crease, in the plane of the largest half breadth",
    "transom": "plane, a layer of its own with a creased rim",
    "flat bar": "two rows of points along the whole centre plane, the outer one a crease",
}
MOST_POINTS = 125
# Full-scale value published with the design.
PUBLISHED = {"displaced_volume": 312622.0}
WANTED = [
    # The stern: bulb, tunnel above it, counter, long run.
    ("station", "inflection", 2, {"x": (9, 62), "z": (4.5, 17)}, "stern bulb to counter, bilge"),
    ("station", "dip", 1, {"x": (39, 41), "z": (19, 21)}, "straight flare aft"),
    ("station", "dip", 1, {"x": (65, 82), "z": (3, 6)}, "the bulb's end in the bottom"),
    ("waterline", "inflection", 3, {"x": (8, 100), "z": (0, 17)}, "boss, stern bulb, run"),
    ("waterline", "dip", 1, {"x": (20, 22), "z": (6, 10)}, "the straight side of the stern bulb"),
    ("waterline", "dip", 3, {"x": (5, 35), "z": (16, 28)}, "the quarter, straight in parts"),
    ("buttock", "inflection", 2, {"x": (7, 53), "y": (0, 19)}, "stern bulb, tunnel, counter"),
    ("buttock", "dip", 1, {"x": (11, 12), "y": (0, 2)}, "the straight counter"),
    ("buttock", "dip", 1, {"x": (49, 88), "y": (20, 28)}, "straight run, rising to the quarter"),
    ("feature", "inflection", 4, {"x": (1, 8), "y": (0, 0.3)}, "counter, aperture, boss"),
    ("feature", "dip", 2, {"x": (15, 33), "z": (28, 28)}, "the quarter, straight in parts"),
    # The parallel middle body.
    ("waterline", "dip", 1, {"x": (175, 178), "z": (7, 28)}, "flat side between the shoulders"),
    ("buttock", "dip", 1, {"x": (166, 175), "z": (0, 0)}, "flat bottom"),
    # The bow: round below, bulb, flare.
    ("station", "inflection", 1, {"x": (290, 320), "z": (14, 18)}, "bulb or bilge, then flare"),
    ("station", "inflection", 1, {"x": (318, 327), "y": (1, 1.3)}, "the bulb beside the bar"),
    ("waterline", "inflection", 1, {"x": (315, 321), "z": (2, 19)}, "entrance to the bulb"),
    ("waterline", "dip", 2, {"x": (255, 313), "z": (0, 4)}, "straight shoulder of the flat bottom"),
    ("waterline", "dip", 1, {"x": (297, 307), "z": (14, 21)}, "straight entrance"),
    ("buttock", "inflection", 1, {"x": (286, 324), "z": (14, 17)}, "bulb or bilge, then flare"),
    ("buttock", "dip", 1, {"x": (244, 254), "y": (25, 28)}, "straight shoulder"),
    ("feature", "inflection", 1, {"x": (323, 325), "y": (0, 0.3)}, "bulb, then stem"),
]


def make(hull_io):
    mesh, middle, after = SHIP.mesh()
    for section in MIDDLE_BODY:
        mesh.crease([middle[section + 3], *after[section - 4]])
    return mesh.hull(
        hull_io,
        "Bulk carrier",
        "fitted to the surface published of the tanker KVLCC2, at full scale",
        length_pp=LENGTH,
        beam=2.0 * HALF_BEAM,
        draft=DRAFT,
        depth=DEPTH,
        water_density=1.025,
    )
