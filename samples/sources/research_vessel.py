# SPDX-License-Identifier: GPL-3.0-or-later
"""A research vessel for ice: a spoon bow over a steep forefoot, tunnels aft, sides of three planes.

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
LOWER, UPPER = 4.6, 9.0

# Where the sections cross the keel.
STATIONS = (-4.0, 5.0, 14.0, 24.0, 34.0, 46.0, 58.0, 69.0, 78.5, 86.0, 92.0)
# How far the stem is forward of its foot, row by row; and the part of it that sections lean.
STEM_RAKE = (0.0, 0.0, 1.8, 5.4, 9.2, 13.4, 16.4, 18.2, 19.3)
LEAN = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.08, 0.25, 0.5, 0.75)
# The stem from the third row on, in the centre plane: x and z.
STEM = (
    (98.8, 0.9),
    (102.4, 4.5),
    (106.2, 5.9),
    (110.4, 7.6),
    (113.4, 9.8),
    (115.2, 12.9),
    (116.3, 15.8),
)
# Two more points of the stem between its first two here, and the two of valence 3 behind them:
# without them the forefoot could not be as steep as it is below so flat a stem.
FOREFOOT = ((99.5, 0.0, 2.2), (100.3, 0.0, 3.5), (97.3, 0.9, 1.9), (98.6, 1.2, 3.3))

# y and z of the rows at the sections; made fair row by row, with the flats held.
# fmt: off
BREADTHS = (
    (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0),
    (2.4, 2.09, 1.9, 2.81, 5, 6.99, 7.01, 6.2, 4.8, 3.4, 2.2),
    (5.6, 5.39, 5.2, 6.03, 8.17, 9.08, 9.07, 8.6, 7.3, 5.4, 3),
    (8.8, 9, 9.2, 9.81, 10.58, 10.58, 10.58, 10.5, 9.21, 7, 3.9),
    (10.6, 10.89, 11.01, 11.09, 11.1, 11.1, 11.1, 11.1, 10.43, 8.59, 5.16),
    (11, 11.3, 11.45, 11.5, 11.5, 11.5, 11.5, 11.5, 11.21, 9.7, 6.13),
    (11.1, 11.4, 11.5, 11.5, 11.5, 11.5, 11.5, 11.5, 11.4, 10.14, 6.68),
    (10.75, 11.05, 11.15, 11.15, 11.15, 11.15, 11.15, 11.15, 11.42, 11.15, 8.29),
    (None, None, None, None, None, None, 10.95, 10.7, 11.12, 11.18, 8.56),
)
HEIGHTS = (
    (5.8, 4.19, 2, 0.31, 0, 0, 0, 0, 0, 0, 0),
    (6, 4.49, 2.4, 0.61, 0, 0, 0, 0, 0, 0, 0.3),
    (6.95, 7.01, 6.08, 3.2, 0.62, 0, 0, 0, 0.19, 0.62, 1.48),
    (6.3, 5, 3.7, 2.29, 1.16, 1.16, 1.16, 1.16, 1.5, 2.41, 3.79),
    (6.9, 6.31, 5.4, 4.09, 2.9, 2.9, 2.9, 2.9, 3.43, 4.64, 5.8),
    (8.01, 7.19, 6.2, 5.19, 4.6, 4.6, 4.6, 4.8, 5.6, 6.85, 7.81),
    (9, 9, 9, 9, 9, 9, 9, 9, 9.31, 9.8, 10.07),
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
    "complex stem contour": "steep forefoot below a raked stem, refined by four points, two of "
    "them of valence 3",
    "tunnelled stern": "the third row is above its neighbours aft",
    "tumblehome": "above the upper knuckle, to the deck edge",
    "forecastle knuckle": "the row of the main deck is a crease from the forecastle's break on",
    "flat side in three parts": "planes of flare, vertical and of tumblehome between two knuckles",
    "flat bottom": "the lowest three rows in the base plane",
    "transom": "plane, a layer of its own with a creased rim",
}
MOST_POINTS = 119
WANTED = []


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
    _add_transom(mesh, rows[0])
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


def _add_transom(mesh, rim):
    """The transom: strips across from the side to the bottom, a crease round it."""
    x, _, z = mesh.points[rim[7]]
    ring = [*rim, mesh.point((x, 0.0, z))]
    for face in ((1, 0, 8, 7), (2, 1, 7, 6), (3, 2, 6, 5), (5, 4, 3)):
        mesh.face(*(ring[k] for k in face), layer=1)
    mesh.crease(rim)
