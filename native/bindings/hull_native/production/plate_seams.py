# SPDX-License-Identifier: GPL-3.0-or-later
"""Which parts of seams are borders of plates."""

from ..polylines import foot_on, lengths_along, middle_of


def used_seams(curves, seams, plates):
    """The seams, SurfaceCurves of HullCurves, that plates() of them have as borders: of those with
    stretches that end within a plate, which were left out, the pieces between other seams that are
    not."""
    borders = _borders(plates)
    used = []
    for k, seam in enumerate(seams):
        pieces = curves.pieces(seam, [*seams[:k], *seams[k + 1 :]])
        kept = [piece for piece in pieces if _is_on(piece.points, borders.get(seam.name, ()))]
        used += [seam] if len(kept) == len(pieces) else kept
    return used


def _borders(plates):
    """By the names of curves the plates' sides there, (k, 3) each."""
    found = {}
    for plate in plates:
        for name, line in (side for loop in plate.loops for side in loop):
            found.setdefault(name, []).append(line)
    return found


def _is_on(points, borders):
    """Whether the middle of a polyline is nearer to one of these lines than its quarter is long."""
    middle, near = middle_of(points), 0.25 * lengths_along(points)[-1]
    return any(foot_on(line, lengths_along(line), middle)[1] < near for line in borders)
