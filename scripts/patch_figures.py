# SPDX-License-Identifier: GPL-3.0-or-later
"""The container ship's patches in pictures, after figures 7.2 and 7.3 of Greshake 2021.

PYTHONPATH=build/release/python:samples python3 scripts/patch_figures.py FOLDER [VIEW ...]

into FOLDER: patches-ship-reflection.png, patches-ship-distance.png, patches-bulb-reflection.png and
patches-bulb-distance.png; a table in Markdown to the terminal. VIEW is ship or bulb; without any:
both. The published surface of the Duisburg Test Case lies beside the project (see
target_hulls.py); without it its pictures are left out.
"""

import math
import sys
from dataclasses import dataclass
from pathlib import Path

import cairo
import hull_native as hn
import numpy as np
import target_hulls
import vessels
from figures import paper, seen_surface
from hull_fairness.lights import BANDS

NAME = "container_ship"
# Of one picture of a page, in dots.
WIDTH = {"ship": 640, "bulb": 480}
# Dots of a picture that are computed for each that is shown, in both directions.
FINER = 2
# Bearing from the bow to port and elevation in degrees; x from (over Lpp), z to (over the draft).
VIEWS = {"ship": (52.0, -14.0, -1.0, 10.0), "bulb": (58.0, -10.0, 0.952, 0.95)}
LIGHT, DARK, AROUND = (0.95, 0.95, 0.96), (0.10, 0.13, 0.18), (0.70, 0.72, 0.74)
BORDER = (0.86, 0.28, 0.10)
# Of BANDS.
BAND_FACTOR = {"ship": 0.5, "bulb": 1.0}
# log10 of distances in m.
LEAST, MOST = -7.0, 0.0
FOOT, GAP = 34, 14


@dataclass
class Shape:
    """One of the pictures of a page: what it shows, under which words."""

    words: str
    see: object  # adds it to a seen_surface.Seen
    patches: object = None
    has_distance: bool = True


def shapes(surface):
    yield Shape("exact surface", lambda seen: seen_surface.see_surface(seen, surface), None, False)
    try:
        corners = target_hulls.triangles(NAME)
        yield Shape(
            "Duisburg Test Case, as published",
            lambda seen: seen_surface.see_triangles(seen, corners),
        )
    except FileNotFoundError as error:
        print(f"left out: {error}", file=sys.stderr)
    sets = [(f"a patch a cell, n = {n}", hn.fit_per_cell(surface, n)) for n in (4, 5, 6, 7)]
    sets.append(("exact patches", hn.exact_patches(surface)))
    for words, patches in sets:
        found = hn.measure_quality(surface, patches)
        angle = max(found.largest_seam_angle, found.largest_seam_angle_at_points)
        size = (
            f"{found.patch_count} patches, {1e3 * found.largest_distance:.2g} mm, "
            f"{math.degrees(angle):.2g}°"
        )
        print(f"| {words} | {size.replace(', ', ' | ')} | {found.control_point_count} |")
        yield Shape(
            f"{words}: {size}",
            lambda seen, patches=patches: seen_surface.see_patches(seen, patches),
            patches,
        )


def view_of(surface, given, name, width):
    bearing, elevation, aft, top = VIEWS[name]
    points = surface.evaluate_grid(4)[0].reshape(-1, 3)
    points = np.concatenate([points, points * [1.0, -1.0, 1.0]])
    points = points[(points[:, 0] > aft * given.length_pp) & (points[:, 2] < top * given.draft)]
    probe = seen_surface.View(bearing, elevation, (0.0, 1.0, 0.0, 1.0), 1)
    x, y = points @ probe.right, points @ probe.up
    margin = 0.03 * np.ptp(x)
    window = (x.min() - margin, x.max() + margin, y.min() - margin, y.max() + margin)
    return seen_surface.View(bearing, elevation, window, width)


def reflections(seen, factor):
    """(dots, 3): the colour of the light that each dot mirrors, of bands along the ship."""
    eye, normals = seen.view.eye, seen.normals
    mirrored = 2.0 * (normals @ eye)[:, None] * normals - eye
    turns = np.arctan2(mirrored[:, 2], mirrored[:, 1]) * factor * BANDS / (2.0 * math.pi)
    colours = np.where((turns % 1.0 > 0.5)[:, None], LIGHT, DARK)
    colours[~np.isfinite(seen.depth)] = AROUND
    return colours


