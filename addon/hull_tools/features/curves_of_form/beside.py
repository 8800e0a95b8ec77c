# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves that other subjects draw dashed beside a hull's own in the plot of an analysis: of another
hull, say. The analysis draws those that are there and knows nothing of where they come from."""

from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True, eq=False)
class Curve:
    """x, y (n,) in the units of the plot's axes; name: for its legend. handles: places (k, 2) by
    which it may be dragged, or None; frame: ((low, high) of x, the same of y) that the plot's axes
    keep for its sake, or None; colour: sRGB, that of its lines in the view, or None."""

    name: str
    x: np.ndarray
    y: np.ndarray
    handles: np.ndarray = None
    frame: tuple = None
    colour: tuple = None


@dataclass
class Beside:
    """Of one hull: Curves by (name of the analysis, whose they are)."""

    curves: dict = field(default_factory=dict)

    def put(self, analysis, whose, curve):
        """A Curve in place of the one of before; None for none."""
        if curve is None:
            self.curves.pop((analysis, whose), None)
        else:
            self.curves[analysis, whose] = curve

    def of(self, analysis):
        """The Curves of an analysis, as a tuple."""
        return tuple(curve for key, curve in sorted(self.curves.items()) if key[0] == analysis)
