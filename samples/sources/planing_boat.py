# SPDX-License-Identifier: GPL-3.0-or-later
"""A fast motor boat: hard chine, warped bottom from a fine bow to a deadrise of 14 degrees aft.

Nine sections and the stem, seven rows of points along the ship: keel, two in the bottom, the chine,
two in the side, the deck edge. Keel and stem are one curve, chine and deck edge one each; what is
between them is nearly straight, a little round forward.
"""

import numpy as np

from .mesh import Mesh, largest

FEATURES = {
    "hard chine": "a crease along the fourth row, from the transom to the stem",
    "deadrise": "keel and chine run straight aft, the bottom between them straight across",
    "fine bow": "the chine rises, the rows of the bottom draw in to the stem",
    "raked transom": "plane faces in a layer of their own, within a crease",
}
MOST_POINTS = 69

WANTED = [
    (
        "waterline",
        "dip",
        1,
        {"x": (7.0, 9.0), "y": (0.7, 1.4), "z": (0.3, 0.55)},
        "from the run, along the nearly level bottom, to a straight entrance",
    ),
]

LENGTH, BEAM, DRAFT, DEPTH = 11.4, 3.9, 0.7, 1.75
# The transom: x at the base line, and how far it leans, x over z.
TRANSOM_X, TRANSOM_RAKE = 0.14, -0.2
# Keel points of the sections, closer where the keel turns up.
STATIONS = np.array([0.0, 1.45, 2.9, 4.35, 5.8, 7.2, 8.5, 9.65, 10.65])
# The rows of the bottom and of the side, in parts of the way from keel to chine to deck edge.
BOTTOM, SIDE = np.array([1, 2]) / 3, np.array([1, 2]) / 3
CHINE, DECK = 3, 6
# Where the widest sections are, and where chine and deck edge end at the stem: heights.
WIDEST, CHINE_Z, DECK_Z = 4.4, 1.2, 2.05
# The keel is straight up to the first, the stem's head is at the second.
FOREFOOT, STEM_X = 5.6, 13.19
# How round the sections of the bow are: parts of the half-breadth of the chine.
ROUND = 0.075


def profile(x):
    """Height of keel and stem: one curve that bends more and more."""
    return DECK_Z * np.clip((x - FOREFOOT) / (STEM_X - FOREFOOT), 0.0, None) ** 4.3


def stem_x(z):
    return FOREFOOT + (STEM_X - FOREFOOT) * (z / DECK_Z) ** (1 / 4.3)


def breadth(x, widest, aft, end, power):
    """Half-breadth of chine or deck edge: `aft` less at the transom, none at its end."""
    behind = np.clip((WIDEST - x) / WIDEST, 0.0, None)
    before = np.clip((x - WIDEST) / (end - WIDEST), 0.0, 1.0)
    return widest * (1.0 - aft * behind**2) * (1.0 - before**power)


def rise(x, low, high, first, end, power):
    """Height of chine or deck edge: `low` up to x = first, `high` at its end."""
    return low + (high - low) * np.clip((x - first) / (end - first), 0.0, 1.0) ** power


def lines():
    """Keel, chine and deck edge: points (sections, 3) each."""
    along = np.clip((STATIONS - WIDEST) / (STATIONS[-1] - WIDEST), 0.0, 1.0)
    keel = np.stack([STATIONS, 0.0 * STATIONS, profile(STATIONS)], axis=-1)
    end = stem_x(CHINE_Z)
    x = STATIONS + 0.5 * along**1.8
    chine = np.stack(
        [x, breadth(x, 1.7, 0.05, end, 2.3), rise(x, 0.42, CHINE_Z, 4.0, end, 2.2)], axis=-1
    )
    x = STATIONS + 1.1 * along**1.8
    deck = np.stack(
        [x, breadth(x, 1.95, 0.06, STEM_X, 2.7), rise(x, DEPTH, DECK_Z, 3.0, STEM_X, 2.0)], axis=-1
    )
    return keel, chine, deck


def points():
    """Points (sections, rows, 3); the stem is the last section."""
    keel, chine, deck = lines()
    bow = np.clip((STATIONS - WIDEST) / (STATIONS[-1] - WIDEST), 0.0, 1.0) ** 1.5
    bulge = ROUND * (bow * chine[:, 1])[:, None] * (0.0, 1.0, -0.6)
    bottom = [keel + a * (chine - keel) + 4.0 * a * (1.0 - a) * bulge for a in BOTTOM]
    side = [chine + a * (deck - chine) for a in SIDE]
    grid = np.stack([keel, *bottom, chine, *side, deck], axis=1)
    foot = grid[-1, 0, 2]
    heights = np.array([foot, foot, foot + 0.5 * (CHINE_Z - foot), CHINE_Z, 0, 0, DECK_Z])
    heights[CHINE + 1 : DECK] = CHINE_Z + SIDE * (DECK_Z - CHINE_Z)
    stem = np.stack([stem_x(heights), 0.0 * heights, heights], axis=-1)
    grid = np.concatenate([grid, stem[None]])
    grid[0, :, 0] = TRANSOM_X + TRANSOM_RAKE * grid[0, :, 2]
    grid[:, :, 1] *= 0.5 * BEAM / largest(grid[:, DECK, 1])
    return grid


def make(hull_io):
    mesh = Mesh()
    grid = points()
    rows = mesh.round_stem_body(grid[:-1], grid[-1, 2:])
    mesh.crease([row[CHINE] for row in rows])
    mesh.deck([row[DECK] for row in rows])
    size = np.hypot(1.0, TRANSOM_RAKE)
    mesh.flat((-1.0, 0.0, TRANSOM_RAKE), -TRANSOM_X / size, layer=1)
    return mesh.hull(
        hull_io,
        "Planing boat",
        "designed for this project: a motor boat with hard chines and a warped bottom",
        length_pp=LENGTH,
        beam=BEAM,
        draft=DRAFT,
        depth=DEPTH,
        water_density=1.025,
    )
