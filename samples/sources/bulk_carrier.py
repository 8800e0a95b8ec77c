# SPDX-License-Identifier: GPL-3.0-or-later
"""A large tanker or bulk carrier after KVLCC2, fitted to its published surface.

KVLCC2 is a tanker of Kim, Van & Kim 2001.

A flat bar, two rows of points 0.25 m apart, runs round the whole centre plane: from the transom
under the counter, round the propeller boss, along the keel, round the bulb and up the stem. Within
it, lower rows of points run from the stern aperture forward and end on the bulb; upper ones begin
at the transom. A ring of four points more goes round the bulb. The coordinates are those of a fit
to the corners of that surface's triangles, which are long and cut off what bulges between them,
faired at the bow and along the deck edge, and rounded to millimetres.

The parallel middle body is the part between four equal sections, where the surface does not depend
on x. The outer two lie beyond it, so that bilge and borders of the flats run out of it with the
same tangent and curvature. In the flat bottom sections share the keel's points.
"""

from .barred import BarredShip

LENGTH, HALF_BEAM, DRAFT, DEPTH = 320.0, 29.0, 20.8, 28.0
BAR = 0.25

# x and z along the bar: counter, aperture, boss, keel, bulb, notch above it, stem, stem head. The
# line is a B-spline: it turns inside these points.
# fmt: off
CONTOUR = [
    (-5.5, 18.721), (3.289, 16.429), (11.323, 13.7), (9.926, 7.146), (6.901, 6.832),
    (7.053, 5.094), (10.454, 3.136), (10.586, 0), (24.252, 0), (70.204, 0), (297.795, 0),
    (311.568, 0), (319.222, 0.192), (326.179, 3.991), (328.651, 9.575), (327.51, 14.729),
    (320.607, 17.226), (319.453, 21.243), (320.894, 23.731), (323.459, 28),
]
# Between the last section and the stem, round the bulb.
RING = [
    (320.924, 2.104, 1.841), (326.514, 3.885, 7.668), (325.669, 3.144, 13.926),
    (316.861, 6.801, 16.386),
]
# Sections from aft. Three of the counter, from the bar to the deck. Then ten from the boss on:
# border of the flat bottom, four round the bilge, border of the flat side, deck edge.
SECTIONS = [
    [
        (-5.5, 4.642, 19.78), (-5.5, 7.763, 21.831), (-5.5, 8.9, 24.381), (-5.5, 9.124, 28),
    ],
    [
        (4.311, 6.73, 17.947), (5.436, 12.229, 20.514), (6.238, 14.571, 23.642),
        (4.619, 13.692, 28),
    ],
    [
        (14.099, 5.112, 15.054), (16.602, 14.639, 17.36), (18.87, 19.161, 22.363),
        (15.963, 18.227, 28),
    ],
    [
        (10.021, 1.593, 5.134), (12.424, 1.534, 6.976), (16.429, 0.88, 10.562),
        (20.906, 6.099, 13.365), (24.185, 16.247, 16.33), (27.773, 22.233, 21.402),
        (29.76, 22.716, 28),
    ],
    [
        (12.211, 1.79, 0.921), (15.786, 3.365, 3.286), (22.359, 3.506, 9.158),
        (28.097, 8.753, 12.316), (33.63, 19.135, 14.516), (38.297, 24.761, 20.719),
        (45.905, 26.666, 28),
    ],
    [
        (30.092, 3.514, 0), (34.65, 6.946, 2.529), (39.239, 9.764, 7.939), (43.491, 17.064, 10.45),
        (49.422, 26.528, 15.737), (56.102, 29.098, 23.539), (63.035, 28.865, 28),
    ],
    [
        (66.526, 8.617, 0), (68.502, 15.94, 1.423), (69.712, 21.295, 3.747), (70.8, 25.667, 7.555),
        (71.464, 27.765, 12.175), (78.759, 29, 19.782), (82.621, 29, 28),
    ],
    [
        (120.8, 26.475, 0), (120.7, 27.054, 0), (120.6, 27.936, 0.319), (120.6, 28.681, 1.064),
        (120.6, 29, 1.946), (120.6, 29, 2.525),
    ],
    [
        (134, 26.475, 0), (134, 27.054, 0), (134, 27.936, 0.319), (134, 28.681, 1.064),
        (134, 29, 1.946), (134, 29, 2.525), (134, 29, 28),
    ],
    [
        (222, 26.475, 0), (222, 27.054, 0), (222, 27.936, 0.319), (222, 28.681, 1.064),
        (222, 29, 1.946), (222, 29, 2.525), (222, 29, 28),
    ],
    [
        (241.3, 26.475, 0), (241, 27.054, 0), (240.7, 27.936, 0.319), (240.5, 28.681, 1.064),
        (240.4, 29, 1.946), (240.4, 29, 2.525), (242, 29, 28),
    ],
    [
        (285.285, 14.152, 0), (285.892, 19.691, 1.232), (286.568, 23.25, 3.146),
        (286.909, 26.168, 6.1), (287.276, 27.793, 10.056), (287.392, 28.068, 14.564),
        (289.027, 29, 28),
    ],
    [
        (313.049, 3.219, 0), (312.826, 8.365, 2.513), (312.914, 12.75, 7.45),
        (312.183, 14.174, 13.052), (313.463, 12.928, 20.551), (312.471, 13.388, 24.12),
        (315.562, 15.017, 28),
    ],
]
# fmt: on
SHIP = BarredShip(
    CONTOUR,
    SECTIONS,
    BAR,
    HALF_BEAM,
    counter=slice(0, 3),
    aperture=slice(5, 1, -1),
    keel=(5, 6, 7, 8, 9, 9, 9, 10, 10, 10, 11),
    stem=slice(12, 20),
    flat_bottom=slice(2, 10),
    flat_side=slice(6, 12),
    short={7: 8},
    ring=RING,
)

