# SPDX-License-Identifier: GPL-3.0-or-later
"""A frigate of 96.00 x 11.50 x 6.00 m, T 3.25 m, by a network of nine curves, then of two more, in
the spirit of Koelman (1999, 6.3): how far its surface is from the known hull that the curves are
taken from, and a picture of each step.

PYTHONPATH=build/release/python:samples python3 scripts/frigate_network.py [FOLDER]

into FOLDER: frigate.png; distances to the terminal.
"""

import sys
from dataclasses import dataclass
from pathlib import Path

import cairo
import hull_native as hn
import numpy as np
import vessels

SAMPLE = "naval_vessel"
LENGTH, BREADTH, DEPTH, DRAFT = 96.0, 11.5, 6.0, 3.25
# Of the length, from aft: the ordinates to begin with, and a further one through the sonar dome.
ORDINATES, FURTHER = (0.17, 0.42, 0.66, 0.86), 0.92
# Height, m, of a further waterline of the dome, which begins at the third ordinate.
PART_HEIGHT = 0.3
# Of the length: the curves', and what they are joined within.
CURVE_TOLERANCE, JOIN_TOLERANCE = 1e-5, 3e-5
# Of the length, from aft: sections that are no curves of the network.
HELD_OUT = np.arange(0.03, 0.98, 0.04)
# Places on a spline between which it is a line.
_FINE = 4001
# The picture: dots, and drawn waterlines' places of the body plan, dots a metre.
_WIDTH, _HEIGHT, _HEAD, _SCALE = 1240, 300, 40, 36.0
_KNOWN, _OWN = (0.62, 0.62, 0.66), (0.0, 0.45, 0.70)


@dataclass(frozen=True)
class Step:
    """What was added, the CurveNetwork, its NetworkPatches; of its surface's sections at HELD_OUT
    the RMS distance from the known hull, m, the largest, and where that is."""

    added: str
    network: object
    made: object
    rms: float
    largest: float
    place: np.ndarray


def known_hull():
    """The LimitSurface of the sample, scaled: from x = 0, with the deck amidships at the depth."""
    vessel = vessels.vessel(SAMPLE)
    mesh = vessel.surface.mesh
    low, high = mesh.points.min(axis=0), mesh.points.max(axis=0)
    scale = [LENGTH / (high[0] - low[0]), 0.5 * BREADTH / high[1]]
    scale.append(DEPTH / vessel.data.particulars.depth)
    points = (mesh.points - [low[0], 0.0, 0.0]) * scale
    return hn.LimitSurface(mesh.with_points(points), vessel.surface.scheme)


def first_curves(surface):
    """The nine curves: contour, deck edge, construction waterline, knuckle, transom and four
    ordinates."""
    features = _features(surface)
    waterline = _waterline(surface, "construction waterline", DRAFT)
    ordinates = _sections(surface, stations=[share * LENGTH for share in ORDINATES])
    return [*features, waterline, *ordinates]


def further_curves(surface):
    """An ordinate through the dome, and a waterline from the third ordinate around it: where the
    surface of the nine is farthest off."""
    (ordinate,) = _sections(surface, stations=[FURTHER * LENGTH])
    start = ORDINATES[2] * LENGTH
    return ordinate, _waterline(surface, "waterline of the dome", PART_HEIGHT, start)


def _waterline(surface, name, height, start=0.0):
    """A waterline forward of x = start, m; where that is 0, of the transom's rim."""
    (line,) = _sections(surface, waterlines=[height])
    points = line.points if line.points[0, 0] < line.points[-1, 0] else line.points[::-1]
    if start > 0.0:
        points = points[points[:, 0] > start + 1e-3 * LENGTH]
        points = np.vstack([_on_section(surface, start, height), points])
    else:
        points = points[np.flatnonzero(points[:, 0] < 1e-6 * LENGTH)[-1] :]
    return hn.NetworkCurve(name, points, kind="waterline", plane=(0, 0, 1, height))


def _on_section(surface, x, height):
    """(3,) m: the place of a height on the section at x."""
    plane = hn.plane_across("x", x)
    (branches,) = hn.section_splines(surface, [plane], CURVE_TOLERANCE * LENGTH)
    splines = [spline for branch in branches for spline in branch.splines]
    line = np.concatenate(
        [
            spline.evaluate(np.linspace(spline.knots[0], spline.knots[-1], _FINE))
            for spline in splines
        ]
    )
    off = line[:, 2] - height
    (i, *_) = np.flatnonzero(off[1:] * off[:-1] <= 0.0)
    return line[i] + off[i] / (off[i] - off[i + 1]) * (line[i + 1] - line[i])


def _sections(surface, **planes):
    curves = hn.network_curves(surface, **planes, tolerance=CURVE_TOLERANCE * LENGTH)
    return [curve for curve in curves if curve.kind in ("station", "waterline")]


