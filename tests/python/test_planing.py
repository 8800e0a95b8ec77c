# SPDX-License-Identifier: GPL-3.0-or-later
"""Savitsky's method against another program, its own equations, and from exact hulls."""

import dataclasses
import math

import hull_native as hn
import numpy as np
import pytest
from test_planing_example import BOAT, SPEED, WATER
from transformation_hulls import Sample


def test_readings_are_checked():
    with pytest.raises(ValueError, match="give one each"):
        hn.planing_at_trims(BOAT, SPEED, [2.0], readings=[], **WATER)
    with pytest.raises(ValueError, match="A reading is one of"):
        hn.planing_at_trims(BOAT, SPEED, [2.0], readings=[{"lambda": 3.0}], **WATER)
    with pytest.raises(ValueError, match="bottom_speed must be a number above zero"):
        hn.planing_at_trims(BOAT, SPEED, [2.0], readings=[{"bottom_speed": 0.0}], **WATER)


def test_lift_and_centre_of_pressure_are_those_of_another_program():
    """Without charts between: what the tests of ydeos_hydrodynamics have for the motor yacht of
    Larsson & Eliasson's Principles of Yacht Design, page 204; that program solves to 1e-6."""
    yacht = hn.PlaningBoat(9.75, 2.74, 17.9, 3.55, 1.145, thrust_angle_deg=3.0, thrust_arm=0.49)
    trim = 4.168706856548404
    result, _ = hn.planing_at_trims(yacht, 20.6, [trim], water_density=1.025)[0]
    assert result.speed_coefficient == pytest.approx(3.9740342082443276, rel=1e-14)
    assert result.lift_coefficient == pytest.approx(0.05855929710250599, rel=1e-14)
    assert result.flat_lift_coefficient == pytest.approx(0.08508584811026254, rel=1e-8)
    assert result.wetted_length_ratio == pytest.approx(1.8124177483423276, rel=1e-8)
    assert result.pressure_arm == pytest.approx(0.006468009810514541, abs=1e-7)


def test_formulas_hold():
    """Lift (15), (16) and Schoenherr's line are implicit: put back, they are met."""
    result = hn.savitsky(BOAT, [SPEED], **WATER)[0]
    flat, ratio = result.flat_lift_coefficient, result.wetted_length_ratio
    assert flat - 0.065 * flat**0.6 == pytest.approx(result.lift_coefficient, rel=1e-12)
    dynamic = 0.0120 * math.sqrt(ratio) + 0.0055 * ratio**2.5 / result.speed_coefficient**2
    assert dynamic * result.trim_deg**1.1 == pytest.approx(flat, rel=1e-12)
    for number in (1e6, 3.61e8, 5e9):
        line = hn.attc_1947(number)
        assert 0.242 / math.sqrt(line) == pytest.approx(math.log10(number * line), rel=1e-13)


def test_from_a_hull():
    hull = Sample("planing_boat")
    draft = hull.ship.draft
    boat = hn.planing_boat(hull.body, draft=draft, deadrise_deg=18.0, vcg=0.8)
    water = hn.hydrostatics(hull.body, draft=draft)
    assert boat.mass_t == water.displacement_t
    assert boat.lcg == pytest.approx(water.lcb - water.waterline_aft)
    assert hn.planing_boat(hull.body, draft=draft, deadrise_deg=18.0, vcg=0.8, beam=2.0).beam == 2.0


def test_hulls_beside_one_another_have_no_deadrise_and_are_told():
    hull = Sample("catamaran")
    draft = hull.ship.draft
    for call in (hn.bottom_deadrise, lambda *a, **how: hn.planing_boat(*a, vcg=1.0, **how)):
        with pytest.raises(ValueError, match="beside one another .* give the deadrise"):
            call(hull.body, draft=draft)
    boat = hn.planing_boat(hull.body, draft=draft, deadrise_deg=12.0, vcg=1.0)
    one = dataclasses.replace(boat, side_by_side=False)
    for each, count in ((boat, 1), (one, 0)):
        ((found, _),) = hn.planing_at_trims(each, 12.0, [4.0])
        assert sum("beside one another" in text for text in found.outside) == count