def scale_colours(values):
    return hn.colour_scale(values, kind="slope", limits=(LEAST, MOST)).colours(values)


def distance_colours(seen, surface):
    """Of every FINER-th dot in both directions, (height, width, 3)."""
    height, width = (FINER * (n // FINER) for n in (seen.view.height, seen.view.width))
    grid = seen.points.reshape(seen.view.height, seen.view.width, 3)
    apart = seen_surface.distances(grid[:height:FINER, :width:FINER].reshape(-1, 3), surface)
    colours = scale_colours(np.log10(np.clip(apart, 10.0**LEAST, 10.0**MOST)))
    colours[~np.isfinite(apart)] = AROUND
    return colours.reshape(height // FINER, width // FINER, 3)


def paint_borders(colours, seen, points):
    """Dots of border points that are seen, and those beside them."""
    metre = seen.view.dots_per_metre
    for side in (1.0, -1.0):
        there = points * [1.0, side, 1.0]
        there = there[seen.is_seen(there, 4.0 / metre)]
        columns, rows = np.floor(seen.view.dots(there)).astype(int).T
        for down in range(FINER):
            for right in range(FINER):
                at_row = np.minimum(rows + down, seen.view.height - 1)
                at_column = np.minimum(columns + right, seen.view.width - 1)
                colours[at_row * seen.view.width + at_column] = BORDER


def write_page(path, pictures, legend):
    """Pictures (h, w, 3) with their words, in two columns; legend: whether there is one."""
    height, width = pictures[0][1].shape[:2]
    rows = math.ceil(len(pictures) / 2)
    full = rows * (height + FOOT) + (FOOT if legend else 0)
    page = cairo.ImageSurface(cairo.FORMAT_RGB24, 2 * width + GAP, full)
    context = cairo.Context(page)
    context.set_source_rgb(1.0, 1.0, 1.0)
    context.paint()
    for number, (words, dots) in enumerate(pictures):
        left, top = number % 2 * (width + GAP), number // 2 * (height + FOOT)
        context.set_source_surface(paper.image(dots), left, top)
        context.paint()
        label = f"({chr(ord('a') + number)}) {words}"
        paper.text(context, (left + 0.5 * width, top + height + 0.62 * FOOT), label, 17.0)
    if legend:
        _paint_legend(context, 2 * width + GAP, rows * (height + FOOT))
    page.write_to_png(str(path))


def _paint_legend(context, width, top):
    bar, left = 0.56 * width, 0.22 * width
    colours = scale_colours(np.linspace(LEAST, MOST, round(bar)))
    for column, colour in enumerate(colours):
        context.set_source_rgb(*colour)
        context.rectangle(left + column, top, 1.5, 0.35 * FOOT)
        context.fill()
    names = ("0.1 µm", "1 µm", "10 µm", "0.1 mm", "1 mm", "10 mm", "0.1 m", "1 m")
    for number, name in enumerate(names):
        at = left + bar * number / (len(names) - 1)
        paper.text(context, (at, top + 0.85 * FOOT), name, 15.0)


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    vessel = vessels.vessel(NAME)
    surface, given = vessel.surface, vessel.data.particulars
    print("| | patches | largest distance | largest angle at seams | control points |")
    print("|---|---|---|---|---|")
    wanted = list(shapes(surface))
    for name in sys.argv[2:] or VIEWS:
        view = view_of(surface, given, name, FINER * WIDTH[name])
        mirrors, apart = [], []
        for shape in wanted:
            seen = seen_surface.Seen(view)
            shape.see(seen)
            colours = reflections(seen, BAND_FACTOR[name])
            if shape.patches is not None:
                paint_borders(colours, seen, seen_surface.border_points(shape.patches, view))
            mirrors.append((shape.words, view.shown(colours, FINER)))
            if shape.has_distance:
                apart.append((shape.words, distance_colours(seen, surface)))
        write_page(folder / f"patches-{name}-reflection.png", mirrors, legend=False)
        write_page(folder / f"patches-{name}-distance.png", apart, legend=True)


if __name__ == "__main__":
    main()
