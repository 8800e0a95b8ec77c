# SPDX-License-Identifier: GPL-3.0-or-later
"""In which units diagrams show what is computed in metres, tonnes and kilonewtons."""

import numpy as np


class PlotUnits:
    """sizes: {unit: (how many of it the unit shown has, its symbol)}, such as {"m": (0.3048,
    "ft"), "m²": (0.3048**2, "ft²")}; what is not in it is shown as it is. ValueError for a size
    that is not positive."""

    def __init__(self, sizes=None):
        self._sizes = dict(sizes or {})
        for unit, (size, _) in self._sizes.items():
            if not (np.isfinite(size) and size > 0.0):
                raise ValueError(f'The size of what "{unit}" is shown in must be above 0: {size}.')

    def of(self, values, unit):
        """Numbers or arrays in a unit, in that shown; None stays."""
        if values is None or unit not in self._sizes:
            return values
        return values / self._sizes[unit][0]

    def symbol(self, unit):
        return self._sizes[unit][1] if unit in self._sizes else unit

    def fixed(self, value, unit, decimals):
        """A number as text with so many decimals, and its unit."""
        return f"{self.of(value, unit):.{decimals}f} {self.symbol(unit)}"

    def figures(self, value, unit):
        """With four figures, without trailing zeros and without an exponent for usual sizes."""
        return f"{figures(self.of(value, unit))} {self.symbol(unit)}"


METRIC = PlotUnits()
# What is smaller is shown with an exponent.
_LEAST_FIXED = 1e-6


def figures(value):
    """A number's four figures, without an exponent from 1e-6 on; of more than four, all whole
    ones."""
    text = f"{value:.4g}" if abs(value) < 1e4 else f"{value:.0f}"
    if "e" not in text or abs(value) < _LEAST_FIXED:
        return text
    return np.format_float_positional(float(text), trim="-")