def v_bottom(deadrise, chine, mirrored=True, rail=0.0):
    """HullBody of a prismatic V, 12 m long, with vertical sides from the chine on; rail: by so much
    a level rail breaks the bottom's middle."""
    slope = math.tan(deadrise)
    half = 0.5 * chine
    rows = [(half, half * slope + 2.0), (half, half * slope), (0.0, 0.0)]
    if rail:
        rows[2:2] = [(half / 2 + rail, half / 2 * slope), (half / 2, half / 2 * slope)]
    if not mirrored:
        rows += [(-y, z) for y, z in rows[-2::-1]]
    x = np.linspace(0.0, 12.0, 4)
    points = np.array([[(at, y, z) for at in x] for y, z in rows])
    corners = np.arange(len(rows) * 4).reshape(len(rows), 4)
    faces = np.stack(
        [corners[:-1, :-1], corners[:-1, 1:], corners[1:, 1:], corners[1:, :-1]], axis=-1
    ).reshape(-1, 4)
    creases = [pair for row in corners[1:-1] for pair in zip(row, row[1:])]
    mesh = hn.ControlMesh(points.reshape(-1, 3), np.full(len(faces), 4), faces.ravel(), creases)
    return hn.HullBody(hn.LimitSurface(mesh), mirrored=mirrored)


@pytest.mark.parametrize("mirrored", [True, False])
@pytest.mark.parametrize("degrees", [0.0, 5.0, 17.0, 40.0])
def test_deadrise_of_a_prismatic_bottom(degrees, mirrored):
    """Whatever the draft, the trim and what lies above the chine."""
    body = v_bottom(math.radians(degrees), 3.0, mirrored)
    for draft, trim in ((0.3, 0.0), (1.6, 0.0), (1.6, 0.02)):
        found = hn.bottom_deadrise(body, draft=draft, trim=trim, draft_at=6.0)
        assert math.degrees(found) == pytest.approx(degrees, abs=1e-9)
    boat = hn.planing_boat(body, draft=1.6, vcg=1.0)
    assert boat.deadrise_deg == pytest.approx(degrees, abs=1e-9)
    assert hn.planing_boat(body, draft=1.6, vcg=1.0, deadrise_deg=12.0).deadrise_deg == 12.0


def test_deadrise_across_a_rail_is_that_of_the_chord():
    """A level rail leaves keel and chine where they are."""
    body = v_bottom(0.3, 3.0, rail=0.2)
    found = hn.bottom_deadrise(body, draft=1.6)
    assert math.tan(found) == pytest.approx(math.tan(0.3), abs=1e-9)
    with pytest.raises(ValueError, match="no bottom flatter than 45°"):
        hn.bottom_deadrise(v_bottom(math.radians(50.0), 3.0), draft=1.0)
    with pytest.raises(ValueError, match="out of the water"):
        hn.bottom_deadrise(body, draft=-1.0)


def test_what_is_outside_has_its_name():
    """One range after the other is left."""
    slow = hn.planing_at_trims(BOAT, 3.0, [4.0], **WATER)[0][0]
    assert slow.speed_coefficient == pytest.approx(3.0 / math.sqrt(hn.GRAVITY * BOAT.beam))
    names = [[text.partition(" is outside ")[0] for text in result.outside] for result in (
        slow,
        hn.planing_at_trims(BOAT, SPEED, [1.5], **WATER)[0][0],
        hn.planing_at_trims(BOAT, SPEED, [3.0], **WATER)[0][0],
        hn.planing_at_trims(BOAT, 100.0, [16.0], **WATER)[0][0],
    )]  # fmt: skip
    value = f"speed coefficient Cv {slow.speed_coefficient:.3g}"
    assert value in names[0] and f"{value} is outside 0.6 to 13.0" in slow.outside
    assert [name.rpartition(" ")[0] for name in names[1]] == [
        "trim in degrees", "wetted length to beam"
    ]  # fmt: skip
    assert names[2] == []
    assert [name.rpartition(" ")[0] for name in names[3]] == [
        "speed coefficient Cv", "trim in degrees"
    ]  # fmt: skip
    rows = hn.savitsky_table(BOAT, [SPEED, 9.0], **WATER)
    assert rows[0]["outside"] == "" and "wetted length to beam" in rows[1]["outside"]


