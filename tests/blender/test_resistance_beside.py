# SPDX-License-Identifier: GPL-3.0-or-later
"""The resistance of the hull that a hull is compared with, beside its own; and the waves behind."""

import csv

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, make_active, part, sample, state_of
from test_panels import Drawn, context
from test_resistance import planing, result_of


def kept_and_broadened(hull):
    """The rows of a hull that is kept as it is, and then made broader."""
    before = result_of(hull).rows
    bpy.ops.hull.keep_variant(name="narrow")
    for vertex in hull.data.vertices:
        vertex.co.y *= 1.1
    hull.data.update()
    bpy.context.view_layer.update()
    return before


def with_variant(method="HOLTROP"):
    """The coaster beside itself as it was before it became broader."""
    hull = sample("coaster")
    own = hull.hull.resistance
    own.method, own.speed_from, own.speed_to, own.speed_step = method, 10.0, 12.0, 1.0
    return hull, own, kept_and_broadened(hull)


def with_planing_variant():
    """The planing boat by Savitsky beside herself as she was before she became broader."""
    hull, own = planing()
    own.deadrise, own.speed_from, own.speed_step = 0.0, 20.0, 5.0
    return hull, own, kept_and_broadened(hull)


def totals(rows):
    return [row["total_kN"] for row in rows]


@pytest.mark.parametrize("method", ["HOLTROP", "MICHELL", "DELFT"])
def test_the_variant_has_what_the_hull_had(method):
    hull, own, before = with_variant(method)
    result = result_of(hull)
    assert result.other.name == "narrow" and result.other.message == ""
    assert totals(result.other.rows) == pytest.approx(totals(before), rel=1e-12)
    assert min(np.abs(np.divide(totals(result.rows), totals(before)) - 1.0)) > 0.01
    assert any(remark.startswith("Compared with narrow, at draft") for remark in result.remarks())
    plot = part("features.resistance.resistance_curves").plot(result, "coaster")
    assert plot.curve_names[-1] == "narrow"
    own.stern = "10"  # this hull's settings count for both
    if method == "HOLTROP":
        assert min(np.divide(totals(result_of(hull).other.rows), totals(before))) > 1.01


def test_a_planing_boat_beside_herself(tmp_path):
    """By Savitsky, each at the trim of her own; shaft and what else is given are this boat's."""
    hull, own, before = with_planing_variant()
    result = result_of(hull)
    assert len(before) == len(result.rows) == len(result.other.rows) == 5
    assert result.other.name == "narrow" and result.other.message == ""
    for row, old in zip(result.other.rows, before):
        assert row["total_kN"] == pytest.approx(old["total_kN"], rel=1e-12)
        assert row["trim_deg"] == pytest.approx(old["trim_deg"], rel=1e-12)
    assert min(np.abs(np.divide(totals(result.rows), totals(before)) - 1.0)) > 0.01
    curves = part("features.resistance.resistance_curves")
    assert curves.plot(result, "boat").curve_names[-1] == "narrow"
    path = tmp_path / "planing.csv"
    bpy.ops.hull.export_table(filepath=str(path), analysis="resistance_curves")
    with open(path, newline="", encoding="utf-8") as stream:
        read = list(csv.DictReader(stream))
    for row, old in zip(read, before, strict=True):
        assert float(row["other hull total [kN]"]) == pytest.approx(old["total_kN"], rel=1e-8)
    own.chine_beam = 3.0  # what is given counts for this hull alone
    assert totals(result_of(hull).other.rows) == pytest.approx(totals(before), rel=1e-12)
    own.thrust_arm = 0.4  # the shaft is told of both
    assert totals(result_of(hull).other.rows) != pytest.approx(totals(before), rel=1e-4)


def test_the_other_is_computed_once(monkeypatch):
    hull, own, _ = with_variant()
    methods = part("features.resistance.methods")
    bodies, compute = [], methods.found
    monkeypatch.setattr(methods, "found", lambda body, asked: (
        bodies.append(body), compute(body, asked))[1])  # fmt: skip
    for draft in (5.0, 5.1, 5.2):
        hull.hull.draft = draft
        bpy.context.view_layer.update()
        result_of(hull)
    assert len(bodies) <= 4  # its own draft stays: three times this hull, once the other
    bodies.clear()
    ship, curves = state_of(hull).ship.source.ship, part("features.resistance.resistance_curves")
    for is_beside in (True, False, True):  # nor this hull, where only the other is another
        hull.hull.variants.resistance_beside = is_beside
        found = curves.compute(ship, curves.inputs(hull.hull, 1.0))
        assert (found.other is not None) == is_beside and len(found.rows) == 3
    assert len(bodies) == 1
    bodies.clear()
    own.speed_to = 13.0
    assert result_of(hull).other.rows[-1]["speed_kn"] == pytest.approx(13.0)
    assert len(bodies) == 2


