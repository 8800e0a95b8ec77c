# SPDX-License-Identifier: GPL-3.0-or-later
"""That a hull was scaled in Blender, so that its particulars are those of another hull."""

from dataclasses import dataclass

import numpy as np

from ....hull_io.scale import LARGEST_FACTOR, Scale
from ..constraints import plane_keeping

# Factors and shifts (of the size) nearer to none are rounding, and so are other parts of a map.
_ROUNDING = 1e-5


@dataclass
class NoticedScale:
    """x, y and z of all points were multiplied by factors and shifted since the particulars were
    given as they are, in Blender's units. Undo takes it back: that is a scale too."""

    factors: np.ndarray = None
    shift: np.ndarray = None
    _points: object = None
    _given: tuple = ()

    def follow(self, settings, points):
        """Looks at an Object.hull, and points (n, 3) of its mesh as they are now."""
        given = (settings.length_pp, settings.beam, settings.draft, settings.depth)
        before, self._points = self._points, points
        is_other = before is None or len(before) != len(points) or given != self._given
        if is_other:
            self._given, self.factors, self.shift = given, np.ones(3), np.zeros(3)
        if is_other or (before == points).all():
            return
        found = plane_keeping.affine_map(before, points)
        if found is None:
            return
        matrix, shift = found
        factors = np.diag(matrix)
        if np.abs(matrix - np.diag(factors)).max() > _ROUNDING or factors.min() <= 0.0:
            return
        self.factors, self.shift = self.factors * factors, self.shift * factors + shift

    def forget(self):
        """The particulars are those of the hull as it is."""
        self._points = None

    def noticed(self):
        """The Scale; None where there is none to speak of."""
        if self.factors is None or np.abs(self.factors - 1.0).max() <= _ROUNDING:
            return None
        if not (1.0 / LARGEST_FACTOR <= self.factors).all() or self.factors.max() > LARGEST_FACTOR:
            return None
        # What was meant is a round number or none.
        return Scale(tuple(float(f"{part:.6g}") for part in self.factors), self._shift())

    def _shift(self):
        size = np.abs(self._points).max(initial=0.0)
        shift = np.where(np.abs(self.shift) > _ROUNDING * size, self.shift, 0.0)
        return tuple(shift.tolist())
