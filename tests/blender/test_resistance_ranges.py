# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel Resistance by Michell's integral: what is outside is told, and a speed that cannot be
computed does not take the others their numbers."""

import csv
import math

import bpy
import pytest
from addon_under_test import part, sample
from test_panels import Drawn, context
from test_resistance import result_of


def by_michell(name, first, last, step):
    hull = sample(name)
    own = hull.hull.resistance
    own.method = "MICHELL"
    own.speed_from, own.speed_to, own.speed_step = first, last, step
    return hull


def drawn(hull, panel):
    part("features.analyses").outcome_of(hull, bpy.context.scene, "resistance_curves")
    one = Drawn(getattr(part("panels.resistance"), panel))
    one.draw(context())
    return one.layout.noted


def test_a_full_ship_is_told_in_the_remarks():
    hull = by_michell("bulk_carrier", 12.0, 14.0, 2.0)
    noted = " ".join(drawn(hull, "HULL_PT_resistance_remarks"))
    for name in ("Froude number", "block coefficient", "half angle of entrance"):
        assert noted.count(f"Out of the method's range: {name}") == 1, name
    assert "None" not in noted


def test_a_slender_ship_has_no_remark():
    hull = by_michell("naval_vessel", 20.0, 24.0, 4.0)
    assert list(result_of(hull).remarks()) == []
    assert drawn(hull, "HULL_PT_resistance_remarks") == ["None"]


def test_a_speed_that_cannot_be_computed_has_a_dash(tmp_path):
    hull = by_michell("coaster", 1.0, 11.0, 5.0)
    result = result_of(hull)
    assert math.isnan(result.rows[0]["total_kN"]) and result.rows[1]["total_kN"] > 0.0
    remarks = list(result.remarks())
    assert "Without numbers, as out of what can be computed: 1 kn" in remarks
    assert any("Michell's integral 0.0174 is outside 0.05 to 5" in text for text in remarks)
    assert drawn(hull, "HULL_PT_resistance").count("–") == 2  # RT and PE
    path = tmp_path / "michell.csv"
    bpy.ops.hull.export_table(filepath=str(path), analysis="resistance_curves")
    with open(path, newline="", encoding="utf-8-sig") as stream:
        first, second, *_ = csv.DictReader(stream)
    assert (first["total [kN]"], first["effective power [kW]"]) == ("", "")
    assert first["speed [kn]"] == "1" and float(second["total [kN]"]) > 0.0
    assert bpy.ops.hull.export_plot(
        filepath=str(tmp_path / "michell.svg"), analysis="resistance_curves"
    ) == {"FINISHED"}
    assert "nan" not in (tmp_path / "michell.svg").read_text().lower()


def test_only_speeds_that_cannot_be_computed_are_told():
    with pytest.raises(ValueError, match="is outside 0.05 to 5"):
        result_of(by_michell("coaster", 0.5, 1.0, 0.5))


def test_beside_another_hull_too(tmp_path):
    hull = by_michell("coaster", 1.0, 11.0, 5.0)
    bpy.ops.hull.keep_variant(name="before")
    result = result_of(hull)
    assert math.isnan(result.other.rows[0]["total_kN"])
    assert "–" in drawn(hull, "HULL_PT_resistance")
    path = tmp_path / "beside.csv"
    bpy.ops.hull.export_table(filepath=str(path), analysis="resistance_curves")
    assert "nan" not in path.read_text(encoding="utf-8-sig").lower()
    part("features.resistance.resistance_curves").plot(result, "coaster")
