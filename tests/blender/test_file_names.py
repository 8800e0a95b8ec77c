# SPDX-License-Identifier: GPL-3.0-or-later
"""Names that no file can have, folders that can't be written to, and folders in the file's place
are refused in a sentence by every operator that writes a file, and nothing is left."""

import os
import re

import bpy
import pytest
from addon_under_test import hull_io, lined_hull, part, sample
from edited_hulls import grid_hull
from expect_morph import boxes, morph_of
from networks import grid_network
from test_hulls_from_geometry import triangles_of
from test_panels import texts

pytestmark = pytest.mark.once

# Operator: (endings, what else it is told, of the first file's name what stands between the path's
# stem and the ending).
EXPORTS = {
    "curvature": ((".svg",), {"position": 5.0}, ""),
    "curves": ((".dxf",), {}, ""),
    "figures": ((".svg",), {}, "-rendering"),
    "frame_table": ((".csv",), {}, ""),
    "frames": ((".pdf",), {}, ""),
    "freeship": ((".fbm",), {}, ""),
    "hull": ((".hull.json",), {}, ""),
    "iges": ((".igs",), {}, ""),
    "lines": ((".pdf", ".dxf"), {}, ""),
    "model": ((".stl", ".3mf", ".obj", ".cli"), {}, ""),
    "nesting": ((".csv", ".pdf"), {"stock_length": 20.0, "stock_breadth": 5.0}, ""),
    "network": ((".step",), {}, ""),
    "panels": ((".gdf", ".dat", ".obj"), {}, ""),
    "parts": ((".stl",), {}, ""),
    "plates": ((".csv", ".pdf"), {}, ""),
    "plot": ((".svg",), {"analysis": "sectional_areas"}, ""),
    "report": ((".txt", ".json"), {}, ""),
    "sections": ((".gf", ".hll", ".mlt", ".txt"), {}, ""),
    "series_table": ((".csv",), {}, ""),
    "step": ((".step",), {}, ""),
    "stretch": ((".pdf",), {}, ""),
    "table": ((".csv",), {"analysis": "hydrostatic_table"}, ""),
    "templates": ((".pdf",), {}, ""),
    "view": ((".svg", ".dxf"), {}, ""),
}
READING = {"import_hull", "hull_from_file", "load_area_curve", "load_stl"}
CASES = [(kind, ending) for kind, (endings, *_) in EXPORTS.items() for ending in endings]
# Stretch takes seconds each time, and is written as templates are.
short_cases = pytest.mark.parametrize("kind, ending", [c for c in CASES if c[0] != "stretch"])
cases = pytest.mark.parametrize("kind, ending", CASES)


def write(kind, path):
    return getattr(bpy.ops.hull, f"export_{kind}")(filepath=str(path), **EXPORTS[kind][1])


@pytest.fixture
def prepared(request):
    """What is written, active."""
    kind = request.getfixturevalue("kind")
    conversions = part("features.conversion.conversions")
    if kind == "network":
        yield grid_network()
        return
    if kind == "series_table":
        yield morph_of(*boxes((1.0, 1.0, 1.0), (2.0, 1.5, 0.5)))
        conversions.stop()
        return
    # All plates of a box are developed, and have no stretch.
    found = grid_hull() if kind == "stretch" else lined_hull()
    if kind in ("plates", "templates", "stretch", "nesting", "frames", "frame_table"):
        plate_rules(found)
    if kind in ("step", "iges", "report"):
        conversions.begin(found, bpy.context.scene).result()
        conversions.take_finished()
    yield found
    conversions.stop()


def plate_rules(hull):
    for kind, value in (("strakes", 1.0), ("butts", 5.0)):
        rule = hull.hull.plates.rules.add()
        rule.kind, rule.value = kind, value
    made = hull.hull.plates.ranges.add()
    made.last, made.spacing = 40, 0.5


def refused(kind, path):
    with pytest.raises((RuntimeError, ValueError)) as told:
        write(kind, path)
    text = str(told.value)
    assert "Errno" not in text and "Traceback" not in text, text
    return text


