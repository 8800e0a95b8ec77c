# SPDX-License-Identifier: GPL-3.0-or-later
"""Wheels carry what they need and ask the system for no more than their tag says; as binutils sees
it."""

import ctypes
import re
import subprocess
import zipfile
from pathlib import Path

import carried
import elf_versions
import pytest

ROOT = Path(__file__).resolve().parents[2]

WHEELS = sorted((ROOT / "build" / "wheels").glob("hull_native-*.whl"))
MOST_BYTES = 60e6
# Of Cairo, which needs hypot as of glibc 2.35.
CAIRO = Path("/usr/lib/x86_64-linux-gnu/libcairo.so.2")


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def versions_of(path):
    """(symbol, version) of all that a shared object asks for, as readelf tells it."""
    told = output("readelf", "--wide", "--dyn-syms", path)
    return set(re.findall(r" UND (\w+)@(\w+(?:\.\w+)*)", told))


def asked_for(path):
    found = elf_versions.needs(path.read_bytes())
    return {(symbol, need.version) for need in found for symbol in need.symbols}


needs_cairo = pytest.mark.skipif(not CAIRO.exists(), reason=f"{CAIRO} is not there")


@needs_cairo
def test_versions_are_those_that_readelf_tells():
    assert asked_for(CAIRO) == versions_of(CAIRO)
    assert len(asked_for(CAIRO)) > 100


@needs_cairo
def test_a_lowered_version_is_asked_for_no_longer_and_the_library_loads(tmp_path):
    copy = tmp_path / "libcairo-lowered.so"
    data, lowered = CAIRO.read_bytes(), []
    for need in elf_versions.needs(data):
        if need.library == "libm.so.6" and need.version != "GLIBC_2.2.5":
            data = elf_versions.lowered(data, need, "GLIBC_2.2.5")
            lowered += need.symbols
    copy.write_bytes(data)
    assert lowered
    versions = dict(versions_of(copy))
    assert {versions[symbol] for symbol in lowered} == {"GLIBC_2.2.5"}
    # All others are as they were, of other libraries with the same version too.
    before = dict(versions_of(CAIRO))
    assert all(versions[symbol] == before[symbol] for symbol in before.keys() - set(lowered))
    library = ctypes.CDLL(copy)
    library.cairo_version_string.restype = ctypes.c_char_p
    assert library.cairo_version_string().startswith(b"1.")


@pytest.mark.parametrize("data", [b"", b"\x7fELF", b"MZ" + bytes(100)])
def test_what_is_no_elf_file_is_refused(data):
    with pytest.raises(ValueError, match="no ELF file"):
        elf_versions.needs(data)


@needs_cairo
def test_a_version_that_is_not_there_is_no_substitute():
    newest = next(need for need in elf_versions.needs(CAIRO.read_bytes()) if need.symbols)
    with pytest.raises(ValueError, match="GLIBC_9.9 is not asked for"):
        elf_versions.lowered(CAIRO.read_bytes(), newest, "GLIBC_9.9")


# --- the wheels of build/wheels ---

wheels = pytest.mark.parametrize(
    "wheel",
    WHEELS or [pytest.param(None, marks=pytest.mark.skip(reason="no wheel: ./hull wheel"))],
    ids=lambda wheel: wheel and wheel.name,
)


@pytest.fixture(scope="module")
def unpacked(tmp_path_factory):
    """The folder of an unpacked wheel; each is unpacked once."""
    folders = {}

    def folder_of(wheel):
        if wheel not in folders:
            folders[wheel] = tmp_path_factory.mktemp("wheel")
            with zipfile.ZipFile(wheel) as file:
                file.extractall(folders[wheel])
        return folders[wheel]

    return folder_of


def objects_in(folder):
    found = sorted(folder.rglob("*.so"))
    assert len(found) > 20
    return found


@wheels
def test_nothing_is_needed_from_outside_but_the_runtimes(wheel, unpacked):
    objects = objects_in(unpacked(wheel))
    carried_names = {path.name for path in objects}
    for path in objects:
        dynamic = output("readelf", "--wide", "--dynamic", path)
        needed = set(re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic))
        assert needed - carried_names <= set(carried.OF_THE_SYSTEM), path.name
        place = re.findall(r"\(RPATH\).*\[(.*)\]", dynamic)
        assert place == ["$ORIGIN" if path.parent.name == carried.FOLDER else "$ORIGIN/libs"]


@wheels
def test_names_of_libraries_are_like_nobody_elses(wheel, unpacked):
    for path in objects_in(unpacked(wheel)):
        if path.parent.name == carried.FOLDER:
            name = re.findall(r"\(SONAME\).*\[(.*)\]", output("readelf", "-W", "-d", path))
            assert name == [path.name]
            assert re.fullmatch(r"lib.+-[0-9a-f]{8}\.so", path.name)


@wheels
def test_no_symbol_is_newer_than_the_tag_says(wheel, unpacked):
    tag = re.search(r"manylinux_(\d+)_(\d+)_x86_64", wheel.name)
    least = tuple(map(int, tag.groups()))
    asked = set()
    for path in objects_in(unpacked(wheel)):
        versions = re.findall(r"Name: GLIBC_(\d+)\.(\d+)", output("readelf", "-W", "-V", path))
        asked |= {tuple(map(int, version)) for version in versions}
    assert max(asked) == least


@wheels
def test_modules_show_their_entry_alone(wheel, unpacked):
    modules = sorted((unpacked(wheel) / "hull_native").glob("*.so"))
    assert len(modules) >= 5
    for path in modules:
        shown = output("nm", "--dynamic", "--defined-only", path).split()[2::3]
        assert shown == [f"PyInit_{path.name.split('.')[0]}"]


@wheels
def test_a_wheel_is_small_and_lists_what_is_in_it(wheel, unpacked):
    assert wheel.stat().st_size <= MOST_BYTES
    folder = unpacked(wheel)
    (record,) = folder.glob("*.dist-info/RECORD")
    listed = {line.rsplit(",", 2)[0] for line in record.read_text().splitlines()}
    assert listed == {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}
    assert len(list(folder.glob("*.dist-info/licenses/*.txt"))) > 10
