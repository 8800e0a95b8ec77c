# SPDX-License-Identifier: GPL-3.0-or-later
"""The worked example of Holtrop & Mennen (1982), section 5: 205 m, 25 knots, item by item to the
digits printed there."""

import math
from decimal import Decimal

import hull_native as hn
import pytest

KNOT = 1852.0 / 3600.0
SPEED = 25.0 * KNOT
SHIP = hn.HoltropShip(
    length=205.0,
    beam=32.0,
    draft_forward=10.0,
    draft_aft=10.0,
    displaced_volume=37500.0,
    lcb_percent=-0.75,
    midship=0.98,
    waterplane=0.75,
    bulb_area=20.0,
    bulb_height=4.0,
    transom_area=16.0,
    appendages=((50.0, 1.5),),
    stern_coefficient=10.0,
)
WATER = {"gravity": 9.81, "water_density": 1.025}

# As printed, in such an order that each follows from those above it.
COEFFICIENTS = {
    "Fn": "0.2868", "CP": "0.5833", "LR": "81.385", "c12": "0.5102", "c13": "1.030",
    "1+k1": "1.156", "S": "7381.45", "CF": "0.001390", "c7": "0.1561", "iE": "12.08",
    "c1": "1.398", "c3": "0.02119", "c2": "0.7595", "c5": "0.9592", "m1": "-2.1274",
    "c15": "-1.69385", "m2": "-0.17087", "lambda": "0.6513", "PB": "0.6261", "Fni": "1.5084",
    "FnT": "5.433", "c4": "0.04", "CA": "0.000352", "CV": "0.001963", "c9": "14.500",
    "c11": "1.250", "CP1": "0.5477",
}  # fmt: skip
PARTS = {
    "friction": "869.63", "appendages": "8.83", "wave": "557.11", "bulb": "0.049",
    "transom": "0.00", "correlation": "221.98",
}  # fmt: skip
TOTAL, EFFECTIVE_POWER = "1793.26", "23063"
PROPULSION = {"w": "0.2584", "t": "0.1747", "etaR": "0.9931"}
# The speed that these are of is not 25 knots to their last digit, but is Fn = 0.2868 to its own.
OF_THE_SPEED = ("Fni", "FnT")
# What each part is made of among the coefficients.
MADE_OF = {
    "friction": ("S", "CF"),
    "appendages": ("CF",),
    "wave": ("c1", "c2", "c5", "m1", "m2", "lambda", "Fn"),
    "bulb": ("PB", "Fni"),
    "transom": ("FnT",),
    "correlation": ("S", "CA"),
}


def half_unit(printed):
    """Of the last digit."""
    return 0.5 * 10.0 ** Decimal(printed).as_tuple().exponent


def as_printed(*names):
    return {name: float(COEFFICIENTS[name]) for name in names}


def example(readings=None, speed=SPEED):
    propeller = hn.Propeller(8.0, area_ratio=0.7393)
    how = {"edition": 1982, "propeller": propeller, "readings": readings}
    return hn.holtrop(SHIP, [speed], **WATER, **how)[0]


def rounds_to(value, printed, loose=0.0):
    return abs(value - float(printed)) <= half_unit(printed) * (1.0 + 1e-9) + loose


@pytest.mark.parametrize("name", [name for name in COEFFICIENTS if name not in OF_THE_SPEED])
def test_coefficients_are_as_printed(name):
    """Of the ship's particulars alone: no rounding on the way."""
    assert rounds_to(example().coefficients[name], COEFFICIENTS[name])


@pytest.mark.parametrize("name", OF_THE_SPEED)
def test_coefficients_of_the_speed_are_as_printed(name):
    """Between the speeds of 0.28675 and 0.28685 each grows through what is printed."""
    root = math.sqrt(WATER["gravity"] * SHIP.length)
    froude, half = float(COEFFICIENTS["Fn"]), half_unit(COEFFICIENTS["Fn"])
    low, high = (example(speed=(froude + side) * root).coefficients[name] for side in (-half, half))
    assert low < float(COEFFICIENTS[name]) < high
    assert high - low < 5e-4 * high