def test_all_operators_that_write_files_are_tried():
    """Those with a path, but for those that read. A series has a folder and names of its own."""
    found = set()
    for name in dir(bpy.ops.hull):
        properties = getattr(bpy.ops.hull, name).get_rna_type().properties.keys()
        if "filepath" in properties:
            found.add(name)
    assert found - READING == {f"export_{kind}" for kind in EXPORTS}
    assert READING <= found


def written_to_be_read(operator, path):
    if operator == "import_hull":
        bpy.ops.hull.export_hull(filepath=str(path))
    elif operator == "load_area_curve":
        path.write_text("x,area\n0,0\n5,4\n10,0\n")
    else:
        hull_io().write_stl(path, *triangles_of(sample("barge")))


@pytest.mark.skipif(os.name == "nt", reason="names of files are no bytes there")
@pytest.mark.parametrize("operator", sorted(READING))
def test_names_that_are_no_letters(operator, tmp_path):
    """As of old archives: Prüfung in Latin-1."""
    lined_hull()
    read = getattr(bpy.ops.hull, operator)
    ending = {"import_hull": ".hull.json", "load_area_curve": ".csv"}.get(operator, ".stl")
    odd = os.fsdecode(os.fsencode(tmp_path) + b"/Pr\xfcfung" + os.fsencode(ending))
    with pytest.raises(RuntimeError, match=r"^Error: Pr\?fung.*can't be opened"):
        read(filepath=odd)
    written_to_be_read(operator, tmp_path / f"file{ending}")
    os.rename(tmp_path / f"file{ending}", odd)
    assert read(filepath=odd) == {"FINISHED"}
    assert texts()


@short_cases
def test_names_that_no_file_can_have(kind, ending, prepared, tmp_path):
    for begin, said in (("n" * 300, "too long"), ("two\nlines", "line breaks")):
        assert said in refused(kind, tmp_path / (begin + ending))
        assert not list(tmp_path.iterdir())


@short_cases
def test_no_name(kind, ending, prepared, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for path in ("", f"{tmp_path}{os.sep}"):
        assert "name" in refused(kind, path)
        assert not list(tmp_path.iterdir())


@cases
def test_the_longest_name(kind, ending, prepared, tmp_path):
    between = EXPORTS[kind][2] or ("-areas" if kind == "series_table" else "")
    stem = "n" * (255 - len(between) - len(ending))
    if kind == "figures":  # another one has the longest name
        stem = stem[: len("rendering") - len("sections-plan")]
    write(kind, tmp_path / f"{stem}{ending}")
    assert f"{stem}{EXPORTS[kind][2]}{ending}" in {found.name for found in tmp_path.iterdir()}


@short_cases
def test_a_folder_has_the_name(kind, ending, prepared, tmp_path):
    taken = tmp_path / f"taken{EXPORTS[kind][2]}{ending}"
    taken.mkdir()
    assert "folder" in refused(kind, tmp_path / f"taken{ending}")
    assert list(tmp_path.iterdir()) == [taken] and not list(taken.iterdir())


@short_cases
def test_a_folder_that_is_read_only(kind, ending, prepared, tmp_path, monkeypatch):
    """Parts of a drawing may be made among the temporary files, where all may write."""
    monkeypatch.setenv("TMPDIR", "/tmp")
    write(kind, tmp_path / f"before{ending}")  # what is imported late is
    folder, before, is_root = tmp_path / "kept", os.getcwd(), os.geteuid() == 0
    folder.mkdir()
    os.chdir(folder)
    os.chmod(folder, 0o555)
    if is_root:
        os.seteuid(65534)
    try:
        text = refused(kind, f"file{ending}")
    finally:
        if is_root:
            os.seteuid(0)
        os.chmod(folder, 0o755)
        os.chdir(before)
    assert re.search("your rights to it|you may write to|be written", text)
    assert not list(folder.iterdir())
