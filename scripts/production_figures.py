# SPDX-License-Identifier: GPL-3.0-or-later
"""The drawings in docs/production.md: a template, a frame, a map of stretch and a nesting of the
coaster's shell.

PYTHONPATH=build/release/python:samples python3 scripts/production_figures.py FOLDER

into FOLDER: template.png, frame.png, stretch.png, nesting.png. Needs pdftoppm.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import hull_io
import hull_native as hn
from vessels import surface_of

SAMPLE = Path(__file__).parents[1] / "samples" / "coaster.hull.json"
# Sheets in mm, and dots an inch.
SHEETS = {"template": (260, 180), "frame": (260, 180), "stretch": (260, 110), "nesting": (260, 110)}
DOTS = 110
RULES = [("strakes", 2.4), ("from_centre", 1.2), ("butts", 12.0)]
FRAMES = [(-5, 10, 0.55), (10, 140, 0.65)]
THICKNESS, STOCK = 0.012, (18.5, 3.2)  # m


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


def main(folder):
    with tempfile.TemporaryDirectory() as made:
        for name, drawing in drawings().items():
            path = Path(made) / f"{name}.pdf"
            hn.write_shop_booklet([drawing], path, paper=SHEETS[name])
            picture = ["pdftoppm", "-png", "-singlefile", "-r", str(DOTS), path, folder / name]
            subprocess.run(picture, check=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
