# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of docs/fields.md that shows the recipes of shape fields, before and after.

PYTHONPATH=build/release/python:samples python3 scripts/recipe_figures.py HULLS FOLDER

HULLS: what recipe_hulls.py wrote; into FOLDER: field-recipes.png.
"""

import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import vessels
from figures import paper
from figures.before_after import AFTER, BEFORE, TITLE, Frame, cuts, paint_both

# The page in mm, margins, and the width that is shown in the docs, in dots.
WIDTH, HEIGHT, MARGIN, GAP, COLUMN, SMALL, LABEL = 248.0, 314.0, 8.0, 8.0, 112.0, 1400, 2.8


@dataclass(frozen=True)
class Picture:
    """title; axis: across which sections are cut, at places, parts of the hull's extent there;
    axes: the coordinates that are to the right and up; low, high (2,): of the frame, parts of the
    extent; stretch: upwards."""

    title: str
    axis: str
    places: tuple
    axes: tuple
    low: tuple
    high: tuple
    stretch: float = 1.0


def _from(first, last, count):
    return tuple(np.linspace(first, last, count))


_WATERLINES = ("z", _from(0.1, 0.95, 9), (0, 1), (0.6, 0.0), (1.02, 1.08), 2.0)
_BODY = ("x", _from(0.62, 0.98, 10), (1, 2), (-0.05, -0.05), (1.2, 1.15))
PICTURES = {
    "sharpen": Picture("Sharper Fore Ship: waterlines", *_WATERLINES),
    "fatten": Picture("Fuller Fore Ship: waterlines", *_WATERLINES),
    "sheer": Picture(
        "Raise the Sheer: profile and buttocks",
        "y",
        _from(0.1, 0.8, 4),
        *((0, 2), (0.4, -0.05), (1.02, 1.15), 2.0),
    ),
    "flare": Picture("Flare: stations of the fore ship", *_BODY),
    "bilge": Picture(
        "Move the Bilge: stations", "x", _from(0.42, 0.62, 5), (1, 2), (0.5, -0.03), (1.05, 0.3)
    ),
    "tunnel": Picture(
        "Tunnel: stations of the after ship",
        "x",
        _from(0.03, 0.2, 8),
        (1, 2),
        (0.0, 0.1),
        (1.0, 0.6),
    ),
    "bulb": Picture(
        "Bulb: profile and buttocks",
        "y",
        _from(0.02, 0.17, 4),
        *((0, 2), (0.87, -0.02), (1.03, 0.7)),
    ),
}


def surfaces_of(name, folder):
    """The hull_native.LimitSurfaces before and after."""
    files = (folder / f"{name}-{when}.hull.json" for when in ("before", "after"))
    return [vessels.surface_of(hull_io.read_hull(file)) for file in files]


def outlines(surface):
    """Points (n, 3) of its creases and borders."""
    curves = hn.crease_curves(surface)
    samples = (np.linspace(0.0, c.edge_count, 16 * c.edge_count + 1) for c in curves)
    return [curve.evaluate(t)[0] for curve, t in zip(curves, samples)]


def paint_picture(context, picture, both, left, top):
    """Returns where it ends, in mm from above."""
    points = both[0].evaluate_grid(4)[0].reshape(-1, 3)
    low, size = points.min(axis=0), np.ptp(points, axis=0)
    axes, axis = list(picture.axes), "xyz".index(picture.axis)
    corners = [low[axes] + size[axes] * part for part in (picture.low, picture.high)]
    scale = COLUMN / (corners[1] - corners[0])[0]
    frame = Frame(left, top + TITLE, scale, *corners, picture.stretch)
    frame.title(context, picture.title)
    places = low[axis] + size[axis] * np.array(picture.places)
    lines = [cuts(surface, picture.axis, places) + outlines(surface) for surface in both]
    paint_both(context, frame, picture.axes, *lines)
    return frame.bottom


def paint(folder):
    def painted(context):
        ends = [MARGIN, MARGIN]
        for name, picture in PICTURES.items():
            column = int(ends[1] < ends[0])
            left = MARGIN + column * (COLUMN + GAP)
            bottom = paint_picture(context, picture, surfaces_of(name, folder), left, ends[column])
            ends[column] = bottom + GAP
        at = MARGIN
        for words, colour in (("before", BEFORE), ("after", AFTER)):
            paper.line(context, [(at, max(ends)), (at + 8.0, max(ends))], 0.5, colour)
            paper.text(context, (at + 10.0, max(ends) + 1.0), words, LABEL, align=0.0)
            at += 16.0 + paper.text_width_of(context, words, LABEL)

    return painted


def main():
    hulls, folder = map(Path, sys.argv[1:3])
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        stem = Path(temporary) / "recipes"
        paper.draw(stem, WIDTH, HEIGHT, paint(hulls))
        paper.make_small(f"{stem}.png", folder / "field-recipes.png", SMALL)


if __name__ == "__main__":
    main()
