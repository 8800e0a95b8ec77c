# SPDX-License-Identifier: GPL-3.0-or-later
"""Make build/wheels/hull_native-VERSION-…-manylinux_….whl of what is compiled in build/release.

The wheel has the packages hull_native, hull_io, hull_fairness, hull_fitting and hull_studies, and
every library they need but the C and C++ runtimes; its tag says the oldest C library that has all
that is asked for. The same build gives the same bytes.

PYTHONPATH=scripts python3 scripts/wheels/build_wheel.py
"""

import base64
import hashlib
import os
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
from pathlib import Path

import carried
from package import ROOT, files_below
from zips import write_zip

NATIVE = ROOT / "build" / "release" / "python" / "hull_native"
WHEELS = ROOT / "build" / "wheels"
PACKAGES = ("hull_io", "hull_fairness", "hull_fitting", "hull_studies")
DISTRIBUTION = "hull_native"

METADATA = """\
Metadata-Version: 2.1
Name: hull-native
Version: {version}
Summary: Exact ship hulls of crease-tagged control meshes: lines, hydrostatics, stability, STEP
License: GPL-3.0-or-later
Requires-Python: >=3.11
Requires-Dist: numpy

Hulls as Catmull-Clark surfaces, evaluated exactly, in plain Python: sections, hydrostatics,
stability, NURBS patches in STEP and IGES, lines plans; readers of hull files and of geometry.
The licences of the libraries carried along are beside this file.
"""
WHEEL = """\
Wheel-Version: 1.0
Generator: hull_tools
Root-Is-Purelib: false
Tag: {tag}
"""


def version():
    with open(ROOT / "addon" / "blender_manifest.toml", "rb") as manifest:
        return tomllib.load(manifest)["version"]


def python_tag():
    """cp311 for the Python that runs this."""
    return "cp{}{}".format(*sys.version_info[:2])


def carried_package(folder):
    """Copies hull_native with its libraries to `folder`; the compatibility tag of the wheel."""
    package = folder / "hull_native"
    shutil.copytree(NATIVE, package, ignore=shutil.ignore_patterns("__pycache__"))
    libraries = carried.carry(package)
    write_stubs(folder)
    major, minor = carried.least_glibc([*libraries, *package.glob("*.so")])
    machine = sysconfig.get_platform().removeprefix("linux-")
    return f"{python_tag()}-{python_tag()}-manylinux_{major}_{minor}_{machine}"


def write_stubs(folder):
    """Type stubs beside the package in a folder, made of its docstrings."""
    script = ROOT / "scripts" / "reference" / "stubs.py"
    subprocess.run(
        [sys.executable, script, folder / "hull_native"],
        env={**os.environ, "PYTHONPATH": str(folder), "PYTHONDONTWRITEBYTECODE": "1"},
        check=True,
    )


def licences():
    """(name, bytes) of licence texts: ours, those of the packages whose libraries go along."""
    yield "LICENSE", (ROOT / "LICENSE").read_bytes()
    for package in carried.debian_packages(NATIVE):
        text = Path("/usr/share/doc") / package / "copyright"
        yield f"{package}.txt", text.read_bytes()


def contents(folder, tag):
    """(name, bytes) of all files of a wheel but the list of them."""
    for path in files_below(folder):
        yield str(path.relative_to(folder)), path.read_bytes()
    for name in PACKAGES:
        for path in files_below(ROOT / "python" / name):
            yield str(path.relative_to(ROOT / "python")), path.read_bytes()
    info = f"{DISTRIBUTION}-{version()}.dist-info"
    yield f"{info}/METADATA", METADATA.format(version=version()).encode()
    yield f"{info}/WHEEL", WHEEL.format(tag=tag).encode()
    for name, text in licences():
        yield f"{info}/licenses/{name}", text


def with_record(contents):
    """The contents and, last, the list of them with their hashes (PEP 376)."""
    record = []
    for name, data in contents:
        yield name, data
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record.append(f"{name},sha256={digest},{len(data)}\n")
    name = f"{DISTRIBUTION}-{version()}.dist-info/RECORD"
    yield name, "".join([*sorted(record), f"{name},,\n"]).encode()


def main():
    if not any(NATIVE.glob("_core*.so")):
        sys.exit(f"no native module in {NATIVE}: ./hull wheel builds it first")
    WHEELS.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=WHEELS) as folder:
        try:
            tag = carried_package(Path(folder))
        except (OSError, ValueError, subprocess.CalledProcessError) as error:
            sys.exit(f"no wheel is made: {error}")
        for old in WHEELS.glob(f"{DISTRIBUTION}-*-{python_tag()}-*.whl"):
            old.unlink()
        target = WHEELS / f"{DISTRIBUTION}-{version()}-{tag}.whl"
        write_zip(target, with_record(contents(Path(folder), tag)))
    print(f"{target.relative_to(ROOT)}: {target.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
