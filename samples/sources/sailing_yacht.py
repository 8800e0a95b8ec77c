# SPDX-License-Identifier: GPL-3.0-or-later
"""A sailing yacht: canoe body with a wide stern, fin keel with a bulb, spade rudder.

Three bodies, each the port half: the canoe body, open at the deck; keel and bulb, one body that is
open where it meets the canoe body; the rudder, closed but for the centre plane. The base line is
the bottom of the bulb.
"""

import numpy as np

from .mesh import SHELL, TRANSOM, Mesh, by_station, faired, largest

FEATURES = {
    "canoe body": "the layers Shell and Transom: twelve sections and the stem, eight rows",
    "fin keel with bulb": "the layer Keel: a body of its own, a crease where fin and bulb meet",
    "spade rudder": "the layer Rudder: a body of its own, with plane faces above and below",
}
MOST_POINTS = 200

_BULB = {"x": (4.3, 7.0), "z": (0.0, 0.5)}
WANTED = [
    ("station", "dip", 1, _BULB, "bulb, less round where the fin's foot is"),
    ("waterline", "dip", 1, _BULB, "the bulb's side between nose and tail"),
    ("waterline", "dip", 1, {"x": (6.0, 10.5), "z": (1.9, 2.6)}, "fine bow, straight to the stem"),
    (
        "waterline",
        "dip",
        1,
        {"x": (1.5, 3.0), "z": (2.4, 2.9)},
        "from the transom's corner to midship",
    ),
    ("buttock", "dip", 3, _BULB, "the bulb's back and bottom between nose and tail"),
    (
        "buttock",
        "inflection",
        2,
        {"x": (6.2, 6.7), "z": (0.3, 0.5)},
        "the bulb's back before the fin",
    ),
    ("buttock", "dip", 1, {"x": (1.5, 3.0), "z": (2.5, 3.2)}, "side, straight to the transom"),
    ("feature", "dip", 1, _BULB, "the bulb's bottom between nose and tail"),
    # Reflection lines.
    (
        "reflection",
        "wave",
        1,
        {"x": (6.3, 6.95), "z": (0, 0.15)},
        "the bulb's nose, between its irregular points",
    ),
]

LENGTH, BEAM, DRAFT, DEPTH = 11.2, 3.9, 2.3, 3.45
KEEL, RUDDER = ("Keel", (0.35, 0.36, 0.38)), ("Rudder", (0.30, 0.32, 0.36))

STATIONS = np.array([-0.6, 0.45, 1.6, 2.8, 4.0, 5.2, 6.4, 7.55, 8.6, 9.5, 10.25, 10.85])
# Half-breadth of the sheer at the stations: the steps between its slopes change evenly.
SHEER = (1.737, 1.827, 1.902, 1.950, 1.956, 1.904, 1.776, 1.554, 1.251, 0.909, 0.568, 0.259)
# Height of the middle of the bottom, by x.
ROCKER = {-0.6: 2.39, 1.5: 2.09, 3.5: 1.86, 5.6: 1.78, 7.5: 1.83, 9.5: 1.965, 10.85: 2.125}
# Half-breadths and heights of the rows from the centre plane to the sheer, in parts of the sheer's,
# by x: round, flatter aft, with a softer bilge forward.
ROUND = {
    -0.6: (
        (0, 0.21, 0.48, 0.70, 0.85, 0.93, 0.975, 1),
        (0, 0.0, 0.045, 0.155, 0.34, 0.55, 0.77, 1),
    ),
    4.0: (
        (0, 0.19, 0.44, 0.665, 0.825, 0.918, 0.972, 1),
        (0, 0.008, 0.050, 0.146, 0.30, 0.505, 0.745, 1),
    ),
    8.0: (
        (0, 0.185, 0.412, 0.622, 0.782, 0.887, 0.96, 1),
        (0, 0.014, 0.070, 0.170, 0.32, 0.52, 0.755, 1),
    ),
    10.85: (
        (0, 0.155, 0.34, 0.51, 0.662, 0.795, 0.91, 1),
        (0, 0.02, 0.12, 0.245, 0.40, 0.58, 0.785, 1),
    ),
}
# The stem from above its foot to the deck: nearly plumb.
STEM = (
    (11.22, 0.0, 2.27),
    (11.27, 0.0, 2.47),
    (11.29, 0.0, 2.72),
    (11.315, 0.0, 3.02),
    (11.34, 0.0, 3.35),
    (11.37, 0.0, 3.755),
)
# How much the rows are faired.
STIFFNESS = 40.0

