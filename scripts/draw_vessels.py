# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the five figures of vessels, as PDF and PNG.

PYTHONPATH=build/release/python:samples python3 scripts/draw_vessels.py FOLDER NAME ...

into FOLDER/NAME/.
"""

import sys
from pathlib import Path

import hull_native as hn
import vessels


def draw(vessel, folder):
    folder.mkdir(parents=True, exist_ok=True)
    given = vessel.data.particulars
    body = hn.HullBody(vessel.surface, mirrored=vessel.data.half)
    hn.write_hull_figures(
        body,
        folder / vessel.name,
        title=vessel.data.name,
        length=given.length_pp,
        beam=given.beam,
        draft=given.draft,
        depth=given.depth,
        endings=(".png", ".pdf"),
    )


def main():
    folder, *names = sys.argv[1:]
    for name in names:
        print(f"Figures of {name}", flush=True)
        draw(vessels.vessel(name), Path(folder) / name)


if __name__ == "__main__":
    main()
