# SPDX-License-Identifier: GPL-3.0-or-later
"""Wake fraction, thrust deduction and relative rotative efficiency by Holtrop and Mennen (1982) and
Holtrop (1984)."""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Propeller:
    """diameter in m; area_ratio AE/AO; pitch_ratio P/D, for twin screws; screws 1 or 2; open_stern:
    a single screw behind shafts and brackets, as of fast ships. open_water_efficiency: 0 is
    unknown. shaft_efficiency: what gears and bearings leave of the engine's power."""

    diameter: float
    area_ratio: float = 0.6
    pitch_ratio: float = 1.0
    screws: int = 1
    open_stern: bool = False
    open_water_efficiency: float = 0.0
    shaft_efficiency: float = 1.0

    def __post_init__(self):
        for name in ("diameter", "area_ratio", "pitch_ratio"):
            value = getattr(self, name)
            if not (value > 0.0 and math.isfinite(value)):
                raise ValueError(f"A propeller's {name} must be above zero, not {value}.")
        if self.screws not in (1, 2):
            raise ValueError(f"A ship has 1 or 2 screws by Holtrop's method, not {self.screws}.")
        if not 0.0 <= self.open_water_efficiency < 1.0:
            raise ValueError(
                "The open water efficiency must be from 0 (unknown) to below 1, not "
                f"{self.open_water_efficiency}."
            )
        if not 0.0 < self.shaft_efficiency <= 1.0:
            raise ValueError(
                f"The shaft efficiency must be above 0 and at most 1, not {self.shaft_efficiency}."
            )


def propulsion_factors(ship, propeller, c, edition):
    """{"w", "t", "etaR", "etaH"} of a completed HoltropShip. `c`: coefficients at the speed, by the
    papers' names; CV, CP1 and c8 to c20 are added."""
    # Of hull and appendages, as 1 + k of Holtrop & Mennen (1978) has it: the example's CV does.
    wetted = c["S"] + ship.appendage_area
    added = (c["1+k2"] - c["1+k1"]) * ship.appendage_area / wetted
    c["CV"] = (c["1+k1"] + added) * c["CF"] + c["CA"]
    breadth = math.sqrt(ship.beam * ship.draft)
    forward = c["CP"] - 0.0225 * ship.lcb_percent
    if propeller.screws == 2:
        wake = 0.3095 * c["CB"] + 10.0 * c["CV"] * c["CB"] - 0.23 * propeller.diameter / breadth
        deduction = 0.325 * c["CB"] - 0.1885 * propeller.diameter / breadth
        rotative = 0.9737 + 0.111 * forward - 0.06325 * propeller.pitch_ratio
    elif propeller.open_stern:
        wake = 0.3 * c["CB"] + 10.0 * c["CV"] * c["CB"] - 0.1
        deduction, rotative = 0.10, 0.98
    else:
        _take_wake_coefficients(ship, propeller, c)
        wake = (_wake_1982 if edition == 1982 else _wake_1984)(ship, c)
        deduction = (_deduction_1982 if edition == 1982 else _deduction_1984)(ship, propeller, c)
        rotative = 0.9922 - 0.05908 * propeller.area_ratio + 0.07424 * forward
    if not wake < 1.0:
        raise ValueError(
            f"Holtrop's wake fraction is {wake:.3g} for this ship and a propeller of "
            f"{propeller.diameter:.4g} m: check its diameter and the draft aft."
        )
    hull = (1.0 - deduction) / (1.0 - wake)
    return {"w": wake, "t": deduction, "etaR": rotative, "etaH": hull}


def _take_wake_coefficients(ship, propeller, c):
    aft, diameter = ship.draft_aft, propeller.diameter
    broad = ship.beam / aft
    # Of hull and appendages: the paper's example has its c9 with both.
    c["c8"] = (c["S"] + ship.appendage_area) / (ship.length * diameter)
    c["c8"] *= broad if broad < 5.0 else (7.0 * broad - 25.0) / (broad - 3.0)
    c["c9"] = c["c8"] if c["c8"] < 28.0 else 32.0 - 16.0 / (c["c8"] - 24.0)
    deep = aft / diameter
    c["c11"] = deep if deep < 2.0 else 0.0833333 * deep**3 + 1.33333
    c["CP1"] = 1.45 * c["CP"] - 0.315 - 0.0225 * ship.lcb_percent
    if not c["CP1"] < 1.0:
        raise ValueError(
            f"Holtrop's wake has no value for a prismatic coefficient of {c['CP']:.3g} with "
            f"lcb_percent {ship.lcb_percent:.3g}."
        )


def _wake_1982(ship, c):
    viscous = c["c9"] * c["CV"] * ship.length / ship.draft_aft
    viscous *= 0.0661875 + 1.21756 * c["c11"] * c["CV"] / (1.0 - c["CP1"])
    potential = 0.24558 * math.sqrt(ship.beam / (ship.length * (1.0 - c["CP1"])))
    fullness = 0.11434 / (0.95 - c["CB"]) - 0.09726 / (0.95 - c["CP"])
    stern = ship.stern_coefficient * (0.75 * c["CV"] + 0.002)
    return viscous + potential + fullness + stern


def _wake_1984(ship, c):
    if c["CP"] < 0.7:
        c["c19"] = 0.12997 / (0.95 - c["CB"]) - 0.11056 / (0.95 - c["CP"])
    else:
        c["c19"] = 0.18567 / (1.3571 - ship.midship) - 0.71276 + 0.38648 * c["CP"]
    c["c20"] = 1.0 + 0.015 * ship.stern_coefficient
    viscous = c["c9"] * c["CV"] * ship.length / ship.draft_aft
    viscous *= 0.050776 + 0.93405 * c["c11"] * c["CV"] / (1.0 - c["CP1"])
    potential = 0.27915 * math.sqrt(ship.beam / (ship.length * (1.0 - c["CP1"])))
    return c["c20"] * (viscous + potential + c["c19"])


def _deduction_1982(ship, propeller, c):
    slender = ship.beam / ship.length
    c["c10"] = slender if slender < 1.0 / 5.2 else 0.25 - 0.003328402 / (slender - 0.134615385)
    return (
        0.001979 * ship.length / (ship.beam - ship.beam * c["CP1"])
        + 1.0585 * c["c10"]
        - 0.00524
        - 0.1418 * propeller.diameter**2 / (ship.beam * ship.draft)
        + 0.0015 * ship.stern_coefficient
    )


def _deduction_1984(ship, propeller, c):
    broad = (ship.beam / ship.length) ** 0.28956
    large = (math.sqrt(ship.beam * ship.draft) / propeller.diameter) ** 0.2624
    run = (1.0 - c["CP"] + 0.0225 * ship.lcb_percent) ** 0.01762
    return 0.25014 * broad * large / run + 0.0015 * ship.stern_coefficient