def spread(name):
    """(value by the printed coefficients, how far their rounding moves it)."""
    printed = as_printed(*MADE_OF[name])
    value, moved = getattr(example(printed), name), 0.0
    for each in printed:
        half = half_unit(COEFFICIENTS[each])
        ends = [
            getattr(example({**printed, each: printed[each] + side}), name)
            for side in (-half, half)
        ]
        moved += max(abs(end - value) for end in ends)
    return value, moved


@pytest.mark.parametrize("name", PARTS)
def test_parts_follow_from_the_printed_coefficients(name):
    """Printed with more digits than what they follow from: the two intervals meet, and the second
    is narrow."""
    value, moved = spread(name)
    assert rounds_to(value, PARTS[name], loose=moved)
    assert moved <= 2e-3 * value


def test_total_and_power_follow_from_the_printed_parts():
    """To the digit."""
    parts = {name: float(printed) for name, printed in PARTS.items()}
    form = (float(COEFFICIENTS["1+k1"]) - 1.0) * parts["friction"]
    assert rounds_to(sum(parts.values()) + form, TOTAL)
    assert rounds_to(float(TOTAL) * SPEED, EFFECTIVE_POWER)
    found = example()
    own = [getattr(found, name) for name in PARTS]
    assert found.total == pytest.approx(sum(own) + found.form, rel=1e-14)
    k1 = found.coefficients["1+k1"] - 1.0
    assert found.form == pytest.approx(k1 * found.friction, rel=1e-14)
    assert found.effective_power == pytest.approx(found.total * SPEED, rel=1e-14)
    assert found.total == pytest.approx(float(TOTAL), abs=0.3)


@pytest.mark.parametrize("name", PROPULSION)
def test_propulsion_is_as_printed(name):
    """By the printed CV, c9, c11 and CP1, and without them."""
    printed = as_printed("CV", "c9", "c11", "CP1")
    for readings in (printed, None):
        assert rounds_to(example(readings).propulsion[name], PROPULSION[name])


def results(edition, speeds, readings=None):
    propeller = hn.Propeller(8.0, area_ratio=0.7393)
    how = {"edition": edition, "propeller": propeller, "readings": readings}
    return hn.holtrop(SHIP, speeds, **WATER, **how)


def numbers(result):
    return result.total, *result.propulsion.values()


@pytest.mark.parametrize("edition", (1982, 1984))
def test_each_reading_counts(edition):
    """Whatever is told as a coefficient of the ship has its part in a number, at some speed."""
    root = math.sqrt(WATER["gravity"] * SHIP.length)
    speeds = [froude * root for froude in (0.1, 0.29, 0.45, 0.6)]
    plain, moved = results(edition, speeds), set()
    names = set().union(*(result.coefficients for result in plain))
    for name in names:
        value = next(r.coefficients[name] for r in plain if name in r.coefficients)
        read = results(edition, speeds, {name: 0.99 * value if value else 0.5})
        if any(numbers(one) != numbers(other) for one, other in zip(plain, read)):
            moved.add(name)
    assert moved == names


def test_readings_of_what_is_in_use_at_some_speeds_alone():
    root = math.sqrt(WATER["gravity"] * SHIP.length)
    speeds = [0.3 * root, 0.5 * root]
    slow, fast = results(1984, speeds, {"m3": -2.5})
    assert "m3" not in slow.coefficients and fast.coefficients["m3"] == -2.5
    assert slow.total == results(1984, speeds)[0].total
    assert fast.total != results(1984, speeds)[1].total
    with pytest.raises(ValueError, match="'m3' is no coefficient of this ship at these speeds"):
        results(1984, speeds[:1], {"m3": -2.5})
    assert results(1984, [], {"m3": -2.5}) == []


def test_readings_are_checked():
    with pytest.raises(ValueError, match="'c17' is no coefficient of this ship"):
        example({"c17": 1.0})
    with pytest.raises(ValueError, match="finite number; that of 'c1' is nan"):
        example({"c1": math.nan})


def test_a_reading_stands_in_place_of_the_formula():
    """The form factor of a model test."""
    plain, tested = example(), example({"1+k1": 1.2})
    assert tested.coefficients["1+k1"] == 1.2
    assert tested.form == pytest.approx(0.2 * plain.friction, rel=1e-12)
    assert (tested.friction, tested.wave) == (plain.friction, plain.wave)
