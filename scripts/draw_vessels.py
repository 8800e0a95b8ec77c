# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws control mesh, lines plan and sections plan of vessels, as PDF and PNG.

PYTHONPATH=build/release/python:samples python3 scripts/draw_vessels.py FOLDER NAME ...

into FOLDER/NAME/.
"""

import sys
from pathlib import Path

import vessels
from figures import control_mesh, lines_plan, sections_plan


def draw(vessel, folder):
    folder.mkdir(parents=True, exist_ok=True)
    control_mesh.draw(vessel.data, folder / "control_mesh")
    lines_plan.draw(vessel, folder / "lines_plan")
    sections_plan.draw(vessel, folder / "sections_plan")


def main():
    folder, *names = sys.argv[1:]
    for name in names:
        draw(vessels.vessel(name), Path(folder) / name)


if __name__ == "__main__":
    main()
