# SPDX-License-Identifier: GPL-3.0-or-later
"""Savitsky's method against the worked example of his paper (1964, Table 1)."""

import math

import hull_native as hn
import numpy as np
import pytest

FOOT, POUND = 0.3048, 0.45359237e-3  # m, t
POUND_FORCE = hn.GRAVITY * POUND  # kN
SPEED = 67.5 * FOOT
BOAT = hn.PlaningBoat(
    mass_t=60000.0 * POUND,
    beam=14.0 * FOOT,
    deadrise_deg=10.0,
    lcg=29.0 * FOOT,
    vcg=2.0 * FOOT,
    thrust_angle_deg=4.0,
    thrust_arm=0.5 * FOOT,
)
# As the table's own numbers have them: ρ/2 = 0.97 slug/ft³, Rn of Vm, λ and b.
WATER = {"water_density": 1.94 * 515.378818e-3, "viscosity": 1e-5 * FOOT**2}

# τ, then as printed: λ, Vm, CF with the allowance, Df, D, c. Most of it the paper reads off its
# charts, and Df has ρ = 2.0: λ within 1.5 % (4° is off its own formula by 5 %), Df and D by that.
TABLE = [
    (2.0, 3.85, 67.0, 0.00214, 7340.0, 9434.0, -2.6),
    (3.0, 2.60, 66.6, 0.00224, 5160.0, 8304.0, 5.5),
    (4.0, 1.86, 66.2, 0.00232, 3760.0, 7948.0, 10.8),
]


def test_table_of_the_paper():
    found = hn.planing_at_trims(BOAT, SPEED, [row[0] for row in TABLE], **WATER)
    for (result, _), (trim, ratio, speed, friction, df, total, arm) in zip(found, TABLE):
        loose = 0.05 if trim == 4.0 else 0.015
        assert result.speed_coefficient == pytest.approx(3.18, abs=0.005)
        assert result.lift_coefficient == pytest.approx(0.069, abs=0.0005)
        assert result.flat_lift_coefficient == pytest.approx(0.085, abs=0.0015)
        assert result.wetted_length_ratio == pytest.approx(ratio, rel=loose)
        assert result.bottom_speed / FOOT == pytest.approx(speed, abs=0.25)
        assert result.friction_coefficient == pytest.approx(friction, abs=0.000015)
        assert result.friction / POUND_FORCE == pytest.approx(df * 1.94 / 2.0, rel=loose + 0.01)
        assert result.total / POUND_FORCE == pytest.approx(total, rel=0.03)
        assert result.pressure_arm / FOOT == pytest.approx(arm, abs=0.9)
    assert found[0][1] < 0.0 < found[1][1] < found[2][1]


# ρ of the table's Df; half units of the last digits of λ, Vm, CF and c, in the table's units.
DENSE = {**WATER, "water_density": 2.0 * 515.378818e-3}
HALVES = (0.005, 0.05, 5e-6, 0.05)


def by_readings(trim, ratio, speed, friction, arm):
    """(PlaningResult, moment in lb ft) at λ, Vm, CF and c as they are given."""
    reading = {
        "wetted_length_ratio": ratio,
        "bottom_speed": speed * FOOT,
        "pressure_place": (29.0 - arm) / (ratio * 14.0),
    }
    how = {**DENSE, "readings": [reading]}
    ((plain, _),) = hn.planing_at_trims(BOAT, SPEED, [trim], **how)
    allowance = 0.0004 + friction - plain.friction_coefficient
    ((result, moment),) = hn.planing_at_trims(
        BOAT, SPEED, [trim], roughness_allowance=allowance, **how
    )
    assert result.friction_coefficient == pytest.approx(friction, rel=1e-12)
    return result, moment / (POUND_FORCE * FOOT)


def with_reach(trim, given, value):
    """(value by_readings(), how far the rounding of what is given moves it)."""
    middle, reach = value(*by_readings(trim, *given)), 0.0
    for i, half in enumerate(HALVES):
        ends = [
            value(*by_readings(trim, *given[:i], given[i] + side, *given[i + 1 :]))
            for side in (-half, half)
        ]
        reach += max(abs(end - middle) for end in ends)
    return middle, reach


