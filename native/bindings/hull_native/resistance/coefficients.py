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

    def require_readings(self):
        """ValueError for readings that stand in place of nothing."""
        for name in self._readings:
            if name not in self:
                known = ", ".join(sorted(self))
                raise ValueError(f"{name!r} is no coefficient of this ship; these are: {known}.")


def checked_readings(readings):
    """The same dict. ValueError for what is no finite number."""
    for name, value in readings.items():
        if not math.isfinite(value):
            raise ValueError(f"A reading must be a finite number; that of {name!r} is {value}.")
    return readings
