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
from hull_native import FolderBeside

_POINTS = (20, 1000)
_REPORT = "report.json"


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        sys.exit(f"hull from: {message} (./hull from --help tells what can be given)")


def _number(kind, text):
    """None where the text is no number of this kind."""
    try:
        return kind(text)
    except ValueError:
        return None


def _positive(text):
    value = _number(float, text)
    if value is None or not (math.isfinite(value) and value > 0.0):
        raise argparse.ArgumentTypeError(f"it is a number above zero, not '{text}'")
    return value


def _budget(text):
    value = _number(int, text)
    if value is None or not _POINTS[0] <= value <= _POINTS[1]:
        raise argparse.ArgumentTypeError(
            f"it is a whole number from {_POINTS[0]} to {_POINTS[1]}, not '{text}'"
        )
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


class _Progress:
    """Tells in one line of a terminal how far the fit is; elsewhere nothing."""

    def __init__(self):
        self._is_watched, self._is_begun = sys.stderr.isatty(), False

    def __call__(self, share):
        if self._is_watched:
            print(f"\rFitting: {100.0 * share:.0f} %", end="", file=sys.stderr, flush=True)
            self._is_begun = True

    def end_line(self):
        if self._is_begun:
            print(file=sys.stderr)


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
    """All files, or none."""
    stations = station_overlays(made.shell, made.fitted)
    told = [
        {"x": one.x, "rms": one.rms, "largest": one.largest, "place": list(one.place)}
        for one in stations
    ]
    text = json.dumps({**made.report, "stations": told}, indent=1)
    names = (f"{made.data.name}.hull.json", _REPORT, "sections.pdf", "sections.png")
    folder.mkdir(parents=True, exist_ok=True)
    with FolderBeside([folder / name for name in names]) as aside:
        hull_io.write_hull_file(made.data, aside / names[0])
        (aside / _REPORT).write_text(text + "\n")
        overlays.draw(made.data.name, stations, made.report["draft"], aside / "sections")
        aside.hand_over([aside / name for name in names])


def _source_in(folder):
    """The name of the file that the hull in a folder was made of; None where none is told."""
    try:
        return json.loads((folder / _REPORT).read_text()).get("source")
    except (OSError, ValueError, AttributeError):
        return None


def main():
    given = _arguments()
    known = {
        name: value
        for name in ("unit", "forward", "up", "is_half")
        if (value := getattr(given, name)) is not None
    }
    tolerance = None if given.tolerance is None else 1e-3 * given.tolerance
    progress = _Progress()
    try:
        geometry = read_geometry(_path_of(given))
        made = hull_from_geometry(
            geometry, budget=given.points, tolerance=tolerance, draft=given.draft,
            stern_post=not given.no_post, knuckles=not given.no_knuckles,
            progress=progress, **known
        )  # fmt: skip
        folder = given.into / made.data.name
        before = _source_in(folder)
        _write(made, folder)
    except (HullFileError, ValueError, OSError) as error:
        progress.end_line()
        sys.exit(f"hull from: {error}")
    except KeyboardInterrupt:
        sys.exit("\nhull from: ended by Ctrl C; nothing was made")
    progress.end_line()
    seen = os.path.relpath(folder, given.called_from)
    seen = folder.resolve() if seen.startswith("..") else seen
    print(f"{seen}/{made.data.name}.hull.json, report.json, sections.pdf, sections.png")
    if before not in (None, made.report["source"]):
        print(f"the hull of {before}, which was there, was replaced")
    _tell(made.report)


if __name__ == "__main__":
    main()
