# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a hull of a file of geometry.

PYTHONPATH=build/release/python python3 scripts/hull_from.py FILE FOLDER [--points N]
    [--tolerance MM] [--draft T] [--unit U] [--forward AXIS] [--up AXIS] [--half | --whole]

writes NAME.hull.json, report.json and sections.pdf and .png into FOLDER/NAME/.
"""

import argparse
import json
import sys
from pathlib import Path

import hull_io
from figures import overlays
from hull_fitting import hull_from_geometry, station_overlays
from hull_io.errors import HullFileError
from hull_io.geometry import read_geometry
from hull_io.geometry.guessing import AXES
from hull_io.geometry.values import METRES_PER_UNIT


def _arguments():
    parser = argparse.ArgumentParser(prog="hull from", description=__doc__.splitlines()[0])
    parser.add_argument("file", type=Path, metavar="FILE")
    parser.add_argument("folder", type=Path, metavar="FOLDER")
    parser.add_argument("--points", type=int, help="control points at most (150)")
    parser.add_argument("--tolerance", type=float, metavar="MM", help="3e-4 of the length")
    parser.add_argument("--draft", type=float, metavar="T", help="m; 60 %% of the depth")
    parser.add_argument("--unit", choices=sorted(METRES_PER_UNIT), help="of the file's numbers")
    parser.add_argument("--forward", choices=AXES, help="which of the file's axes is forward")
    parser.add_argument("--up", choices=AXES)
    side = parser.add_mutually_exclusive_group()
    side.add_argument("--half", action="store_const", const=True, dest="is_half")
    side.add_argument("--whole", action="store_const", const=False, dest="is_half")
    return parser.parse_args()


def _tell(report):
    told, volume, area = report["distances"], report["displaced_volume"], report["wetted_surface"]
    print(
        f"{report['points']} control points, {report['points_in_rows_of_one_x']} of them in rows "
        f"of one x"
    )
    for name, of in (("all", told), ("below the draft", report["distances_below_draft"])):
        if of:
            print(
                f"{name}: RMS {1e3 * of['rms']:.4g} mm, largest {1e3 * of['largest']:.4g} mm at "
                f"{tuple(of['place'])}"
            )
    for name, of, unit in (("displacement", volume, "m³"), ("wetted surface", area, "m²")):
        more = 100.0 * (of["hull"] / of["source"] - 1.0)
        print(f"{name} {of['source']:.6g} {unit}, of the hull {of['hull']:.6g} ({more:+.3f} %)")
    for left_out in report["left_out"]:
        print(left_out)
    for doubt in report["doubts"]:
        print(f"to be looked at: {report['guesses'][doubt]}")


def _write(made, folder):
    folder.mkdir(parents=True, exist_ok=True)
    stations = station_overlays(made.shell, made.fitted)
    told = [
        {"x": one.x, "rms": one.rms, "largest": one.largest, "place": list(one.place)}
        for one in stations
    ]
    hull_io.write_hull_file(made.data, folder / f"{made.data.name}.hull.json")
    overlays.draw(made.data.name, stations, made.report["draft"], folder / "sections")
    text = json.dumps({**made.report, "stations": told}, indent=1)
    (folder / "report.json").write_text(text + "\n")


def main():
    given = _arguments()
    known = {
        name: value
        for name in ("unit", "forward", "up", "is_half")
        if (value := getattr(given, name)) is not None
    }
    tolerance = None if given.tolerance is None else 1e-3 * given.tolerance
    try:
        geometry = read_geometry(given.file)
        made = hull_from_geometry(
            geometry, budget=given.points, tolerance=tolerance, draft=given.draft, **known
        )
        folder = given.folder / made.data.name
        _write(made, folder)
    except (HullFileError, ValueError, OSError) as error:
        sys.exit(f"hull from: {error}")
    print(f"{folder}/{made.data.name}.hull.json, report.json, sections.pdf, sections.png")
    _tell(made.report)


if __name__ == "__main__":
    main()
