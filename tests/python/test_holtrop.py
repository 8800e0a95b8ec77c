# SPDX-License-Identifier: GPL-3.0-or-later
"""Holtrop and Mennen's method against the worked examples of both papers, and from exact hulls."""

import dataclasses
import math

import hull_native as hn
import numpy as np
import pytest
from test_holtrop_example import KNOT
from test_holtrop_example import SHIP as SHIP_1982
from test_holtrop_example import example
from transformation_hulls import SAMPLES, Sample

# Holtrop (1984): 50 m, twin screws.
SHIP_1984 = hn.HoltropShip(
    length=50.0,
    beam=12.0,
    draft_forward=3.1,
    draft_aft=3.3,
    displaced_volume=900.0,
    lcb_percent=-4.5,
    midship=0.78,
    waterplane=0.8,
    wetted_surface=584.9,
    entrance_angle_deg=25.0,
    transom_area=10.0,
    appendages=((50.0, 3.0),),
)


def test_resistance_of_1982():
    """Without the roundings by which the paper goes on; with them test_holtrop_example."""
    result = example()
    assert result.froude == pytest.approx(0.2868, abs=0.00005)
    for name, printed, digits in (
        ("friction", 869.63, 0.02),
        ("appendages", 8.83, 0.01),
        ("wave", 557.11, 0.35),
        ("bulb", 0.049, 0.0005),
        ("transom", 0.00, 0.005),
        ("correlation", 221.98, 0.1),
        ("total", 1793.26, 0.3),
    ):
        assert getattr(result, name) == pytest.approx(printed, rel=0.0, abs=digits), name
    assert result.effective_power == pytest.approx(23063.0, abs=4.0)
    for name, printed in (("w", 0.2584), ("t", 0.1747), ("etaR", 0.9931)):
        assert result.propulsion[name] == pytest.approx(printed, abs=0.00007), name


# As printed, by what half a unit of the last digit is; kN at 25 to 35 knots.
COEFFICIENTS_1984 = {
    "1+k1": (1.297, 0.0005), "CA": (0.00064, 0.000005), "c17": (1.4133, 0.00005),
    "m3": (-2.0298, 0.00005), "c5": (0.7329, 0.00005),
}  # fmt: skip
PRINTED_1984 = {
    "wave": (475, 512, 539, 564, 590, 618),
    "appendages": (21, 24, 28, 31, 35, 39),
    "transom": (25, 16, 2, 0, 0, 0),
    "total": (662, 715, 756, 807, 864, 925),
}


def example_1984(readings=None):
    speeds = [knots * KNOT for knots in (25, 27, 29, 31, 33, 35)]
    return hn.holtrop(SHIP_1984, speeds, gravity=9.81, readings=readings)


@pytest.mark.parametrize("name", COEFFICIENTS_1984)
def test_coefficients_of_1984(name):
    value, half = COEFFICIENTS_1984[name]
    assert example_1984()[0].coefficients[name] == pytest.approx(value, abs=half)


@pytest.mark.parametrize("name", PRINTED_1984)
def test_resistance_of_1984(name):
    """To the kN, as printed: the rounding of the printed coefficients moves what is beyond half a
    kN as far, and of the transom's that of c6 to three decimals."""
    found = np.array([getattr(result, name) for result in example_1984()])
    reach = np.zeros(len(found))
    for each, (value, half) in COEFFICIENTS_1984.items():
        ends = [
            [getattr(result, name) for result in example_1984({each: value + side})]
            for side in (-half, half)
        ]
        reach += 0.5 * np.abs(np.subtract(*ends))
    if name == "transom":
        rounded = [
            getattr(example_1984({"c6": round(result.coefficients["c6"], 3)})[i], name)
            for i, result in enumerate(example_1984())
        ]
        reach += np.abs(found - rounded)
    beyond = np.abs(found - PRINTED_1984[name])
    assert (beyond <= 0.5 + reach).all() and (beyond <= 0.6).all()
    assert (beyond > 0.5).sum() <= 1


def test_wave_resistance_is_continuous():
    """Between the formulas for slow and fast ships it is interpolated."""
    for froude in (0.4, 0.55):
        middle = froude * math.sqrt(hn.GRAVITY * SHIP_1984.length)
        before, after = hn.holtrop(SHIP_1984, [middle * (1 - 1e-9), middle * (1 + 1e-9)])
        assert after.wave == pytest.approx(before.wave, rel=1e-6)


def test_roughness_and_thruster():
    speed = [12.0]
    smooth, rough = (hn.holtrop(SHIP_1982, speed, roughness=ks)[0] for ks in (150e-6, 300e-6))
    added = (0.105 * 300e-6 ** (1 / 3) - 0.005579) / 205.0 ** (1 / 3)
    assert rough.coefficients["CA"] - smooth.coefficients["CA"] == pytest.approx(added)
    with_thruster = dataclasses.replace(SHIP_1982, thruster_diameter=2.0)
    added = hn.holtrop(with_thruster, speed)[0].appendages - smooth.appendages
    assert added == pytest.approx(hn.SEA_WATER_DENSITY * 12.0**2 * math.pi * 4.0 * 0.005)


