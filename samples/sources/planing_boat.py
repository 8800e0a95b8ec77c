# SPDX-License-Identifier: GPL-3.0-or-later
"""A fast motor boat: chine flat and spray rail, warped bottom from a fine bow to 20 degrees aft.

Nine sections and the stem, eight rows of points along the ship: keel, one in the bottom, the level
strips of spray rail and chine with two each, one in the side, the deck edge. Keel and stem are one
curve, chine and deck edge one each; what is between them is nearly straight, a little round
forward.
"""

import numpy as np

from .mesh import Mesh, largest

FEATURES = {
    "chine flat": "a level strip between two creases, 0.12 m wide aft, from transom to stem",
    "spray rail": "a level strip between two creases halfway from keel to chine",
    "deadrise": "keel and chine run straight aft, the bottom between them straight across",
    "fine bow": "the chine rises, the rows of the bottom draw in to the stem",
    "raked transom": "plane faces in a layer of their own, within a crease",
}
MOST_POINTS = 77

_BOTTOM = {"x": (6.0, 11.2), "z": (0.1, 0.65)}
WANTED = [
    ("reflection", "wave", 2, _BOTTOM, "bottom round between straight edges of keel and rail"),
    ("reflection", "wave", 1, {"x": (11.8, 12.3)}, "side, straight to the stem"),
]

LENGTH, BEAM, DRAFT, DEPTH = 11.4, 3.9, 0.7, 1.75
# The transom: x at the base line, and how far it leans, x over z.
TRANSOM_X, TRANSOM_RAKE = 0.14, -0.2
# Keel points of the sections, closer where the keel turns up.
STATIONS = np.array([0.0, 1.45, 2.9, 4.35, 5.8, 7.2, 8.5, 9.65, 10.65])
# Where the first row of the bottom, the rail, and the row of the side are, in parts of the way from
# keel to chine and from chine to deck edge.
FIRST, RAIL, SIDE = 0.25, 0.5, 0.5
# Inner and outer edges of the level strips, and the deck edge, by their rows.
RAIL_EDGES, CHINE_EDGES, DECK = (2, 3), (4, 5), 7
# How wide the strips of rail and chine are aft; they narrow towards the stem.
RAIL_WIDTH, CHINE_WIDTH = 0.06, 0.12
# Where the widest sections are, and where rail, chine and deck edge end at the stem: heights.
WIDEST, RAIL_Z, CHINE_Z, DECK_Z = 4.4, 0.86, 1.3, 2.05
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
        [x, breadth(x, 1.7, 0.05, end, 2.3), rise(x, 0.56, CHINE_Z, 4.0, end, 2.2)], axis=-1
    )
    x = STATIONS + 1.1 * along**1.8
    deck = np.stack(
        [x, breadth(x, 1.95, 0.06, STEM_X, 2.7), rise(x, DEPTH, DECK_Z, 3.0, STEM_X, 2.0)], axis=-1
    )
    return keel, chine, deck


def points():
    """Points (sections, rows, 3); the stem is the last section."""
    keel, chine, deck = lines()
    bow = np.clip((STATIONS - WIDEST) / (STATIONS[-1] - WIDEST), 0.0, 1.0)
    inward = (1.0 - 0.6 * bow**2)[:, None] * (0.0, -1.0, 0.0)
    inner = chine + CHINE_WIDTH * inward
    rail = RAIL_WIDTH * inward
    bulge = ROUND * (bow**1.5 * chine[:, 1])[:, None] * (0.0, 1.0, -0.6)

    def across(part):
        return keel + part * (inner + rail - keel) + 4.0 * part * (1.0 - part) * bulge

    side = chine + SIDE * (deck - chine)
    at_rail = across(RAIL)
    rows = [keel, across(FIRST), at_rail, at_rail - rail, inner, chine, side, deck]
    grid = np.stack(rows, axis=1)
    foot = grid[-1, 0, 2]
    heights = np.array([foot, foot, *[RAIL_Z] * 2, *[CHINE_Z] * 2, 0.0, DECK_Z])
    heights[DECK - 1] = CHINE_Z + SIDE * (DECK_Z - CHINE_Z)
    stem = np.stack([stem_x(heights), 0.0 * heights, heights], axis=-1)
    grid = np.concatenate([grid, stem[None]])
    grid[0, :, 0] = TRANSOM_X + TRANSOM_RAKE * grid[0, :, 2]
    grid[:, :, 1] *= 0.5 * BEAM / largest(grid[:, DECK, 1])
    return grid


def make(hull_io):
    mesh = Mesh()
    grid = points()
    rail, chine, side, deck = (mesh.point(grid[-1, row]) for row in (2, 4, 6, 7))
    # Both edges of a level strip end in one point of the stem.
    rows = mesh.round_stem_body(grid[:-1], [rail, rail, chine, chine, side, deck], is_fan=True)
    for edge in (*RAIL_EDGES, *CHINE_EDGES):
        mesh.crease([row[edge] for row in rows])
    mesh.deck([row[DECK] for row in rows])
    size = np.hypot(1.0, TRANSOM_RAKE)
    mesh.flat((-1.0, 0.0, TRANSOM_RAKE), -TRANSOM_X / size, layer=1)
    return mesh.hull(
        hull_io,
        "Planing boat",
        "designed for this project: a motor boat with hard chines and spray rails",
        length_pp=LENGTH,
        beam=BEAM,
        draft=DRAFT,
        depth=DEPTH,
        water_density=1.025,
    )