@pytest.mark.parametrize("row", TABLE, ids=lambda row: f"{row[0]:.0f}")
def test_each_item_of_the_table_follows_from_those_above_it(row):
    """Within half a unit of its last digit, and what the rounding of λ, Vm, CF and c leaves open
    where these have fewer digits. Its Df has ρ = 2.0 slug/ft³; its D takes cos τ for 1 and, for
    tan τ, the angle with four digits."""
    trim, ratio, speed, friction, df, total, arm = row
    reading = {"wetted_length_ratio": ratio, "bottom_speed": speed * FOOT}
    ((result, _),) = hn.planing_at_trims(BOAT, SPEED, [trim], readings=[reading], **WATER)
    assert result.friction_coefficient == pytest.approx(friction, abs=5e-6 + 1e-6)
    # The chart of the centre of pressure is read to less than a hundredth of the wetted length.
    apart = (result.pressure_arm / FOOT - arm) / (ratio * 14.0)
    assert abs(apart) < 0.0065
    given = (ratio, speed, friction, arm)
    found, reach = with_reach(trim, given, lambda result, _: result.friction / POUND_FORCE)
    assert found == pytest.approx(df, abs=5.0 + reach)
    assert reach < 0.01 * df
    result, _ = by_readings(trim, *given)
    angle = math.radians(trim)
    assert 60000.0 * round(angle, 4) + df == pytest.approx(total, abs=0.5)
    assert result.pressure / POUND_FORCE == pytest.approx(60000.0 * math.tan(angle), rel=1e-12)
    level = math.cos(angle)
    assert result.total == pytest.approx(result.pressure + result.friction / level, rel=1e-14)


def test_equilibrium_follows_from_the_table():
    """The moment is none at 2.3°, whatever the rounding; there the printed drags have 9,095 lb
    between them, and these by the readings that within theirs."""
    trims = [row[0] for row in TABLE[:2]]
    moments = [
        with_reach(row[0], (*row[1:4], row[6]), lambda _, moment: moment) for row in TABLE[:2]
    ]
    for side in (-1.0, 0.0, 1.0):
        at = np.interp(0.0, [moment + side * reach for moment, reach in moments], trims)
        assert round(float(at), 1) == 2.3
    drag = np.interp(2.3, trims, [row[5] for row in TABLE[:2]])
    assert drag == pytest.approx(9095.0, abs=0.5)
    own = [
        with_reach(
            row[0], (*row[1:4], row[6]), lambda r, _: (r.pressure + r.friction) / POUND_FORCE
        )
        for row in TABLE[:2]
    ]
    drag, reach = (float(np.interp(2.3, trims, column)) for column in zip(*own))
    assert drag == pytest.approx(9095.0, abs=0.5 + reach)
    assert reach < 0.005 * drag


def test_effective_power_is_that_of_the_drag():
    """EHP = D V / 550 of the paper's D and V: 1,116 horsepower."""
    horsepower = 550.0 * FOOT * POUND_FORCE
    assert round(9095.0 * 67.5 / 550.0) == 1116
    result = hn.savitsky(BOAT, [SPEED], **WATER)[0]
    drag = result.total / POUND_FORCE
    assert result.effective_power / horsepower == pytest.approx(drag * 67.5 / 550.0, rel=1e-13)
    assert result.effective_power / horsepower == pytest.approx(1116.2, rel=0.03)


def test_equilibrium_of_the_paper():
    result = hn.savitsky(BOAT, [SPEED], **WATER)[0]
    assert result.trim_deg == pytest.approx(2.3, abs=0.05)
    assert result.total / POUND_FORCE == pytest.approx(9095.0, rel=0.03)
    assert result.keel_draft / FOOT == pytest.approx(2.24, abs=0.06)
    assert result.outside == ()
    moment = hn.planing_at_trims(BOAT, SPEED, [result.trim_deg], **WATER)[0][1]
    assert abs(moment) < 1e-9 * BOAT.mass_t * hn.GRAVITY * BOAT.lcg
