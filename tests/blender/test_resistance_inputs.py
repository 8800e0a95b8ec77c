# SPDX-License-Identifier: GPL-3.0-or-later
"""What the resistance rests on: shown as measured, given in its place; power at the propeller."""

import bpy
import pytest
from addon_under_test import part, sample, state_of
from test_panels import Drawn, context
from test_resistance import planing, result_of


def coaster(method="HOLTROP"):
    hull = sample("coaster")
    own = hull.hull.resistance
    own.method, own.speed_from, own.speed_to, own.speed_step = method, 10.0, 12.0, 2.0
    return hull, own


def native():
    return part("bridge.native").require()


def position_of(result):
    where = result.given.where
    return {"draft": where.draft, "trim": where.trim, "draft_at": where.draft_at}


def test_measured_and_given_of_holtrop():
    """What is given counts, also in what is not given; what was measured is shown all the same."""
    hull, own = coaster()
    before = result_of(hull)
    water = state_of(hull).ship.body
    ship = native().holtrop_ship(water, **position_of(before))
    for name, value in before.measured.items():
        if isinstance(value, float):
            assert value == pytest.approx(getattr(ship, name), rel=1e-5, abs=1e-9), name
    given = {"length": 88.0, "bulb_area": 3.5, "bulb_height": 2.0, "entrance_angle_deg": 25.0}
    for name, value in given.items():
        setattr(own.holtrop, name, value)
    own.thruster_diameter, own.roughness_um = 1.2, 250.0
    after = result_of(hull)
    assert after.measured["length"] == pytest.approx(before.measured["length"])
    ship = native().holtrop_ship(water, **position_of(before), thruster_diameter=1.2, **given)
    density = before.given.where.water_density
    speeds = before.given.speeds
    wanted = native().holtrop(ship, speeds, roughness=250e-6, water_density=density)
    for row, expected in zip(after.rows, wanted, strict=True):
        assert row["total_kN"] == pytest.approx(expected.total, rel=1e-5)
        assert row["bulb_kN"] == pytest.approx(expected.bulb, rel=1e-5) and row["bulb_kN"] > 0.0
    own.holtrop.entrance_angle_deg = 0.0
    assert result_of(hull).rows[0]["total_kN"] != after.rows[0]["total_kN"]


def test_measured_and_given_of_the_delft_series():
    hull, own = coaster("DELFT")
    before = result_of(hull)
    assert set(before.measured) >= {"lcb", "lcf", "prismatic"}
    own.delft.wetted_surface = 2.0 * before.measured["wetted_surface"]
    after = result_of(hull)
    for row, old in zip(after.rows, before.rows):
        assert row["friction_kN"] == pytest.approx(2.0 * old["friction_kN"], rel=1e-6)


def test_deadrise_is_that_of_the_hull_unless_given():
    hull, own = planing()
    own.deadrise = 0.0
    result = result_of(hull)
    body = state_of(hull).ship.body
    angle = native().bottom_deadrise(body, **position_of(result))
    assert result.measured["deadrise_deg"] == pytest.approx(57.29577951308232 * angle, rel=1e-6)
    own.deadrise = angle
    again = result_of(hull)
    for row, other in zip(result.rows, again.rows, strict=True):
        assert row["total_kN"] == pytest.approx(other["total_kN"], rel=1e-5)
    own.planing_mass_t, own.planing_lcg = 1.2 * result.measured["mass_t"], 3.0
    heavier = result_of(hull)
    assert heavier.rows[-1]["total_kN"] > again.rows[-1]["total_kN"]
    assert heavier.measured["mass_t"] == result.measured["mass_t"]


def test_nothing_at_all_can_be_given():
    """No bulb, no transom and the centre amidships for Holtrop's method; a flat bottom."""
    hull = sample("container_ship")
    own = hull.hull.resistance
    own.method, own.speed_from, own.speed_to, own.speed_step = "HOLTROP", 20.0, 22.0, 2.0
    before = result_of(hull)
    assert before.rows[0]["bulb_kN"] > 0.0 and before.measured["lcb_percent"] != 0.0
    own.zeros = {"bulb_area", "lcb_percent"}
    after = result_of(hull)
    ship = native().holtrop_ship(
        state_of(hull).ship.body, **position_of(before), bulb_area=0.0, lcb_percent=0.0
    )
    density = before.given.where.water_density
    wanted = native().holtrop(ship, before.given.speeds, water_density=density)
    assert after.rows[0]["bulb_kN"] == 0.0
    assert after.rows[0]["total_kN"] == pytest.approx(wanted[0].total, rel=1e-5)
    own.holtrop.bulb_area = 12.0  # a number counts, whatever was pressed before
    assert result_of(hull).rows[0]["bulb_kN"] > 0.0

    boat, own = planing()
    own.deadrise, own.zeros = 0.0, {"deadrise_deg"}
    flat = result_of(boat)
    assert dict(flat.given.given)["deadrise_deg"] == 0.0 and flat.measured["deadrise_deg"] > 5.0


