# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell's plates written in Blender."""

import csv

import bpy
import pytest
from addon_under_test import part, sample


@pytest.mark.parametrize("ending", ["pdf", "dxf"])
def test_drawings_of_plates(tmp_path, ending):
    sample("coaster")
    path = tmp_path / f"plates.{ending}"
    arguments = {"plate_length": 20.0, "strake": 3.0, "frame_spacing": 2.4}
    assert bpy.ops.hull.export_plates(filepath=str(path), **arguments) == {"FINISHED"}
    assert path.stat().st_size > 10000


def test_the_list_has_the_hull_s_area(tmp_path):
    hull = sample("coaster")
    path = tmp_path / "plates.csv"
    assert bpy.ops.hull.export_plates(filepath=str(path), plate_length=20.0) == {"FINISHED"}
    rows = list(csv.DictReader(path.open()))
    surface = part("features.hull.hull_state").state_of(hull).ship.surface
    hull_native = part("bridge.native").require()
    whole = hull_native.surface_areas(surface).areas.sum()
    # Seven digits of each.
    both = sum(float(row["area_m2"]) * int(row["pieces"]) for row in rows)
    assert both == pytest.approx(2.0 * whole, rel=1e-6)
    assert {row["pieces"] for row in rows} == {"1", "2"}


def test_too_many_plates_are_one_sentence(tmp_path, monkeypatch):
    sample("coaster")
    monkeypatch.setattr(part("bridge.limits"), "MOST_PLATES", 3)
    with pytest.raises(RuntimeError, match="ask for larger ones"):
        bpy.ops.hull.export_plates(filepath=str(tmp_path / "plates.csv"))
    assert not list(tmp_path.iterdir())
