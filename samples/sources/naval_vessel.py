# SPDX-License-Identifier: GPL-3.0-or-later
"""A modern surface combatant: sonar dome under the forefoot, tumblehome above a knuckle.

Fourteen sections and the stem, ten rows of points along the ship: from the keel over a soft bilge
to the waterline and on to the knuckle and the deck edge. Forward the five lowest rows make the
dome, those above it the bow. Points are on curves through few designed values, then faired along
the rows, since steps between points that change evenly are what makes a surface smooth; and at the
forward shoulder across them, too.
"""

import numpy as np

from .mesh import Mesh, faired, faired_patch, largest, spline

FEATURES = {
    "sonar dome": "the five lowest rows end in the dome under and before the forefoot; it is"
    " smooth: no crease, one irregular point of three faces beside its foot",
    "tumblehome": "a crease along the whole ship, above it one strip that leans inboard",
    "raked stem": "the upper half of the last section, straight from the water to the deck",
    "four sections at the forward shoulder": "those at 98, 108, 117 and 125 m",
    "transom": "plane faces in a layer of their own, within a crease; its foot is in the water",
}
MOST_POINTS = 153

WANTED = [
    (
        "station",
        "inflection",
        1,
        {"x": (103.0, 144.0), "z": (0.5, 7.0)},
        "bilge or dome, then flare",
    ),
    ("waterline", "dip", 1, {"x": (120.0, 136.0), "z": (-2.4, 3.0)}, "sides of the dome"),
    (
        "waterline",
        "inflection",
        2,
        {"x": (75.0, 105.0), "z": (0.2, 1.3)},
        "bottom runs into the dome",
    ),
    ("waterline", "dip", 1, {"x": (90.0, 108.0), "z": (1.1, 3.6)}, "bottom runs into the dome"),
    (
        "waterline",
        "dip",
        1,
        {"x": (25.0, 50.0), "z": (3.2, 6.9)},
        "from the transom's corner to midship",
    ),
    (
        "buttock",
        "inflection",
        1,
        {"x": (75.0, 90.0), "z": (-0.1, 0.5)},
        "keel turns down to the dome",
    ),
    ("buttock", "inflection", 1, {"x": (100.0, 128.0), "z": (-2.0, 0.6)}, "the dome's bottom"),
    ("buttock", "inflection", 1, {"x": (126.0, 143.0), "z": (0.2, 2.5)}, "dome, then flare"),
    (
        "buttock",
        "inflection",
        2,
        {"x": (119.0, 127.0), "z": (2.0, 5.0)},
        "the dome's back, then flare",
    ),
    (
        "buttock",
        "inflection",
        1,
        {"x": (126.0, 140.0), "z": (7.0, 10.0)},
        "flare, straight to the knuckle",
    ),
    ("buttock", "dip", 1, {"x": (90.0, 135.0), "z": (6.0, 8.0)}, "flare, straight to the knuckle"),
    ("buttock", "dip", 1, {"x": (75.0, 96.0), "z": (0.3, 1.2)}, "bottom runs into the dome"),
    (
        "buttock",
        "dip",
        1,
        {"x": (35.0, 45.0), "z": (3.0, 4.0)},
        "from the bilge to the straight run",
    ),
    (
        "buttock",
        "inflection",
        1,
        {"x": (0.0, 10.0), "z": (5.0, 7.0)},
        "runs out beside the transom",
    ),
    (
        "feature",
        "inflection",
        1,
        {"x": (75.0, 95.0), "z": (-0.1, 0.1)},
        "keel turns down to the dome",
    ),
    ("feature", "inflection", 1, {"x": (110.0, 120.0), "z": (-2.0, 0.0)}, "the dome's bottom"),
    (
        "feature",
        "inflection",
        1,
        {"x": (141.0, 145.0), "z": (1.0, 3.0)},
        "the dome's nose, then the stem",
    ),
    ("reflection", "wave", 1, {"x": (142.0, 145.5), "z": (-2.0, 1.5)}, "round the dome's nose"),
]