def test_both_afloat_and_another_hull():
    hull, _, before = with_variant()
    hull.hull.draft -= 0.5
    own_draft = result_of(hull).other.rows
    assert totals(own_draft) == pytest.approx(totals(before), rel=1e-12)
    hull.hull.variants.afloat = "SAME"
    assert max(np.divide(totals(result_of(hull).other.rows), totals(before))) < 0.99
    box = add_hull()
    make_active(hull)
    hull.hull.variants.compared_with = "HULL"
    assert result_of(hull).other is None
    hull.hull.variants.other_hull = box
    hull.hull.variants.afloat = "OWN"
    box.hull.draft = -5.0
    bpy.context.view_layer.update()
    result = result_of(hull)
    assert result.other.rows == [] and "out of the water" in result.other.message
    assert result.other.message in result.remarks()
    box.hull.heel = 0.1
    bpy.context.view_layer.update()
    result = result_of(hull)
    assert "heel to zero" in result.other.message and len(result.rows) == 3
    part("features.resistance.resistance_curves").plot(result, "coaster")
    hull.hull.variants.resistance_beside = False
    assert result_of(hull).other is None


def test_inputs_that_are_given_are_each_hull_s_own():
    hull, own, before = with_variant()
    own.holtrop.wetted_surface = 3000.0
    assert totals(result_of(hull).other.rows) == pytest.approx(totals(before), rel=1e-12)
    hull.hull.variants.kept[0].resistance.holtrop.wetted_surface = 3000.0
    assert min(np.divide(totals(result_of(hull).other.rows), totals(before))) > 1.05


def test_table_and_panel_have_the_other(tmp_path):
    hull, _, before = with_variant()
    path = tmp_path / "beside.csv"
    bpy.ops.hull.export_table(filepath=str(path), analysis="resistance_curves")
    with open(path, newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    for row, old in zip(rows, before, strict=True):
        total = float(row["total [kN]"])
        assert float(row["other hull total [kN]"]) == pytest.approx(old["total_kN"], rel=1e-8)
        assert float(row["difference [kN]"]) == pytest.approx(total - old["total_kN"], rel=1e-6)
        assert float(row["part [%]"]) == pytest.approx(100.0 * (total / old["total_kN"] - 1.0))
        assert row["compared with"] == "narrow"
    part("features.analyses").outcome_of(hull, bpy.context.scene, "resistance_curves")
    drawn = Drawn(part("panels.resistance").HULL_PT_resistance)
    drawn.draw(context())
    assert "other kN" in drawn.layout.noted
    assert "property resistance_beside" in drawn.layout.noted
    bpy.ops.hull.export_plot(filepath=str(tmp_path / "a.svg"), analysis="resistance_curves")
    hull.hull.variants.resistance_beside = False
    bpy.ops.hull.export_plot(filepath=str(tmp_path / "b.svg"), analysis="resistance_curves")
    assert (tmp_path / "a.svg").stat().st_size > (tmp_path / "b.svg").stat().st_size


def test_wave_pattern_and_spectrum():
    """Their resistance is that of the table; the pattern is that of the formula for points."""
    hull = sample("coaster")
    own = hull.hull.resistance
    own.method, own.speed_from, own.speed_to, own.speed_step = "MICHELL", 12.0, 14.0, 2.0
    native = part("bridge.native").require()
    analyses, scene = part("features.analyses"), bpy.context.scene
    spectrum = analyses.result_of(hull, scene, "wave_spectrum")
    (row,) = [row for row in result_of(hull).rows if row["speed_kn"] > 13.0]
    assert spectrum.resistance == pytest.approx(row["wave_kN"], rel=1e-3)
    # Waves steeper than 85° are left out.
    assert 0.125 * spectrum.power.sum() == pytest.approx(spectrum.resistance, rel=0.02)
    own.wave_speed_kn = 12.0
    pattern = analyses.result_of(hull, scene, "wave_pattern")
    where, waves, found = (
        pattern.given.where,
        part("features.resistance.free_waves"),
        pattern.behind,
    )
    assert pattern.given.speed == pytest.approx(12.0 * 1852.0 / 3600.0)
    integral = waves.integral(state_of(hull).ship.body, pattern.given)
    stern = native.hydrostatics(state_of(hull).ship.body, draft=where.draft).waterline_aft
    at = (4, 250)
    point = [[stern - found.x[at[1]], -found.y[at[0]]]]  # on the other side
    (height,) = native.wave_heights(integral, pattern.given.speed, point,
                                    gravity=native.GRAVITY, steepest=found.steepest)  # fmt: skip
    scale = np.abs(found.heights).max()
    assert found.heights[at] == pytest.approx(height, abs=1e-5 * scale)
    for name in ("wave_pattern", "wave_spectrum"):
        assert analyses.plot_of(name, analyses.result_of(hull, scene, name), "coaster")
    drawn = Drawn(part("panels.resistance").HULL_PT_resistance_waves)
    drawn.draw(context())
    assert {"property wave_pattern", "property wave_spectrum"} <= set(drawn.layout.noted)


def test_waves_of_no_ship_are_told():
    hull = sample("catamaran")
    with pytest.raises(ValueError, match="beside the centre plane"):
        part("features.analyses").result_of(hull, bpy.context.scene, "wave_pattern")
    hull.hull.heel = 0.1
    with pytest.raises(ValueError, match="set the heel to zero"):
        part("features.analyses").result_of(hull, bpy.context.scene, "wave_spectrum")
