# SPDX-License-Identifier: GPL-3.0-or-later
"""A body plan of what a hull was fitted to, pale and wide, and of the hull upon it, thin."""

import numpy as np

from . import paper

# The drawing in mm; around it is room for words.
LARGEST = (240.0, 150.0)
SIDE, TOP, FOOT = 14.0, 12.0, 16.0
SOURCE, HULL, WATER = (0.55, 0.75, 0.95), (0.70, 0.10, 0.06), (0.0, 0.42, 0.30)
LABEL = 2.6


def draw(name, overlays, draft, stem):
    """Writes `stem`.pdf and .png of hull_fitting's StationOverlays: the after half to the left, the
    fore half to the right."""
    every = np.concatenate([one.source.reshape(-1, 2) for one in overlays])
    breadth, low, high = every[:, 0].max(), every[:, 1].min(), every[:, 1].max()
    mm = min(LARGEST[0] / (2.0 * breadth), LARGEST[1] / (high - low))
    width, height = 2.0 * breadth * mm + 2.0 * SIDE, (high - low) * mm + TOP + FOOT

    def at(places, side):
        places = np.asarray(places)
        x = 0.5 * width + side * mm * places[..., 0]
        return np.stack([x, TOP + mm * (high - places[..., 1])], axis=-1)

    def paint(context):
        for ends in ([[-breadth, draft], [breadth, draft]], [[0.0, low], [0.0, high]]):
            paper.line(context, at(ends, 1.0), 0.15, WATER if ends[0][0] else paper.GREY)
        middle = 0.5 * (overlays[0].x + overlays[-1].x)
        for pieces, pen, colour in (("source", 0.9, SOURCE), ("hull", 0.18, HULL)):
            for one in overlays:
                for side in {-1.0 if one.x <= middle else 1.0, 1.0 if one.x >= middle else -1.0}:
                    for piece in at(getattr(one, pieces), side):
                        paper.line(context, piece, pen, colour)
        worst = max(overlays, key=lambda one: one.largest)
        words = (
            f"{name}: stations at x = {', '.join(f'{one.x:.4g}' for one in overlays)} m; farthest "
            f"off {worst.largest:.3g} m, at x = {worst.x:.4g} m"
        )
        paper.text(context, (SIDE, height - 8.0), words, LABEL, paper.BLACK, 0.0)
        paper.text(
            context,
            (SIDE, height - 4.0),
            "wide: the source; thin: the hull",
            LABEL,
            paper.GREY,
            0.0,
        )

    paper.draw(stem, width, height, paint)
