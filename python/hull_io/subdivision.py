# SPDX-License-Identifier: GPL-3.0-or-later
"""Points of a control mesh subdivided as FREE!ship shows it: after some steps of Catmull and Clark,
not at their limits. Plain NumPy, for the few numbers in which files mean that mesh."""

import numpy as np

MAX_CELLS = 2_000_000


def subdivided(points, faces, creases, corners, levels):
    """(m, 3) the points after `levels` steps, or fewer where there would be more than MAX_CELLS.

    points (n, 3); faces: lists of indices; creases: pairs; corners: indices. Borders are creases,
    and a border point of a single face is a corner.
    """
    used, indices = np.unique(np.concatenate([np.asarray(f) for f in faces]), return_inverse=True)
    number = {old: new for new, old in enumerate(used.tolist())}
    mesh = (
        np.asarray(points, dtype=np.float64)[used],
        np.array([len(face) for face in faces]),
        indices.reshape(-1),
        np.array([[number[a], number[b]] for a, b in creases], dtype=np.int64).reshape(-1, 2),
        np.array([number[point] for point in corners if point in number], dtype=np.int64),
    )
    for _ in range(levels):
        if len(mesh[2]) > MAX_CELLS:
            break
        mesh = _step(*mesh)
    return mesh[0]


def _step(points, sizes, loops, creases, corners):
    """One step, to faces of four corners."""
    n, count = len(points), len(sizes)
    owner = np.repeat(np.arange(count), sizes)
    starts = np.cumsum(sizes) - sizes
    following = np.arange(1, len(loops) + 1)
    following[starts + sizes - 1] = starts
    before = np.empty_like(following)
    before[following] = np.arange(len(loops))
    centres = np.add.reduceat(points[loops], starts) / sizes[:, None]

    sides = np.sort(np.stack([loops, loops[following]], axis=1), axis=1)
    keys, edge_of, users = np.unique(
        sides[:, 0] * n + sides[:, 1], return_inverse=True, return_counts=True
    )
    edge_of = edge_of.reshape(-1)
    edges = np.stack([keys // n, keys % n], axis=1)
    tagged = np.sort(creases, axis=1)
    is_crease = (users != 2) | np.isin(keys, tagged[:, 0] * n + tagged[:, 1])

    middles = 0.5 * points[edges].sum(axis=1)
    beside = _summed(len(edges), edge_of, centres[owner])
    inserted = np.where(is_crease[:, None], middles, 0.5 * middles + 0.25 * beside)

    # Around each point: its faces, the middles of its edges, its creases.
    valence = np.bincount(loops, minlength=n)
    around = _summed(n, loops, centres[owner])
    ends = edges.reshape(-1)
    edge_count = np.bincount(ends, minlength=n)
    spokes = _summed(n, ends, np.repeat(middles, 2, axis=0))
    crease_ends = edges[is_crease].reshape(-1)
    crease_count = np.bincount(crease_ends, minlength=n)
    along = _summed(n, crease_ends, np.repeat(middles[is_crease], 2, axis=0))

    k = np.maximum(valence, 1)[:, None]
    smooth = around / k / k + 2.0 * spokes / np.maximum(edge_count, 1)[:, None] / k
    smooth = smooth + (k - 3.0) / k * points
    is_fixed = (crease_count > 2) | ((valence == 1) & (crease_count == 2))
    is_fixed[corners] = True
    moved = np.where((crease_count == 2)[:, None], 0.5 * points + 0.25 * along, smooth)
    moved = np.where(is_fixed[:, None], points, moved)

    quads = np.stack([loops, n + edge_of, n + len(edges) + owner, n + edge_of[before]], axis=1)
    halves = np.stack([edges, np.repeat((n + np.arange(len(edges)))[:, None], 2, axis=1)], axis=2)
    return (
        np.concatenate([moved, inserted, centres]),
        np.full(len(loops), 4),
        quads.reshape(-1),
        halves[is_crease].reshape(-1, 2),
        corners,
    )


def _summed(count, where, values):
    result = np.zeros((count, values.shape[1]))
    np.add.at(result, where, values)
    return result
