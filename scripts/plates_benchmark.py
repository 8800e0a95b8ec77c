# SPDX-License-Identifier: GPL-3.0-or-later
"""The coaster's shell in plates: divided, laid out, drawn with frames and waterlines, listed and
written, in seconds of the clock and of the processor, against a limit; part of ./hull bench.

PYTHONPATH=build/release/python:samples python3 scripts/plates_benchmark.py [FOLDER]

FOLDER keeps what is written: plates.pdf, plates.dxf, an SVG a plate at 1:10, lists and stock
plates.
"""

import pathlib
import sys
import tempfile
import time

import hull_native as hn
import numpy as np
import vessels

NAME, STRAKE, PLATE_LENGTH, THICKNESS = "coaster", 2.4, 12.0, 0.012
FRAMES = [(-5, 10, 0.6), (10, 140, 0.65)]
STOCK = [(14.0, 3.2), (20.0, 3.2)]
MOST_S = 60.0  # of the processor: the clock's depends on what else runs


class Stages:
    """Times of one stage after the other."""

    def __init__(self):
        self.rows, self.last = [], self.now()

    @staticmethod
    def now():
        return np.array([time.perf_counter(), time.process_time()])

    def done(self, what):
        now = self.now()
        self.rows.append((what, *(now - self.last)))
        self.last = now


def marks_of(curves, surface):
    """Frames and waterlines each metre, as plate_drawing() takes them."""
    low, high = np.asarray(surface.mesh.points).min(axis=0), np.asarray(surface.mesh.points).max(0)
    marks = [
        ("FRAMES", curve)
        for curve in hn.frame_marks(curves, hn.frame_table(FRAMES), low[0], high[0])
    ]
    for z in np.arange(np.ceil(low[2]) + 1.0, high[2], 1.0):
        for curve in curves.in_plane(hn.plane_across("z", z), f"WL {z:g}"):
            marks.append(("WATERLINES", curve))
    return marks


def write_all(listed, marks, folder):
    hn.write_plates(listed, folder / "plates.pdf", marks=marks)
    hn.write_plates(listed, folder / "plates.dxf", marks=marks)
    for one in listed:
        name = one.name.replace("/", "").replace(" ", "")
        hn.plate_drawing(one, marks=marks).write(folder / f"{name}.svg", scale=0.1)
    used = hn.nesting(listed, STOCK)
    rows = {"plates.csv": hn.plate_rows(listed), "stock.csv": hn.nesting_rows(used)}
    for name, table in rows.items():
        (folder / name).write_text(hn.rows_csv(table))


def run(folder):
    """(Stages, number of plates)."""
    surface, stages = vessels.vessel(NAME).surface, Stages()
    curves, seams = hn.shell_seams(surface, strake=STRAKE, plate_length=PLATE_LENGTH)
    plates = hn.plates(surface, seams)
    stages.done("seams and plates")
    listed = hn.plate_list(plates, thickness=THICKNESS, mirrored=True)
    stages.done("laid out")
    marks = marks_of(curves, surface)
    stages.done("frames and waterlines")
    write_all(listed, marks, folder)
    stages.done("drawn, listed, written")
    return stages, len(plates)


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else scratch)
        folder.mkdir(parents=True, exist_ok=True)
        stages, count = run(folder)
    for what, clock, processor in stages.rows:
        print(f"{what:<50} {clock:9.2f} s {processor:9.2f} s of the processor")
    clock = sum(row[1] for row in stages.rows)
    processor = sum(row[2] for row in stages.rows)
    missed = "  MISSED" if processor > MOST_S else ""
    what = f"{count} plates of the {NAME} in all"
    print(
        f"{what:<50} {clock:9.2f} s {processor:9.2f} s of the processor   "
        f"(at most {MOST_S:g} s){missed}"
    )


if __name__ == "__main__":
    main()