LENGTH, BEAM, DRAFT, DEPTH = 142.0, 18.4, 5.3, 11.0
TRANSOM_X, STEM_X = -3.0, 141.5
ROWS, KNUCKLE, DECK = 10, 8, 9
# The rows below this one end in the dome, the others at the stem.
FIRST_ABOVE_DOME = 5

# Spaces shrink evenly towards the bow, so that forward shoulder and dome have points enough.
STATIONS = np.array([-3, 9.5, 22.5, 36, 49.5, 62.5, 75, 87, 98, 108, 117, 125, 131.5, 136.5])
# How far sections lean forward above the dome, in parts of the stem's rake.
LEAN = {10: 0.06, 11: 0.2, 12: 0.48, 13: 0.77}

# Half-breadths of the rows from the one next to the keel to the deck edge, by x of a section where
# it does not lean. The deck is narrower than the knuckle: tumblehome, which fades towards the stem.
BREADTHS = {
    -3.0: (1.5, 3.1, 4.65, 6.0, 6.9, 7.45, 7.78, 8.0, 7.35),
    25.0: (1.5, 3.45, 5.4, 6.95, 7.95, 8.48, 8.74, 8.88, 8.15),
    50.0: (1.5, 3.6, 5.7, 7.35, 8.4, 8.86, 9.07, 9.18, 8.42),
    75.0: (1.5, 3.55, 5.6, 7.3, 8.38, 8.86, 9.07, 9.2, 8.45),
    98.0: (1.35, 2.82, 4.21, 5.52, 6.51, 7.42, 8.1, 8.66, 8.08),
    108.0: (1.22, 2.54, 3.6, 4.45, 5.19, 6.17, 7.06, 7.95, 7.47),
    117.0: (1.15, 2.4, 3.16, 3.58, 4.02, 4.68, 5.69, 6.94, 6.62),
    125.0: (1.15, 2.35, 2.84, 2.63, 2.72, 3.29, 4.25, 5.62, 5.45),
    131.5: (1.25, 2.5, 2.85, 2.1, 1.55, 1.97, 2.70, 3.98, 3.97),
    136.5: (1.3, 2.45, 2.7, 1.65, 0.75, 0.98, 1.40, 2.12, 2.2),
}
# Heights of the rows between keel and knuckle, in parts of the way. The first two are alike: the
# bottom is level at the centre plane.
HEIGHTS = {
    -3.0: (0, 0.0, 0.01, 0.045, 0.125, 0.27, 0.49, 0.735, 1),
    75.0: (0, 0.006, 0.045, 0.122, 0.259, 0.435, 0.622, 0.811, 1),
    100.0: (0, 0.006, 0.050, 0.138, 0.275, 0.435, 0.61, 0.80, 1),
    131.5: (0, 0, 0.058, 0.17, 0.298, 0.43, 0.58, 0.775, 1),
}
# How much the rows' half-breadths, in and above the dome, and heights above the keel are faired.
STIFF_BREADTHS, STIFF_HEIGHTS = (4.0, 30.0), 2.0
# What is faired across the rows, too, by its sections and rows: the forward shoulder down to the
# dome's back, where the side turns from upright to flare; and how much, along the ship and across.
SHOULDER, STIFF_SHOULDER = (slice(8, 14), slice(4, 8)), (30.0, 10.0)
# How far heights of the lowest rows are faired as heights above the keel, which stays as it is.
KEEL_PART = {1: 1.0, 2: 0.8, 3: 0.4}