# Half a section of a foil from the leading edge aft: parts of the chord, and of half the thickness.
# The first two are abreast: the nose is round.
FOIL = ((0.0, 0.0), (0.0, 0.42), (0.14, 0.98), (0.38, 1.10), (0.68, 0.66), (1.0, 0.0))
# Leading edge, chord, half thickness and height of the fin's foils, from a little within the canoe
# body down to the bulb, and of the rudder's, whose top runs along the bottom close below it.
FIN = (
    (6.35, 1.35, 0.095, 1.83),
    (6.308, 1.238, 0.089, 1.45),
    (6.265, 1.122, 0.082, 1.05),
    (6.226, 1.022, 0.076, 0.70),
    (6.20, 0.95, 0.072, None),
)
BLADE = (
    (0.72, 0.56, 0.050, 2.184, 0.079),
    (0.69, 0.51, 0.044, 1.70),
    (0.66, 0.46, 0.038, 1.15),
    (0.63, 0.41, 0.032, 0.62),
)
# The bulb's rings: x and radius, a teardrop. The second to the last but one begin at the fin.
BULB = (
    (6.91, 0.135),
    (6.60, 0.230),
    (6.25, 0.278),
    (5.90, 0.292),
    (5.58, 0.283),
    (5.28, 0.255),
    (5.00, 0.212),
    (4.68, 0.140),
)
BULB_NOSE, BULB_TAIL, BULB_Z = 7.0, 4.3, 0.2315
# A ring from above the bulb round its side to below: y and z in parts of the radius.
RING = ((0.0, 0.8), (0.60, 0.76), (1.14, 0.0), (0.60, -0.76), (0.0, -0.8))


def canoe_body_points():
    """Points (sections, rows, 3) without the stem."""
    parts, bottom = by_station(ROUND, STATIONS), by_station(ROCKER, STATIONS)[:, None]
    top = 3.44 + 0.004 * np.clip(STATIONS - 2.5, 0.0, None)[:, None] ** 2
    x = np.repeat(STATIONS[:, None], parts.shape[2], axis=1)
    y = parts[:, 0] * np.array(SHEER)[:, None]
    z = bottom + parts[:, 1] * (top - bottom)
    grid = np.stack([x, y, z], axis=-1)
    for axis in (1, 2):
        # The two lowest rows end at the stem's foot and beside it.
        for row in (0, 1):
            grid[:, row, axis] = faired(grid[:, row, axis], STIFFNESS)
        for row, end in enumerate(STEM, start=2):
            line = [*grid[:, row, axis], end[axis]]
            grid[:, row, axis] = faired(line, STIFFNESS)[:-1]
    grid[:, :, 1] *= 0.5 * BEAM / largest([*grid[:, -1, 1], 0.0])
    return np.round(grid, 4)


def add_canoe_body(mesh):
    rows = mesh.round_stem_body(canoe_body_points(), STEM)
    mesh.deck([row[-1] for row in rows])
    mesh.flat((-1, 0, 0), -STATIONS[0], layer=1)


def foil(leading_edge, chord, half_thickness, z, rise=0.0):
    """Places of a foil's points. rise: from the leading edge to the trailing one."""
    return [(leading_edge - a * chord, t * half_thickness, z + a * rise) for a, t in FOIL]


def add_keel(mesh):
    levels = [mesh.row(foil(*section)) for section in FIN[:-1]]
    lowest = foil(*FIN[-1][:3], BULB_Z)
    rings = []
    for (x, radius), at_fin in zip(BULB, [None, *lowest, None]):
        ring = [(x, y * radius, BULB_Z + z * radius) for y, z in RING]
        if at_fin:
            # Where the fin's side meets the bulb's back.
            height = 0.8 * np.sqrt(radius**2 - at_fin[1] ** 2)
            ring[0] = (at_fin[0], at_fin[1], BULB_Z + height)
        rings.append(mesh.row(np.round(ring, 4)))
    joint = [ring[0] for ring in rings[1:-1]]
    nose, tail = mesh.row([(BULB_NOSE, 0.0, BULB_Z), (BULB_TAIL, 0.0, BULB_Z)])
    mesh.strips([_cap(rings[0], nose), *rings, _cap(rings[-1], tail)], layer=2)
    mesh.strips([joint, *levels[::-1]], layer=2)
    mesh.crease(joint)
    mesh.corner(joint[0], joint[-1])


def _cap(ring, tip):
    """A row that ends a bulb in the centre plane, smoothly: top, bottom and their neighbours there
    are one point each."""
    return [ring[0], ring[0], tip, ring[-1], ring[-1]]


def add_rudder(mesh):
    levels = [mesh.row(foil(*section)) for section in BLADE]
    mesh.strips(levels[::-1], layer=3)
    for level, turn in ((levels[0], 1), (levels[-1], -1)):
        mesh.crease(level)
        nose, side, quarter, middle, aft, tail = level
        mesh.face(*(nose, side, aft, tail)[::turn], layer=3)
        mesh.face(*(side, quarter, middle, aft)[::turn], layer=3)


def make(hull_io):
    mesh = Mesh([SHELL, TRANSOM, KEEL, RUDDER])
    add_canoe_body(mesh)
    add_keel(mesh)
    add_rudder(mesh)
    return mesh.hull(
        hull_io,
        "Sailing yacht",
        "designed for this project: a cruiser-racer with fin keel, bulb and spade rudder",
        length_pp=LENGTH,
        beam=BEAM,
        draft=DRAFT,
        depth=DEPTH,
        water_density=1.025,
    )
