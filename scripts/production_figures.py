# SPDX-License-Identifier: GPL-3.0-or-later
"""The drawings in docs/production.md: a template, a frame, a map of stretch and a nesting of the
coaster's shell; its panels, and its model in segments.

PYTHONPATH=build/release/python:samples python3 scripts/production_figures.py FOLDER

into FOLDER: template.png, frame.png, stretch.png, nesting.png, panel-mesh.png, segments.png.
Needs pdftoppm.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
from hull_native.drawings.hidden_lines import Eye, Sight
from vessels import surface_of

SAMPLE = Path(__file__).parents[1] / "samples" / "coaster.hull.json"
# Sheets in mm, and dots an inch.
SHEETS = {"template": (260, 180), "frame": (260, 180)}
LOW_SHEET = (260, 110)
# Of a low sheet at 1:2, below its title: mm that are free, and dots to the right, down, across and
# high.
FREE, BELOW_TITLE = np.array([430.0, 84.0]), ("50", "196", "1028", "232")
DOTS = 110
RULES = [("strakes", 2.4), ("from_centre", 1.2), ("butts", 12.0)]
FRAMES = [(-5, 10, 0.55), (10, 140, 0.65)]
THICKNESS, STOCK = 0.012, (18.5, 3.2)  # m
PANEL, DRAFT = 3.0, 5.2  # m
MACHINE = (300.0, 200.0, 100.0)  # mm, of a model at 1:100
# Of the size: how far segments are moved apart; what is nearer than the last is in nothing's way.
APART, IN_FRONT = 0.12, 2e-4


def drawings():
    """{name: ShopDrawing}."""
    surface = surface_of(hull_io.read_hull_file(SAMPLE))
    curves, seams = hn.seams_by_rules(surface, [hn.SeamRule(*rule) for rule in RULES])
    plates = hn.plates(surface, seams, across_centre=True)
    listed = hn.plate_list(plates, thickness=THICKNESS, mirrored=True)
    table = hn.frame_table(FRAMES)
    frames = hn.frame_marks(curves, table, table.positions[0], table.positions[-1])
    bent = max(
        (one for one in listed if one.flat.converged and one.plate.area > 10.0),
        key=lambda one: one.flat.stretch[1] / one.flat.stretch[0],
    )
    templates = hn.plate_templates(bent, curves, frames)
    used = hn.nesting([piece for one in listed for piece in one.pieces], [STOCK])
    broad = [sum(one.extents[1] > 0.8 for one, _, _ in stock.laid) for stock in used]
    fullest = broad.index(max(broad))
    return {
        "template": hn.template_drawing(bent, templates[:: max(1, len(templates) // 5)]),
        "frame": hn.frame_drawing(
            surface,
            table.position(20),
            name="20",
            mirrored=True,
            thickness=THICKNESS,
            waterlines=(2.0, 4.0),
            marks=seams,
        ),
        "stretch": hn.stretch_drawing(bent),
        "nesting": hn.nesting_drawing(used[fullest], f"S{fullest + 1}"),
    }


class Faces:
    """What hides lines: triangles, as the eye sees them."""

    def __init__(self, seen, triangles):
        self._given = seen, triangles

    def covers(self, places):
        return hn.places_covered(*self._given, places)


def faces_drawing(points, faces, axes):
    """The ShopDrawing of the sides of faces (m, k), those behind others left out."""
    seen = Eye(axes, points, None).seen(points)
    sides = np.concatenate([faces[:, [k, (k + 1) % faces.shape[1]]] for k in range(faces.shape[1])])
    sides = np.unique(np.sort(sides, axis=1), axis=0)
    triangles = np.concatenate([faces[:, [0, k, k + 1]] for k in range(1, faces.shape[1] - 1)])
    size = np.ptp(seen[:, :2], axis=0).max()
    # As large as fits; what it says of its scale is cut off.
    scale = (FREE / np.ptp(seen[sides.ravel(), :2], axis=0)).min()
    drawing = hn.ShopDrawing("")
    for pieces in Sight(Faces(seen, triangles), size, IN_FRONT * size).pieces(seen[sides]):
        for is_seen, piece in pieces:
            if is_seen:
                drawing.add_line("FRAMES", scale * piece[:, :2])
    return drawing


def panels_drawing(body):
    mesh = hn.wetted_panels(body, PANEL, draft=DRAFT)
    axes = hn.view_axes(np.radians(60.0), np.radians(-20.0))
    return faces_drawing(mesh.points, mesh.panels, axes)


def segments_drawing(body):
    model = hn.closed_model(body, 0.1).scaled(10.0)
    points, triangles, count = [], [], 0
    middle = 0.5 * (model.points.min(axis=0) + model.points.max(axis=0))
    for one in hn.segmented(model, machine=MACHINE).segments:
        own = one.model.points
        centre = 0.5 * (own.min(axis=0) + own.max(axis=0))
        points.append(own + APART * (centre - middle) * (1.0, 3.0, 1.0))
        triangles.append(one.model.triangles + count)
        count += len(own)
    axes = hn.view_axes(np.radians(-60.0), np.radians(20.0))
    return faces_drawing(np.vstack(points), np.vstack(triangles), axes)


def draw(drawing, path, paper, cut):
    """Writes it as a PDF file; the command that makes a picture of this, of what `cut` leaves."""
    hn.write_shop_booklet([drawing], path, paper=paper)
    options = [word for pair in zip(("-x", "-y", "-W", "-H"), cut) for word in pair]
    return ["pdftoppm", "-png", "-singlefile", "-r", str(DOTS), *options, path]


def main(folder):
    body = hn.HullBody(surface_of(hull_io.read_hull_file(SAMPLE)), mirrored=True)
    meshes = {"panel-mesh": panels_drawing(body), "segments": segments_drawing(body)}
    with tempfile.TemporaryDirectory() as made:
        for name, drawing in {**drawings(), **meshes}.items():
            path = Path(made) / f"{name}.pdf"
            cut = BELOW_TITLE if name in meshes else ()
            picture = draw(drawing, path, SHEETS.get(name, LOW_SHEET), cut)
            subprocess.run([*picture, folder / name], check=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
