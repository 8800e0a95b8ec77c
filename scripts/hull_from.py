# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a hull of a file of geometry.

PYTHONPATH=build/release/python python3 scripts/hull_from.py FILE [--points N]
    [--tolerance MM] [--draft T] [--unit U] [--forward AXIS] [--up AXIS] [--half | --whole]
    [--no-post] [--no-knuckles] [--into FOLDER] [--called-from FOLDER]

writes NAME.hull.json, report.json and sections.pdf and .png into FOLDER/NAME/, or into out/NAME/.
FILE may be as seen from where the caller is.
"""

import argparse
import json
import math
import os
import sys
from pathlib import Path

import hull_io
from figures import overlays
from hull_fitting import hull_from_geometry, station_overlays
from hull_io.errors import HullFileError
from hull_io.geometry import read_geometry
from hull_io.geometry.guessing import AXES
from hull_io.geometry.values import METRES_PER_UNIT

_POINTS = (20, 1000)


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        sys.exit(f"hull from: {message} (./hull from --help tells what can be given)")


def _positive(text):
    value = float(text)
    if not (math.isfinite(value) and value > 0.0):
        raise argparse.ArgumentTypeError(f"it is a number above zero, not '{text}'")
    return value


def _budget(text):
    value = int(text)
    if not _POINTS[0] <= value <= _POINTS[1]:
        raise argparse.ArgumentTypeError(f"from {_POINTS[0]} to {_POINTS[1]}, not '{text}'")
    return value


def _arguments():
    parser = _Parser(prog="./hull from", description=__doc__.splitlines()[0], allow_abbrev=False)
    parser.add_argument("file", metavar="FILE")
    parser.add_argument("--points", type=_budget, metavar="N", help="control points at most (150)")
    parser.add_argument("--tolerance", type=_positive, metavar="MM", help="3e-4 of the length")
    parser.add_argument("--draft", type=_positive, metavar="T", help="m; 60 %% of the depth")
    parser.add_argument("--unit", choices=sorted(METRES_PER_UNIT), help="of the file's numbers")
    parser.add_argument("--forward", choices=AXES, help="which of the file's axes is forward")
    parser.add_argument("--up", choices=AXES)
    side = parser.add_mutually_exclusive_group()
    side.add_argument("--half", action="store_const", const=True, dest="is_half")
    side.add_argument("--whole", action="store_const", const=False, dest="is_half")
    parser.add_argument("--no-post", action="store_true", help="lay out no stern post")
    parser.add_argument("--no-knuckles", action="store_true", help="lay no creases along knuckles")
    parser.add_argument("--into", type=Path, default=Path("out"), help=argparse.SUPPRESS)
    parser.add_argument("--called-from", type=Path, default=Path(), help=argparse.SUPPRESS)
    return parser.parse_args(_with_axes(sys.argv[1:]))


def _with_axes(words):
    """Words of the command line, where "-x" behind an option is an axis and no option."""
    joined = []
    for word in words:
        if joined and joined[-1] in ("--forward", "--up") and word in AXES:
            joined[-1] += "=" + word
        else:
            joined.append(word)
    return joined


def _path_of(given):
    path = given.called_from / given.file
    if path.is_dir():
        raise ValueError(f"'{given.file}' is a folder: give a file")
    if not path.exists():
        raise ValueError(f"there is no file '{given.file}'")
    return path


def _show_progress(share):
    print(f"\rFitting: {100.0 * share:.0f} %", end="", file=sys.stderr, flush=True)


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
    is_watched = sys.stderr.isatty()
    try:
        geometry = read_geometry(_path_of(given))
        made = hull_from_geometry(
            geometry, budget=given.points, tolerance=tolerance, draft=given.draft,
            stern_post=not given.no_post, knuckles=not given.no_knuckles,
            progress=_show_progress if is_watched else None, **known
        )  # fmt: skip
        folder = given.into / made.data.name
        _write(made, folder)
    except (HullFileError, ValueError, OSError) as error:
        sys.exit(f"hull from: {error}")
    except KeyboardInterrupt:
        sys.exit("\nhull from: ended by Ctrl C; nothing was made")
    if is_watched:
        print(file=sys.stderr)
    seen = os.path.relpath(folder, given.called_from)
    seen = folder.resolve() if seen.startswith("..") else seen
    print(f"{seen}/{made.data.name}.hull.json, report.json, sections.pdf, sections.png")
    _tell(made.report)


if __name__ == "__main__":
    main()