def test_propellers():
    c = hn.holtrop(SHIP_1984, [12.0], propeller=hn.Propeller(2.0, screws=2))[0]
    cb, ratio = 900.0 / (50.0 * 12.0 * 3.2), 2.0 / math.sqrt(12.0 * 3.2)
    assert c.propulsion["t"] == pytest.approx(0.325 * cb - 0.1885 * ratio)
    wake = 0.3095 * cb + 10.0 * c.coefficients["CV"] * cb - 0.23 * ratio
    assert c.propulsion["w"] == pytest.approx(wake)
    propeller = hn.Propeller(2.0, open_stern=True, open_water_efficiency=0.6)
    result = hn.holtrop(SHIP_1984, [12.0], propeller=propeller)[0]
    efficiency = 0.6 * 0.98 * result.propulsion["etaH"]
    assert result.delivered_power == pytest.approx(result.effective_power / efficiency)
    assert result.shaft_power == result.delivered_power
    geared = dataclasses.replace(propeller, shaft_efficiency=0.97)
    result = hn.holtrop(SHIP_1984, [12.0], propeller=geared)[0]
    assert 0.97 * result.shaft_power == pytest.approx(result.delivered_power, rel=1e-14)
    assert (c.delivered_power, c.shaft_power) == (0.0, 0.0)


def test_outside_is_told_by_name():
    assert hn.holtrop(SHIP_1982, [10.0])[0].outside == ()
    broad = dataclasses.replace(SHIP_1982, beam=60.0, prismatic=0.5)
    told = " ".join(hn.holtrop(broad, [50.0])[0].outside)
    for name in ("prismatic coefficient", "length to beam", "beam to draft", "Froude number"):
        assert name in told


@pytest.mark.parametrize("name", SAMPLES)
def test_hulls_beside_one_another_are_told(name):
    hull = Sample(name)
    ship = hn.holtrop_ship(hull.body, draft=hull.ship.draft)
    assert ship.side_by_side == (name == "catamaran")
    told = [text for text in hn.holtrop(ship, [5.0])[0].outside if "beside one another" in text]
    assert len(told) == int(ship.side_by_side)
    assert not hn.holtrop_ship(hull.body, draft=hull.ship.draft, side_by_side=False).side_by_side


def test_from_the_exact_hull():
    hull = Sample("container_ship")
    draft = hull.ship.draft
    ship = hn.holtrop_ship(hull.body, draft=draft)
    water = hn.hydrostatics(hull.body, draft=draft)
    assert ship.wetted_surface == water.wetted_surface
    assert ship.completed().prismatic == pytest.approx(
        water.displaced_volume / (water.largest_section.area * water.waterline_length)
    )
    estimated = dataclasses.replace(ship, wetted_surface=None).completed()
    assert estimated.wetted_surface == pytest.approx(ship.wetted_surface, rel=0.05)
    given = hn.holtrop_ship(hull.body, draft=draft, bulb_area=0.0, wetted_surface=3000.0)
    assert (given.bulb_area, given.wetted_surface) == (0.0, 3000.0)
    assert 0.0 < hn.holtrop(ship, [8.0])[0].total < hn.holtrop(ship, [10.0])[0].total


@pytest.mark.parametrize(
    "change, said",
    [
        ({"beam": 0.0}, "beam must be above zero"),
        ({"draft_aft": math.nan}, "draft_aft must be a finite number"),
        ({"transom_area": -1.0}, "transom_area must not be negative"),
        ({"prismatic": 0.96}, "prismatic between"),
        ({"entrance_angle_deg": 90.0}, "half angle of entrance"),
        ({"lcb_percent": 20.0}, "too near an end"),
        ({"appendages": ((1.0, -2.0),)}, "appendage"),
        ({"bulb_height": 12.0}, "need the bulb in the water"),
    ],
)
def test_bad_ships(change, said):
    with pytest.raises(ValueError, match=said):
        hn.holtrop(dataclasses.replace(SHIP_1982, **change), [10.0])


def test_bad_speeds_and_waters():
    for speed in (0.0, -1.0, math.nan):
        with pytest.raises(ValueError, match="The speed must be a number above zero"):
            hn.holtrop(SHIP_1982, [speed])
    with pytest.raises(ValueError, match="edition"):
        hn.holtrop(SHIP_1982, [5.0], edition=1978)
    with pytest.raises(ValueError, match="viscosity"):
        hn.holtrop(SHIP_1982, [5.0], viscosity=0.0)
    for how in ({"diameter": 0.0}, {"diameter": 2.0, "screws": 3}):
        with pytest.raises(ValueError):
            hn.Propeller(**how)
    for efficiency in (0.0, 1.1, math.nan):
        with pytest.raises(ValueError, match="shaft efficiency must be above 0 and at most 1"):
            hn.Propeller(2.0, shaft_efficiency=efficiency)
    hull = Sample("container_ship")
    with pytest.raises(ValueError, match="out of the water"):
        hn.holtrop_ship(hull.body, draft=-1.0)
    with pytest.raises(ValueError, match="no field of HoltropShip"):
        hn.holtrop_ship(hull.body, draft=hull.ship.draft, breadth=3.0)


SHALLOW = {"draft_forward": 0.1, "draft_aft": 0.1, "displaced_volume": 28.0, "transom_area": 0.0}


@pytest.mark.parametrize(
    "changes, words",
    [
        ({"waterplane": 1.0, "entrance_angle_deg": None}, "give entrance_angle_deg"),
        ({"transom_area": 1e3}, "transom_area below"),
        (SHALLOW, "for a length of 500 drafts: check the drafts"),
    ],
)
def test_forms_at_which_a_formula_has_no_value_are_refused(changes, words):
    with pytest.raises(ValueError, match=words):
        hn.holtrop(dataclasses.replace(SHIP_1984, **changes), [0.3, 10.0])


def test_a_hull_whose_water_lies_at_its_zero_is_refused():
    """Drafts are to z = 0, which is not its keel."""
    hull = Sample("coaster")
    points = hull.surface.mesh.points - (0.0, 0.0, 3.0)
    hull.surface.set_points(points)
    body = hn.HullBody(hull.surface, mirrored=True)
    with pytest.raises(ValueError, match="move the hull onto its base line"):
        hn.holtrop_ship(body, draft=0.0)
