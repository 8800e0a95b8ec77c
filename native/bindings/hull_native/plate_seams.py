# SPDX-License-Identifier: GPL-3.0-or-later
"""Which parts of seams are borders of plates."""

import numpy as np


def used_seams(curves, seams, plates):
    """The seams, SurfaceCurves of HullCurves, that plates() of them have as borders: of those with
    stretches that end within a plate, which were left out, the pieces between other seams that are
    not."""
    borders = _borders(plates)
    used = []
    for k, seam in enumerate(seams):
        pieces = curves.pieces(seam, [*seams[:k], *seams[k + 1 :]])
        kept = [piece for piece in pieces if _is_on(piece.points, borders.get(seam.name))]
        used += [seam] if len(kept) == len(pieces) else kept
    return used


def _borders(plates):
    """By the names of curves the chords (k, 2, 3) of the plates' sides there."""
    found = {}
    for plate in plates:
        for name, line in (side for loop in plate.loops for side in loop):
            found.setdefault(name, []).append(np.stack([line[:-1], line[1:]], axis=1))
    return {name: np.concatenate(chords) for name, chords in found.items()}


def _is_on(points, chords):
    """Whether the middle of a polyline is nearer to one of these chords than its quarter is
    long."""
    if chords is None:
        return False
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    middle = [np.interp(0.5 * along[-1], along, points[:, axis]) for axis in range(3)]
    start, way = chords[:, 0], chords[:, 1] - chords[:, 0]
    length = np.maximum((way * way).sum(axis=1), np.finfo(float).tiny)
    share = np.clip(((middle - start) * way).sum(axis=1) / length, 0.0, 1.0)
    off = np.linalg.norm(start + share[:, None] * way - middle, axis=1)
    return bool(off.min() < 0.25 * along[-1])