def _features(surface):
    """Contour, deck edge, knuckle and transom: creases and borders, end to end."""
    parts = {"contour": [], "deck edge": [], "knuckle": [], "transom": []}
    for curve in hn.network_curves(surface, tolerance=CURVE_TOLERANCE * LENGTH):
        points = curve.points
        if np.ptp(points[:, 0]) < 1e-6 * LENGTH:
            if points[:, 1].max() > 0.0 and curve.kind == "knuckle":
                parts["transom"].append(points)
        elif points[:, 1].max() < 1e-6 * LENGTH:
            parts["contour"].append(points)
        else:
            parts["knuckle" if curve.kind == "knuckle" else "deck edge"].append(points)
    kinds = {"contour": "profile", "deck edge": "deck_edge", "knuckle": "knuckle"}
    found = []
    for name, lines in parts.items():
        points, knuckles = _end_to_end(lines)
        kind = kinds.get(name, "station")
        found.append(hn.NetworkCurve(name, points, kind=kind, knuckles=knuckles))
    return found


def _end_to_end(lines):
    """(points, numbers of those where lines meet) of one line or two."""
    if len(lines) == 1:
        return lines[0], []
    first, second = sorted(lines, key=lambda line: line[:, [0, 2]].min(axis=0).tolist())
    if min(np.linalg.norm(second[[0, -1]] - first[0], axis=1)) < 1e-6 * LENGTH:
        first = first[::-1]
    if np.linalg.norm(second[-1] - first[-1]) < 1e-6 * LENGTH:
        second = second[::-1]
    return np.concatenate([first, second[1:]]), [len(first) - 1]


def steps(surface=None):
    """The Steps: nine curves, one more, one more."""
    surface = known_hull() if surface is None else surface
    curves = first_curves(surface)
    found = [_step("nine curves", surface, curves)]
    for curve in further_curves(surface):
        curves = [*curves, curve]
        found.append(_step(curve.name, surface, curves))
    return found


def _step(added, surface, curves):
    network = hn.CurveNetwork(curves, JOIN_TOLERANCE * LENGTH)
    made = hn.network_patches(network)
    points, weights = [], []
    for line in held_out(made.patches):
        steps = np.linalg.norm(np.diff(line, axis=0), axis=1)
        points.append(line)
        weights.append(0.5 * (np.append(steps, 0.0) + np.append(0.0, steps)))
    points, weights = np.concatenate(points), np.concatenate(weights)
    apart = np.asarray(hn.SurfaceTree(surface).closest_points(points).distances)
    most = int(apart.argmax())
    rms = float(np.sqrt(np.average(apart**2, weights=weights)))
    return Step(added, network, made, rms, float(apart[most]), points[most])


def held_out(patches):
    """Lines (n, 3): sections of a PatchSet between the network's ordinates."""
    planes = [hn.plane_across("x", share * LENGTH) for share in HELD_OUT]
    sections = hn.patch_sections(patches, planes)
    return [np.asarray(curve.points) for curves in sections for curve in curves]


def draw(path, surface, found):
    """The picture: of each step its curves, and sections of both surfaces as a body plan."""
    from network_figures import FINER, draw_edges, paper, view_of

    page = cairo.ImageSurface(cairo.FORMAT_RGB24, _WIDTH, len(found) * _HEIGHT)
    context = cairo.Context(page)
    context.set_source_rgb(1.0, 1.0, 1.0)
    context.paint()
    planes = [hn.plane_across("x", share * LENGTH) for share in HELD_OUT]
    known = [
        np.asarray(curve.points) for curves in hn.sections(surface, planes) for curve in curves
    ]
    for number, step in enumerate(found):
        top = number * _HEIGHT
        view = view_of(step.network)
        drawn = 0.68 * _WIDTH / (view.width / FINER)
        context.save()
        context.translate(0.0, top + _HEAD)
        context.scale(drawn, drawn)
        draw_edges(context, step.network, view, 0.0, 1.4, with_nodes=True)
        context.restore()
        words = f"{len(step.network.curves)} curves: {1e3 * step.rms:.0f} mm RMS between them"
        paper.text(context, (0.34 * _WIDTH, top + 0.6 * _HEAD), words, 17.0)
        for lines, colour, width in (
            (known, _KNOWN, 2.6),
            (held_out(step.made.patches), _OWN, 1.0),
        ):
            _draw_body_plan(context, lines, top + _HEIGHT - 1.6 * _HEAD, colour, width)
    page.write_to_png(str(path))


def _draw_body_plan(context, lines, foot, colour, width):
    """Aftship to the left, foreship to the right."""
    middle = 0.84 * _WIDTH
    context.set_source_rgb(*colour)
    context.set_line_width(width)
    for line in lines:
        side = -1.0 if line[0, 0] < 0.5 * LENGTH else 1.0
        for i, (_, y, z) in enumerate(line):
            move = context.line_to if i else context.move_to
            move(middle + side * _SCALE * 0.9 * y, foot - _SCALE * 0.9 * z)
        context.stroke()


def main():
    surface = known_hull()
    found = steps(surface)
    if len(sys.argv) > 1:
        draw(Path(sys.argv[1]) / "frigate.png", surface, found)
    for step in found:
        for problem in step.network.problems:
            print(problem.what)
        for problem in step.made.problems:
            print(problem.what)
        print(
            f"{step.added}: {len(step.network.curves)} curves, {step.network.region_count} regions,"
            f" RMS {1e3 * step.rms:.1f} mm, at most {1e3 * step.largest:.1f} mm at",
            np.round(step.place, 2).tolist(),
        )


if __name__ == "__main__":
    main()
