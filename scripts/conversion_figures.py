# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of docs/conversion.md: errors against the grading as plots, and one patch a cell
against exact patches as a table.

PYTHONPATH=build/dev/python python3 scripts/conversion_figures.py FOLDER [FILE ...]

The plots go into FOLDER, tables of hulls (.hull.json, .fbm, .ftm) to the terminal.
"""

import math
import sys
import tempfile
import time
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np

ROOT = Path(__file__).resolve().parents[1]

VALENCES = (3, 5, 6, 8)
GRADINGS = np.arange(2, 17)
SEED = 7
COLOURS = ((0.1, 0.3, 0.7), (0.1, 0.55, 0.4), (0.8, 0.45, 0.0), (0.45, 0.25, 0.1))
SEAM_ANGLE = math.radians(0.02)
ANY_ANGLE = 1.0  # met without moving anything


def fan(valence, rings=3):
    """Faces of four corners around one point, moved at random; every other point is regular."""
    angles = 2.0 * np.pi * np.arange(valence) / valence
    spokes = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    numbers, points = {}, []

    def number(sector, a, b):
        """Of the point a steps along a spoke and b along the next."""
        if b and not a:
            sector, a, b = sector + 1, b, 0
        key = (sector % valence if a else 0, a, b)
        if key not in numbers:
            numbers[key] = len(points)
            points.append(a * spokes[sector % valence] + b * spokes[(sector + 1) % valence])
        return numbers[key]

    faces = [
        [
            number(sector, a, b),
            number(sector, a + 1, b),
            number(sector, a + 1, b + 1),
            number(sector, a, b + 1),
        ]
        for sector in range(valence)
        for a in range(rings)
        for b in range(rings)
    ]
    flat = np.array(points)
    heights = 0.1 * (flat[:, :1] ** 2 - 0.5 * flat[:, 1:] ** 2)
    moves = 0.15 * np.random.default_rng(SEED).uniform(-1.0, 1.0, (len(flat), 3))
    moved = np.hstack([flat, heights]) + moves
    return hn.ControlMesh(moved, np.full(len(faces), 4), np.concatenate(faces))


def eigenvalues(valence):
    """Of the subdivision around a point: that of the tangent plane, and the largest of those that
    bend the surface (Halstead, Kass & DeRose 1993)."""

    def of_wave(cosine):
        return (5.0 + cosine + math.sqrt((cosine + 9.0) * (cosine + 1.0))) / 16.0

    tangent = of_wave(math.cos(2.0 * math.pi / valence))
    own, edges = 1.0 - 1.75 / valence, 1.5 / valence
    cup = (4.0 * own - 1.0 + math.sqrt((4.0 * own - 1.0) ** 2 + 8.0 * edges - 4.0)) / 8.0
    saddle = of_wave(math.cos(4.0 * math.pi / valence)) if valence > 3 else 0.0
    return tangent, max(cup, saddle)


def measured(surface, seam_angle):
    """Distances over the length, and angles in degrees, for all gradings."""
    found = []
    for grading in GRADINGS:
        patches = hn.exact_patches(surface, grading=int(grading), seam_angle=seam_angle)
        report = hn.measure_quality(surface, patches, normal_reach=0.0)
        angle = max(report.largest_seam_angle, report.largest_seam_angle_at_points)
        found.append((report.largest_distance_per_length, math.degrees(angle)))
    return np.array(found).T


def draw(path, title, label, curves, low):
    """Fitted seams as lines; dashed what is there before, with its slope."""
    plot = hn.Plot(title)
    plot.add_x_axis("Grading K: how often knots are halved", range=(2, 16))
    plot.set_y_axis(f"log\N{SUBSCRIPT ONE}\N{SUBSCRIPT ZERO} of the {label}")
    for (valence, fitted, before, ratio), colour in zip(curves, COLOURS):
        for values, style, name in (
            (fitted, "solid", f"{valence} faces"),
            (before, "dashed", f"not fitted: {ratio:.3f} a halving"),
        ):
            shown = values > low
            numbers = np.log10(values[shown])
            plot.add_curve(name, GRADINGS[shown], numbers, style=style, colour=colour)
    hn.write_plot(plot, path)


def plots(folder):
    distances, angles = [], []
    for valence in VALENCES:
        tangent, bend = eigenvalues(valence)
        surface = hn.LimitSurface(fan(valence))
        fitted, before = measured(surface, SEAM_ANGLE), measured(surface, ANY_ANGLE)
        last = before[:, 4] / before[:, 0]
        print(
            f"{valence} faces: lambda {tangent:.4f}, mu {bend:.4f}, expected a halving "
            f"{bend:.4f} and {bend / tangent:.4f}, measured {last[0] ** 0.25:.4f} and "
            f"{last[1] ** 0.25:.4f}"
        )
        distances.append((valence, fitted[0], before[0], bend))
        angles.append((valence, fitted[1], before[1], bend / tangent))
    draw(
        folder / "exact-patches-distance.svg",
        "Exact patches: largest distance from the surface",
        "distance over the length",
        distances,
        1e-13,
    )
    draw(
        folder / "exact-patches-angle.svg",
        "Exact patches: largest angle between normals at seams",
        "angle in degrees",
        angles,
        1e-6,
    )


def row(name, surface, convert, mirrored):
    start = time.perf_counter()
    patches = convert()
    seconds = time.perf_counter() - start
    found = hn.measure_quality(surface, patches)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "hull.step"
        hn.write_step(patches, path, mirrored=mirrored)
        size = path.stat().st_size
    cells = (
        name,
        f"{1e3 * found.largest_distance:.2g}",
        f"{found.largest_distance_per_length:.1e}",
        f"{1e3 * found.rms_distance:.2g}",
        f"{math.degrees(found.largest_seam_angle):.2g}",
        f"{found.patch_count}",
        f"{found.control_point_count}",
        f"{size / 1e6:.1f}",
        f"{1e3 * seconds:.0f}",
    )
    print("| " + " | ".join(cells) + " |", flush=True)


def table(path):
    hull = hull_io.read_hull(path)
    shell = hull_io.shell_arrays(hull)
    surface = hn.LimitSurface(hn.ControlMesh(*shell.arguments()))
    print(f"\n{path.name}: {surface.cell_count} cells")
    print(
        "| | distance, mm | of the length | rms, mm | angle, degrees | patches | control points "
        "| file, MB | time, ms |"
    )
    print("|---|---|---|---|---|---|---|---|---|")
    for points in (4, 5, 6, 7):
        row(
            f"`per_cell` {points} × {points}",
            surface,
            lambda n=points: hn.fit_per_cell(surface, control_points=n),
            hull.half,
        )
    row("`exact` 1e-6", surface, lambda: hn.exact_patches(surface), hull.half)
    row("`exact` 1e-8", surface, lambda: hn.exact_patches(surface, tolerance=1e-8), hull.half)


def main():
    folder, *files = map(Path, sys.argv[1:])
    folder.mkdir(parents=True, exist_ok=True)
    plots(folder)
    for path in files:
        table(path)


main()
