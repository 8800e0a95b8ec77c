# SPDX-License-Identifier: GPL-3.0-or-later
"""Make build/package/hull_tools-VERSION.zip, the add-on as Blender installs it on this system.

Its native module takes the libraries of this system; scripts/wheels makes zips that bring theirs.

The zip has one folder, hull_tools, so that Blender 3.4 takes it as a legacy add-on and Blender 4.2
and later as an extension. In the folder are the content of addon/, the samples, the licence, and
beside the inner package hull_tools the packages hull_io, hull_fairness, hull_fitting and
hull_native: their users, two folders down, write `from ... import hull_native`.

The same sources give the same bytes: names are sorted, dates fixed. With --name-only the path of
the zip is printed, and nothing made.
"""

import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

from zips import write_zip

ROOT = Path(__file__).resolve().parent.parent
ADDON = ROOT / "addon"
PYTHON = ROOT / "python"
NATIVE = ROOT / "build" / "release" / "python" / "hull_native"


def package_file():
    with open(ADDON / "blender_manifest.toml", "rb") as manifest:
        version = tomllib.load(manifest)["version"]
    return ROOT / "build" / "package" / f"hull_tools-{version}.zip"


def files_below(folder):
    """The files of a package, without what Python or an editor leaves there."""
    for path in sorted(folder.rglob("*")):
        hidden = any(part.startswith(".") for part in path.relative_to(folder).parts)
        if path.is_file() and not hidden and "__pycache__" not in path.parts:
            yield path


def stripped(library):
    """The bytes of a shared library without its symbols for debugging."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / library.name
        subprocess.run(["strip", "--strip-unneeded", "-o", copy, library], check=True)
        return copy.read_bytes()


def plain_contents():
    """Names inside the zip and the bytes under each, of all but the native module."""
    yield "hull_tools/LICENSE", (ROOT / "LICENSE").read_bytes()
    for path in files_below(ADDON):
        yield f"hull_tools/{path.relative_to(ADDON)}", path.read_bytes()
    for package in ("hull_io", "hull_fairness", "hull_fitting"):
        for path in files_below(PYTHON / package):
            yield f"hull_tools/{path.relative_to(PYTHON)}", path.read_bytes()
    for path in (ROOT / "samples").glob("*.hull.json"):
        yield f"hull_tools/samples/{path.name}", path.read_bytes()


def contents():
    """Names inside the zip and the bytes under each; libraries are those of this system."""
    yield from plain_contents()
    for path in files_below(NATIVE):
        data = stripped(path) if path.suffix == ".so" else path.read_bytes()
        yield f"hull_tools/hull_native/{path.relative_to(NATIVE)}", data


def main():
    if sys.argv[1:] == ["--name-only"]:
        print(package_file())
        return
    if not any(NATIVE.glob("_core*.so")):
        sys.exit(f"no native module in {NATIVE}: ./hull package builds it first")
    write_zip(package_file(), contents())


if __name__ == "__main__":
    main()