# The dome's section next to the stem. Its points are abreast of those in the centre plane, so that
# the dome is round in front; the first is the foot, where keel and stem are joined.
NOSE = (
    (138.8, 0.0, -2.4),
    (138.8, 1.25, -2.4),
    (142.3, 1.65, -1.6),
    (144.0, 1.6, 0.0),
    (141.3, 1.15, 1.75),
)
# The stem from above the foot: round the dome, in to the neck below the water, out to the deck.
STEM = (
    (144.0, 0.0, -1.5),
    (145.5, 0.0, 0.0),
    (143.5, 0.0, 1.8),
    (141.1, 0.0, 3.35),
    (141.55, 0.0, 5.1),
    (144.3, 0.0, 7.95),
    (148.24, 0.0, 11.1),
    (150.87, 0.0, 13.2),
)


def keel(x):
    """Height of the keel: up to the transom's foot, bent least at its ends; down to the dome."""
    aft = np.clip((70.0 - x) / 73.0, 0.0, None)
    fore = np.clip((x - 92.0) / 42.0, 0.0, 1.0)
    run = 4.85 * (1.75 * aft**2.5 - 0.75 * aft**3.5)
    return run - 2.4 * fore**3 * (10.0 - 15.0 * fore + 6.0 * fore**2)


def knuckle(x):
    return 7.3 + 3.8 * np.clip((x - 30.0) / 118.0, 0.0, None) ** 2.5


def deck(x):
    return 10.8 + 2.4 * np.clip((x - 30.0) / 121.0, 0.0, None) ** 2.5


def designed():
    """Points (sections, rows, 3) before they are faired; the stem is the last section."""
    x = np.repeat(STATIONS[:, None], ROWS, axis=1)
    stem = np.array([NOSE[0], NOSE[0], *STEM])
    for section, lean in LEAN.items():
        x[section, FIRST_ABOVE_DOME:] += lean * (stem[FIRST_ABOVE_DOME:, 0] - STEM_X)
    y = spline(list(BREADTHS), [(0.0, *breadths) for breadths in BREADTHS.values()])(STATIONS)
    part = spline(list(HEIGHTS), list(HEIGHTS.values()))(STATIONS)
    bottom, top = keel(STATIONS)[:, None], knuckle(x[:, KNUCKLE])[:, None]
    z = np.hstack([bottom + part * (top - bottom), deck(x[:, DECK])[:, None]])
    points = np.concatenate([np.stack([x, y, z], axis=-1), stem[None]])
    points[-2, : len(NOSE)] = NOSE
    return points


def points():
    """Points (sections, rows, 3): faired along the rows, and as wide as the ship."""
    grid = designed()
    for row in range(1, ROWS):
        above = row >= FIRST_ABOVE_DOME
        line = grid[:, row] if above else grid[:-2, row]
        line[:, 1] = faired(line[:, 1], STIFF_BREADTHS[above])
        if row < KNUCKLE:
            bottom = KEEL_PART.get(row, 0.0) * keel(np.append(STATIONS, STEM_X))[: len(line)]
            line[:, 2] = bottom + faired(line[:, 2] - bottom, STIFF_HEIGHTS)
    grid[:, FIRST_ABOVE_DOME:, 1] *= 0.5 * BEAM / largest(grid[:, KNUCKLE, 1])
    below = grid[:, :DECK, 1]
    grid[:, :DECK, 1] = faired_patch(below, *SHOULDER, *STIFF_SHOULDER)
    return np.round(grid, 4)


def make(hull_io):
    mesh = Mesh()
    grid = points()
    rows = mesh.round_stem_body(grid[:-1], grid[-1, 2:])
    mesh.crease([row[KNUCKLE] for row in rows])
    mesh.deck([row[DECK] for row in rows])
    mesh.flat((-1, 0, 0), -TRANSOM_X, layer=1)
    return mesh.hull(
        hull_io,
        "Naval vessel",
        "designed for this project: a surface combatant with sonar dome and tumblehome",
        length_pp=LENGTH,
        beam=BEAM,
        draft=DRAFT,
        depth=DEPTH,
        water_density=1.025,
    )
