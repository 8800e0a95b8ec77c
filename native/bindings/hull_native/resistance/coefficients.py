# SPDX-License-Identifier: GPL-3.0-or-later
"""Coefficients of a regression by their names, some of which are given in place of formulas."""

import math


class Coefficients(dict):
    """What has a reading keeps that, whatever a formula says of it."""

    def __init__(self, readings):
        super().__init__()
        self._readings = readings

    def __setitem__(self, name, value):
        super().__setitem__(name, self._readings.get(name, value))


def require_used(readings, used):
    """ValueError for readings that stand in place of nothing in any of the Coefficients used."""
    known = sorted(set().union(*used))
    for name in readings if used else ():
        if name not in known:
            raise ValueError(
                f"{name!r} is no coefficient of this ship at these speeds; these are: "
                f"{', '.join(known)}."
            )


def checked_readings(readings):
    """The same dict. ValueError for what is no finite number."""
    for name, value in readings.items():
        if not math.isfinite(value):
            raise ValueError(f"A reading must be a finite number; that of {name!r} is {value}.")
    return readings
