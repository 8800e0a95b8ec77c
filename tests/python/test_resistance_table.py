# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of resistance over speeds, and their text."""

import csv
import io

import hull_native as hn
import pytest
from transformation_hulls import Sample

SPEEDS = [6.0, 9.0]


@pytest.fixture(scope="module")
def hull():
    return Sample("container_ship")


def test_michell_table(hull):
    draft = hull.ship.draft
    rows = hn.michell_table(hull.body, SPEEDS, draft=draft, form_factor=1.2, tolerance=1e-2)
    water = hn.hydrostatics(hull.body, draft=draft)
    for row, speed in zip(rows, SPEEDS):
        line = hn.ittc_1957(speed * water.waterline_length / hn.SEA_WATER_VISCOSITY)
        friction = 0.5 * hn.SEA_WATER_DENSITY * speed**2 * water.wetted_surface * line
        assert row["friction_kN"] == pytest.approx(friction)
        assert row["form_kN"] == pytest.approx(0.2 * friction)
        assert row["total_kN"] == pytest.approx(1.2 * friction + row["wave_kN"])
        assert row["effective_power_kW"] == pytest.approx(row["total_kN"] * speed)
    with pytest.raises(ValueError, match="form factor"):
        hn.michell_table(hull.body, SPEEDS, draft=draft, form_factor=-1.0)


def test_viscosity_goes_with_the_density():
    """Fresh and sea water of 15 °C by the ITTC's tables, and evenly between."""
    assert hn.water_viscosity(hn.SEA_WATER_DENSITY) == hn.SEA_WATER_VISCOSITY == 1.18831e-6
    assert hn.water_viscosity(1.0) == hn.FRESH_WATER_VISCOSITY == 1.13902e-6
    assert hn.water_viscosity(0.9991) == 1.13902e-6 and hn.water_viscosity(1.03) == 1.18831e-6
    half = 0.5 * (1.13902e-6 + 1.18831e-6)
    assert hn.water_viscosity(1.0125) == pytest.approx(half, rel=1e-12)


@pytest.mark.parametrize("density", [1.0, 1.005, 1.025])
def test_all_methods_take_the_viscosity_of_the_density(hull, density):
    """Without a viscosity each gives what it gives with that of the density, and friction is that
    of its line at the Reynolds number of that water."""
    draft, wet = hull.ship.draft, {"water_density": density}
    known = {**wet, "viscosity": 1.13902e-6 + (density - 1.0) / 0.025 * (1.18831e-6 - 1.13902e-6)}
    waves = {"draft": draft, "tolerance": 1e-2}
    yacht = hn.DelftYacht(10.0, 3.0, 0.5, 7.5, 21.0, 25.0, 0.56, 0.75, 5.3, 5.5)
    boat = hn.PlaningBoat(27.2, 4.27, 10.0, 8.84, 1.0)
    methods = (
        lambda water: hn.michell_table(hull.body, SPEEDS, **waves, **water),
        lambda water: hn.holtrop_table(hull.body, SPEEDS, draft=draft, **water),
        lambda water: hn.delft_table(yacht, [3.0], **water),
        lambda water: hn.savitsky_table(boat, [20.0], **water),
    )
    for method in methods:
        ours, theirs = method(wet), method(known)
        other = method({**wet, "viscosity": 1.18831e-6})
        for row, wanted, sea in zip(ours, theirs, other):
            for name in ("friction_kN", "total_kN"):
                assert row[name] == pytest.approx(wanted[name], rel=1e-12)
                assert (row[name] == sea[name]) == (density == 1.025)
    length = hn.hydrostatics(hull.body, draft=draft).waterline_length
    line, sea = (
        hn.ittc_1957(SPEEDS[0] * length / viscosity)
        for viscosity in (known["viscosity"], hn.SEA_WATER_VISCOSITY)
    )
    fresh_row, sea_row = (
        hn.michell_table(hull.body, SPEEDS[:1], **waves, **water)[0] for water in (wet, {})
    )
    ratio = fresh_row["friction_kN"] / sea_row["friction_kN"]
    assert ratio == pytest.approx(density / 1.025 * line / sea, rel=1e-9)


def test_holtrop_table_and_text(hull):
    propeller = hn.Propeller(5.0)
    draft = hull.ship.draft
    given = {"appendages": ((40.0, 1.5),)}
    rows = hn.holtrop_table(hull.body, SPEEDS, draft=draft, given=given, propeller=propeller)
    ship = hn.holtrop_ship(hull.body, draft=draft, **given)
    for row, result in zip(rows, hn.holtrop(ship, SPEEDS, propeller=propeller)):
        assert row["total_kN"] == result.total and row["wake_fraction"] == result.propulsion["w"]
    assert "delivered_power_kW" not in rows[0]
    read = list(csv.DictReader(io.StringIO(hn.resistance_csv(rows))))
    assert list(read[0]) == list(rows[0])
    for line, row in zip(read, rows):
        for name, value in row.items():
            if isinstance(value, float):
                assert float(line[name]) == pytest.approx(value, rel=1e-5)
    with pytest.raises(ValueError, match="no speeds"):
        hn.resistance_csv([])


def test_rows_of_a_given_ship_have_the_power(hull):
    propeller = hn.Propeller(5.0, open_water_efficiency=0.6, shaft_efficiency=0.98)
    draft = hull.ship.draft
    rows = hn.holtrop_rows(hn.holtrop_ship(hull.body, draft=draft), SPEEDS, propeller=propeller)
    assert rows == hn.holtrop_table(hull.body, SPEEDS, draft=draft, propeller=propeller)
    for row in rows:
        efficiency = row["hull_efficiency"] * row["rotative_efficiency"] * 0.6
        assert row["delivered_power_kW"] * efficiency == pytest.approx(row["effective_power_kW"])
        assert row["shaft_power_kW"] * 0.98 == pytest.approx(row["delivered_power_kW"])


def test_plot(hull):
    draft = hull.ship.draft
    rows = hn.holtrop_table(hull.body, SPEEDS, draft=draft)
    plot = hn.resistance_plot(rows, others=[("slower", rows[:1])])
    assert isinstance(plot, hn.Plot)
    with pytest.raises(ValueError, match="needs a row"):
        hn.resistance_plot([])


def test_froude_numbers_are_by_the_gravity_that_is_given(hull):
    draft, length = hull.ship.draft, hn.holtrop_ship(hull.body, draft=hull.ship.draft).length
    yacht = hn.delft_yacht(hull.body, draft=draft)
    for gravity in (9.78, hn.GRAVITY):
        rows = hn.holtrop_table(hull.body, SPEEDS, draft=draft, gravity=gravity)
        rows += hn.delft_table(yacht, SPEEDS, gravity=gravity)
        for row in rows:
            assert row["froude"] == row["speed_m_s"] / (gravity * length) ** 0.5