FEATURES = {
    "displacement bulb": "four rows end on the contour of the stem, which bulges below the water",
    "stern bulb": "three rows end on the aperture; two points of the bar make the propeller boss",
    "parallel middle body": "between four equal sections, two at either end",
    "flat bottom": "between the bar and a crease, in the base plane",
    "flat side": "above a crease, in the plane of the largest half breadth",
    "transom": "plane, a layer of its own with a creased rim",
    "flat bar": "two rows of points along the whole centre plane, the outer one a crease",
}
MOST_POINTS = 125
# Full-scale value published with the design.
PUBLISHED = {"displaced_volume": 312622.0}
WANTED = [
    # The stern: boss, bulb, tunnel above it, counter, long run.
    ("station", "inflection", 2, {"x": (9, 66), "z": (4, 17)}, "stern bulb to counter, bilge"),
    ("station", "dip", 1, {"x": (65, 84), "z": (3, 6)}, "the bulb's end in the bottom"),
    ("waterline", "inflection", 3, {"x": (8, 100), "z": (0, 17)}, "boss, stern bulb, run"),
    ("waterline", "dip", 2, {"x": (10, 26), "z": (6, 10)}, "the straight side of the stern bulb"),
    ("waterline", "dip", 4, {"x": (0, 48), "z": (14, 25)}, "counter to quarter to shoulder"),
    ("waterline", "dip", 1, {"x": (79, 84), "z": (17, 18)}, "where the flat side begins"),
    ("buttock", "inflection", 2, {"x": (4, 56), "y": (0, 28)}, "stern bulb, tunnel, counter"),
    ("buttock", "dip", 1, {"x": (10, 12), "y": (0, 2), "z": (3, 5)}, "boss to stern bulb"),
    ("buttock", "dip", 1, {"x": (9, 26), "y": (0, 17), "z": (13, 18)}, "the straight counter"),
    ("buttock", "dip", 1, {"x": (34, 95), "y": (10, 28)}, "straight run, rising to the quarter"),
    ("feature", "inflection", 4, {"x": (1, 12), "y": (0, 0.3)}, "counter, aperture, boss"),
    ("feature", "dip", 1, {"x": (9, 12), "y": (0, 0.3)}, "the straight side of the aperture"),
    # The parallel middle body.
    ("waterline", "dip", 1, {"x": (145, 190)}, "flat side and bilge between the shoulders"),
    ("buttock", "dip", 1, {"x": (145, 190)}, "flat bottom and bilge between the shoulders"),
    ("feature", "dip", 1, {"x": (145, 190)}, "keel, deck and borders of the flats, all straight"),
    # The bow: a straight entrance that turns round the nose of the bulb; flare.
    ("station", "inflection", 1, {"x": (285, 320), "z": (13, 18)}, "bulb or bilge, then flare"),
    ("station", "inflection", 1, {"x": (302, 312), "z": (24, 26)}, "flare, straight to the deck"),
    ("station", "dip", 1, {"x": (310, 327), "z": (1, 6)}, "the bulb's straight underside"),
    ("waterline", "inflection", 2, {"x": (309, 323), "z": (0, 19)}, "straight, then the bulb"),
    ("waterline", "dip", 2, {"x": (255, 321), "z": (0, 13)}, "straight from shoulder to nose"),
    ("waterline", "dip", 2, {"x": (280, 319), "z": (14, 24)}, "straight entrance"),
    ("buttock", "inflection", 1, {"x": (285, 324), "z": (13, 18)}, "bulb or bilge, then flare"),
    ("buttock", "dip", 1, {"x": (316, 318), "z": (18, 20)}, "bulb to flare"),
    ("feature", "inflection", 1, {"x": (323, 325), "y": (0, 0.3)}, "bulb, then stem"),
    # Reflection lines.
    (
        "reflection",
        "kink",
        2,
        {"x": (8, 25), "y": (0, 5), "z": (2, 9.6)},
        "boss, and its end in the stern bulb",
    ),
    (
        "reflection",
        "wave",
        3,
        {"x": (8, 25), "y": (0, 5), "z": (2, 9.6)},
        "boss, and its end in the stern bulb",
    ),
    (
        "reflection",
        "wave",
        3,
        {"x": (7, 26), "y": (0, 14), "z": (13, 16.5)},
        "tunnel above the stern bulb to counter",
    ),
    (
        "reflection",
        "wave",
        1,
        {"x": (0, 12), "y": (11, 17), "z": (24, 27)},
        "the quarter draws in to the transom",
    ),
    (
        "reflection",
        "wave",
        1,
        {"x": (34, 42), "y": (1.5, 2.5), "z": (0, 0.1)},
        "the bottom rises beside the bar",
    ),
    (
        "reflection",
        "kink",
        2,
        {"x": (312, 329), "y": (0, 3), "z": (0, 8.5)},
        "the bulb rises from the keel",
    ),
    (
        "reflection",
        "wave",
        2,
        {"x": (303, 329), "y": (0, 9), "z": (0, 8.5)},
        "the bulb rises from the keel",
    ),
    (
        "reflection",
        "wave",
        2,
        {"x": (313, 323), "y": (0, 10), "z": (21, 26.5)},
        "flare above the bulb to the straight stem",
    ),
    (
        "reflection",
        "wave",
        1,
        {"x": (293, 320), "y": (7, 23), "z": (10, 23)},
        "blunt bow: lights turn from the stem round to the side",
    ),
]


def make(hull_io):
    mesh, *_ = SHIP.mesh()
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
