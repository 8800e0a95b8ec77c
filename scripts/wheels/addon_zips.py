# SPDX-License-Identifier: GPL-3.0-or-later
"""Make the add-on for Blenders on any Linux of the wheels in build/wheels.

build/package/hull_tools-VERSION-extension.zip is for Blender 4.2 and later: the native module is
in it as wheels, one for each Python that a Blender has, named in the manifest; Blender unpacks the
one for its own. hull_tools-VERSION-blender-3.4.zip is for the Blender before, which knows no
wheels: the module is unpacked in it. All else is as in the zip that scripts/package.py makes.

PYTHONPATH=scripts python3 scripts/wheels/addon_zips.py
"""

import sys
import zipfile
from pathlib import Path

import package
from build_wheel import DISTRIBUTION, WHEELS, version
from zips import write_zip

MANIFEST = "blender_manifest.toml"


EXTENSION, LEGACY = "extension", "blender-3.4"
# Debian's Blender 3.4 runs this one.
LEGACY_PYTHON = "cp311"


def zip_file(kind):
    return package.package_file().with_name(f"hull_tools-{version()}-{kind}.zip")


def manifest_with(wheels, text):
    """The manifest's text with the wheels named in it; before its first table, as TOML wants."""
    names = "".join(f'    "./wheels/{wheel.name}",\n' for wheel in wheels)
    head, table, rest = text.partition("\n[")
    return f"{head}\nwheels = [\n{names}]\n{table}{rest}"


def extension_contents(wheels):
    """Names inside the extension and the bytes under each."""
    for name, data in package.plain_contents():
        if Path(name).name == MANIFEST:
            data = manifest_with(wheels, data.decode("utf-8")).encode("utf-8")
        yield name, data
    for wheel in wheels:
        yield f"hull_tools/wheels/{wheel.name}", wheel.read_bytes()


def legacy_contents(wheel):
    """Names inside the add-on for Blender 3.4, and the bytes under each."""
    yield from package.plain_contents()
    with zipfile.ZipFile(wheel) as opened:
        for name in opened.namelist():
            if name.startswith("hull_native/"):
                yield f"hull_tools/{name}", opened.read(name)
            elif "/licenses/" in name:
                yield f"hull_tools/hull_native/licenses/{Path(name).name}", opened.read(name)


def main():
    wheels = sorted(WHEELS.glob(f"{DISTRIBUTION}-{version()}-*.whl"))
    if not wheels:
        sys.exit(f"no wheel in {WHEELS}: ./hull wheel makes one first")
    made = {EXTENSION: extension_contents(wheels)}
    for wheel in wheels:
        if f"-{LEGACY_PYTHON}-" in wheel.name:
            made[LEGACY] = legacy_contents(wheel)
    for kind, contents in made.items():
        write_zip(zip_file(kind), contents)
        print(f"{zip_file(kind).name}: {zip_file(kind).stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
