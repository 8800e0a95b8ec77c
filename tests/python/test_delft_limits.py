# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever is outside of the Delft series' models is told by its name."""

import math

import hull_native as hn
import pytest

# The series' limits, by the names that are told: the lower and the upper one.
LIMITS = {
    "Froude number": (0.1, 0.6),
    "length to beam": (2.73, 5.0),
    "beam to draft": (2.46, 19.38),
    "length to volume^(1/3)": (4.34, 8.5),
    "LCB in % of the length": (-8.2, 0.0),
    "LCF in % of the length": (-9.5, -1.8),
    "prismatic coefficient": (0.52, 0.60),
    "midship coefficient": (0.645, 0.78),
    "waterplane to volume^(2/3)": (3.78, 12.67),
    "Froude number heeled": (0.25, 0.55),
}


def told_at(name, value):
    """What is told of a yacht in the middle of all limits, but for one."""
    at = {each: 0.5 * (low + high) for each, (low, high) in LIMITS.items()} | {name: value}
    length, volume = 10.0, (10.0 / at["length to volume^(1/3)"]) ** 3
    beam = length / at["length to beam"]
    yacht = hn.DelftYacht(
        length=length,
        beam=beam,
        draft=beam / at["beam to draft"],
        volume=volume,
        waterplane_area=at["waterplane to volume^(2/3)"] * volume ** (2.0 / 3.0),
        wetted_surface=25.0,
        prismatic=at["prismatic coefficient"],
        midship=at["midship coefficient"],
        lcb=0.01 * length * (50.0 - at["LCB in % of the length"]),
        lcf=0.01 * length * (50.0 - at["LCF in % of the length"]),
    )
    is_heeled = name == "Froude number heeled"
    froude = at[name] if is_heeled else at["Froude number"]
    heel = 10.0 if is_heeled else 0.0
    return hn.delft(yacht, [froude * math.sqrt(hn.GRAVITY * length)], heel_deg=heel)[0].outside


@pytest.mark.parametrize("end", [0, 1], ids=["lower", "upper"])
@pytest.mark.parametrize("name", LIMITS)
def test_each_limit_is_told_by_its_name(name, end):
    """A thousandth of the range within nothing is told, as much beyond it that one alone."""
    low, high = LIMITS[name]
    limit, step = (low, high)[end], 1e-3 * (high - low) * (-1.0, 1.0)[end]
    assert told_at(name, limit - step) == ()
    (said,) = told_at(name, limit + step)
    assert said == f"{name} {limit + step:.3g} is outside {low} to {high}"


def test_no_limit_is_without_a_test():
    nothing = hn.DelftYacht(*(1.0, 20.0, 20.0, 1e5, 1e-3, 1.0, 0.1, 0.1, 0.99, 0.99))
    (found,) = hn.delft(nothing, [100.0], heel_deg=10.0)
    assert [text.partition(" is ")[0].rpartition(" ")[0] for text in found.outside] == list(LIMITS)
