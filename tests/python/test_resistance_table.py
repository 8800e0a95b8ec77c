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


def test_holtrop_table_and_text(hull):
    propeller = hn.Propeller(5.0)
    draft = hull.ship.draft
    given = {"appendages": ((40.0, 1.5),)}
    rows = hn.holtrop_table(hull.body, SPEEDS, draft=draft, given=given, propeller=propeller)
    ship = hn.holtrop_ship(hull.body, draft=draft, **given)
    for row, result in zip(rows, hn.holtrop(ship, SPEEDS, propeller=propeller)):
        assert row["total_kN"] == result.total and row["wake_fraction"] == result.propulsion["w"]
    read = list(csv.DictReader(io.StringIO(hn.resistance_csv(rows))))
    assert list(read[0]) == list(rows[0])
    for line, row in zip(read, rows):
        for name, value in row.items():
            if isinstance(value, float):
                assert float(line[name]) == pytest.approx(value, rel=1e-5)
    with pytest.raises(ValueError, match="no speeds"):
        hn.resistance_csv([])


def test_plot(hull):
    draft = hull.ship.draft
    rows = hn.holtrop_table(hull.body, SPEEDS, draft=draft)
    plot = hn.resistance_plot(rows, others=[("slower", rows[:1])])
    assert isinstance(plot, hn.Plot)
    with pytest.raises(ValueError, match="needs a row"):
        hn.resistance_plot([])
