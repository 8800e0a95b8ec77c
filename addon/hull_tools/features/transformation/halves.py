# SPDX-License-Identifier: GPL-3.0-or-later
"""Prismatic coefficients of fore and aft body, and shifts of sections to wanted ones.

Of a half: its volume divided by the area of the station at Lpp / 2 and by Lpp / 2. The fore body is
all that is ahead of that station, the aft body all abaft.
"""

from dataclasses import dataclass

import numpy as np

from ...bridge import native

_MET = 1e-10  # of a coefficient
_MOST_STEPS = 12
_FIRST = 0.02  # of a shift's coefficient, for the first differences
_LARGEST = 1.0
_HALVINGS = 16  # of the range of a shift's coefficient, where its ends are looked for
_SHORTEST = 1.0 / 64.0  # of a step


@dataclass(frozen=True)
class Prismatics:
    fore: float
    aft: float


def prismatics(body, position, length_pp):
    """The Prismatics of a hull_native.HullBody; position: arguments of hull_native about the water,
    upright. ValueError where the station at Lpp / 2 has no area."""
    hull_native, middle = native.require(), 0.5 * length_pp
    (area,) = hull_native.section_areas(body, [middle], **position).areas
    if not area > 0.0:
        raise ValueError("There is no section at Lpp / 2: Cp has no meaning")
    whole = hull_native.hydrostatics(body, **position).displaced_volume
    aft = hull_native.volume_abaft(body, middle, **position)
    return Prismatics(*(volume / (area * middle) for volume in (whole - aft, aft)))


class HalfSolver:
    """Finds the coefficients of a hull_native.SectionShift of one half, or both apart, by which
    halves have wanted prismatic coefficients.

    shift: for part "fore", "aft" or "apart"; moved: moves (n, 3) → the HullBody with these.
    """

    def __init__(self, shift, part, moved, position, length_pp):
        self._shift, self._moved = shift, moved
        self._names = {"fore": ("fore",), "aft": ("aft",)}.get(part, ("fore", "aft"))
        self._position, self._length = position, length_pp

    def solve(self, wanted):
        """hull_native.SectionsShifted for Prismatics, of which that of a half that stays is not
        looked at. ValueError with what can be reached where it is out of reach."""
        target = np.array([getattr(wanted, name) for name in self._names])
        if not np.isfinite(target).all():
            raise ValueError("Cp wanted is no number")
        now = np.zeros(len(target))
        result, values = self._at(now)
        slopes = self._slopes(values)
        for _ in range(_MOST_STEPS):
            if np.abs(values - target).max() <= _MET:
                return result
            step, before = np.linalg.solve(slopes, target - values), values
            now, result, values, step = self._stepped(now, step)
            # Broyden's: what the step has shown of the slopes.
            slopes += np.outer(values - before - slopes @ step, step) / (step @ step)
        raise ValueError("The search did not end: ask for a smaller change, or keep less")

    def _at(self, coefficients):
        result = self._shift.shifted(list(coefficients))
        found = prismatics(self._moved(result.moves), self._position, self._length)
        return result, np.array([getattr(found, name) for name in self._names])

    def _slopes(self, values):
        columns = []
        for axis in np.eye(len(values)):
            try:
                columns.append((self._at(_FIRST * axis)[1] - values) / _FIRST)
            except ValueError:
                columns.append((self._at(-_FIRST * axis)[1] - values) / -_FIRST)
        slopes = np.column_stack(columns)
        if not np.abs(np.linalg.det(slopes)) > 0.0:
            raise ValueError("Nothing of that half may be shifted: keep less of it")
        return slopes

    def _stepped(self, now, step):
        part = 1.0
        while part >= _SHORTEST:
            try:
                return now + part * step, *self._at(now + part * step), part * step
            except ValueError:
                part *= 0.5
        raise ValueError(self._reach())

    def _reach(self):
        """What can be reached by each half alone, in a sentence."""
        ranges = []
        for index, name in enumerate(self._names):
            axis = np.eye(len(self._names))[index]
            ends = sorted(self._end(side * axis)[index] for side in (-1.0, 1.0))
            ranges.append(f"Cp {name} can be {ends[0]:.4f} to {ends[1]:.4f} here")
        other = ", each while the other half is as it is" if len(ranges) > 1 else ""
        return ", ".join(ranges) + other

    def _end(self, axis):
        """The values farthest on the way along an axis of the coefficients."""
        low, high = 0.0, _LARGEST
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            try:
                self._shift.shifted(list(middle * axis))
                low = middle
            except ValueError:
                high = middle
        return self._at(low * axis)[1]
