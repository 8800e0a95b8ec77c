# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of docs/networks.md: a sample's lines as a network, and the surface of its patches.

PYTHONPATH=build/release/python:samples python3 scripts/network_figures.py FOLDER

into FOLDER: networks.png; what the network is made of to the terminal.
"""

import sys
from collections import Counter
from pathlib import Path

import cairo
import hull_native as hn
import numpy as np
import vessels
from figures import paper, seen_surface

NAME = "coaster"
STATIONS, WATERLINES = 23, 11
# Of the length: the curves', and what they are joined within.
CURVE_TOLERANCE, JOIN_TOLERANCE = 1e-5, 3e-5
WIDTH, FINER, FOOT, MARGIN = 1040, 2, 40, 24
BEARING, ELEVATION = 38.0, -9.0
GRID = 12
AROUND, LIGHT, DARK = (1.0, 1.0, 1.0), (0.95, 0.95, 0.96), (0.30, 0.36, 0.44)
COLOURS = {
    "border": (0.10, 0.10, 0.12),
    "crease": (0.84, 0.37, 0.0),
    "smooth": (0.0, 0.45, 0.70),
}


def network_of(surface):
    curves = vessels.curves_of(surface, STATIONS, WATERLINES, CURVE_TOLERANCE)
    length = np.ptp(np.asarray(surface.mesh.points)[:, 0])
    return hn.CurveNetwork(curves, JOIN_TOLERANCE * length)


def see_network(seen, network):
    """Adds the patches to a seen_surface.Seen, sampled more closely than its dots."""
    for region in range(network.region_count):
        patch = network.patch(region)
        coarse = seen.view.dots(patch.evaluate(patch.grid(1)[0])[0])
        size = np.linalg.norm(np.ptp(coarse, axis=0))
        count = int(np.ceil(1.2 * size / seen_surface.SPACING)) + 2
        seen.add(*patch.evaluate(patch.grid(count)[0]))


def distances(surface, network):
    """(n,) m: of the patches' points from the hull."""
    points = [
        patch.evaluate(patch.grid(GRID)[0])[0]
        for patch in map(network.patch, range(network.region_count))
    ]
    return hn.SurfaceTree(surface).closest_points(np.concatenate(points)).distances


def edge_roles(network):
    """The role of each edge, by its number."""
    regions = Counter(
        edge for region in range(network.region_count) for side in network.sides(region)
        for edge, _ in side
    )  # fmt: skip
    creases = set(network.crease_edges)
    return [
        "border" if regions[edge] < 2 else "crease" if edge in creases else "smooth"
        for edge in range(len(network.edges))
    ]


def view_of(network):
    probe = seen_surface.View(BEARING, ELEVATION, (0.0, 1.0, 0.0, 1.0), 1)
    points = np.concatenate([network.edge_points(e, 8) for e in range(len(network.edges))])
    x, y = points @ probe.right, points @ probe.up
    margin = 0.03 * np.ptp(x)
    window = (x.min() - margin, x.max() + margin, y.min() - margin, y.max() + margin)
    return seen_surface.View(BEARING, ELEVATION, window, FINER * WIDTH)


def reflected(seen):
    """(dots, 3): bands of light along the ship, mirrored, softened by what faces the eye."""
    eye, normals = seen.view.eye, seen.normals
    mirrored = 2.0 * (normals @ eye)[:, None] * normals - eye
    turns = 6.0 * np.arctan2(mirrored[:, 2], mirrored[:, 1]) / np.pi
    colours = np.where((turns % 1.0 > 0.5)[:, None], LIGHT, DARK)
    colours[~np.isfinite(seen.depth)] = AROUND
    return colours


def draw_edges(context, network, view, top, width, with_nodes):
    for edge, role in enumerate(edge_roles(network)):
        dots = view.dots(network.edge_points(edge, 24)) / FINER
        context.set_source_rgb(*COLOURS[role])
        context.set_line_width(width * (1.0 if role == "smooth" else 1.8))
        context.move_to(*(dots[0] + [0.0, top]))
        for dot in dots[1:]:
            context.line_to(*(dot + [0.0, top]))
        context.stroke()
    if not with_nodes:
        return
    context.set_source_rgb(0.1, 0.1, 0.12)
    for x, y in view.dots(np.asarray(network.nodes)) / FINER + [0.0, top]:
        context.arc(x, y, 2.0, 0.0, 2.0 * np.pi)
        context.fill()


def write(path, network):
    view = view_of(network)
    seen = seen_surface.Seen(view)
    see_network(seen, network)
    height = view.height // FINER
    page = cairo.ImageSurface(cairo.FORMAT_RGB24, WIDTH, 2 * (height + FOOT))
    context = cairo.Context(page)
    context.set_source_rgb(1.0, 1.0, 1.0)
    context.paint()
    draw_edges(context, network, view, 0.0, 1.1, with_nodes=True)
    words = "(a) curves and nodes: border black, knuckles of the surface orange, smooth blue"
    paper.text(context, (0.5 * WIDTH, height + 0.6 * FOOT), words, 17.0)
    context.set_source_surface(paper.image(view.shown(reflected(seen), FINER)), 0, height + FOOT)
    context.paint()
    words = f"(b) the surface of its {network.region_count} patches, mirroring bands of light"
    paper.text(context, (0.5 * WIDTH, 2 * height + 1.6 * FOOT), words, 17.0)
    page.write_to_png(str(path))


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    surface = vessels.vessel(NAME).surface
    network = network_of(surface)
    for problem in network.problems:
        print(problem.what)
    sides = Counter(len(network.sides(region)) for region in range(network.region_count))
    print(f"{len(network.curves)} curves, {len(network.nodes)} nodes, {len(network.edges)} edges")
    print("regions by their number of sides:", dict(sorted(sides.items())))
    apart = np.asarray(distances(surface, network))
    length = np.ptp(np.asarray(surface.mesh.points)[:, 0])
    print(
        f"from the hull: RMS {1e3 * np.sqrt(np.mean(apart**2)):.2g} mm, at most "
        f"{1e3 * apart.max():.2g} mm on {length:.4g} m"
    )
    write(folder / "networks.png", network)


if __name__ == "__main__":
    main()