def test_zeros_are_in_hull_files(tmp_path):
    hull, own = coaster()
    own.zeros = {"transom_area", "bulb_area"}
    path = tmp_path / "coaster.hull.json"
    bpy.ops.hull.export_hull(filepath=str(path))
    bpy.ops.hull.import_hull(filepath=str(path))
    read = bpy.context.object
    assert read != hull and read.hull.resistance.zeros == {"transom_area", "bulb_area"}


def test_delivered_power_stands_beside_the_effective(tmp_path):
    hull, own = coaster()
    own.propeller_diameter = 3.6
    assert "delivered_power_kW" not in result_of(hull).rows[0]
    own.open_water_efficiency, own.shaft_efficiency = 0.6, 0.97
    result = result_of(hull)
    for row in result.rows:
        efficiency = 0.6 * row["hull_efficiency"] * row["rotative_efficiency"]
        assert row["delivered_power_kW"] == pytest.approx(row["effective_power_kW"] / efficiency)
        assert row["shaft_power_kW"] == pytest.approx(row["delivered_power_kW"] / 0.97)
    path = tmp_path / "power.csv"
    bpy.ops.hull.export_table(filepath=str(path), analysis="resistance_curves")
    titles = path.read_text().splitlines()[0].split(",")
    assert {"delivered power [kW]", "shaft power [kW]"} <= set(titles)
    part("features.analyses").outcome_of(hull, bpy.context.scene, "resistance_curves")
    drawn = Drawn(part("panels.resistance").HULL_PT_resistance)
    drawn.draw(context())
    assert "PD kW" in drawn.layout.noted and "property shaft_efficiency" in drawn.layout.noted


@pytest.mark.parametrize("method", ["HOLTROP", "DELFT", "SAVITSKY", "MICHELL"])
def test_the_panel_shows_what_was_measured(method):
    hull = sample("planing_boat" if method == "SAVITSKY" else "coaster")
    own = hull.hull.resistance
    own.method, own.speed_to = method, 20.0
    part("features.analyses").outcome_of(hull, bpy.context.scene, "resistance_curves")
    drawn = Drawn(part("panels.resistance").HULL_PT_resistance_inputs)
    drawn.draw(context())
    noted = drawn.layout.noted
    if method == "MICHELL":
        assert any("exact surface" in text for text in noted)
        assert {"property length", "property wetted_surface"} <= set(noted)
        assert f"{result_of(hull).measured['length']:.2f} m" in noted
        return
    measured = result_of(hull).measured
    length = measured["lcg" if method == "SAVITSKY" else "length"]
    assert f"{length:.2f} m" in noted
    wanted = {"HOLTROP": "transom_area", "DELFT": "lcf", "SAVITSKY": "deadrise"}
    assert f"property {wanted[method]}" in noted
    assert "property zeros" in noted
    assert "–" not in noted


def test_what_is_given_follows_the_hull():
    hull, own = coaster()
    own.holtrop.length, own.holtrop.draft_aft, own.delft.waterplane_area = 80.0, 5.0, 700.0
    own.delft.wetted_surface, own.planing_mass_t = 1000.0, 10.0
    before = hull.hull.length_pp
    assert bpy.ops.hull.set_dimensions(length=2.0 * before, beam=0, depth=0) == {"FINISHED"}
    assert own.holtrop.length == pytest.approx(160.0)
    assert (own.holtrop.draft_aft, own.holtrop.draft_forward) == (5.0, 0.0)
    assert own.delft.waterplane_area == pytest.approx(1400.0)
    assert own.delft.wetted_surface == pytest.approx(1000.0 * 2.0 ** (2.0 / 3.0))
    assert own.planing_mass_t == pytest.approx(20.0)


@pytest.mark.parametrize(
    "change, said",
    [
        ({"entrance_angle_deg": 89.0, "length": 5.0}, "Holtrop's formulas need"),
        ({"lcb_percent": 40.0}, "too near an end"),
    ],
)
def test_what_no_ship_has_is_told(change, said):
    hull, own = coaster()
    for name, value in change.items():
        setattr(own.holtrop, name, value)
    with pytest.raises(ValueError, match=said):
        result_of(hull)
