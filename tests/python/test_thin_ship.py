# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a ship and of a speed is outside of Michell's integral and the ITTC line is told by its
name, and a speed without a number does not take the others theirs."""

import csv
import io
import math
from dataclasses import replace

import hull_native as hn
import pytest
from transformation_hulls import Sample

# Slender, of a fine entrance.
SHIP = hn.ThinShip(
    length=100.0,
    beam=12.0,
    draft=4.0,
    volume=2000.0,
    wetted_surface=1350.0,
    entrance_angle_deg=10.0,
)
NUMBERS = ("friction", "form", "wave", "wave_error", "total")


def named(ship=SHIP, froude=0.3, reynolds=1e9):
    """The sentences without their numbers."""
    return [text.partition(" is ")[0].rstrip("0123456789.e+°") for text in
            ship.outside(froude, reynolds)]  # fmt: skip


def test_a_thin_ship_at_usual_speeds_is_within():
    assert hn.ThinShip.outside(SHIP, 0.2, 1e6) == ()
    assert SHIP.outside(1.0, 1e10) == ()


@pytest.mark.parametrize(
    "name, within, beyond",
    [
        ("Froude number ", {"froude": 0.2}, {"froude": 0.199}),
        ("Froude number ", {"froude": 1.0}, {"froude": 1.001}),
        ("Reynolds number ", {"reynolds": 1e6}, {"reynolds": 0.999e6}),
        ("length to beam ", {"ship": replace(SHIP, beam=20.0)},
         {"ship": replace(SHIP, beam=20.001)}),
        ("block coefficient ", {"ship": replace(SHIP, draft=2000.0 / 0.6999 / 1200.0)},
         {"ship": replace(SHIP, draft=2000.0 / 0.7001 / 1200.0)}),
        ("half angle of entrance ", {"ship": replace(SHIP, entrance_angle_deg=20.0)},
         {"ship": replace(SHIP, entrance_angle_deg=20.001)}),
        # L / ∇^(1/3) of 7.937: 7.5 is asked for at Fn 1, so also beyond it.
        ("length to volume^(1/3) ", {"ship": replace(SHIP, volume=(100.0 / 7.501) ** 3, draft=5.0),
                                     "froude": 1.0},
         {"ship": replace(SHIP, volume=(100.0 / 7.499) ** 3, draft=5.0), "froude": 1.0}),
        # Between the guide's two: 4.0 + 3.5 / 2 at Fn 0.6.
        ("length to volume^(1/3) ", {"ship": replace(SHIP, volume=(100.0 / 5.751) ** 3, draft=9.0),
                                     "froude": 0.6},
         {"ship": replace(SHIP, volume=(100.0 / 5.749) ** 3, draft=9.0), "froude": 0.6}),
        ("length to volume^(1/3) ", {"ship": replace(SHIP, volume=(100.0 / 4.001) ** 3, draft=30.0),
                                     "froude": 0.2},
         {"ship": replace(SHIP, volume=(100.0 / 3.999) ** 3, draft=30.0), "froude": 0.2}),
    ],
)  # fmt: skip
def test_each_limit_is_told_by_its_name(name, within, beyond):
    assert named(**within) == []
    assert named(**beyond) == [name]


def test_a_full_ship_is_told_and_a_slender_one_is_not():
    full, slender = Sample("bulk_carrier"), Sample("naval_vessel")
    (row,) = hn.michell_table(full.body, [7.0], draft=full.ship.draft, tolerance=1e-2)
    said = row["outside"].split("; ")
    assert [text.partition(" 0")[0].partition(" 4")[0] for text in said] == [
        "Froude number", "block coefficient", "half angle of entrance",
    ]  # fmt: skip
    (row,) = hn.michell_table(slender.body, [12.0], draft=slender.ship.draft, tolerance=1e-2)
    assert 0.3 < row["froude"] < 0.35 and row["outside"] == ""


def test_thin_ship_of_the_exact_hull():
    hull = Sample("coaster")
    ship = hn.thin_ship(hull.body, draft=hull.ship.draft)
    water = hn.hydrostatics(hull.body, draft=hull.ship.draft)
    assert (ship.length, ship.beam) == (water.waterline_length, water.waterline_beam)
    assert (ship.volume, ship.wetted_surface) == (water.displaced_volume, water.wetted_surface)
    assert ship.entrance_angle_deg == pytest.approx(math.degrees(water.entrance_chord_angle))
    deep = hn.thin_ship(hull.body, draft=100.0)
    assert (deep.length, deep.beam) == pytest.approx((88.85, 13.6))
    with pytest.raises(ValueError, match="out of the water"):
        hn.thin_ship(hull.body, draft=-1.0)


@pytest.fixture(scope="module")
def hull():
    return Sample("container_ship")


def test_given_length_and_surface_are_the_friction_s(hull):
    where = {"draft": hull.ship.draft, "tolerance": 1e-2}
    (row,) = hn.michell_table(
        hull.body, [9.0], length=300.0, wetted_surface=2e4, form_factor=1.1, **where
    )
    (own,) = hn.michell_table(hull.body, [9.0], **where)
    line = hn.ittc_1957(9.0 * 300.0 / hn.SEA_WATER_VISCOSITY)
    assert row["friction_kN"] == pytest.approx(0.5 * 1.025 * 81.0 * 2e4 * line, rel=1e-12)
    assert (row["wave_kN"], row["froude"]) == (own["wave_kN"], own["froude"])
    for name in ("length", "wetted_surface"):
        with pytest.raises(ValueError, match=f"friction's {name} must be above zero"):
            hn.michell_table(hull.body, [9.0], **{name: 0.0}, **where)


def test_a_speed_without_a_number_leaves_its_row_empty(hull):
    """Just beyond the integral's Froude numbers, which it refuses itself, and just within."""
    where = {"draft": hull.ship.draft, "tolerance": 1e-2}
    integral = hn.MichellIntegral(hull.body, **where)
    unit = math.sqrt(hn.GRAVITY * integral.length)
    inside = [0.05000001 * unit, 9.0, 4.9999999 * unit]
    beyond = [0.04999999 * unit, 5.0000001 * unit]
    for speed in beyond:
        with pytest.raises(ValueError, match="no speed for Michell"):
            integral.resistance([speed])
    rows = hn.michell_table(hull.body, [beyond[0], *inside, beyond[1]], **where)
    assert [row["speed_m_s"] for row in rows] == [beyond[0], *inside, beyond[1]]
    assert rows[1:-1] == hn.michell_table(hull.body, inside, **where)
    for row, said in ((rows[0], "0.05 is outside 0.05 to 5"), (rows[-1], "5 is outside 0.05 to 5")):
        assert all(math.isnan(row[f"{name}_kN"]) for name in NUMBERS)
        assert math.isnan(row["effective_power_kW"]) and row["froude"] > 0.0
        assert row["outside"].startswith(f"Froude number of Michell's integral {said}; Froude")
    read = list(csv.DictReader(io.StringIO(hn.resistance_csv(rows))))
    assert read[0]["total_kN"] == "" and float(read[1]["total_kN"]) > 0.0
    plot = hn.resistance_plot(rows, others=[("again", rows)])
    assert isinstance(plot, hn.Plot) and "again" in plot.curve_names
    with pytest.raises(ValueError, match="is outside 0.05 to 5"):
        hn.michell_table(hull.body, beyond, **where)
    with pytest.raises(ValueError, match="no speeds"):
        hn.michell_table(hull.body, [], **where)
    with pytest.raises(ValueError, match="needs a row"):
        hn.resistance_plot(rows[:1])


def test_a_reynolds_number_without_a_friction_leaves_its_row_empty(hull):
    speeds = {"speeds": [6.0, 9.0], "draft": hull.ship.draft, "tolerance": 1e-2}
    slow, fast = hn.michell_table(hull.body, viscosity=3.0, **speeds)
    assert slow["outside"].startswith("Reynolds number of the ITTC line 712 is not above 1000")
    assert math.isnan(slow["total_kN"]) and fast["total_kN"] > fast["wave_kN"] > 0.0
    assert "Reynolds number 1.07e+03 is below 1e+06" in fast["outside"]


@pytest.mark.parametrize("speed", [0.0, -1.0, math.nan, math.inf])
def test_what_is_no_speed_is_refused(hull, speed):
    with pytest.raises(ValueError, match="speed must be a number above zero"):
        hn.michell_table(hull.body, [9.0, speed], draft=hull.ship.draft)
