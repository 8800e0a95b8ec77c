# SPDX-License-Identifier: GPL-3.0-or-later
"""Names that no file can have are refused in a sentence by every writer, and nothing is left."""

import bpy
import pytest
from addon_under_test import lined_hull, part

ENDINGS = {
    "hull": ".hull.json",
    "lines": ".pdf",
    "lines dxf": ".dxf",
    "table": ".csv",
    "plot": ".svg",
    "step": ".step",
    "iges": ".igs",
    "report": ".txt",
}


def write(kind, path):
    if kind == "table":
        return bpy.ops.hull.export_table(filepath=path, analysis="hydrostatic_table")
    if kind == "plot":
        return bpy.ops.hull.export_plot(filepath=path, analysis="sectional_areas")
    if kind == "report":
        return part("features.exchange.exports").export_report(bpy.context.object, path)
    return getattr(bpy.ops.hull, f"export_{kind.split()[0]}")(filepath=path)


@pytest.fixture
def hull():
    found = lined_hull()
    part("features.conversion.conversions").begin(found, bpy.context.scene).result()
    part("features.conversion.conversions").take_finished()
    return found


@pytest.mark.parametrize("kind", ENDINGS)
def test_names_that_no_file_can_have(hull, kind, tmp_path):
    for begin, said in (("n" * 300, "too long"), ("two\nlines", "line breaks")):
        with pytest.raises((RuntimeError, ValueError), match=said) as refused:
            write(kind, str(tmp_path / (begin + ENDINGS[kind])))
        assert "Errno" not in str(refused.value)
        assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("kind", ENDINGS)
def test_the_longest_name(hull, kind, tmp_path):
    path = tmp_path / ("n" * (255 - len(ENDINGS[kind])) + ENDINGS[kind])
    write(kind, str(path))
    assert [found.name for found in tmp_path.iterdir()] == [path.name]
