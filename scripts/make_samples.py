# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes samples/NAME.hull.json from samples/sources/NAME.py, and on request their numbers.

PYTHONPATH=python:samples python3 scripts/make_samples.py [NAME ...]
PYTHONPATH=build/dev/python:samples python3 scripts/make_samples.py --expected [NAME ...]

Without names: all that have a source. --expected also writes samples/expected/NAME.json, the
particulars of the surface at the design draft.
"""

import argparse
import json
from pathlib import Path

import hull_io
import sources

ROOT = Path(__file__).resolve().parents[1]
SAMPLES = ROOT / "samples"

EXPECTED = (
    "displaced_volume",
    "lcb",
    "kb",
    "wetted_surface",
    "waterplane_area",
    "lcf",
    "km_transverse",
    "km_longitudinal",
)


def expected(data):
    """The particulars of a hull at its design draft, by name: m, m², m³."""
    import hull_native as hn

    shell = hull_io.shell_arrays(data)
    arrays = shell.arguments()
    surface = hn.LimitSurface(hn.ControlMesh(*arrays), data.scheme)
    found = hn.upright_hydrostatics(surface, draft=data.particulars.draft, mirrored=data.half)
    return {name: getattr(found, name) for name in EXPECTED}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--expected", action="store_true")
    given = parser.parse_args()
    for name in given.names or sources.names():
        data = sources.source(name).make(hull_io)
        hull_io.write_hull_file(data, SAMPLES / f"{name}.hull.json")
        print(f"{name}: {len(data.points)} points, {len(data.faces)} faces")
        if given.expected:
            text = json.dumps(expected(data), indent=1)
            (SAMPLES / "expected").mkdir(exist_ok=True)
            (SAMPLES / "expected" / f"{name}.json").write_text(text + "\n")


if __name__ == "__main__":
    main()
