# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared libraries carried along with extension modules, under names of their own.

Each library that a module needs, but those that every Linux with the tag's C library has, is
copied beside it; its name gets a hash of what is in it, so that no other program's library of the
same name is taken for it, and it is found by its place (`$ORIGIN`). Versions of the C library's
symbols that only better handling of errors has brought are lowered.
"""

import hashlib
import re
import subprocess
from pathlib import Path

import elf_versions

FOLDER = "libs"
# What stays the system's: the C and C++ runtimes, whose versions the wheel's tag tells.
OF_THE_SYSTEM = (
    "libc.so.6",
    "libm.so.6",
    "libdl.so.2",
    "libpthread.so.0",
    "librt.so.1",
    "ld-linux-x86-64.so.2",
    "libgcc_s.so.1",
    "libstdc++.so.6",
)
# Functions that have got a newer version for the way they tell errors alone, which nobody here
# looks at: hypot in glibc 2.35, fmod in 2.38 (glibc's NEWS).
_SAME_FUNCTION = {"hypot", "fmod"}
_OLDEST = "GLIBC_2.2.5"
# Functions that glibc has only lately, and the library that has them too, where it is carried.
_ELSEWHERE = {"arc4random_buf": "libbsd.so.0"}


def carry(package):
    """Gives the extension modules (*.so) in a folder all that they need, in its folder FOLDER; the
    paths of the libraries there."""
    modules = sorted(package.glob("*.so"))
    found = {}
    for module in modules:
        found.update(_libraries_of(module))
    target = package / FOLDER
    target.mkdir()
    names = {name: _own_name(path) for name, path in found.items()}
    for name, path in found.items():
        _copy(path, target / names[name], names)
        _rename(target / names[name], names, "$ORIGIN", names[name])
    for module in modules:
        _copy(module, module, names)
        _rename(module, names, f"$ORIGIN/{FOLDER}")
    return sorted(target.iterdir())


def debian_packages(folder):
    """Names of the Debian packages that the libraries come from which modules in a folder need."""
    paths = {path for module in folder.glob("*.so") for path in _libraries_of(module).values()}
    found = set()
    for path in paths:
        # Files may be told with or without /usr, which is the same folder.
        told = _output("dpkg", "-S", f"*{str(path).removeprefix('/usr')}")
        found.add(told.split(":", 1)[0])
    return sorted(found)


def least_glibc(paths):
    """(major, minor) of the oldest C library that has all that is asked for."""
    versions = [(2, 2)]
    for path in paths:
        for need in elf_versions.needs(path.read_bytes()):
            if need.version.startswith("GLIBC_2."):
                versions.append(tuple(map(int, need.version[6:].split(".")[:2])))
    return max(versions)


def _libraries_of(module):
    """Paths by name of all libraries that a module needs, and these need, but the system's."""
    told = _output("ldd", module)
    if "not found" in told:
        raise ValueError(f"{module}: a library it needs is missing: {told}")
    found = dict(re.findall(r"^\s*(\S+) => (/\S+)", told, re.MULTILINE))
    return {name: Path(path).resolve() for name, path in found.items() if name not in OF_THE_SYSTEM}


def _moved(data, names):
    """Symbols of a file that are to come from another library than the C library: one that is
    carried."""
    return {
        symbol
        for need in elf_versions.needs(data)
        if need.library == "libc.so.6"
        for symbol in need.symbols
        if _ELSEWHERE.get(symbol) in names
    }


def _own_name(path):
    """libTKMath.so.7.6.3 with its hash as libTKMath-0123abcd.so."""
    digest = hashlib.sha256(path.read_bytes()).hexdigest()[:8]
    return f"{path.name.split('.so')[0]}-{digest}.so"


def _copy(path, target, names):
    """Writes a shared object to `target` with the versions it asks for lowered, without what is
    for debugging."""
    data = path.read_bytes()
    moved = _moved(data, names)
    for need in elf_versions.needs(data):
        symbols = set(need.symbols)
        if need.library not in OF_THE_SYSTEM or not symbols:
            continue
        if symbols <= _SAME_FUNCTION or symbols <= moved:
            data = elf_versions.lowered(data, need, _OLDEST)
    target.write_bytes(data)
    target.chmod(0o755)
    subprocess.run(["strip", "--strip-unneeded", target], check=True)


def _rename(path, names, search_path, own_name=""):
    """Has a shared object ask for the libraries by their new names, at search_path."""
    # patchelf confuses the arguments of several kinds of changes: one kind a call.
    needed = _output("patchelf", "--print-needed", path).split()
    for symbol in _moved(path.read_bytes(), names):
        _patch(path, "--clear-symbol-version", symbol)
        if _ELSEWHERE[symbol] not in needed:
            _patch(path, "--add-needed", names[_ELSEWHERE[symbol]])
    carried = [name for name in needed if name in names]
    if carried:
        _patch(
            path, *(word for name in carried for word in ("--replace-needed", name, names[name]))
        )
    if own_name:
        _patch(path, "--set-soname", own_name)
    _patch(path, "--force-rpath", "--set-rpath", search_path)


def _patch(path, *change):
    _output("patchelf", *change, path)


def _output(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise ValueError(f"{' '.join(map(str, command))}: {done.stderr.strip()}")
    return done.stdout
