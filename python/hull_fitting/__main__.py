# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a hull of a file of geometry.

python3 -m hull_fitting FILE FOLDER [--points N] [--tolerance MM] [--draft T] [--unit U] …

writes NAME.hull.json and report.json into FOLDER.
"""

import argparse
import json
import sys
from pathlib import Path

import hull_io
from hull_io.errors import HullFileError
from hull_io.geometry import read_geometry
from hull_io.geometry.guessing import AXES
from hull_io.geometry.values import METRES_PER_UNIT

from .making import hull_from_geometry


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
    for doubt in report["doubts"]:
        print(f"to be looked at: {report['guesses'][doubt]}")


def main():
    given = _arguments()
    known = {
        name: value
        for name in ("unit", "forward", "up", "is_half")
        if (value := getattr(given, name)) is not None
    }
    tolerance = None if given.tolerance is None else 1e-3 * given.tolerance
    try:
        made = hull_from_geometry(
            read_geometry(given.file),
            budget=given.points,
            tolerance=tolerance,
            draft=given.draft,
            **known,
        )
        given.folder.mkdir(parents=True, exist_ok=True)
        hull_io.write_hull_file(made.data, given.folder / f"{made.data.name}.hull.json")
        text = json.dumps(made.report, indent=1)
        (given.folder / "report.json").write_text(text + "\n")
    except (HullFileError, ValueError, OSError) as error:
        sys.exit(f"hull from: {error}")
    _tell(made.report)


if __name__ == "__main__":
    main()
