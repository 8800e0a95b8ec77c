# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the container ship with the surface it was fitted to: sections, and distances.

PYTHONPATH=build/dev/python:samples python3 scripts/compare_container_ship.py PICTURE.svg

writes the sections of both at 11 stations and prints distances of the target's points below the
water from the exact surface, by parts of the ship, as a table in Markdown.
"""

import sys
from pathlib import Path

import hull_native as hn
import numpy as np
import target_hulls
import vessels

NAME = "container_ship"
COUNT = 200000
# Parts of the ship, x in m.
PARTS = (
    ("Stern, to 0.1 Lpp", -10.0, 35.5),
    ("Run, 0.1 to 0.35 Lpp", 35.5, 124.25),
    ("Middle, 0.35 to 0.65 Lpp", 124.25, 230.75),
    ("Entrance, 0.65 to 0.9 Lpp", 230.75, 319.5),
    ("Bow, from 0.9 Lpp", 319.5, 370.0),
    ("Whole", -10.0, 370.0),
)
_DOTS = 14.0  # of the picture, a metre
_STYLES = {"target": "#c0392b", "mesh": "#111111"}


def distances(vessel, corners):
    """Points of the target below the water and their distances, m."""
    points, normals = target_hulls.samples(corners, COUNT)
    below = (points[:, 1] >= 0.0) & (points[:, 2] < vessel.data.particulars.draft)
    points = points[below]
    return points, hn.SurfaceTree(vessel.surface).closest_points(points).distances


def table(points, apart):
    yield "| | RMS, mm | 95 %, mm | largest, mm |"
    yield "|---|---|---|---|"
    for label, aft, forward in PARTS:
        part = 1e3 * apart[(points[:, 0] >= aft) & (points[:, 0] < forward)]
        rms = np.sqrt(np.mean(part**2))
        yield f"| {label} | {rms:.0f} | {np.percentile(part, 95):.0f} | {part.max():.0f} |"


def stations(length):
    """Stations 0 to 10."""
    return [length * k / 10.0 for k in range(11)]


def path(points, colour, width):
    places = " ".join(f"{y:.2f},{z:.2f}" for y, z in points)
    return f'<polyline points="{places}" stroke="{colour}" stroke-width="{width}"/>'


def picture(vessel, corners):
    """Sections as SVG: the after body to the left, the fore body to the right."""
    given = vessel.data.particulars
    half, top = 0.5 * given.beam + 1.0, given.depth + 1.0
    drawn = []
    for place in stations(given.length_pp):
        side = -1.0 if place < 0.5 * given.length_pp else 1.0

        def seen(points):
            points = np.asarray(points)
            return np.stack([half + side * points[:, 1], top - points[:, 2]], axis=1) * _DOTS

        segments = target_hulls.section(corners, 0, place + 1e-4)
        segments = segments[segments[:, :, 1].mean(axis=1) > 0.0]
        segments = segments[segments[:, :, 2].mean(axis=1) < given.depth - 0.02]
        drawn += [path(seen(ends), _STYLES["target"], 3.5) for ends in segments]
        for curve in hn.sections(vessel.surface, [[1.0, 0.0, 0.0, place]])[0]:
            drawn.append(path(seen(curve.points), _STYLES["mesh"], 1.2))
    water = (top - given.draft) * _DOTS
    wide, high = 2.0 * half * _DOTS, (top + 1.0) * _DOTS
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide:.0f}" height="{high:.0f}">',
            '<rect width="100%" height="100%" fill="white"/>',
            f'<line x1="0" x2="{wide:.0f}" y1="{water:.1f}" y2="{water:.1f}" stroke="#3498db"/>',
            '<g fill="none" stroke-linecap="round">',
            *drawn,
            "</g>",
            '<g font-family="sans-serif" font-size="16">',
            f'<text x="20" y="24" fill="{_STYLES["target"]}">published surface</text>',
            f'<text x="20" y="46" fill="{_STYLES["mesh"]}">control mesh of 136 points</text>',
            "</g></svg>",
        ]
    )


def main():
    vessel = vessels.vessel(NAME)
    corners = target_hulls.triangles(NAME)
    Path(sys.argv[1]).write_text(picture(vessel, corners) + "\n")
    print("\n".join(table(*distances(vessel, corners))))


if __name__ == "__main__":
    main()
