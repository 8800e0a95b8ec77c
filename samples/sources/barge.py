# SPDX-License-Identifier: GPL-3.0-or-later
"""A barge for inland waters: flat but for the bilge and the bow's swim; the port half.

Five sections of six rows: keel, three about the bilge's circle between its ends, side, deck edge.
All sections have the same bilge, moved up with the bottom, so that what is between them is ruled.
"""

import numpy as np

from .mesh import SHELL, Mesh

FEATURES = {
    "flat bottom and side": "the points of three sections lie in them, to the bilge's ends",
    "knuckle of the run": "a crease across the bottom and up the side at x = 9.5 m",
    "swim bow": "the two foremost sections: the bottom rises smoothly to the bow's transom",
    "transoms": "plane, within creases, at both ends",
}
MOST_POINTS = 32

_MIDDLE = {"x": (25.0, 40.0)}
WANTED = [
    ("waterline", "dip", 1, _MIDDLE, "the flat side between run and bow"),
    ("waterline", "dip", 1, {"x": (71.0, 75.5)}, "the bow's side, straight to its transom"),
]

LENGTH, BEAM, DRAFT, DEPTH = 76.5, 11.4, 3.2, 4.0

# Half-breadths, and heights above the bottom, of the rows below the deck edge. The second to the
# fifth are the bilge: a crease or a surface with straight neighbours is within 15 mm of a circle
# of 0.99 m radius there.
BILGE_Y = (0.0, 4.4, 5.17, 5.7, 5.7)
BILGE_Z = (0.0, 0.0, 0.0, 0.53, 1.3)
# x, height of the bottom, height of the deck edge.
SECTIONS = ((0.0, 1.7, 4.0), (9.5, 0.0, 4.0), (58.0, 0.0, 4.0), (67.5, 0.0, 4.0))
# The bow's transom: narrower by this part, its bilge of the same form.
BOW = (76.5, 2.2, 4.5)
BOW_Y = (0.0, 3.56, 4.176, 4.6, 4.6)
BOW_Z = (0.0, 0.0, 0.0, 0.424, 1.04)


def section(x, bottom, deck, half_breadths=BILGE_Y, heights=BILGE_Z):
    rows = [(x, y, bottom + z) for y, z in zip(half_breadths, heights)]
    return np.round([*rows, (x, half_breadths[-1], deck)], 4)


def make(hull_io):
    mesh = Mesh([SHELL, ("Transoms", (0.7, 0.7, 0.68))])
    rows = [mesh.row(section(*place)) for place in SECTIONS]
    rows.append(mesh.row(section(*BOW, BOW_Y, BOW_Z)))
    mesh.strips(rows)
    mesh.crease(rows[1])
    for rim, turn in ((rows[0], 1), (rows[-1], -1)):
        add_transom(mesh, rim, turn)
    return mesh.hull(
        hull_io,
        "Inland barge",
        "designed for this project, after the simple barges of inland navigation",
        length_pp=LENGTH,
        beam=BEAM,
        draft=DRAFT,
        depth=DEPTH,
        water_density=1.0,
    )


def add_transom(mesh, rim, turn):
    """Strips across a transom from the centre plane; turn: 1 for one that looks aft, -1 forward."""
    keel, flat, low, bilge, side, deck = rim
    x, _, z = mesh.points[deck]
    top = mesh.point((x, 0.0, z))
    mesh.crease(rim)
    mesh.face(*turned((keel, top, deck, flat), turn), layer=1)
    mesh.face(*turned((flat, deck, side, low), turn), layer=1)
    mesh.face(*turned((low, side, bilge), turn), layer=1)


def turned(face, turn):
    """A face's points from the same first one on, in their order or against it."""
    return face if turn > 0 else (face[0], *face[:0:-1])