@pytest.mark.parametrize("speed", [0.0, -1.0, math.nan])
def test_bad_speeds(speed):
    with pytest.raises(ValueError, match="speed must be a number above zero"):
        hn.savitsky(BOAT, [speed])


@pytest.mark.parametrize(
    "speed, trim, how, said",
    [
        (20.0, 0.0, {}, "trim must be above 0° and below 90°, not 0.0°"),
        (20.0, -1.0, {}, "trim must be above 0°"),
        (20.0, math.nan, {}, "trim must be above 0°"),
        (20.0, 90.0, {}, "below 90°"),
        (0.0, 4.0, {}, "speed must be a number above zero"),
        (20.0, 4.0, {"viscosity": 0.0}, "viscosity must be a number above zero"),
        (20.0, 4.0, {"gravity": -1.0}, "gravity must be a number above zero"),
        (20.0, 4.0, {"roughness_allowance": math.nan}, "roughness_allowance must be a finite"),
    ],
)
def test_bad_numbers_at_held_trims(speed, trim, how, said):
    with pytest.raises(ValueError, match=said):
        hn.planing_at_trims(BOAT, speed, [trim], **how)
    if "roughness_allowance" in how:
        with pytest.raises(ValueError, match=said):
            hn.savitsky(BOAT, [speed], **how)


def test_bad_boats():
    for change, said in (
        ({"mass_t": 0.0}, "mass_t must be above zero"),
        ({"deadrise_deg": 50.0}, "deadrise"),
        ({"vcg": math.nan}, "vcg must be a finite number"),
    ):
        with pytest.raises(ValueError, match=said):
            dataclasses.replace(BOAT, **change)
    far_forward = hn.PlaningBoat(27.0, 4.27, 10.0, 60.0, 0.6)
    with pytest.raises(ValueError, match="no trim from"):
        hn.savitsky(far_forward, [20.0])
    with pytest.raises(ValueError, match="friction_line"):
        hn.savitsky(BOAT, [20.0], friction_line="hughes")
    hull = Sample("planing_boat")
    with pytest.raises(ValueError, match="out of the water"):
        hn.planing_boat(hull.body, draft=-2.0, deadrise_deg=18.0, vcg=0.8)


def test_rows_of_speeds_in_equilibrium():
    boat = hn.PlaningBoat(5.0, 2.5, 17.0, 3.5, 0.8)
    speeds = [8.0, 12.0, 16.0]
    rows = hn.savitsky_table(boat, speeds)
    for row, found in zip(rows, hn.savitsky(boat, speeds), strict=True):
        assert row["total_kN"] == found.total and row["trim_deg"] == found.trim_deg
        assert row["friction_kN"] + row["pressure_kN"] == pytest.approx(found.total, rel=1e-14)
        assert row["speed_kn"] == pytest.approx(found.speed / 0.514444, rel=1e-5)
    assert hn.resistance_csv(rows).splitlines()[0].startswith("speed_kn,speed_m_s,friction_kN")
    hopeless = hn.PlaningBoat(5.0, 2.5, 17.0, 3.5, 0.8, thrust_arm=50.0)
    with pytest.raises(ValueError, match="equilibrium"):
        hn.savitsky_table(hopeless, speeds)
    with pytest.raises(ValueError, match="no speeds"):
        hn.savitsky_table(boat, [])
